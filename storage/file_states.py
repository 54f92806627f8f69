"""By what a file that is read by several processes is known to be the same."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Mapping
from dataclasses import astuple

import numpy as np
from osgeo import gdal

from ..core.database.model import ReferenceDatabase
from ..core.errors import ParameterError


def state(path: str) -> tuple[int, float]:
    """(bytes, time of the last change) of a file; zeros for what is no file. Names of GDAL's are asked of GDAL."""
    if os.path.exists(path):
        found = os.stat(path)
        return found.st_size, found.st_mtime
    known = gdal.VSIStatL(path)
    return (known.size, float(known.mtime)) if known is not None else (0, 0.0)


def require_unchanged(before: Mapping[str, tuple[int, float]]) -> None:
    """Raises ParameterError where a file is another one than when ``state`` reported that of it."""
    for path, then in before.items():
        if state(path) != then:
            raise ParameterError("{path} was changed while it was read; start again when it stays as it is.", path=path)


def fingerprint(database: ReferenceDatabase) -> str:
    """SHA-256 of what is localized by: parameters, classes, landmarks and windows, wherever the file lies."""
    windows, landmarks = database.windows, database.references
    sha = hashlib.sha256(repr(astuple(database.parameters)).encode())
    sha.update(database.class_table.to_csv().encode())
    columns = (
        *(landmarks.positions, landmarks.classes, landmarks.areas_m2, landmarks.touches_edge),
        *(windows.levels, windows.sizes, windows.centers, windows.counts, windows.vectors, windows.described),
    )
    for column in columns:
        sha.update(np.ascontiguousarray(column).tobytes())
    return sha.hexdigest()
