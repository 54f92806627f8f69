"""Photos with a known true position, labeled by a network: of the sample area, of tiles, and of places with labels."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache, partial
from typing import TYPE_CHECKING

import cv2
import numpy as np

from benchmarks.ground import Ground, Image, Wanted, memory_ground
from benchmarks.maps import NoDataError, World, read, read_photo
from benchmarks.places import BUILDING, TILE_CLASSES, place, prepared
from benchmarks.results import ROOT
from sample.photo import turned
from semref.core.evaluation.trial import Query
from semref.core.labels.class_shares import FULL, ClassShares, SeenLabels
from semref.core.labels.image_source import ArrayImage
from semref.core.segmentation.class_bias import known_biases
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.photo_labels import PhotoLabels

if TYPE_CHECKING:
    from benchmarks.accuracy import MapRow
    from semref.core.simulation.views import View

SHIPPED = ROOT / "models" / "sample_area.onnx"
SAMPLE_SEED = 1671
"""Seed of an area on which the shipped network was not trained."""

PLACE_PIXEL_M, GAP_PX = 0.25, 400
OTHER = 2
BUILDINGS_ONLY = "value,name,color,role\n1,building,#3c1098,reference\n2,other,#8429f6,background\n"
SEARCHED = (0.7, 1.4)
"""Possible pixel sizes of an image, in pixels of the map."""


@dataclass
class Photos:
    """A ground with a photo and a network.

    Attributes:
        ground: Ground with the true labels.
        picture: (H, W, 3) uint8 on the same pixels.
        model: Network; None for the true labels.
        wanted: Kind of crops.
        searched: Pixel sizes to search; None for the default of the method.
        columns: First and last column of the photo for crops.
        other: Value of all other classes of the network than buildings; None to keep them.
    """

    ground: Ground
    picture: np.ndarray
    model: SegmentationModel | None
    wanted: Wanted
    searched: tuple[float, float] | None
    columns: tuple[int, int] = (0, 0)
    other: int | None = None

    def __post_init__(self) -> None:
        table = self.ground.database.class_table
        if self.model is not None:
            self._values = self.model.classes.values_in(table, "The model")
            self._biases = known_biases(self.model.class_bias, table)

    def image(self, rng: np.random.Generator, number: int) -> Image:
        """Draw a crop, with labels of the network or true labels."""
        image, photo = self.crop(rng)
        return image if self.model is None else replace(image, seen=self.labeled(photo))

    def crop(self, rng: np.random.Generator) -> tuple[Image, np.ndarray]:
        """Draw a crop; return its true labels and its photo, (H, W, 3) uint8."""
        self.stay_inside()
        image = self.ground.draw(self.wanted, rng)
        return image, self.taken(image.view)

    def taken(self, view: View) -> np.ndarray:
        """Return the photo of a view, (H, W, 3) uint8."""
        center, scale = self.ground.frame.to_pixels(view.position), view.pixel_size / self.ground.frame.pixel_size
        picture = turned(self.picture, center, view.heading_deg, scale, view.shape_hw[::-1])
        return np.ascontiguousarray(picture[:, ::-1]) if view.is_mirrored else picture

    def labeled(self, photo_hw3: np.ndarray, is_thorough: bool = False) -> SeenLabels:
        """Label a photo in the same way as *Localize images*, which looks again without a position."""
        look_again = None if is_thorough else partial(self.labeled, photo_hw3, True)
        return replace(self._seen(photo_hw3, is_thorough), biases=self._biases, look_again=look_again)

    def _seen(self, photo_hw3: np.ndarray, is_thorough: bool) -> SeenLabels:
        found = PhotoLabels(self.model, ArrayImage(photo_hw3), self._values, is_thorough=is_thorough).seen()
        if self.other is None:
            return found
        labels = np.where(found.labels_hw == BUILDING, BUILDING, self.other).astype(np.uint8)
        planes, values = [found.shares.of(np.array([BUILDING]))], [BUILDING]
        if self.other:
            planes, values = [*planes, FULL - planes[0]], [BUILDING, OTHER]
        shares = ClassShares(np.array(values, np.uint8), np.concatenate(planes, axis=2), found.shares.picture)
        return SeenLabels(labels, shares)

    def stay_inside(self) -> None:
        """Keep the centers so far inside the allowed part of the photo that all of an image shows it."""
        if self.columns == (0, 0):
            return
        pixel = self.ground.frame.pixel_size
        reach = max(self.wanted.sizes_px) * self.wanted.scales[1] * np.sqrt(0.5) * pixel
        left, _, _, top = self.ground.frame.extent
        height, (first, last) = pixel * self.picture.shape[0], (pixel * column for column in self.columns)
        if min(height, last - first) < 2 * reach:
            raise ValueError("The place has no room for images of this size.")
        self.ground.extent = (left + first + reach, top - height + reach, left + last - reach, top - reach)


def of(world: World, row: MapRow) -> Photos:
    """Return the photos of a row.

    Raises:
        NoDataError: Photos or network are missing.
    """
    if row.photos == "sample":
        return SamplePhotos(*_sample(), _model(world, row), Wanted(), None)
    sizes = tuple(row.wanted.get("sizes_px", (512, 640, 768)))
    is_mirrored = row.foreign == "mirrored"
    wanted = Wanted((0.9, 1.1), landmarks=(0, 10**9), sizes_px=sizes, is_inside=True, is_mirrored=is_mirrored)
    if row.photos.startswith("tile"):
        path = world.data / "dubai_aerial" / f"{row.photos}_label.tif"
        if not path.exists():
            raise NoDataError(f"{path.name} is not here.")
        ground = memory_ground(read(path), TILE_CLASSES, (512, 128, 60))
        picture = read_photo(path.with_name(path.name.replace("label", "image")))
        return Photos(ground, picture, _model(world, row), wanted, SEARCHED)
    return _of_place(world, row, wanted)


def _of_place(world: World, row: MapRow, wanted: Wanted) -> Photos:
    name, _, number = row.photos.partition(".")
    photo = place(name).photos[int(number or 0)]
    if not (world.data / photo.image).exists():
        raise NoDataError(f"{photo.image} is not here.")
    image, labels = prepared(replace(photo, part=(0.0, 1.0)), world.data, PLACE_PIXEL_M, world.work / "places")
    picture = read_photo(image)
    other = OTHER if row.maps_other else 0
    truth = np.where(read(labels) == BUILDING, BUILDING, other)
    truth[~picture.any(axis=2)] = 0
    labels = truth.astype(np.uint8)
    if row.other_km2:
        labels = side_by_side(labels, other_buildings(world, row.other_km2))
    ground = memory_ground(labels, BUILDINGS_ONLY, (64, 32 if row.other_km2 else 16, 3.75), PLACE_PIXEL_M)
    searched = tuple(PLACE_PIXEL_M * scale for scale in SEARCHED)
    columns = tuple(round(share * picture.shape[1]) for share in photo.part)
    return Photos(ground, picture, _model(world, row), wanted, searched, columns, other)


def other_buildings(world: World, area_km2: float) -> np.ndarray:
    """Return a square of Liechtenstein's buildings around its densest town, (H, W) uint8 at the pixels of places."""
    labels = read(world.label_map("liechtenstein")) == BUILDING
    edge = round(1000 * area_km2**0.5)
    density = cv2.boxFilter(labels.astype(np.float32), -1, (edge, edge), borderType=cv2.BORDER_CONSTANT)
    row, column = np.unravel_index(density.argmax(), density.shape)
    rows, columns = (slice(max(at - edge // 2, 0), at + edge // 2) for at in (row, column))
    town = np.where(labels[rows, columns], BUILDING, OTHER).astype(np.uint8)
    return town.repeat(round(1 / PLACE_PIXEL_M), axis=0).repeat(round(1 / PLACE_PIXEL_M), axis=1)


def side_by_side(left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Return two label maps beside each other, with unlabeled ground between them."""
    height = max(len(left), len(right))
    both = np.zeros((height, left.shape[1] + GAP_PX + right.shape[1]), np.uint8)
    both[: len(left), : left.shape[1]], both[: len(right), -right.shape[1] :] = left, right
    return both


def _model(world: World, row: MapRow) -> SegmentationModel | None:
    if row.labels == "true":
        return None
    if not row.network:
        return SegmentationModel(str(SHIPPED), 1)
    found = sorted(world.models.glob(f"*{row.network}*.onnx")) if world.models else []
    if len(found) != 1:
        raise NoDataError(f"--models has {len(found)} networks with “{row.network}” in their names; one is needed.")
    return SegmentationModel(str(found[0]), 1)


class SamplePhotos(Photos):
    """Rendered photos of the sample area, with another exposure, blur and JPEG."""

    def image(self, rng: np.random.Generator, number: int) -> Image:
        """Render a photo at a random place and heading."""
        from sample import photo, pictures

        seed = SAMPLE_SEED + number
        picture = next(iter(pictures.plan_photos(self.ground.labels_hw.shape, seed, 1)))
        taken = photo.shoot(self.picture, picture, seed)
        jpeg = cv2.imencode(".jpg", taken[:, :, ::-1], [cv2.IMWRITE_JPEG_QUALITY, 85])[1]
        read = np.ascontiguousarray(cv2.imdecode(jpeg, cv2.IMREAD_COLOR)[:, :, ::-1])
        return Image(Query(picture.view(len(taken))), self.labeled(read))


@lru_cache(maxsize=1)
def _sample() -> tuple[Ground, np.ndarray]:
    from sample.classes import CLASSES
    from sample.files import rasterize
    from sample.landscape import make_landscape
    from sample.photo import render

    landscape = make_landscape(SAMPLE_SEED)
    rows = [f"{c.value},{c.name},{c.color},{c.role}" for c in CLASSES]
    table = "\n".join(["value,name,color,role", *rows])
    ground = memory_ground(rasterize(landscape), table, (640, 160, 50))
    return ground, render(landscape)
