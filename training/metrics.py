"""Class weights, confusion matrices and IoU."""

from __future__ import annotations

import numpy as np

from .tiles import IGNORED

RAREST_WEIGHT = 5.0  # largest weight of a class relative to a class of median area


def class_weights(pixels: np.ndarray) -> np.ndarray:
    """Return (K,) loss weights: √(median share / share of the class), at most RAREST_WEIGHT, 0 without pixels."""
    shares = pixels / max(pixels.sum(), 1)
    present = shares > 0
    weights = np.zeros(len(pixels))
    weights[present] = np.minimum(np.sqrt(np.median(shares[present]) / shares[present]), RAREST_WEIGHT)
    return weights


def confusion_matrix(labels: np.ndarray, predicted: np.ndarray, count: int, sets: int = 0) -> np.ndarray:
    """Return (count + sets, count) pixels of each label (row) and predicted class (column) without IGNORED.

    Args:
        predicted: Predicted classes, of the same shape.
        sets: Number of labels after the classes that allow several classes (partial.py).
    """
    known = labels != IGNORED
    pairs = labels[known].astype(np.int64) * count + predicted[known]
    return np.bincount(pairs, minlength=(count + sets) * count).reshape(count + sets, count)


def intersection_over_union(confusion: np.ndarray, allowed: np.ndarray | None = None) -> np.ndarray:
    """Return (count,) intersection over union of each class; NaN for a class without true pixels.

    Args:
        confusion: (count + sets, count) pixels.
        allowed: (count + sets, count) bool of the classes that each label allows (partial.py). A pixel of a set counts
            as wrong for the classes that it excludes, and does not count for the others.
    """
    count = confusion.shape[1]
    allowed = np.eye(count, dtype=bool) if allowed is None else allowed
    truth = confusion.sum(axis=1)[:count]
    wrongly = np.where(allowed, 0, confusion).sum(axis=0)
    return np.where(truth > 0, np.diag(confusion) / np.maximum(truth + wrongly, 1), np.nan)


def rates(confusion: np.ndarray) -> np.ndarray:
    """Return (K, K) shares of each true class (row) by predicted class; 0 in rows without pixels."""
    return confusion / np.maximum(confusion.sum(axis=1, keepdims=True), 1)
