"""What a worker does: opens the label map, or the database, and does one task. Runs in the workers' processes."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
from osgeo import gdal

from ..core.database.tasks import TASKS
from ..core.errors import SemRefError
from ..core.geometry.frame import MapFrame
from ..core.segmentation.certainty import Sureness
from ..core.segmentation.tiling import segment_tiles
from ..storage.label_maps import GdalLabels
from ..storage.rasterize import burnt_strip
from . import jobs
from .photos import Opening, opened
from .task_names import BURN, SEGMENT

_CACHE_BYTES = 64 << 20
"""GDAL's cache of one worker; by default it is a share of the machine's memory, for each of them."""


def do(task: str, path: str, shared: tuple, arguments: tuple) -> tuple[str, Any]:
    """Does one task.

    Args:
        task: One of ``TASKS``; SEGMENT, whose shared arguments are those of ``photos.Opening``; BURN, whose shared one
            is a CRS and whose others are geotransform and shape of a strip and its polygons; or one of ``jobs.TASKS``,
            whose shared one is the job and whose other are pieces of it.
        path: The label map.
        shared: The task's first arguments.
        arguments: The others.

    Returns:
        “done” and what it gave; “failed” and class, template and values of an error that the user can mend.
    """
    try:
        if task == SEGMENT:
            return "done", _segmented(shared, *arguments)
        if task == BURN:
            return "done", _burnt(*shared, *arguments)
        if task in jobs.TASKS:
            gdal.SetCacheMax(_CACHE_BYTES)
            return "done", jobs.do(task, *shared, *arguments)
        return "done", TASKS[task](_labels(path), *shared, *arguments)
    except SemRefError as error:
        return "failed", (type(error).__name__, error.sentence.template, error.sentence.values)


@lru_cache(1)
def _labels(path: str) -> GdalLabels:
    gdal.SetCacheMax(_CACHE_BYTES)
    return GdalLabels(path)


def _burnt(crs: str, geotransform: tuple[float, ...], shape_hw: tuple[int, int], *polygons: np.ndarray) -> np.ndarray:
    """(H, W) uint8 labels of a strip."""
    gdal.SetCacheMax(_CACHE_BYTES)
    return burnt_strip(MapFrame(crs, geotransform, shape_hw), *polygons)


def _segmented(opening: tuple, first: tuple[int, int], count: int) -> tuple[np.ndarray, float, int]:
    """(h, w) uint8 labels of a block, and the sum and number of how sure the network is of some of them."""
    gdal.SetCacheMax(_CACHE_BYTES)
    photo, sure, overlap = opened(Opening(*opening)), Sureness(), Opening(*opening).overlap
    tiles = photo.tiles.block(photo.model.tile_hw, first, count)
    labels = []
    values = photo.model.classes.values
    for _, rows in segment_tiles(photo.model, photo.image, values, overlap, tiles):
        if rows is not None:
            labels.append(rows.labels_hw)
            sure.add(rows.sure)
    return np.concatenate(labels), sure.total, sure.count
