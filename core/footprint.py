"""The ground that an image shows."""

from __future__ import annotations

from typing import Tuple

import numpy as np


def image_corners(
    center: Tuple[float, float], heading_deg: float, pixel_size: float, width_px: int, height_px: int
) -> np.ndarray:
    """(4, 2) map coordinates of an image's upper left, upper right, lower right and lower left corner.

    ``center``: map coordinates of the image's centre; ``heading_deg``: of the image's top, clockwise from grid north.
    """
    heading = np.radians(heading_deg)
    right = np.array([np.cos(heading), -np.sin(heading)])
    up = np.array([np.sin(heading), np.cos(heading)])
    across, along = right * width_px / 2 * pixel_size, up * height_px / 2 * pixel_size
    return np.asarray(center) + np.array([along - across, across + along, across - along, -across - along])
