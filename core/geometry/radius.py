"""Ellipses and circles that hold a share of a two-dimensional Gaussian error."""

from __future__ import annotations

import numpy as np

from .pose import Ellipse

HELD = 0.95
CIRCLE_95 = float(np.sqrt(-2 * np.log(1 - HELD)))
"""Radius of the circle that holds 95 % of an error that is alike in all directions, in deviations along an axis."""

DIRECTIONS = 1440
"""In a quarter turn, of ellipses up to a hundred times as long as wide."""

STEPS, SMALLEST_STEP = 60, 1e-12


def ellipse_of(covariance: np.ndarray) -> Ellipse:
    """The 95 % ellipse of a position.

    Args:
        covariance: (2, 2), map units².
    """
    values, axes = np.linalg.eigh(covariance)
    minor, major = CIRCLE_95 * np.sqrt(np.maximum(values, 0))
    direction = 90 - np.degrees(np.arctan2(axes[1, 1], axes[0, 1]))
    return Ellipse(float(major), float(minor), float(direction % 180))


def circle_radius(covariance: np.ndarray, held: float = HELD) -> float:
    """Radius of the circle around the position that holds a share of the errors, map units.

    Between that of the longer axis alone (1.96 σ for 95 %) and that of two equal ones (2.45 σ).

    Args:
        covariance: (2, 2), map units².
        held: The share.
    """
    if not np.isfinite(covariance).all():
        return float("inf")
    minor, major = np.sqrt(np.maximum(np.linalg.eigvalsh(covariance), 0))
    if major <= 0:
        return 0.0
    # In units of the longer axis; a line is taken for a very thin ellipse.
    thin = max(minor / major, 0.01)
    # The density falls to 0 along each direction as exp(−r² g / 2), so the integral beyond r is known. A quarter of all
    # directions is like the others.
    angles = (np.arange(DIRECTIONS) + 0.5) * np.pi / 2 / DIRECTIONS
    steep = np.cos(angles) ** 2 + (np.sin(angles) / thin) ** 2
    low, high = 0.0, float(np.sqrt(-2 * np.log(1 - held)))
    radius = high
    for _ in range(STEPS):
        density = np.exp(-(radius**2) * steep / 2)
        off = float((density / steep).mean() / thin) - (1 - held)
        low, high = (low, radius) if off < 0 else (radius, high)
        # Newton's method, or halving where that leaves what is known.
        slope = radius * float(density.mean()) / thin
        following = radius + off / slope if slope > 0 else low
        if abs(following - radius) < SMALLEST_STEP:
            break
        radius = following if low < following < high else (low + high) / 2
    return float(radius * major)
