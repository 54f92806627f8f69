"""How sure a network may be: the temperature that makes probabilities of its scores, on validation tiles.

Guo et al. 2017, arXiv:1706.04599: scores are divided by one number before their softmax, so that the true classes are
most likely on ground that the network was not trained on.
"""

from __future__ import annotations

from typing import Callable

import numpy as np

MOST_TILES = 100
PIXELS_A_TILE = 4096
"""Neighbors tell the same, so that a few from all over a tile are as good as all."""

SMALLEST, LARGEST = 0.25, 16.0
STEPS = 61
"""Temperatures tried, in even ratios of 1.07."""


def fitted(scores_of: Callable[[np.ndarray], np.ndarray], reader: object) -> float | None:
    """The temperature of least negative log likelihood; None where no tile has known pixels.

    Args:
        scores_of: Image (H, W, 3) to scores (C, H, W).
        reader: Gives images with their true channels by number, has a length.
    """
    pieces = [_sampled(scores_of, *reader(index)) for index in range(min(len(reader), MOST_TILES))]
    scores = np.concatenate([piece for piece, _ in pieces]) if pieces else np.empty((0, 1))
    if not len(scores):
        return None
    truth = np.concatenate([channels for _, channels in pieces])
    tried = np.geomspace(SMALLEST, LARGEST, STEPS)
    return float(tried[np.argmin([loss(scores / temperature, truth) for temperature in tried])])


def loss(scores: np.ndarray, truth: np.ndarray) -> float:
    """Mean negative log likelihood of the true channels (N,) by the softmax of scores (N, C)."""
    highest = scores.max(axis=1, keepdims=True)
    total = np.log(np.exp(scores - highest).sum(axis=1)) + highest[:, 0]
    return float((total - scores[np.arange(len(truth)), truth]).mean())


def _sampled(
    scores_of: Callable[[np.ndarray], np.ndarray], image: np.ndarray, labels: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Scores (N, C) and true channels (N,) of pixels all over a tile whose one class is known."""
    scores = scores_of(image)
    known = np.flatnonzero(labels < len(scores))
    known = known[:: max(1, len(known) // PIXELS_A_TILE)]
    return scores.reshape(len(scores), -1)[:, known].T.astype(np.float64), labels.ravel()[known].astype(int)
