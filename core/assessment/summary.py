"""What the trials of an assessment say about it: success by landmarks, and whether predicted success came true."""

from __future__ import annotations

from typing import List, Optional, Sequence

import numpy as np

from ..evaluation.rates import rate_of
from ..evaluation.summary import RateAt
from .images import SimulatedFix

LANDMARK_BINS = (0, 3, 6, 10, 15, 20, 40, 80)
"""Whole landmarks in view, from each number to the next, the last without end."""

PROBABILITY_BINS = tuple(np.linspace(0, 1, 11).tolist())


def binned(values: np.ndarray, right: np.ndarray, edges: Sequence[float]) -> List[RateAt]:
    """A rate for each bin that has values; values (n,), right (n,) bool; the last bin includes its end."""
    edges = np.asarray(edges, float)
    numbers = np.clip(np.searchsorted(edges, values, side="right") - 1, 0, len(edges) - 2)
    found = []
    for number in np.unique(numbers):
        inside = numbers == number
        rate = rate_of(right[inside].tolist())
        found.append(RateAt(float(values[inside].mean()), float(edges[number]), float(edges[number + 1]), rate))
    return found


def success_by_landmarks(fixes: Sequence[SimulatedFix]) -> List[RateAt]:
    """Right fixes of simulated images by the landmarks in view."""
    values = np.array([fix.objects for fix in fixes], float)
    return binned(values, np.array([fix.right for fix in fixes], bool), (*LANDMARK_BINS, np.inf))


def calibration(predicted: np.ndarray, right: np.ndarray) -> List[RateAt]:
    """Right ones among images by their predicted success (n,) 0…1; NaN is left out."""
    known = np.isfinite(predicted)
    return binned(predicted[known], np.asarray(right, bool)[known], PROBABILITY_BINS)


def brier_score(predicted: np.ndarray, right: np.ndarray) -> Optional[float]:
    """Mean squared difference of predicted success and what came of it (1 right, 0 not); None without predictions."""
    known = np.isfinite(predicted)
    if not known.any():
        return None
    return float(((predicted[known] - np.asarray(right, float)[known]) ** 2).mean())
