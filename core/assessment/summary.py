"""What the trials of an assessment say about it: success by landmarks, and whether predicted success came true."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..evaluation.rates import RateAt, binned
from ..evaluation.trial import Trial

LANDMARK_BINS = (0, 3, 6, 10, 15, 20, 40, 80)
"""Whole landmarks in view, from each number to the next, the last without end."""

PROBABILITY_BINS = tuple(np.linspace(0, 1, 11).tolist())


def success_by_landmarks(trials: Sequence[Trial]) -> list[RateAt]:
    """Right fixes of simulated images by the landmarks in view."""
    counted = [(t.landmarks, t.is_right) for t in trials if t.landmarks is not None]
    return binned([count for count, _ in counted], [right for _, right in counted], (*LANDMARK_BINS, np.inf))


def calibration(predicted: np.ndarray, right: np.ndarray) -> list[RateAt]:
    """Right ones among images by their predicted success (n,) 0…1; NaN is left out."""
    known = np.isfinite(predicted)
    return binned(predicted[known], np.asarray(right, bool)[known], PROBABILITY_BINS)


def brier_score(predicted: np.ndarray, right: np.ndarray) -> float | None:
    """Mean squared difference of predicted success and what came of it (1 right, 0 not); None without predictions."""
    known = np.isfinite(predicted)
    if not known.any():
        return None
    return float(((predicted[known] - np.asarray(right, float)[known]) ** 2).mean())
