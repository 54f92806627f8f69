"""Where labels come from, piece by piece, so that a map never has to fit into memory."""

from __future__ import annotations

from typing import Protocol

import numpy as np


class LabelSource(Protocol):
    """A label map that is read in pieces; rasters on disk implement it outside ``core``."""

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) in pixels."""

    def read(self, column: int, row: int, width: int, height: int) -> np.ndarray:
        """(height, width) uint8 labels, not to be changed; the piece lies wholly on the map."""


class ArrayLabels:
    """A label map in memory."""

    def __init__(self, labels_hw: np.ndarray) -> None:
        """Keeps the labels, without a copy.

        Args:
            labels_hw: (H, W) uint8 labels.
        """
        self._labels_hw = labels_hw

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) in pixels."""
        return self._labels_hw.shape[0], self._labels_hw.shape[1]

    def read(self, column: int, row: int, width: int, height: int) -> np.ndarray:
        """A view of a piece of the labels."""
        return self._labels_hw[row : row + height, column : column + width]
