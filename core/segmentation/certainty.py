"""How sure a network is: blended scores to percent of each class.

Overlapping tiles are blended in the network's own scores, as for the labels, and made probabilities after that: a
label's percent is then the highest, and seams show in neither.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

NO_DATA = 255
"""Percent of a pixel that was not looked at."""

SUMS_TO_ONE = 1e-3
"""Scores of a pixel that lie in 0…1 and add up to 1 as closely as this are probabilities already."""


@dataclass(frozen=True)
class Certainty:
    """What is wanted beside labels.

    Attributes:
        of_label: Percent of the class that a pixel has.
        of_each: Percent of every class.
    """

    of_label: bool = False
    of_each: bool = False

    @property
    def is_wanted(self) -> bool:
        """Whether a raster of either kind is written."""
        return self.of_label or self.of_each


LABELS_ALONE = Certainty()

SAMPLED_PX = 16
"""How sure a network is on the average is told by every so many pixels of every so many rows."""


@dataclass
class Sureness:
    """How probable a network takes its labels to be, as a mean over pixels that were looked at.

    Attributes:
        total: Sum of the probabilities.
        count: Of the pixels.
    """

    total: float = 0.0
    count: int = 0

    def add(self, probabilities: np.ndarray | Sureness) -> None:
        """Add pixels by the probability of their label, or what is known of others."""
        if isinstance(probabilities, Sureness):
            self.total, self.count = self.total + probabilities.total, self.count + probabilities.count
        else:
            self.total += float(probabilities.sum(dtype=np.float64))
            self.count += probabilities.size

    @property
    def mean(self) -> float | None:
        """0…1; None where nothing was looked at."""
        return self.total / self.count if self.count else None


def are_probabilities(scores: np.ndarray) -> bool:
    """Return whether (N, C, H, W) scores are probabilities as they are, not yet through a softmax."""
    sums = scores.sum(axis=1, dtype=np.float32)
    return bool((scores >= 0).all() and np.abs(sums - 1).max() <= SUMS_TO_ONE)


def softmax(scores: np.ndarray) -> np.ndarray:
    """Return (C, …) float32 probabilities of (C, …) scores, along the first axis."""
    powers = np.exp(scores - scores.max(axis=0))
    powers /= powers.sum(axis=0)
    return powers


def percents(probabilities: np.ndarray) -> np.ndarray:
    """Uint8 0…100 of probabilities, rounded."""
    return (np.clip(probabilities, 0, 1) * 100 + 0.5).astype(np.uint8)
