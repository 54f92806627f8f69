"""Ellipses and circles that hold a share of a two-dimensional Gaussian error."""

from __future__ import annotations

import numpy as np

from .pose import Ellipse

HELD = 0.95
CIRCLE_95 = float(np.sqrt(-2 * np.log(1 - HELD)))
"""Radius of the circle that holds 95 % of an error that is alike in all directions, in deviations along an axis."""

DIRECTIONS = 90
HALVINGS = 40


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
    # The density falls to 0 along each direction as exp(−r² g / 2), so the integral beyond r is known.
    angles = (np.arange(DIRECTIONS * 32) + 0.5) * np.pi / (DIRECTIONS * 32)
    steep = np.cos(angles) ** 2 + (np.sin(angles) / thin) ** 2
    low, high = 0.0, float(np.sqrt(-2 * np.log(1 - held)))
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        beyond = float((np.exp(-(middle**2) * steep / 2) / steep).mean() / thin)
        low, high = (low, middle) if beyond < 1 - held else (middle, high)
    return float(high * major)
