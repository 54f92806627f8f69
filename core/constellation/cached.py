"""The index of a database's landmarks, loaded from the user's cache or built (docs/reference/file_formats.md#cache)."""

from __future__ import annotations

import json
from functools import partial

import numpy as np

from ..cache import digest, load_or_build
from ..database.model import MapLandmarks
from .index import ConstellationIndex, build_index, index_of_parts, index_parts
from .settings import ConstellationSettings

VERSION = 1
"""Increase it whenever the same landmarks and limits give another index, as after a change of a constant."""

FEWEST = 20_000
"""An index of fewer landmarks is built in a fraction of a second and not cached."""


def key_of(references: MapLandmarks, pixel_size_m: float, settings: ConstellationSettings) -> str:
    """Return the SHA-256 of the landmarks and the settings that an index is built with, hexadecimal."""
    limits = settings.limits
    parameters = json.dumps([VERSION, pixel_size_m, limits.neighbors, limits.minimum_side_in_sizes])
    columns = references.positions, references.classes, references.areas_m2, references.touches_edge
    kinds = "<f8", "u1", "<f8", "u1"
    return digest([parameters.encode(), *(np.asarray(column).astype(kind) for column, kind in zip(columns, kinds))])


def cached_index(references: MapLandmarks, pixel_size_m: float, settings: ConstellationSettings) -> ConstellationIndex:
    """Return the index of a database's landmarks; a large one is loaded from the cache or stored there."""
    if len(references) < FEWEST:
        return build_index(references, pixel_size_m, settings)
    key = key_of(references, pixel_size_m, settings)
    make = partial(index_parts, references, pixel_size_m, settings)
    parts = load_or_build("index", key, make)
    return index_of_parts(references, pixel_size_m, settings, parts)
