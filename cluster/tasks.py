"""Execute a task in the process of a worker."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from osgeo import gdal

from ..core.database.tasks import TASKS
from ..core.errors import SemRefError
from ..core.geometry.frame import MapFrame
from ..core.labels.class_table import class_table_from_csv
from ..core.labels.image_source import ImageSource
from ..core.segmentation.certainty import Sureness
from ..core.segmentation.model import SegmentationModel
from ..core.segmentation.resampling import at_resolution
from ..core.segmentation.tiling import Tiles, segment, tiles_of
from ..storage.images import GdalImage
from ..storage.label_maps import GdalLabels
from ..storage.rasterize import rasterize_strip
from . import jobs
from .task_names import BURN, SEGMENT

_CACHE_BYTES = 64 << 20
"""GDAL's cache of a worker. The default is a share of the machine's memory for each worker."""


def do(task: str, path: str, shared: tuple, arguments: tuple) -> tuple[str, Any]:
    """Execute a task.

    Args:
        task: A name of ``core.database.tasks.TASKS``, ``jobs.TASKS``, SEGMENT or BURN.
        shared: First arguments, equal for all calls. SEGMENT: those of ``_open_photo``. BURN: the CRS. Jobs: the job.
        arguments: Other arguments. BURN: geotransform and shape of a strip, and its polygons. Jobs: parts of the job.

    Returns:
        “done” and the result, or “failed” and class, template and values of a SemRefError.
    """
    gdal.SetCacheMax(_CACHE_BYTES)
    try:
        if task == SEGMENT:
            return "done", _segment(shared, *arguments)
        if task == BURN:
            return "done", rasterize_strip(MapFrame(*shared, *arguments[:2]), *arguments[2:])
        if task in jobs.TASKS:
            return "done", jobs.do(task, *shared, *arguments)
        return "done", TASKS[task](_labels(path), *shared, *arguments)
    except SemRefError as error:
        return "failed", (type(error).__name__, error.sentence.template, error.sentence.values)


@lru_cache(1)
def _labels(path: str) -> GdalLabels:
    return GdalLabels(path)


class _Photo(NamedTuple):
    model: SegmentationModel
    image: ImageSource
    tiles: Tiles
    overlap: float


@lru_cache(1)
def _open_photo(
    path: str,
    model: str,
    table_csv: str,
    pixel_size_m: tuple[float, float] | None,
    resolution_m: float | None,
    overlap: float,
) -> _Photo:
    """Open a photo and its network, with one CPU thread: all workers give equal results.

    Args:
        table_csv: A class table as CSV text; empty without one.
        pixel_size_m: Ground size of a pixel along a row and a column, m; None if unknown.
        resolution_m: Pixel size for the network, m; None for the photo's.
        overlap: Share of a tile that neighbors overlap.

    Raises:
        SemRefError: The photo or the network can't be used.
    """
    table = class_table_from_csv(table_csv, "class table") if table_csv else None
    network = SegmentationModel(model, 1, table, "cpu")
    image = at_resolution(GdalImage(path), pixel_size_m, resolution_m)
    return _Photo(network, image, tiles_of(network, image.shape_hw, overlap), overlap)


def _segment(photo_arguments: tuple, first: tuple[int, int], count: int) -> tuple[np.ndarray, float, int]:
    """Return (h, w) uint8 labels of a block, and sum and number of the network's confidences for some pixels."""
    photo, sure = _open_photo(*photo_arguments), Sureness()
    tiles = photo.tiles.block(photo.model.tile_hw, first, count)
    labels = []
    values = photo.model.classes.values
    for _, rows in segment(photo.model, photo.image, values, photo.overlap, tiles=tiles):
        if rows is not None:
            labels.append(rows.labels_hw)
            sure.add(rows.sure)
    return np.concatenate(labels), sure.total, sure.count
