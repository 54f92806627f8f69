"""Follow the outer border of a region of a large map, pixel by pixel (Suzuki & Abe 1985, as in cv2.findContours)."""

from __future__ import annotations

import numpy as np

from ..labels.sources import LabelSource
from .landmarks import center_coordinate

_REACH = 256
"""Pixels around the current one that are in memory at a time, in every direction."""

# The eight neighbors in counter-clockwise order, with y down, starting on the right.
_STEPS = ((1, 0), (1, -1), (0, -1), (-1, -1), (-1, 0), (-1, 1), (0, 1), (1, 1))


class _Surroundings:
    """Which pixels around a point are of one class, as bytes; no pixel beyond the map is."""

    def __init__(self, source: LabelSource, value: int, x: int, y: int) -> None:
        height, width = source.shape_hw
        self.left, self.top = x - _REACH, y - _REACH
        self.width = 2 * _REACH + 1
        left, top = max(self.left, 0), max(self.top, 0)
        right, bottom = min(x + _REACH + 1, width), min(y + _REACH + 1, height)
        held = np.zeros((self.width, self.width), np.uint8)
        labels = source.read(left, top, right - left, bottom - top)
        held[top - self.top : bottom - self.top, left - self.left : right - self.left] = labels == np.uint8(value)
        self.pixels = held.tobytes()
        self.offsets = tuple(dx + dy * self.width for dx, dy in _STEPS)

    def holds_neighbors(self, x: int, y: int) -> bool:
        """Return whether all eight neighbors of a pixel are in memory."""
        return 0 < x - self.left < self.width - 1 and 0 < y - self.top < self.width - 1

    def direction(self, x: int, y: int, first: int, turn: int) -> int | None:
        """Return the first direction with a set neighbor, from ``first``, counter-clockwise (1) or clockwise (−1)."""
        place = (y - self.top) * self.width + x - self.left
        for step in range(8):
            direction = (first + turn * step) % 8
            if self.pixels[place + self.offsets[direction]]:
                return direction
        return None


def follow_outer_border(
    source: LabelSource, value: int, first_pixel: tuple[int, int], minimum_area: float
) -> tuple | None:
    """Measure an 8-connected region by following its border.

    Area and center are those of the polygon through the centers of the border pixels (Green's formula, exact in
    integers), equal to the results of ``cv2.contourArea`` and ``cv2.moments``.

    Args:
        first_pixel: (column, row) of its first pixel in raster order.
        minimum_area: Pixels.

    Returns:
        Its row (class, center x, y, area, left, top, right, bottom); None if it is smaller.
    """
    x0, y0 = first_pixel
    around = _Surroundings(source, value, x0, y0)
    # The pixel to the left of the first one is background; start the search there.
    direction = around.direction(x0, y0, 4, -1)
    if direction is None:
        return None
    start_neighbor = (x0 + _STEPS[direction][0], y0 + _STEPS[direction][1])
    twice_area = six_x = six_y = 0
    left, top, right, bottom = x0, y0, x0, y0
    x, y, back = x0, y0, direction
    while True:
        if not around.holds_neighbors(x, y):
            around = _Surroundings(source, value, x, y)
        onward = around.direction(x, y, back + 1, 1)
        # There always is one: the previous pixel.
        direction = back if onward is None else onward
        next_x, next_y = x + _STEPS[direction][0], y + _STEPS[direction][1]
        cross = (x - x0) * (next_y - y0) - (next_x - x0) * (y - y0)
        twice_area += cross
        six_x += cross * (x + next_x - 2 * x0)
        six_y += cross * (y + next_y - 2 * y0)
        left, right = min(left, next_x), max(right, next_x)
        top, bottom = min(top, next_y), max(bottom, next_y)
        if (next_x, next_y) == (x0, y0) and (x, y) == start_neighbor:
            break
        x, y, back = next_x, next_y, (direction + 4) % 8
    area = abs(twice_area) / 2
    if area < minimum_area or area <= 0:
        return None
    six_areas = 3 * twice_area
    center_x = center_coordinate(left, six_x + (x0 - left) * six_areas, six_areas)
    center_y = center_coordinate(top, six_y + (y0 - top) * six_areas, six_areas)
    return value, center_x, center_y, area, left, top, right + 1, bottom + 1
