"""The label map reduced: most frequent class of every block, as stored in a database's ``overview`` (DESIGN §5)."""

from __future__ import annotations

import cv2
import numpy as np

OVERVIEW_FACTOR = 4
"""Default reduction; 300 km² at 1 m become 4 m pixels."""


def most_frequent_labels(labels_hw: np.ndarray, factor: int = OVERVIEW_FACTOR) -> np.ndarray:
    """(⌈H/f⌉, ⌈W/f⌉) uint8: the most frequent label of each f × f block; of equally frequent ones the smallest.

    Blocks that stick out over the right and lower edge count the pixels they have.
    """
    height, width = labels_hw.shape
    padded = cv2.copyMakeBorder(labels_hw, 0, -height % factor, 0, -width % factor, cv2.BORDER_REPLICATE)
    size = padded.shape[1] // factor, padded.shape[0] // factor
    best = np.zeros(size[::-1], np.float32)
    reduced = np.zeros(size[::-1], np.uint8)
    for value in np.flatnonzero(np.bincount(padded.ravel(), minlength=1)):
        mask = cv2.compare(padded, float(value), cv2.CMP_EQ).astype(np.float32)
        share = cv2.resize(mask, size, interpolation=cv2.INTER_AREA)
        # Shares are multiples of 1/f²; half of one keeps rounding from deciding.
        more = share > best + 0.5 * 255 / factor**2
        reduced[more] = value
        best[more] = share[more]
    return reduced
