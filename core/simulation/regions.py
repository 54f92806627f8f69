"""Regions of label images for simulated errors: find, remove and redraw them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from ..landmarks.landmarks import class_mask


@dataclass(frozen=True)
class ClassRegion:
    """A connected region of one class.

    Attributes:
        box: Bounding box as slices (rows, columns).
        mask: (h, w) bool, its pixels in the box.
    """

    value: int
    area_px: int
    box: tuple[slice, slice]
    mask: np.ndarray


def regions_of(labels_hw: np.ndarray, class_values: Sequence[int], minimum_area_px: float) -> list[ClassRegion]:
    """Return the regions of some classes, class after class, from a least area on."""
    found = []
    for value in class_values:
        _, numbers, stats, _ = cv2.connectedComponentsWithStats(class_mask(labels_hw, value))
        for number in range(1, len(stats)):
            left, top, width, height, area = stats[number]
            if area >= minimum_area_px:
                box = (slice(top, top + height), slice(left, left + width))
                found.append(ClassRegion(int(value), int(area), box, numbers[box] == number))
    return found


def nearest_zero(image_hw: np.ndarray) -> np.ndarray:
    """Return (H, W) int: index of the nearest zero pixel of ``image_hw``, counted from 0 by rows."""
    _, index = cv2.distanceTransformWithLabels(image_hw, cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL)
    return index - 1


def fill_from_around(labels_hw: np.ndarray, lost: np.ndarray, sources: np.ndarray) -> np.ndarray:
    """Return labels with ``lost`` pixels filled from the nearest pixel of ``sources`` (both (H, W) bool)."""
    sources = sources & ~lost
    if not lost.any() or not sources.any():
        return labels_hw
    index = nearest_zero((~sources).astype(np.uint8))
    labels_of = np.zeros(index.max() + 1, np.uint8)
    labels_of[index[sources]] = labels_hw[sources]
    filled = labels_hw.copy()
    filled[lost] = labels_of[index[lost]]
    return filled
