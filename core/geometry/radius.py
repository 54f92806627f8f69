"""Ellipses and circles that contain a given share of a two-dimensional Gaussian error."""

from __future__ import annotations

import numpy as np

from .pose import Ellipse

HELD = 0.95
CIRCLE_95 = float(np.sqrt(-2 * np.log(1 - HELD)))
"""95 % radius of an error that is equal in all directions, in standard deviations along an axis."""

DIRECTIONS = 1440
"""Directions in a quarter turn, enough for ellipses a hundred times as long as wide."""

STEPS, SMALLEST_STEP = 60, 1e-12


def ellipse_of(covariance: np.ndarray) -> Ellipse:
    """Return the 95 % ellipse of a position; ``covariance``: (2, 2), map units²."""
    values, axes = np.linalg.eigh(covariance)
    minor, major = CIRCLE_95 * np.sqrt(np.maximum(values, 0))
    direction = 90 - np.degrees(np.arctan2(axes[1, 1], axes[0, 1]))
    return Ellipse(float(major), float(minor), float(direction % 180))


def circle_radius(covariance: np.ndarray, held: float = HELD) -> float:
    """Return the radius of the circle around the position that contains a share of the errors, map units.

    It is between 1.96 σ (the longer axis only) and 2.45 σ (two equal axes) for 95 %.

    Args:
        covariance: (2, 2), map units².
        held: The share.
    """
    if not np.isfinite(covariance).all():
        return float("inf")
    minor, major = np.sqrt(np.maximum(np.linalg.eigvalsh(covariance), 0))
    if major <= 0:
        return 0.0
    # In units of the longer axis; a line counts as a very thin ellipse.
    thin = max(minor / major, 0.01)
    # The density falls along each direction as exp(−r² g / 2), so the integral beyond r is known. One quarter turn of
    # directions represents all.
    angles = (np.arange(DIRECTIONS) + 0.5) * np.pi / 2 / DIRECTIONS
    steep = np.cos(angles) ** 2 + (np.sin(angles) / thin) ** 2
    low, high = 0.0, float(np.sqrt(-2 * np.log(1 - held)))
    radius = high
    for _ in range(STEPS):
        density = np.exp(-(radius**2) * steep / 2)
        off = float((density / steep).mean() / thin) - (1 - held)
        low, high = (low, radius) if off < 0 else (radius, high)
        # Newton's method, or bisection where Newton leaves the bracket.
        slope = radius * float(density.mean()) / thin
        following = radius + off / slope if slope > 0 else low
        if abs(following - radius) < SMALLEST_STEP:
            break
        radius = following if low < following < high else (low + high) / 2
    return float(radius * major)
