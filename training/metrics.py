"""How much each class counts, and how well it is found."""

from __future__ import annotations

import numpy as np

from .tiles import IGNORED

RAREST_WEIGHT = 5.0  # a class counts at most so many times as much as one of usual area


def class_weights(pixels: np.ndarray) -> np.ndarray:
    """(K,) weight of each class in the loss: √(usual share / its share), at most RAREST_WEIGHT, 0 where it has none."""
    shares = pixels / max(pixels.sum(), 1)
    present = shares > 0
    weights = np.zeros(len(pixels))
    weights[present] = np.minimum(np.sqrt(np.median(shares[present]) / shares[present]), RAREST_WEIGHT)
    return weights


def confusion_matrix(labels: np.ndarray, predicted: np.ndarray, count: int, sets: int = 0) -> np.ndarray:
    """(count + sets, count) pixels of each label (row) and predicted class (column), IGNORED left out.

    sets: how many labels beyond the classes stand for several of them (partial.py).
    """
    known = labels != IGNORED
    pairs = labels[known].astype(np.int64) * count + predicted[known]
    return np.bincount(pairs, minlength=(count + sets) * count).reshape(count + sets, count)


def intersection_over_union(confusion: np.ndarray, allowed: np.ndarray | None = None) -> np.ndarray:
    """(count,) intersection over union of each class; NaN for a class that has no true pixel.

    confusion: (count + sets, count). allowed: which classes each label allows (partial.py); a pixel of a set counts
    against the classes that it excludes, and not at all for those that it may be.
    """
    count = confusion.shape[1]
    allowed = np.eye(count, dtype=bool) if allowed is None else allowed
    truth = confusion.sum(axis=1)[:count]
    wrongly = np.where(allowed, 0, confusion).sum(axis=0)
    return np.where(truth > 0, np.diag(confusion) / np.maximum(truth + wrongly, 1), np.nan)


def rates(confusion: np.ndarray) -> np.ndarray:
    """(K, K) share of each true class (row) that is predicted as each class; 0 in rows without pixels."""
    return confusion / np.maximum(confusion.sum(axis=1, keepdims=True), 1)
