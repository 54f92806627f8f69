"""Shares of classes in each coarse pixel of an image, from a network's scores instead of the best class only."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

import numpy as np

from ..geometry.error_settings import UNBIASED, KnownBiases
from .class_table import UNLABELED

FULL = 255
"""A share of 1 in 8 bits."""


@dataclass(frozen=True)
class ClassShares:
    """Probable shares of classes on a grid that covers an image.

    Attributes:
        values: (K,) uint8 class values, without 0.
        shares: (h, w, K) uint8 share of each pixel of the grid (``FULL`` = all of it); the remainder is unknown.
        picture: (h, w, 3) uint8 of the photo on the same grid, red first; None without a photo.
    """

    values: np.ndarray
    shares: np.ndarray
    picture: np.ndarray | None = None

    def of(self, values: np.ndarray) -> np.ndarray:
        """Return (h, w, N) uint8 shares of N classes: 0 for absent ones, the remainder for value 0 (unlabeled)."""
        found = np.zeros((*self.shares.shape[:2], len(values)), np.uint8)
        for number, value in enumerate(values):
            column = np.flatnonzero(self.values == value)
            if len(column):
                found[..., number] = self.shares[..., column[0]]
            elif value == UNLABELED:
                others = self.shares[..., np.isin(self.values, values)]
                found[..., number] = FULL - np.minimum(others.sum(axis=-1, dtype=np.int64), FULL)
        return found


@dataclass(frozen=True)
class SeenLabels:
    """Labels of an image, with what is known about them.

    Attributes:
        labels_hw: (H, W) uint8 labels.
        shares: Only for photos.
        trained_on: Places that the network of a photo was trained on, empty if unknown; None for label images.
        pixels: (H, W, 3) uint8 of the photo, red first, and (H, W) bool of pixels with data (None: everywhere); None
            if not requested.
        look_again: Labels a photo again, more thoroughly; None if that is not wanted.
    """

    labels_hw: np.ndarray
    shares: ClassShares | None = None
    trained_on: tuple[str, ...] | None = None
    biases: KnownBiases = UNBIASED
    pixels: tuple[np.ndarray, np.ndarray | None] | None = None
    look_again: Callable[[], SeenLabels] | None = None
