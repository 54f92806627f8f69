"""The published method, written directly from the paper with numpy and OpenCV, as a reference for speed and vectors.

It computes one window at a time, shares nothing between windows, and imports nothing from the plugin.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import cv2
import numpy as np

KEPT = 10  # X of the paper
FEWEST = 3


def regions(labels_hw: np.ndarray, classes: Sequence[int], minimum_area: float) -> tuple[np.ndarray, np.ndarray]:
    """Return centers of gravity (N, 2) and ranks 1, 2, … (N,) of the regions of an image (paper §2.2.2 (2))."""
    centers, ranks = [], []
    for rank, value in enumerate(sorted(classes), start=1):
        mask = (labels_hw == value).view(np.uint8)
        contours, hierarchy = cv2.findContours(mask, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_SIMPLE)
        for number, contour in enumerate(contours):
            if hierarchy[0, number, 3] >= 0:
                continue  # the boundary of a hole
            if cv2.contourArea(contour) < minimum_area:
                continue
            moments = cv2.moments(contour)
            # OpenCV's origin is the center of the first pixel.
            centers.append((moments["m10"] / moments["m00"] + 0.5, moments["m01"] / moments["m00"] + 0.5))
            ranks.append(rank)
    return np.array(centers).reshape(-1, 2), np.array(ranks)


def vector(centers: np.ndarray, ranks: np.ndarray, middle: Sequence[float], class_count: int) -> np.ndarray | None:
    """Return distance ratios, angle differences and labels (paper Eq. 1–4); None for fewer than three regions."""
    if len(centers) < FEWEST:
        return None
    dx, dy = centers[:, 0] - middle[0], centers[:, 1] - middle[1]
    distance = np.sqrt(dx**2 + dy**2)
    nearest = np.argsort(distance, kind="stable")[:KEPT]
    distance, rank = distance[nearest], ranks[nearest]
    angle = np.degrees(np.arctan2(dy[nearest], dx[nearest]))
    angle[angle < 0] += 360
    order = np.argsort(angle, kind="stable")
    order = np.roll(order, -int(np.argmax(distance[order])))
    difference = (np.roll(angle[order], -1) - angle[order]) % 360
    rows = np.zeros((3, KEPT), np.float32)
    rows[0, : len(order)] = distance[order] / distance.max()
    rows[1, : len(order)] = difference / difference.max()
    rows[2, : len(order)] = rank[order] / class_count
    return rows.ravel()


def windows(
    labels_hw: np.ndarray, firsts: Iterable[Sequence[int]], size: int, classes: Sequence[int], minimum_area: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return vectors (M, 30), zero if missing, and numbers of regions (M,) of windows given by (column, row)."""
    vectors, counts = [], []
    for column, row in firsts:
        centers, ranks = regions(labels_hw[row : row + size, column : column + size], classes, minimum_area)
        found = vector(centers, ranks, (size / 2, size / 2), len(classes))
        vectors.append(np.zeros(3 * KEPT, np.float32) if found is None else found)
        counts.append(len(ranks))
    return np.array(vectors), np.array(counts)
