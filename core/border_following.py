"""Outer border of one region of a map too large to hold, pixel by pixel (Suzuki & Abe 1985, as in cv2.findContours)."""

from __future__ import annotations

from collections import OrderedDict
from typing import Optional, Tuple

import numpy as np

from .label_source import LabelSource
from .reference_objects import CENTER_OF_FIRST_PIXEL

_BLOCK = 1024
_BLOCKS_KEPT = 64

# The eight neighbours in counter-clockwise order as seen with y down, beginning on the right.
_STEPS = ((1, 0), (1, -1), (0, -1), (-1, -1), (-1, 0), (-1, 1), (0, 1), (1, 1))


class _Pixels:
    """Random access to the pixels of one class, through a few blocks held in memory."""

    def __init__(self, source: LabelSource, value: int) -> None:
        self._source = source
        self._value = value
        self._height, self._width = source.shape_hw
        self._blocks: "OrderedDict[Tuple[int, int], np.ndarray]" = OrderedDict()

    def is_set(self, column: int, row: int) -> bool:
        if not (0 <= column < self._width and 0 <= row < self._height):
            return False
        key = (column // _BLOCK, row // _BLOCK)
        block = self._blocks.get(key)
        if block is None:
            x, y = key[0] * _BLOCK, key[1] * _BLOCK
            block = self._source.read(x, y, min(_BLOCK, self._width - x), min(_BLOCK, self._height - y))
            self._blocks[key] = block
            if len(self._blocks) > _BLOCKS_KEPT:
                self._blocks.popitem(last=False)
        return block[row - key[1] * _BLOCK, column - key[0] * _BLOCK] == self._value


def follow_outer_border(
    source: LabelSource, value: int, first_pixel: Tuple[int, int], minimum_area: float
) -> Optional[tuple]:
    """Region row (class, centre, area, bounds) of the 8-connected region whose first pixel in raster order is given.

    Area and centre are those of the polygon through the border pixels' centres (Green's formula, exact in
    integers), as ``cv2.contourArea`` and ``cv2.moments`` give. None when the area is below ``minimum_area`` (pixels).
    """
    pixels = _Pixels(source, value)
    x0, y0 = first_pixel
    # The pixel to the left of the first one is background; look around from there.
    direction = _next_direction(pixels, x0, y0, 4, clockwise=True)
    if direction is None:
        return None
    start_neighbor = (x0 + _STEPS[direction][0], y0 + _STEPS[direction][1])
    twice_area = six_x = six_y = 0
    left = right = x0
    top = bottom = y0
    x, y, back = x0, y0, direction
    while True:
        direction = _next_direction(pixels, x, y, back + 1, clockwise=False)
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
    center_x = x0 + six_x / (3 * twice_area) + CENTER_OF_FIRST_PIXEL
    center_y = y0 + six_y / (3 * twice_area) + CENTER_OF_FIRST_PIXEL
    return value, center_x, center_y, area, left, top, right + 1, bottom + 1


def _next_direction(pixels: _Pixels, x: int, y: int, first: int, clockwise: bool) -> Optional[int]:
    for turn in range(8):
        direction = (first - turn if clockwise else first + turn) % 8
        if pixels.is_set(x + _STEPS[direction][0], y + _STEPS[direction][1]):
            return direction
    return None
