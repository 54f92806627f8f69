"""Displacement of landmarks between two label maps of the same ground: the accuracy of a map.

See docs/explanation/method.md#displacement-between-map-dates. The pairs come from ``class_shifts``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .class_shifts import PieceShift

SAME_PX = 0.1
"""Landmarks that are closer together did not move: the center of the same polygon in two rasters of one grid."""

BOUNDS_M = (0, 30, 60, 120, 250, 500, 1000, 2000)
"""Bounds of the distances for which the correlation is computed."""

LEAST_MOVED = 30
"""Smallest number of moved landmarks for a correlation."""

MOST_MOVED = 10_000
"""Largest number of moved landmarks for the correlation, evenly chosen: the time grows with the square."""

LONGEST_IN_DEVIATIONS = 2.0
"""Longer displacements count as this long in the correlation, so that a few redrawn landmarks do not dominate it."""

_ROWS_AT_ONCE = 500


@dataclass(frozen=True)
class Displacement:
    """Displacement of the landmarks of a map against another map of the same ground.

    Attributes:
        pairs: Landmarks that both maps have.
        moved: Share of them that is not at the same place in both maps.
        deviation: Standard deviation along each axis of all pairs: the map accuracy.
        moved_deviation: Standard deviation along each axis of the moved ones.
        correlations: (shortest distance, longest distance, correlation) of the displacements of moved landmarks.
    """

    pairs: int
    moved: float
    deviation: float
    moved_deviation: float
    correlations: tuple[tuple[float, float, float], ...] = ()


def displacement_of(pieces: Sequence[PieceShift], pixel_size: float = 1.0) -> Displacement | None:
    """Return the displacement between two maps in meters, or None without pairs of landmarks.

    Args:
        pieces: All pieces of both maps, with the corners of the pieces.
        pixel_size: Meters.
    """
    points = np.concatenate([np.zeros(0, complex), *(piece.corner + piece.points for piece in pieces)])
    offsets = np.concatenate([np.zeros(0, complex), *(piece.offsets for piece in pieces)])
    if not len(offsets):
        return None
    is_moved = np.abs(offsets) > SAME_PX
    moved = offsets[is_moved]
    return Displacement(
        len(offsets),
        float(is_moved.mean()),
        pixel_size * _deviation(offsets),
        pixel_size * _deviation(moved) if len(moved) else 0.0,
        correlations_of(pixel_size * points[is_moved], pixel_size * moved) if len(moved) >= LEAST_MOVED else (),
    )


def correlations_of(points: np.ndarray, offsets: np.ndarray) -> tuple[tuple[float, float, float], ...]:
    """Return (shortest distance, longest distance, correlation) for each range of distances with pairs.

    Args:
        points: (n,) complex, meters.
        offsets: (n,) complex, meters.
    """
    if len(points) > MOST_MOVED:
        chosen = np.linspace(0, len(points) - 1, MOST_MOVED).round().astype(np.int64)
        points, offsets = points[chosen], offsets[chosen]
    lengths = np.abs(offsets)
    offsets = offsets * np.minimum(1, LONGEST_IN_DEVIATIONS * _deviation(offsets) / np.maximum(lengths, 1e-12))
    sums, counts = np.zeros((2, len(BOUNDS_M) - 1))
    for first in range(0, len(points), _ROWS_AT_ONCE):
        rows = slice(first, first + _ROWS_AT_ONCE)
        apart = np.abs(points[rows, None] - points)
        products = (offsets[rows, None] * offsets.conj()).real / 2
        # A landmark is no pair with itself.
        is_other = np.arange(len(points))[rows, None] != np.arange(len(points))
        sums += np.histogram(apart[is_other], BOUNDS_M, weights=products[is_other])[0]
        counts += np.histogram(apart[is_other], BOUNDS_M)[0]
    found = sums / np.maximum(counts, 1) / _deviation(offsets) ** 2
    ranges = zip(BOUNDS_M, BOUNDS_M[1:], found.tolist(), counts)
    return tuple((float(near), float(far), share) for near, far, share, count in ranges if count)


def _deviation(offsets: np.ndarray) -> float:
    return float(np.sqrt((np.abs(offsets) ** 2).mean() / 2))
