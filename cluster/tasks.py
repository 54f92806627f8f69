"""What a worker does: opens the label map and does one task of it. Runs in the workers' processes."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from osgeo import gdal

from ..core.database.parts import TASKS
from ..core.errors import SemRefError
from ..storage.rasters import GdalLabels

_CACHE_BYTES = 64 << 20
"""GDAL's cache of one worker; by default it is a share of the machine's memory, for each of them."""


def do(task: str, path: str, shared: tuple, arguments: tuple) -> tuple[str, Any]:
    """Does one task.

    Args:
        task: One of ``TASKS``.
        path: The label map.
        shared: The task's first arguments.
        arguments: The others.

    Returns:
        “done” and what it gave; “failed” and class, code and values of an error that the user can mend.
    """
    try:
        return "done", TASKS[task](_labels(path), *shared, *arguments)
    except SemRefError as error:
        return "failed", (type(error).__name__, error.sentence.code, error.sentence.values)


def held(values: tuple) -> tuple:
    """Arguments that many tasks share: sent to a worker once, and made again where a worker died with them."""
    return values


@lru_cache(1)
def _labels(path: str) -> GdalLabels:
    gdal.SetCacheMax(_CACHE_BYTES)
    return GdalLabels(path)
