"""A network's scores as shares of classes on a coarse grid, row by row, so that no image of scores is stored.

See docs/explanation/method.md#scores-instead-of-the-best-class.
"""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from ..labels.class_shares import FULL, ClassShares
from ..labels.class_table import UNLABELED
from .certainty import NO_DATA
from .tiling import SegmentedRows

FINEST_EDGE = 512
"""Edge of the grid (root of its area): the finest resolution of map correlation."""


def grid_of(shape_hw: tuple[int, int]) -> tuple[int, int]:
    """Return (w, h) of the grid for an image of that shape, at most its number of pixels."""
    height, width = shape_hw
    step = max(1.0, float(np.sqrt(height * width)) / FINEST_EDGE)
    return max(1, round(width / step)), max(1, round(height / step))


class ScoreShares:
    """Adds up the percents of rows; ``found`` returns their means over the pixels of the grid.

    Stores the grid, and the rows that are being added.
    """

    def __init__(self, values: Sequence[int], shape_hw: tuple[int, int], size_wh: tuple[int, int]) -> None:
        """Start with empty sums.

        Args:
            values: (C,) class value of each channel; several may have the same one, 0 is not a class.
            shape_hw: (height, width) of the image at the network's resolution.
            size_wh: (w, h) of the grid, at most that of the image.
        """
        self._shape_hw, self._size_wh = shape_hw, size_wh
        self._channels = np.asarray(values)
        self._values = np.unique(self._channels[self._channels != UNLABELED]).astype(np.uint8)
        self._sums = np.zeros((len(self._values), size_wh[1], size_wh[0]), np.float32)

    def add(self, rows: SegmentedRows) -> None:
        """Add rows with the percents of each channel; pixels without data count as unknown."""
        if rows.percents_chw is None:
            raise ValueError("The rows have no percents of each channel.")
        has_data = rows.percents_chw[0] != NO_DATA
        first, weights = self._row_weights(rows.first, len(rows.labels_hw))
        for number, value in enumerate(self._values):
            plane = rows.percents_chw[self._channels == value].sum(axis=0, dtype=np.float32) * has_data
            narrow = cv2.resize(plane, (self._size_wh[0], len(plane)), interpolation=cv2.INTER_AREA)
            self._sums[number, first : first + len(weights)] += weights @ narrow

    def _row_weights(self, first: int, count: int) -> tuple[int, np.ndarray]:
        """Return the first grid row that overlaps rows of the image, and (n, count) share of each row in the grid's."""
        step = self._shape_hw[0] / self._size_wh[1]
        begin = int(first / step)
        end = min(int(np.ceil((first + count) / step)), self._size_wh[1])
        edges = np.arange(begin, end + 1) * step
        rows = np.arange(first, first + count)
        inside = np.minimum(edges[1:, None], rows + 1) - np.maximum(edges[:-1, None], rows)
        return begin, (np.maximum(inside, 0) / step).astype(np.float32)

    def found(self) -> ClassShares:
        """Return the shares, once all rows are added."""
        shares = np.rint(np.clip(self._sums / 100, 0, 1) * FULL).astype(np.uint8)
        return ClassShares(self._values, np.ascontiguousarray(np.moveaxis(shares, 0, 2)))
