"""Label maps with random regions, and the class table of three of their classes."""

from __future__ import annotations

import cv2
import numpy as np

from semref.core.labels.class_table import ClassTable, LandCoverClass

TABLE = ClassTable(
    (
        LandCoverClass(2, "building", "#ff0000", "reference"),
        LandCoverClass(3, "forest", "#00ff00"),
        LandCoverClass(5, "water", "#0000ff", "reference"),
    )
)


def blobs(seed: int, shape_hw: tuple[int, int], values=(0, 2, 3, 5), scale: float = 1.5) -> np.ndarray:
    """Return (H, W) uint8 blobs of all values; `scale` is about their size in pixels."""
    noise = np.random.default_rng(seed).random((len(values), *shape_hw)).astype(np.float32)
    smooth = np.stack([cv2.GaussianBlur(layer, (0, 0), scale) for layer in noise])
    return np.array(values, np.uint8)[smooth.argmax(axis=0)]


def snakes(seed: int, shape_hw: tuple[int, int], values=(2, 5, 9)) -> np.ndarray:
    """Return (H, W) uint8: thin and thick lines across the map over small blobs, which enter a window many times."""
    rng = np.random.default_rng(seed)
    labels = blobs(seed, shape_hw, (0, *values), 1.0)
    for thickness in (1, 1, 1, 2, 3):
        points = np.stack([rng.integers(0, size, 12) for size in shape_hw[::-1]], axis=1).astype(np.int32)
        cv2.polylines(labels, [points], False, int(rng.choice(values)), thickness)
    return labels


def squares(size: int = 400) -> np.ndarray:
    """Return (size, size) uint8: 100 squares of classes 1 and 2 on class 7, with the usual size."""
    labels = np.full((size, size), 7, np.uint8)
    for top in range(10, size - 20, 40):
        for left in range(10, size - 20, 40):
            labels[top : top + 20, left : left + 20] = 1 + (top // 40 + left // 40) % 2
    return labels


def scattered_objects(height: int, width: int, count: int, seed: int, background: int = 4) -> np.ndarray:
    """Return (H, W) uint8 labels: ``count`` separate rectangles of classes 1 to 3 on ``background``."""
    random = np.random.default_rng(seed)
    labels = np.full((height, width), background, np.uint8)
    placed = 0
    while placed < count:
        h, w = random.integers(6, 16, 2)
        row, column = random.integers(1, height - h - 1), random.integers(1, width - w - 1)
        around = labels[row - 1 : row + h + 1, column - 1 : column + w + 1]
        if (around == background).all():
            labels[row : row + h, column : column + w] = random.integers(1, 4)
            placed += 1
    return labels


def patches(random: int | np.random.Generator, shape_hw: tuple[int, int], count: int, first: int = 1) -> np.ndarray:
    """Return (H, W) uint8: ``count`` patches of five classes from ``first`` on, each around a random point."""
    rng = np.random.default_rng(random)
    points = np.full(shape_hw, 255, np.uint8)
    points[rng.integers(0, shape_hw[0], count), rng.integers(0, shape_hw[1], count)] = 0
    _, cells = cv2.distanceTransformWithLabels(points, cv2.DIST_L2, 5, labelType=cv2.DIST_LABEL_PIXEL)
    return rng.integers(first, first + 5, cells.max() + 1).astype(np.uint8)[cells]
