"""Overview of a label map: the most frequent class of every block, as stored in a database's ``overview``.

See docs/reference/file_formats.md#reference-database.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager

import cv2
import numpy as np

from .sources import count_labels

OVERVIEW_FACTOR = 4
"""Default reduction: 1 m pixels become 4 m pixels."""

OverviewSink = Callable[[int, int, np.ndarray], None]
"""Takes the column and row of a piece of the overview, and the piece (h, w) uint8."""


class HeldOverview(AbstractContextManager):
    """An overview in memory: accepts pieces in any order; ``labels`` (h, w) is the whole."""

    def __init__(self, shape_hw: tuple[int, int]) -> None:
        self.labels = np.zeros(shape_hw, np.uint8)

    def __exit__(self, *_: object) -> None:
        """Do nothing: there is no file to close."""

    def put(self, column: int, row: int, piece_hw: np.ndarray) -> None:
        """Store a piece (h, w) uint8 with its first pixel at (column, row)."""
        self.labels[row : row + piece_hw.shape[0], column : column + piece_hw.shape[1]] = piece_hw


_WORD = 0x01010101
"""Multiplied by a label: four pixels of that label as one 32-bit word."""


def most_frequent_labels(labels_hw: np.ndarray, factor: int = OVERVIEW_FACTOR) -> np.ndarray:
    """Return (⌈H/f⌉, ⌈W/f⌉) uint8: the most frequent label of each f × f block, the smallest of equally frequent ones.

    Blocks that extend beyond the right and lower edge count their existing pixels.
    """
    height, width = labels_hw.shape
    if factor != 4 or height < 4 or width < 4:
        return _by_counting(labels_hw, factor)
    rows, columns = height // 4 * 4, width // 4 * 4
    reduced = np.empty((-(-height // 4), -(-width // 4)), np.uint8)
    reduced[: rows // 4, : columns // 4] = _four_by_four(labels_hw[:rows, :columns])
    if columns < width:
        reduced[:, columns // 4 :] = _by_counting(labels_hw[:, columns:], 4)
    if rows < height:
        reduced[rows // 4 :] = _by_counting(labels_hw[rows:], 4)
    return reduced


def _four_by_four(labels_hw: np.ndarray) -> np.ndarray:
    """Reduce whole 4 × 4 blocks: most have one label, visible in four words of four pixels; only others are counted."""
    words = np.ascontiguousarray(labels_hw).view(np.uint32)
    first = words[0::4]
    reduced = (first & 0xFF).astype(np.uint8)
    one_label = first == reduced * np.uint32(_WORD)
    for row in (1, 2, 3):
        one_label &= words[row::4] == first
    mixed_rows, mixed_columns = np.nonzero(~one_label)
    if len(mixed_rows):
        blocks = np.stack([words[4 * mixed_rows + row, mixed_columns] for row in range(4)], axis=1)
        pixels = blocks.view(np.uint8)
        best = np.zeros(len(pixels), np.uint8)
        chosen = np.zeros(len(pixels), np.uint8)
        for value in np.flatnonzero(count_labels(pixels)):
            count = (pixels == np.uint8(value)).sum(axis=1, dtype=np.uint8)
            more = count > best
            chosen[more] = value
            best[more] = count[more]
        reduced[mixed_rows, mixed_columns] = chosen
    return reduced


def _by_counting(labels_hw: np.ndarray, factor: int) -> np.ndarray:
    height, width = labels_hw.shape
    size = -(-width // factor), -(-height // factor)
    # The mean of f² where the label matches and 0 elsewhere is the count, exactly, as long as f² fits into 8 bits.
    weight = factor**2 if factor**2 <= 255 else 1
    kind = np.uint8 if factor**2 <= 255 else np.float32
    best = np.zeros(size[::-1], kind)
    reduced = np.zeros(size[::-1], np.uint8)
    present = count_labels(labels_hw)
    for value in np.flatnonzero(present):
        table = np.zeros(256, kind)
        table[value] = weight
        # Pixels beyond the edges count for no label.
        weights = cv2.copyMakeBorder(
            cv2.LUT(labels_hw, table), 0, -height % factor, 0, -width % factor, cv2.BORDER_CONSTANT, value=0
        )
        share = cv2.resize(weights, size, interpolation=cv2.INTER_AREA)
        more = share > best
        reduced[more] = value
        best[more] = share[more]
    return reduced
