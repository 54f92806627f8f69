"""Class weights, confusion matrices, IoU, temperature, and labels of ground where only some classes were drawn.

If only buildings were drawn in a place, its other ground is known to be no building. Such ground gets an extra label
for the set of channels that it may have. The loss uses the network's total probability of the set (the “marginal”
loss of Shi et al. 2021, arXiv:2007.03868). A road is thus not wrong where no roads were drawn.
"""

from __future__ import annotations

from pathlib import Path
from typing import Callable

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
        sets: Number of labels after the classes that allow several classes (``partial_labels``).
    """
    known = labels != IGNORED
    pairs = labels[known].astype(np.int64) * count + predicted[known]
    return np.bincount(pairs, minlength=(count + sets) * count).reshape(count + sets, count)


def intersection_over_union(confusion: np.ndarray, allowed: np.ndarray | None = None) -> np.ndarray:
    """Return (count,) intersection over union of each class; NaN for a class without true pixels.

    Args:
        confusion: (count + sets, count) pixels.
        allowed: (count + sets, count) bool of the classes that each label allows, see ``partial_labels``. A pixel of a
            set counts as wrong for the classes that it excludes, and does not count for the others.
    """
    count = confusion.shape[1]
    allowed = np.eye(count, dtype=bool) if allowed is None else allowed
    truth = confusion.sum(axis=1)[:count]
    wrongly = np.where(allowed, 0, confusion).sum(axis=0)
    return np.where(truth > 0, np.diag(confusion) / np.maximum(truth + wrongly, 1), np.nan)


def rates(confusion: np.ndarray) -> np.ndarray:
    """Return (K, K) shares of each true class (row) by predicted class; 0 in rows without pixels."""
    return confusion / np.maximum(confusion.sum(axis=1, keepdims=True), 1)


def partial_labels(count: int, excluded: dict[Path, list[int]]) -> tuple[np.ndarray, dict[Path, int]]:
    """Return the channels that each label allows, and the label of each folder's unlabeled ground.

    Channel 0 means unlabeled. No set contains it: otherwise ground that differs from the other places would become
    unlabeled.

    Args:
        excluded: By folder of tiles, the channels that its unlabeled ground can't have.

    Returns:
        (count + S, count) bool: a channel allows itself, a set all channels except 0 and the excluded ones. And the
        number of the set by folder, IGNORED for an empty set.
    """
    kept = {path: tuple(sorted(set(range(1, count)) - set(channels))) for path, channels in excluded.items()}
    sets = sorted({channels for channels in kept.values() if channels})
    allowed = np.zeros((count + len(sets), count), bool)
    allowed[:count] = np.eye(count, dtype=bool)
    for row, channels in zip(allowed[count:], sets):
        row[list(channels)] = True
    return allowed, {path: count + sets.index(one) if one else IGNORED for path, one in kept.items()}


def decided_channels(allowed):
    """Return (count + S, count) bool of the channels that a label decides: all, or those that a set excludes.

    ``allowed``: first result of ``partial_labels``, also as a tensor.
    """
    decided = ~allowed
    decided[: allowed.shape[1]] = True
    return decided


MOST_TILES = 100
PIXELS_A_TILE = 4096
"""Sampled pixels per tile; neighboring pixels give no more information."""

SMALLEST, LARGEST = 0.25, 16.0
STEPS = 61
"""Number of tested temperatures, with a constant ratio of 1.07."""

UNTESTED = 2.0
"""Temperature of a network without validation tiles. After 2.5 to 5 minutes of training on few photos of two places,
validation tiles gave 1.3 to 4.9."""


def fit_temperature(scores_of: Callable[[np.ndarray], np.ndarray], reader: object) -> float:
    """Return the temperature of the smallest negative log likelihood; UNTESTED without known pixels.

    Scores are divided by the temperature before the softmax, to convert them to probabilities (Guo et al. 2017,
    arXiv:1706.04599).

    Args:
        scores_of: Function from image (H, W, 3) to scores (C, H, W).
        reader: Sequence of images with their true channels.
    """
    pieces = [_sample(scores_of, *reader(index)) for index in range(min(len(reader), MOST_TILES))]
    scores = np.concatenate([piece for piece, _ in pieces]) if pieces else np.empty((0, 1))
    if not len(scores):
        return UNTESTED
    truth = np.concatenate([channels for _, channels in pieces])
    tried = np.geomspace(SMALLEST, LARGEST, STEPS)
    return float(tried[np.argmin([loss(scores / temperature, truth) for temperature in tried])])


def loss(scores: np.ndarray, truth: np.ndarray) -> float:
    """Return the mean negative log likelihood of the true channels (N,) for the softmax of scores (N, C)."""
    highest = scores.max(axis=1, keepdims=True)
    total = np.log(np.exp(scores - highest).sum(axis=1)) + highest[:, 0]
    return float((total - scores[np.arange(len(truth)), truth]).mean())


def _sample(
    scores_of: Callable[[np.ndarray], np.ndarray], image: np.ndarray, labels: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return scores (N, C) and true channels (N,) of sampled pixels with one known class."""
    scores = scores_of(image)
    known = np.flatnonzero(labels < len(scores))
    known = known[:: max(1, len(known) // PIXELS_A_TILE)]
    return scores.reshape(len(scores), -1)[:, known].T.astype(np.float64), labels.ravel()[known].astype(int)
