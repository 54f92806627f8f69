"""Means of an image on a coarse grid, row by row, so that the image need not fit into memory."""

from __future__ import annotations

from collections.abc import Iterable

import cv2
import numpy as np

from ..labels.image_source import ImageSource
from ..steps import Shares

FINEST_EDGE = 512
"""Edge of the grid (root of its area): the finest resolution of map correlation."""

BAND_ROWS = 512
"""Rows of a photo that are read at a time; affects only time and memory."""


def grid_of(shape_hw: tuple[int, int]) -> tuple[int, int]:
    """Return (w, h) of the grid for an image of that shape, at most its number of pixels."""
    height, width = shape_hw
    step = max(1.0, float(np.sqrt(height * width)) / FINEST_EDGE)
    return max(1, round(width / step)), max(1, round(height / step))


def picture_steps(photo: ImageSource, size_wh: tuple[int, int]) -> Shares[np.ndarray]:
    """Read a photo once more, after its labels: yield 1 after each band.

    Returns:
        (h, w, 3) uint8 means of its pixels on a grid over all of it.
    """
    height, width = photo.shape_hw
    means = GridMeans(photo.shape_hw, size_wh, 3)
    for first in range(0, height, BAND_ROWS):
        pixels, _ = photo.read(0, first, width, min(BAND_ROWS, height - first))
        means.add(first, (pixels[..., band].astype(np.float32) for band in range(3)))
        yield 1.0
    return np.rint(np.clip(means.found(), 0, 255)).astype(np.uint8)


class GridMeans:
    """Adds up rows of an image; ``found`` returns their means over the pixels of the grid."""

    def __init__(self, shape_hw: tuple[int, int], size_wh: tuple[int, int], count: int) -> None:
        """Start with empty sums of ``count`` planes.

        Args:
            shape_hw: (height, width) of the image.
            size_wh: (w, h) of the grid.
        """
        self._height, self._size_wh = shape_hw[0], size_wh
        self._sums = np.zeros((count, size_wh[1], size_wh[0]), np.float32)

    def add(self, first: int, planes: Iterable[np.ndarray]) -> None:
        """Add rows from number ``first`` on, as (rows, W) float32 planes."""
        parts: list[tuple[np.ndarray, np.ndarray]] = []
        for number, plane in enumerate(planes):
            if not parts:
                begin, count, parts = self._row_shares(first, len(plane))
            narrow = cv2.resize(plane, (self._size_wh[0], len(plane)), interpolation=cv2.INTER_AREA)
            for places, shares in parts:
                self._sums[number, begin : begin + count] += shares * narrow[places]

    def _row_shares(self, first: int, count: int) -> tuple[int, int, list[tuple[np.ndarray, np.ndarray]]]:
        """Return first and number n of the grid rows that overlap rows of the image, and these rows.

        The list has, for the first, second, … image row in each grid row, its (n,) number among the ``count`` rows and
        (n, 1) share of the grid row. A matrix of all shares would have almost only zeros.
        """
        step = self._height / self._size_wh[1]
        begin = int(first / step)
        end = min(int(np.ceil((first + count) / step)), self._size_wh[1])
        edges = np.arange(begin, end + 1) * step
        parts = []
        for offset in range(int(np.ceil(step)) + 1):
            rows = np.floor(edges[:-1]).astype(int) + offset
            inside = np.minimum(edges[1:], rows + 1) - np.maximum(edges[:-1], rows)
            inside[(rows < first) | (rows >= first + count)] = 0
            places = np.clip(rows - first, 0, count - 1)
            parts.append((places, (np.maximum(inside, 0) / step).astype(np.float32)[:, None]))
        return begin, end - begin, parts

    def found(self) -> np.ndarray:
        """Return (h, w, count) float32 means, once all rows are added."""
        return np.moveaxis(self._sums, 0, 2)
