"""Similarity transforms between an image and the map, as complex numbers: fit, heading, scale, uncertainty.

An image point is u = (column − W/2) + i (H/2 − row): pixels from the image's centre, y up. A pose (center, turn) puts
it at center + turn · u on the map; center is the position of the image's centre, |turn| the pixel size,
and the image's top points to turn · i.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

CONFIDENCE_TAIL = 0.05
"""The 95 % ellipse leaves out this much."""


ROUND_PRIOR = 20
"""So many matches that say nothing about directions are added when the ellipse's shape is estimated."""


@dataclass(frozen=True)
class PoseUncertainty:
    """95 % ellipse of the position (semi-axes in map units; orientation of the longer one, degrees clockwise from grid
    north, 0–180), standard deviations of heading (degrees) and pixel size (map units)."""

    semi_major: float
    semi_minor: float
    orientation_deg: float
    heading_deviation_deg: float
    pixel_size_deviation: float


def image_points(points_xy: np.ndarray, width_px: float, height_px: float) -> np.ndarray:
    """(n,) complex image points of pixel coordinates (n, 2) (column, row)."""
    points = np.asarray(points_xy, np.float64).reshape(-1, 2)
    return (points[:, 0] - width_px / 2) + 1j * (height_px / 2 - points[:, 1])


def heading_of(turn: complex) -> float:
    """Degrees clockwise from grid north of the image's top, 0 ≤ heading < 360."""
    top = turn * 1j
    return float(np.degrees(np.arctan2(top.real, top.imag)) % 360)


def turn_of(heading_deg: float, pixel_size: float) -> complex:
    """The inverse of ``heading_of`` with a pixel size."""
    return complex(pixel_size * np.exp(-1j * np.radians(heading_deg)))


def fit_similarity(image: np.ndarray, on_map: np.ndarray, weights: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Weighted least squares along the last axis: (…,) complex centres and turns from (…, n) complex points.

    Rows whose weighted image points coincide give a turn of 0.
    """
    total = np.maximum(weights.sum(axis=-1), 1e-300)
    image_mean = (weights * image).sum(axis=-1) / total
    map_mean = (weights * on_map).sum(axis=-1) / total
    away = image - image_mean[..., None]
    spread = (weights * (away.real**2 + away.imag**2)).sum(axis=-1)
    turn = (weights * away.conj() * (on_map - map_mean[..., None])).sum(axis=-1) / np.maximum(spread, 1e-300)
    return map_mean - turn * image_mean, turn


def pose_uncertainty(
    image: np.ndarray, residuals: np.ndarray, deviations: np.ndarray, turn: complex
) -> PoseUncertainty:
    """Of a pose fitted to matches; image, residuals: (n,) complex, on the map; deviations: (n,) assumed σ per axis.

    The noise is measured from the residuals, which know it better than the assumption does; n points and 4 numbers
    fitted leave 2 n − 4 degrees of freedom, and the ellipse's size follows Fisher's F with 2 and those (closed form).
    """
    weights = 1 / deviations**2
    total = weights.sum()
    mean = (weights * image).sum() / total
    away = image - mean
    spread = (weights * np.abs(away) ** 2).sum()
    freedom = max(2 * len(image) - 4, 1)
    # Influence of each match on the centre and on the turn; residuals are a little small where a match pulls much.
    on_turn = weights * away.conj() / spread
    on_center = weights / total - mean * on_turn
    leverage = weights / total + weights * np.abs(away) ** 2 / spread
    variances = np.abs(residuals) ** 2 / 2 / np.maximum(1 - leverage, 0.1)
    pooled = (weights * np.abs(residuals) ** 2).sum() / freedom / weights
    variances = (variances * (len(image) - 4) + pooled * 8) / (len(image) + 4) if len(image) > 4 else pooled
    quantile = freedom / 2 * (CONFIDENCE_TAIL ** (-2 / freedom) - 1)
    variance = (np.abs(on_center) ** 2 * variances).sum()
    # The complex second moment tells how far from round it is; few residuals can't tell.
    moment = (on_center**2 * residuals**2).sum() / 2 * len(image) / (len(image) + ROUND_PRIOR)
    moment *= min(1.0, 0.8 * variance / max(abs(moment), 1e-300))
    major, minor = (float(np.sqrt(2 * quantile * (variance + sign * abs(moment)))) for sign in (1, -1))
    orientation = float((90 - np.degrees(np.angle(moment)) / 2) % 180)
    deviation = float(np.sqrt((np.abs(on_turn) ** 2 * variances).sum()))
    return PoseUncertainty(major, minor, orientation, float(np.degrees(deviation / abs(turn))), deviation)
