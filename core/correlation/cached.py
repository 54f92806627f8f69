"""The pyramid of a large database, from the user's cache or built (docs/reference/file_formats.md#cache)."""

from __future__ import annotations

import json
from functools import partial

import numpy as np

from ..cache import digest, load_or_build
from ..geometry.frame import MapFrame
from .class_pyramid import (
    MAXIMUM_CHANNELS,
    STORED_REDUCTION,
    MapPyramid,
    pyramid_parts,
)
from .settings import CorrelationSettings

VERSION = 2
"""Increase it when the same overview gives other evidence and therefore other results."""

FEWEST_PIXELS = 5_000_000
"""Overviews with fewer pixels are not cached: their pyramid takes a tenth of a second. A cached pyramid needs 1.7 bytes
per pixel."""


def key_of(overview_hw: np.ndarray, settings: CorrelationSettings) -> str:
    """Return the cache key of a pyramid: SHA-256 of the overview and of all build values, hexadecimal."""
    values = json.dumps([VERSION, STORED_REDUCTION, MAXIMUM_CHANNELS, settings.rarity_exponent, *overview_hw.shape])
    return digest([values.encode(), overview_hw])


def cached_pyramid(overview_hw: np.ndarray, frame: MapFrame, settings: CorrelationSettings) -> MapPyramid:
    """Return the pyramid of a database's overview; that of a large map is loaded from the cache or stored there.

    Args:
        overview_hw: (H, W) uint8 labels.
        frame: Grid of its pixels.
        settings: Of the pyramid and of every search in it.
    """
    if overview_hw.size < FEWEST_PIXELS:
        return MapPyramid(overview_hw, frame, settings)
    overview_hw = np.ascontiguousarray(overview_hw)
    make = partial(pyramid_parts, overview_hw, settings.rarity_exponent)
    parts = load_or_build("pyramid", key_of(overview_hw, settings), make)
    return MapPyramid(overview_hw, frame, settings, parts)
