"""The index of a database's landmarks, kept beside it: opened by memory mapping, not built anew at every start.

Told in docs/file-formats.md#kept-beside-a-database.
"""

from __future__ import annotations

import json
from dataclasses import asdict
from functools import partial
from pathlib import Path

import numpy as np

from ..database.model import MapLandmarks
from ..kept.arrays import kept_path, opened_or_made
from ..kept.digests import digest
from .index import ConstellationIndex, IndexParts, build_index, index_of_parts, index_parts, part_shapes
from .settings import ConstellationSettings

SUFFIX = ".semref-index"

VERSION = 1
"""Raised whenever the same landmarks give another index, and so another answer."""

FEWEST = 20_000
"""Landmarks below which an index is built in a fraction of a second and not kept."""


def index_path(database: str) -> Path:
    """Where the index of a database lies: beside it."""
    return kept_path(database, SUFFIX)


def key_of(references: MapLandmarks, pixel_size_m: float, settings: ConstellationSettings) -> str:
    """What tells an index from others: SHA-256 of the landmarks and all that it is built with, hexadecimal."""
    told = json.dumps([VERSION, pixel_size_m, asdict(settings)], sort_keys=True)
    columns = references.positions, references.classes, references.areas_m2, references.touches_edge
    kinds = "<f8", "u1", "<f8", "u1"
    return digest([told.encode(), *(np.asarray(column).astype(kind) for column, kind in zip(columns, kinds))])


def stored_index(
    references: MapLandmarks, pixel_size_m: float, settings: ConstellationSettings, database: str | None
) -> ConstellationIndex:
    """The index of a database's landmarks: opened where it is kept, else built and, of many landmarks, kept.

    Args:
        references: The landmarks.
        pixel_size_m: Of the label map that they are of.
        settings: The index is built with.
        database: The file that they were read from; None for none, and nothing is kept.
    """
    if database is None or len(references) < FEWEST:
        return build_index(references, pixel_size_m, settings)
    key = key_of(references, pixel_size_m, settings)
    make = partial(index_parts, references, pixel_size_m, settings)
    fit = partial(_fit, references=references, settings=settings)
    parts = opened_or_made(index_path(database), key, make, fit, database)
    return index_of_parts(references, pixel_size_m, settings, parts)


def _fit(parts: IndexParts, references: MapLandmarks, settings: ConstellationSettings) -> bool:
    """Whether the arrays have the shapes and kinds of an index of these landmarks."""
    expected = part_shapes(len(references), settings)
    if set(parts) != set(expected):
        return False
    triangles = len(parts["keys"])
    return all(
        array.dtype.str == kind and array.shape == tuple(triangles if n is None else n for n in shape)
        for array, (kind, shape) in ((parts[name], expected[name]) for name in expected)
    )
