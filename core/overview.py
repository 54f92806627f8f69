"""The label map reduced: most frequent class of every block, as stored in a database's ``overview`` (DESIGN §5)."""

from __future__ import annotations

import cv2
import numpy as np

from .label_counts import count_labels

OVERVIEW_FACTOR = 4
"""Default reduction; 300 km² at 1 m become 4 m pixels."""


def most_frequent_labels(labels_hw: np.ndarray, factor: int = OVERVIEW_FACTOR) -> np.ndarray:
    """(⌈H/f⌉, ⌈W/f⌉) uint8: the most frequent label of each f × f block; of equally frequent ones the smallest.

    Blocks that stick out over the right and lower edge count the pixels they have.
    """
    height, width = labels_hw.shape
    size = -(-width // factor), -(-height // factor)
    # The mean of f² where the label is right and 0 elsewhere is the count, exactly, as long as f² fits into 8 bits.
    weight = factor**2 if factor**2 <= 255 else 1
    kind = np.uint8 if factor**2 <= 255 else np.float32
    best = np.zeros(size[::-1], kind)
    reduced = np.zeros(size[::-1], np.uint8)
    present = count_labels(labels_hw)
    for value in np.flatnonzero(present):
        table = np.zeros(256, kind)
        table[value] = weight
        # Beyond the edges nothing counts for any label.
        weights = cv2.copyMakeBorder(
            cv2.LUT(labels_hw, table), 0, -height % factor, 0, -width % factor, cv2.BORDER_CONSTANT, value=0
        )
        share = cv2.resize(weights, size, interpolation=cv2.INTER_AREA)
        more = share > best
        reduced[more] = value
        best[more] = share[more]
    return reduced
