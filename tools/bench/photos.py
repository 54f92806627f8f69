"""The road from photo to fix: photo → segmentation network → label image → position.

Photos of the sample area (its seed is none of the training seeds of the model that ships), and with `--model` turned
crops of a photo of dubai_aerial (`--tile`) that this model was not trained on; where `--model` is a folder, of the
places or tiles that its networks were trained without (real_places.py, real_tiles.py).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import cv2
import numpy as np
from sample.classes import CLASSES
from sample.files import grid_of, rasterize
from sample.landscape import make_landscape

from bench import inputs, page
from bench.correlation import ON_A_TILE
from bench.ground import COLUMNS, Ground, Image, cells, memory_ground
from bench.tiles import tile_ground, tile_paths
from sample import photo, pictures
from semref.core.database.build import BuildSettings
from semref.core.evaluation.trial import Query, Trial
from semref.core.geometry.error_settings import NETWORK_SPREAD
from semref.core.labels.class_shares import SeenLabels
from semref.core.labels.image_source import ArrayImage
from semref.core.localization import Method
from semref.core.segmentation.class_bias import known_biases
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.photo_labels import PhotoLabels
from semref.core.simulation.views import View

PAGE = "benchmarks.md"
AREA = "The sample area, and dubai_aerial, banepa and oam_buildings where named."
SEED = 1671
COUNT, TILE_COUNT, QUICK_COUNT = 200, 50, 2
METHODS = (Method.CONSTELLATION, Method.AUTOMATIC)
SAMPLE_RIGHT_M = 10.0
SHIPPED = inputs.TOOLS.parent / "models" / "sample_area.onnx"
TRUE_LABELS = "true labels"
SILENT = (), NETWORK_SPREAD
"""``Network.biases`` of one that states none."""


def measure(run: inputs.Run) -> dict[str, str]:
    sections = {}
    if run.wants("photos of the sample area"):
        sections["photos of the sample area"] = _sample(run)
    if run.model and run.model.is_dir():
        # It needs what is here.
        from bench import real_places, real_tiles

        if real_tiles.networks(run.model):
            return sections | {"real tiles": real_tiles.measured(run)}
        return sections | {"real places": real_places.measured(run)}
    path = run.data / "dubai_aerial" / f"tile{run.tile}_label.tif"
    if run.model and run.wants("real photos"):
        known = path in tile_paths(run)
        sections["real photos"] = _tile(run, path) if known else f"Not measured: the real data is not here: {path.name}"
    return sections


class Network:
    """A segmentation model whose classes are those of a ground's database."""

    def __init__(self, path: object, ground: Ground) -> None:
        self._model = SegmentationModel(str(path), 1)
        table = ground.database.class_table
        self._values = self._model.classes.values_in(table, "The model")
        known = known_biases(self._model.class_bias, table)
        self.biases = known.class_biases, known.class_spread
        """What ``Localizer.heed_biases`` takes."""

    def labels(self, photo_hw3: np.ndarray) -> np.ndarray:
        """(H, W) uint8, as semref:segmentimage makes them."""
        return self.seen(photo_hw3).labels_hw

    def seen(self, photo_hw3: np.ndarray) -> SeenLabels:
        """What semref:localizeimages sees in a photo."""
        return PhotoLabels(self._model, ArrayImage(photo_hw3), self._values).seen()

    def seen_in_turns(self, photo_hw3: np.ndarray) -> SeenLabels:
        """The same with the means of four looks' scores, the photo turned by right angles; labels are of the first."""
        looks = [self.seen(np.ascontiguousarray(np.rot90(photo_hw3, turns))) for turns in range(4)]
        shares = [np.rot90(one.shares.shares, -turns) for turns, one in enumerate(looks)]
        mean = np.rint(np.mean(shares, axis=0)).astype(np.uint8)
        return replace(looks[0], shares=replace(looks[0].shares, shares=mean))


def _sample(run: inputs.Run) -> str:
    count = run.how_many(COUNT, QUICK_COUNT)
    ground, area_photo = sample_ground()
    network = Network(SHIPPED, ground)
    ground.localizer.heed_biases(*network.biases)
    trials: dict[str, list[Trial]] = {method: [] for method in METHODS}
    for image in sample_photos(area_photo, network, ground, count):
        for method in METHODS:
            trials[method].append(ground.try_image(image, method, SAMPLE_RIGHT_M))
    rows = [cells(tried, method) for method, tried in trials.items()]
    agreement = _agreement(ground, network.labels(area_photo))
    return f"{_SAMPLE.format(limit=SAMPLE_RIGHT_M)}\n\n{page.table(COLUMNS, rows)}\n\n{agreement}"


def sample_ground() -> tuple[Ground, np.ndarray]:
    """The ground of the sample area's true label map, and the photo of all of it, (H, W, 3)."""
    landscape = make_landscape(SEED)
    labels = rasterize(landscape, 1.0)
    classes = [f"{c.value},{c.name},{c.color},{c.role}" for c in CLASSES]
    ground = memory_ground(labels, "\n".join(["value,name,color,role", *classes]), BuildSettings(640, 160, 50))
    return ground, photo.render(landscape, grid_of(landscape, 1.0), 1.0)


def sample_sun_deg(seed: int = SEED) -> float:
    """Where the sun stands over a made-up area, clockwise from grid north: what ``photo.render`` draws first."""
    return float(np.random.default_rng([seed, photo.SEED_OFFSET]).uniform(120, 240))


def sample_photos(
    area_photo: np.ndarray, network: Network, ground: Ground, count: int, seed: int = SEED
) -> Iterator[Image]:
    """Photos of the sample area as the network labels them; the seed says where and how they are taken."""
    for picture in pictures.plan_photos(ground.labels_hw.shape, seed, count):
        seen = photo.shoot(area_photo, picture, seed)
        jpeg = cv2.imencode(".jpg", seen[:, :, ::-1], [cv2.IMWRITE_JPEG_QUALITY, 85])[1]
        found = network.seen(np.ascontiguousarray(cv2.imdecode(jpeg, cv2.IMREAD_COLOR)[:, :, ::-1]))
        yield Image(Query(picture.view(len(seen))), found.labels_hw, shares=found.shares)


_SAMPLE = """\
Rendered photos of the sample area (a landscape that the shipped model has not seen), 640 px, off-grid, any heading,
0.8–1.25 m, JPEG. Right: within {limit:g} m. Database of the true label map."""


def _tile(run: inputs.Run, path: object) -> str:
    ground = tile_ground(path)
    picture = inputs.read_labels(str(path).replace("_label", "_image"))
    picture = np.ascontiguousarray(np.moveaxis(picture[:3], 0, 2))
    network = Network(run.model, ground)
    ground.localizer.heed_biases(*network.biases)
    rows = []
    large: dict[tuple, list[Trial]] = {}
    for number, edge in enumerate(ON_A_TILE.sizes_px):
        rng = np.random.default_rng([SEED, number])
        wanted = replace(ON_A_TILE, sizes_px=(edge,), labeled=0.0)
        images = [ground.draw(wanted, rng) for _ in range(run.how_many(TILE_COUNT, QUICK_COUNT))]
        predicted = [as_seen(image, network.seen(seen(ground, picture, image.view))) for image in images]
        for source, given in (("network", predicted), (TRUE_LABELS, images)):
            for method in METHODS:
                trials = [ground.try_image(image, method) for image in given]
                rows.append(cells(trials, f"tile {run.tile}, {edge} px, {source}, {method}"))
                if edge >= 512:
                    large.setdefault((source, method), []).extend(trials)
    rows += [
        cells(trials, f"tile {run.tile}, ≥ 512 px, {source}, {method}") for (source, method), trials in large.items()
    ]
    about = _TILE.format(tile=run.tile, model=run.model.name)
    return f"{about}\n\n{page.table(COLUMNS, rows)}\n\n{_agreement(ground, network.labels(picture))}"


_TILE = """\
`{model}` on tile {tile} of dubai_aerial, which it was not trained on (`tools/training/train_dubai.py`): off-grid,
turned crops at 0.9–1.1 of the tile's pixels, pixel size searched over 0.7–1.4; database of the annotated labels, all
classes as landmarks; errors in pixels. Right: within 2 % of the edge. “{true}”: what no network could improve. Goal:
≥ 90 % right and ≤ 0.5 % wrong at ≥ 512 px.""".replace("{true}", TRUE_LABELS)


def as_seen(image: Image, found: SeenLabels) -> Image:
    """The image as a network sees it."""
    return replace(image, labels_hw=found.labels_hw, shares=found.shares)


def seen(ground: Ground, photo_hw3: np.ndarray, view: View) -> np.ndarray:
    """What the view shows of a photo with the ground's pixels, (H, W, 3), by linear interpolation."""
    turn, center = np.radians(view.heading_deg), ground.frame.to_pixels(view.position)
    cosine, sine = np.cos(turn), np.sin(turn)
    matrix = view.pixel_size / ground.frame.pixel_size * np.array([[cosine, -sine], [sine, cosine]])
    offset = center - 0.5 - matrix @ ((np.array(view.shape_hw[::-1]) - 1) / 2)
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    return cv2.warpAffine(photo_hw3, np.column_stack([matrix, offset]), view.shape_hw[::-1], flags=flags)


def _agreement(ground: Ground, predicted: np.ndarray) -> str:
    found, right = agreement(ground, ground.labels_hw, predicted)
    rows: list[Sequence[object]] = []
    for entry, iou in zip(ground.database.class_table, found):
        rows.append([entry.name, f"{(ground.labels_hw == entry.value).mean():.1%}", f"{iou:.3f}"])
    rows.append(["mean", "", f"{np.mean(found):.3f}"])
    return f"{page.table(['class', 'share of the ground', 'IoU'], rows)}\n\nPixels with the right class: {right:.1%}."


def agreement(ground: Ground, labels_hw: np.ndarray, predicted: np.ndarray) -> tuple[list[float], float]:
    """Intersection over union of each class, and the share of pixels that are right.

    0 counts only as what the network may answer where a class is.
    """
    known = labels_hw > 0
    found: list[float] = []
    for entry in ground.database.class_table:
        truth, answer = labels_hw == entry.value, (predicted == entry.value) & known
        found.append((truth & answer).sum() / max((truth | answer).sum(), 1))
    return found, (predicted == labels_hw)[known].mean()
