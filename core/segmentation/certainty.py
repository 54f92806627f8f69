"""Certainty of a network: blended scores as percent of each class.

Overlapping tiles are blended in the network's own scores, as for the labels, and converted to probabilities afterwards.
So a label's percent is always the highest, and no seams are visible.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

NO_DATA = 255
"""Percent of a pixel without data."""

SUMS_TO_ONE = 1e-3
"""Scores of a pixel within 0…1 are probabilities if their sum is 1 within this tolerance."""


@dataclass(frozen=True)
class Certainty:
    """Requested outputs in addition to labels.

    Attributes:
        of_label: Percent of each pixel's own class.
        of_each: Percent of every class.
    """

    of_label: bool = False
    of_each: bool = False

    @property
    def is_wanted(self) -> bool:
        """Whether either raster is requested."""
        return self.of_label or self.of_each


LABELS_ALONE = Certainty()

SAMPLED_PX = 16
"""The mean certainty is sampled at one pixel of this many, in one row of this many."""


@dataclass
class Sureness:
    """Mean probability of a network's labels, over sampled pixels.

    Attributes:
        total: Sum of the probabilities.
        count: Number of the pixels.
    """

    total: float = 0.0
    count: int = 0

    def add(self, probabilities: np.ndarray | Sureness) -> None:
        """Add pixels by the probability of their label, or another sum."""
        if isinstance(probabilities, Sureness):
            self.total, self.count = self.total + probabilities.total, self.count + probabilities.count
        else:
            self.total += float(probabilities.sum(dtype=np.float64))
            self.count += probabilities.size

    @property
    def mean(self) -> float | None:
        """Mean, 0…1; None without samples."""
        return self.total / self.count if self.count else None


def are_probabilities(scores: np.ndarray) -> bool:
    """Return whether (N, C, H, W) scores are probabilities already, without a softmax."""
    sums = scores.sum(axis=1, dtype=np.float32)
    return bool((scores >= 0).all() and np.abs(sums - 1).max() <= SUMS_TO_ONE)


def softmax(scores: np.ndarray) -> np.ndarray:
    """Return (C, …) float32 probabilities of (C, …) scores, along the first axis."""
    powers = np.exp(scores - scores.max(axis=0))
    powers /= powers.sum(axis=0)
    return powers


def percents(probabilities: np.ndarray) -> np.ndarray:
    """Return probabilities as uint8 0…100, rounded."""
    return (np.clip(probabilities, 0, 1) * 100 + 0.5).astype(np.uint8)
