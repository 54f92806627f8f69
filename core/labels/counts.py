"""How many pixels each label has."""

from __future__ import annotations

import cv2
import numpy as np

_EXACT = 1 << 24
"""OpenCV's histogram counts in single precision, which is exact up to here."""


def count_labels(labels_hw: np.ndarray) -> np.ndarray:
    """(256,) int64 pixels of each value of (H, W) uint8 labels; many times faster than ``np.bincount``."""
    flat = np.ascontiguousarray(labels_hw).reshape(-1, 1)
    counts = np.zeros(256, np.int64)
    for first in range(0, len(flat), _EXACT):
        part = flat[first : first + _EXACT]
        # (256, 1) until OpenCV 4, (256,) from 5 on.
        counts += cv2.calcHist([part], [0], None, [256], [0, 256]).reshape(-1).astype(np.int64)
    return counts
