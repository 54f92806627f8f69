"""Footprint of an image: the ground that it shows."""

from __future__ import annotations

import numpy as np


def image_corners(
    center: tuple[float, float], heading_deg: float, pixel_size: float, width_px: int, height_px: int
) -> np.ndarray:
    """Return (4, 2) map coordinates of an image's upper left, upper right, lower right and lower left corner.

    Args:
        center: Map (x, y) of the image's center.
        heading_deg: Direction of the image's top, clockwise from grid north.
        pixel_size: Map units.
    """
    heading = np.radians(heading_deg)
    right = np.array([np.cos(heading), -np.sin(heading)])
    up = np.array([np.sin(heading), np.cos(heading)])
    across, along = right * width_px / 2 * pixel_size, up * height_px / 2 * pixel_size
    return np.asarray(center) + np.array([along - across, across + along, across - along, -across - along])


def on_ground(points_xy: np.ndarray, footprint: np.ndarray, shape_hw: tuple[int, int]) -> np.ndarray:
    """Return (n, 2) map coordinates of pixels of an image.

    Uses the homography that maps corners to corners: level ground seen by any camera without distortion (Heckbert
    1989, 2.2.3).

    Args:
        points_xy: (n, 2) pixel coordinates (column, row).
        footprint: (4, 2) map coordinates of the ground at the image's corners, upper left first, clockwise.
        shape_hw: (height, width) of the image.
    """
    height, width = shape_hw
    right, down = (np.asarray(points_xy, np.float64) / (width, height)).T[:, :, None]
    # Relative to the first corner: map coordinates in millions of meters would lose digits.
    first = footprint[0]
    _, second, third, fourth = footprint - first
    one, other, both = second - third, fourth - third, third - second - fourth
    # 0 for a parallelogram, the footprint of a level image.
    slant_right, slant_down = _cross(both, other) / _cross(one, other), _cross(one, both) / _cross(one, other)
    depth = 1 + slant_right * right + slant_down * down
    return first + (second * (1 + slant_right) * right + fourth * (1 + slant_down) * down) / depth


def is_parallelogram(footprint: np.ndarray) -> bool:
    """Return whether an image was level: opposite edges of its footprint (4, 2) are equal."""
    one, other = footprint[1] - footprint[0], footprint[2] - footprint[3]
    return bool(np.hypot(*(one - other)) <= 1e-6 * np.hypot(*one))


def _cross(one: np.ndarray, other: np.ndarray) -> float:
    return float(one[0] * other[1] - one[1] * other[0])
