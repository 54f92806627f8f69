"""Photos of real places by networks that were not trained on them: the part of ``photos`` that is about such places.

``--model FOLDER`` is that of tools/training/train_photos.py: NAME_without_PLACE.onnx, of which that place was left
out. Beside each stands what the true labels of the same crops give, which no network can better.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from bench import inputs, page, photo_places
from bench.correlation import ON_A_TILE
from bench.ground import COLUMNS, Image, cells, memory_ground
from bench.photo_places import Photo, Place
from bench.photos import METHODS, SEED, TRUE_LABELS, Network, as_seen, seen
from semref.core.database.build import BuildSettings
from semref.core.labels.class_shares import FULL, ClassShares, SeenLabels
from semref.core.localization import Prior

PIXEL_M = 0.25
SIZES_PX = (256, 384, 512)
SEARCHED = (0.7 * PIXEL_M, 1.4 * PIXEL_M)
"""Meters that an image's pixel shows, looked for: 0.7 to 1.4 of the map's."""

COUNT, QUICK_COUNT = 30, 2
SETTINGS = BuildSettings(64, 16, 3.75)
BUILDING, OTHER = 1, 2
CLASSES = "value,name,color,role\n1,building,#3c1098,reference\n2,other,#8429f6,background\n"


class BuildingsNetwork(Network):
    """A network of which buildings alone are asked; whatever else it says is other ground."""

    def labels(self, photo_hw3: np.ndarray) -> np.ndarray:
        """(H, W) uint8."""
        return self.seen(photo_hw3).labels_hw

    def seen(self, photo_hw3: np.ndarray) -> SeenLabels:
        """Labels, and shares of buildings and all else where the network tells how sure it is."""
        found = super().seen(photo_hw3)
        labels = np.where(found.labels_hw == BUILDING, BUILDING, OTHER).astype(np.uint8)
        if found.shares is None:
            return SeenLabels(labels)
        buildings = found.shares.of(np.array([BUILDING]))
        values = np.array([BUILDING, OTHER], np.uint8)
        return SeenLabels(labels, ClassShares(values, np.concatenate([buildings, FULL - buildings], axis=2)))


def measured(run: inputs.Run) -> str:
    """Tables of fixes and of agreement, a row for each place that a network of the folder was trained without."""
    rows, agreement = [], []
    for place in photo_places.PLACES:
        for model in without(run.model, place.name):
            case = f"{place.name}, {model.stem.partition('_')[0]}"
            if place.drawn == photo_places.BUILDINGS and run.wants(case):
                grounds = [ground_of(run, photo) for photo in place.photos]
                rows += located(run, place, case, model, grounds)
                agreement.append([case, *agreed(model, grounds)])
    if not rows:
        return f"Not measured: there is no NAME_without_PLACE.onnx in {run.model.name}."
    sizes = ", ".join(map(str, SIZES_PX))
    about = _ABOUT.format(pixel=PIXEL_M, sizes=sizes)
    header = ["place left out, network", "IoU building", "buildings found", "right where found", "share of the ground"]
    return f"{about}\n\n{page.table(COLUMNS, rows)}\n\n{page.table(header, agreement)}"


def without(folder: Path, place: str) -> list[Path]:
    """Networks that a place, or several of them, was left out of: NAME_without_PLACE_and_PLACE.onnx."""
    found = sorted(folder.glob("*_without_*.onnx"))
    return [path for path in found if place in path.stem.partition("_without_")[2].split("_and_")]


_ABOUT = """\
Photos of `banepa` and `oam_buildings` at {pixel:g} m by networks that were trained without the place
(`tools/training/train_photos.py --leave-out`): off-grid, turned crops of {sizes} px where the ground has room for
them, at 0.9–1.1 of its pixels, pixel size searched over 0.7–1.4; database of the annotation, buildings as landmarks
and all else as one class, in meters; of Banepa the database knows both halves, and crops show the half left out.
Right: within 2 % of the edge. “labels alone”: without the network's scores. “true labels”: what no network could
improve; what is missing there the ground does not allow."""


class PlaceGround:
    """A photo's ground: the map with its database, the photo on the same pixels, and where crops may lie.

    Attributes:
        ground: With the true labels; its extent is where centers of crops may lie.
        picture: (H, W, 3) uint8.
        part: (first, last) columns that belong to the place.
    """

    def __init__(
        self, labels: np.ndarray, picture: np.ndarray, part: tuple[float, float], classes: str = CLASSES
    ) -> None:
        self.ground = memory_ground(labels, classes, SETTINGS, PIXEL_M)
        self.ground.prior = Prior(pixel_size_range=SEARCHED)
        self.picture = picture
        self.part = tuple(round(share * labels.shape[1]) for share in part)
        self._whole = self.ground.frame.extent

    def images(self, edge: int, count: int, rng: np.random.Generator) -> list[Image]:
        """Crops that show nothing but the place; none where it has no room for them."""
        wanted = replace(ON_A_TILE, sizes_px=(edge,), labeled=0.0)
        reach = edge * wanted.scales[1] * np.sqrt(0.5) * PIXEL_M
        left, bottom, right, top = self._whole
        height = top - bottom
        first, last = (PIXEL_M * column for column in self.part)
        if min(height, last - first) < 2 * reach:
            return []
        # Beside the other half only: beyond the map nothing can be seen anyway.
        first, last = (first + reach * (first > 0), last - reach * (last < right - left))
        self.ground.extent = (left + first, bottom, left + last, top)
        return [self.ground.draw(wanted, rng) for _ in range(count)]


def ground_of(run: inputs.Run, photo: Photo) -> PlaceGround:
    """The ground of all of a photo, of which a place may be a part."""
    whole = replace(photo, part=(0.0, 1.0))
    image, labels = photo_places.prepared(whole, run.data, PIXEL_M, run.work / "places")
    picture = np.ascontiguousarray(np.moveaxis(inputs.read_labels(image)[:3], 0, 2))
    truth = np.where(inputs.read_labels(labels) == photo_places.BUILDING, BUILDING, OTHER)
    truth[~picture.any(axis=2)] = 0
    return PlaceGround(truth.astype(np.uint8), picture, photo.part)


def located(run: inputs.Run, place: Place, case: str, model: Path, grounds: Sequence[PlaceGround]) -> list[list[str]]:
    """A row a method, by the network and by the true labels, over all photos and sizes."""
    trials: dict[tuple[str, str], list] = {}
    count = -(-run.how_many(COUNT, QUICK_COUNT) // len(grounds))
    for number, one in enumerate(grounds):
        network = BuildingsNetwork(model, one.ground)
        one.ground.localizer.heed_biases(*network.biases)
        for edge in SIZES_PX:
            rng = np.random.default_rng([SEED, photo_places.PLACES.index(place), number, edge])
            for image in one.images(edge, count, rng):
                answer = as_seen(image, network.seen(seen(one.ground, one.picture, image.view)))
                sources = {"network": answer, TRUE_LABELS: image}
                if answer.shares is not None:
                    sources["network, labels alone"] = replace(answer, shares=None)
                for source, given in sources.items():
                    for method in METHODS:
                        found = one.ground.try_image(given, method)
                        for size in ("all sizes", f"{edge} px"):
                            trials.setdefault((size, source, method), []).append(found)
    rows = []
    for (size, source, method), found in sorted(trials.items()):
        if method == METHODS[-1] or size == "all sizes":
            rows.append(cells(found, f"{case}, {size}, {source}, {method}"))
            print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    return rows


def agreed(model: Path, grounds: Sequence[PlaceGround]) -> list[str]:
    """How well buildings are found on the whole of the place's photos."""
    both = true = answered = known = 0
    for one in grounds:
        part = np.s_[:, one.part[0] : one.part[1]]
        labels = one.ground.labels_hw[part]
        predicted = BuildingsNetwork(model, one.ground).labels(np.ascontiguousarray(one.picture[part]))
        truth, answer = labels == BUILDING, (predicted == BUILDING) & (labels > 0)
        both, true, answered = both + (truth & answer).sum(), true + truth.sum(), answered + answer.sum()
        known += (labels > 0).sum()
    iou = both / max(true + answered - both, 1)
    return [f"{iou:.3f}", f"{both / max(true, 1):.1%}", f"{both / max(answered, 1):.1%}", f"{true / max(known, 1):.1%}"]
