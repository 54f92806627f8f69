"""A photo and its network as workers open them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from ..core.labels.class_table import class_table_from_csv
from ..core.labels.image_source import ImageSource
from ..core.segmentation.model import SegmentationModel
from ..core.segmentation.resampling import at_resolution
from ..core.segmentation.tiling import Tiles, tiles_of
from ..storage.images import GdalImage


@dataclass(frozen=True)
class Opening:
    """What a photo is opened with.

    Attributes:
        image: The photo's path.
        model: The network's path.
        table: A class table's CSV text; empty for none.
        pixel_size_m: Ground meters along a row and a column of a pixel of the photo; None where it has none.
        resolution_m: Of a pixel as the network sees it; None for the photo's.
        overlap: Share of a tile that it shares with each neighbor.
    """

    image: str
    model: str
    table: str
    pixel_size_m: tuple[float, float] | None
    resolution_m: float | None
    overlap: float


@dataclass(frozen=True)
class WorkerPhoto:
    """A photo as the network sees it.

    Attributes:
        model: The network.
        image: The photo at the network's resolution.
        tiles: All of it.
    """

    model: SegmentationModel
    image: ImageSource
    tiles: Tiles


@lru_cache(1)
def opened(opening: Opening) -> WorkerPhoto:
    """Open a photo and its network, with one thread of the processor: all workers give the same.

    Raises:
        SemRefError: One of them can't be used.
    """
    table = class_table_from_csv(opening.table, "class table") if opening.table else None
    model = SegmentationModel(opening.model, 1, table, "cpu")
    image = at_resolution(GdalImage(opening.image), opening.pixel_size_m, opening.resolution_m)
    return WorkerPhoto(model, image, tiles_of(model, image.shape_hw, opening.overlap))
