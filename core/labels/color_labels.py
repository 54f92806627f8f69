"""Decode color label images to class values (paper §2.2.2 (2))."""

from __future__ import annotations

import cv2
import numpy as np

from ..errors import ClassTableError
from .class_table import UNLABELED, ClassTable


def decode_colors(image_bgr: np.ndarray, table: ClassTable) -> np.ndarray:
    """Decode by HSV ranges if the table has any, otherwise by nearest color."""
    if any(c.hsv_min is not None for c in table):
        return decode_by_hsv(image_bgr, table)
    return decode_by_nearest_color(image_bgr, table)


def decode_by_hsv(image_bgr: np.ndarray, table: ClassTable) -> np.ndarray:
    """Decode by each class's HSV range, as published; where ranges overlap, the class with the lower value counts.

    ``image_bgr``: (H, W, 3) uint8, blue first. Returns (H, W) uint8; 0 where no range matches.
    Raises ClassTableError when no class has an HSV range.
    """
    with_range = [(c.value, c.hsv_min, c.hsv_max) for c in table if c.hsv_min is not None and c.hsv_max is not None]
    if not with_range:
        raise ClassTableError(
            "No class has hsv_min and hsv_max; add both to the class table, or decode by nearest color."
        )
    hsv = cv2.cvtColor(np.ascontiguousarray(image_bgr), cv2.COLOR_BGR2HSV)
    labels_hw = np.full(hsv.shape[:2], UNLABELED, np.uint8)
    for value, low, high in reversed(with_range):
        labels_hw[_in_hsv_range(hsv, low, high)] = value
    return labels_hw


def decode_by_nearest_color(image_bgr: np.ndarray, table: ClassTable) -> np.ndarray:
    """Decode by the nearest class color in RGB; black means unlabeled unless a class is black.

    ``image_bgr``: (H, W, 3) uint8, blue first. Returns (H, W) uint8.
    """
    values = [c.value for c in table]
    colors = [c.rgb for c in table]
    if UNLABELED not in values and (0, 0, 0) not in colors:
        values.append(UNLABELED)
        colors.append((0, 0, 0))
    best = np.full(image_bgr.shape[:2], np.iinfo(np.int32).max, np.int32)
    labels_hw = np.zeros(image_bgr.shape[:2], np.uint8)
    pixels = image_bgr.astype(np.int32)
    for value, (red, green, blue) in zip(values, colors):
        distance = (pixels[..., 0] - blue) ** 2 + (pixels[..., 1] - green) ** 2 + (pixels[..., 2] - red) ** 2
        nearer = distance < best
        best[nearer] = distance[nearer]
        labels_hw[nearer] = value
    return labels_hw


def _in_hsv_range(hsv: np.ndarray, low: tuple[int, int, int], high: tuple[int, int, int]) -> np.ndarray:
    if low[0] <= high[0]:
        return cv2.inRange(hsv, low, high) > 0
    # Hue is circular: red continues from 180 to 0.
    upper = cv2.inRange(hsv, low, (180, high[1], high[2]))
    lower = cv2.inRange(hsv, (0, low[1], low[2]), high)
    return (upper | lower) > 0
