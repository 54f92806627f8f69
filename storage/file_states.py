"""Detect changes of files that several processes read."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import astuple

from osgeo import gdal

from ..core.cache import digest
from ..core.database.model import ReferenceDatabase
from ..core.errors import ParameterError


def state(path: str) -> tuple[int, float]:
    """Return (bytes, time of the last change) of a file or GDAL name; zeros if there is no file."""
    if os.path.exists(path):
        found = os.stat(path)
        return found.st_size, found.st_mtime
    known = gdal.VSIStatL(path)
    return (known.size, float(known.mtime)) if known is not None else (0, 0.0)


def require_unchanged(before: Mapping[str, tuple[int, float]]) -> None:
    """Raise ParameterError if a file changed since its ``state`` in ``before``."""
    for path, then in before.items():
        if state(path) != then:
            raise ParameterError(
                "{path} was changed while it was read. Start again when no program writes to it.", path=path
            )


def fingerprint(database: ReferenceDatabase) -> str:
    """Return SHA-256 of parameters, classes, landmarks and windows; equal for copies of a database."""
    windows, landmarks = database.windows, database.references
    texts = repr(astuple(database.parameters)), database.class_table.to_csv()
    columns = (
        *(landmarks.positions, landmarks.classes, landmarks.areas_m2, landmarks.touches_edge),
        *(windows.levels, windows.sizes, windows.centers, windows.counts, windows.vectors, windows.described),
    )
    return digest([*(text.encode() for text in texts), *columns])
