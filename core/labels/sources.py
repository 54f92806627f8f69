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


class PartOfMap:
    """A piece of a label map as a map of its own; it lies wholly on the map."""

    def __init__(self, source: LabelSource, column: int, row: int, width: int, height: int) -> None:
        """Reads nothing yet.

        Args:
            source: The whole map.
            column: First column of the piece.
            row: First row of the piece.
            width: Of the piece, pixels.
            height: Of the piece, pixels.
        """
        self._source = source
        self._column = column
        self._row = row
        self._shape_hw = height, width

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) in pixels."""
        return self._shape_hw

    def read(self, column: int, row: int, width: int, height: int) -> np.ndarray:
        """(height, width) uint8 labels, counted from the piece's first pixel."""
        return self._source.read(self._column + column, self._row + row, width, height)


class RollingRows:
    """Rows of a map read once each while a strip moves down: ``strip(row)`` is a view of ``height`` rows.

    Rows are fetched in chunks and the buffer holds at most ``height`` + one chunk, whatever the map's size.
    """

    def __init__(self, source: LabelSource, column: int, width: int, height: int) -> None:
        """Reads nothing yet.

        Args:
            source: The map.
            column: First column of the strip.
            width: Of the strip, pixels.
            height: Of the strip, pixels.
        """
        self._source = source
        self._column = column
        self._height = height
        self._map_height = source.shape_hw[0]
        self._capacity = min(height + max(height // 2, 256), self._map_height)
        self._buffer = np.empty((self._capacity, width), np.uint8)
        self._first = 0
        self._end = 0

    def strip(self, row: int) -> np.ndarray:
        """(height, width) uint8 labels from ``row`` on; ``row`` may only grow from call to call."""
        needed = row + self._height
        if needed > self._end:
            kept = max(0, self._end - row)
            self._buffer[:kept] = self._buffer[row - self._first : self._end - self._first].copy() if kept else 0
            self._first = row
            start = row + kept
            stop = min(row + self._capacity, self._map_height)
            width = self._buffer.shape[1]
            self._buffer[kept : stop - row] = self._source.read(self._column, start, width, stop - start)
            self._end = stop
        return self._buffer[row - self._first : row - self._first + self._height]
