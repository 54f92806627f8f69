"""What a worker does: opens the label map, or the database, and does one task. Runs in the workers' processes."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from osgeo import gdal

from ..core.database.parts import TASKS
from ..core.errors import SemRefError
from ..core.onboard.command_line import finding, localize_options
from ..core.onboard.finder import Finding
from ..storage.rasters import GdalLabels

_CACHE_BYTES = 64 << 20
"""GDAL's cache of one worker; by default it is a share of the machine's memory, for each of them."""


LOCALIZE = "localize"
"""The one task that needs no label map: images in an onboard file."""


def do(task: str, path: str, shared: tuple, arguments: tuple) -> tuple[str, Any]:
    """Does one task.

    Args:
        task: One of ``TASKS``, or LOCALIZE, whose shared arguments are the options and whose other is an image.
        path: The label map.
        shared: The task's first arguments.
        arguments: The others.

    Returns:
        “done” and what it gave; “failed” and class, code and values of an error that the user can mend.
    """
    try:
        if task == LOCALIZE:
            return "done", _finding(shared)(*arguments)
        return "done", TASKS[task](_labels(path), *shared, *arguments)
    except SemRefError as error:
        return "failed", (type(error).__name__, error.sentence.code, error.sentence.values)


@lru_cache(1)
def _labels(path: str) -> GdalLabels:
    gdal.SetCacheMax(_CACHE_BYTES)
    return GdalLabels(path)


@lru_cache(1)
def _finding(options: tuple[str, ...]) -> Finding:
    return finding(localize_options(list(options)))
