"""A reference database in memory: result of a build, input of localization (docs/reference/file_formats.md)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..geometry.frame import MapFrame
from ..labels.class_table import ClassTable
from ..windows.grid import window_name
from .parameters import BuildParameters

_OFF_PIXELS = 1e-3
"""Largest displacement of a window from rounding of large map coordinates, pixels."""


@dataclass(frozen=True)
class Windows:
    """The N windows of a database.

    Attributes:
        first_pixels: (N, 2) int64 first column and row on the label map.
        levels: (N,) int64, counted from 1.
        sizes: (N,) float64 edge, map units.
        centers: (N, 2) float64 map coordinates (x, y).
        counts: (N,) int64 landmarks.
        vectors: (N, 3·X) float32.
        described: (N,) bool, False with too few landmarks for a vector.
        distinctiveness: (N,) float64 distance to the nearest vector elsewhere, NaN without one; None if the windows
            were not compared, or only partly read.
    """

    first_pixels: np.ndarray
    levels: np.ndarray
    sizes: np.ndarray
    centers: np.ndarray
    counts: np.ndarray
    vectors: np.ndarray
    described: np.ndarray
    distinctiveness: np.ndarray | None = None

    def __len__(self) -> int:
        return len(self.levels)

    def name(self, index: int) -> str:
        """Return the ``window_name`` of the window with that index."""
        return window_name(*self.first_pixels[index].tolist())

    @cached_property
    def names(self) -> np.ndarray:
        """(N,) str names of all windows; computed at first use."""
        return np.array([window_name(*pixel) for pixel in self.first_pixels.tolist()], dtype=str)


def first_pixels_of(centers: np.ndarray, sizes: np.ndarray, frame: MapFrame) -> np.ndarray:
    """Return (N, 2) int64 first column and row of windows on the label map, from their centers.

    Args:
        centers: (N, 2) map coordinates (x, y).
        sizes: (N,) edges, map units.

    Raises:
        ValueError: A window is not aligned with whole pixels.
    """
    first = frame.to_pixels(centers) - np.rint(sizes / frame.pixel_size)[:, None] / 2
    whole = np.rint(first)
    if np.abs(first - whole).max(initial=0) > _OFF_PIXELS or whole.min(initial=0) < 0:
        raise ValueError("a window is not aligned with the label map's pixels")
    return whole.astype(np.int64)


@dataclass(frozen=True)
class MapLandmarks:
    """The N landmarks of the whole map.

    Attributes:
        positions: (N, 2) float64 map coordinates (x, y).
        classes: (N,) uint8 class values.
        areas_m2: (N,) float64.
        touches_edge: (N,) bool, whether the map's edge cuts them.
        bounds_px: (N, 4) int64 first column, first row, last column + 1, last row + 1 on the label map; None if not
            read.
    """

    positions: np.ndarray
    classes: np.ndarray
    areas_m2: np.ndarray
    touches_edge: np.ndarray
    bounds_px: np.ndarray | None = None

    def __len__(self) -> int:
        return len(self.classes)

    @property
    def required_bounds(self) -> np.ndarray:
        """``bounds_px``, required by updates.

        Raises:
            ValueError: They were not read.
        """
        if self.bounds_px is None:
            raise ValueError("the landmarks' bounds were not read")
        return self.bounds_px


@dataclass(frozen=True)
class ReferenceDatabase:
    """Windows, landmarks, class table and build parameters of one area.

    Attributes:
        source: The file it was read from; None without one.
        overview: (h, w) uint8, the reduced label map, which map correlation searches; None if not read.
    """

    windows: Windows
    references: MapLandmarks
    class_table: ClassTable
    parameters: BuildParameters
    source: str | None = None
    overview: np.ndarray | None = None
