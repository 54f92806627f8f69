"""Rates of trials with their confidence interval (Wilson 1927), also in bins."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

Z_95 = 1.959964
"""Two-sided 95 % quantile of the normal distribution."""


def wilson(successes: int, trials: int) -> tuple[float, float]:
    """Return the 95 % interval of a rate, (low, high) in 0…1; (0, 1) without trials."""
    if trials == 0:
        return 0.0, 1.0
    rate, square = successes / trials, Z_95**2
    middle = (rate + square / (2 * trials)) / (1 + square / trials)
    half = Z_95 * math.sqrt(rate * (1 - rate) / trials + square / (4 * trials**2)) / (1 + square / trials)
    return max(0.0, middle - half), min(1.0, middle + half)


@dataclass(frozen=True)
class Rate:
    """Successes out of trials."""

    successes: int
    trials: int

    @property
    def share(self) -> float | None:
        """0…1; None without trials."""
        return self.successes / self.trials if self.trials else None

    @property
    def interval(self) -> tuple[float, float]:
        """The 95 % interval of the share."""
        return wilson(self.successes, self.trials)


@dataclass(frozen=True)
class RateAt:
    """A rate of trials in a bin.

    Attributes:
        at: Mean of the values.
        low: Start of the bin.
        high: End of the bin.
    """

    at: float
    low: float
    high: float
    rate: Rate


def rate_of(successes: Iterable[bool]) -> Rate:
    """Return the rate of True among the trials."""
    found = [bool(success) for success in successes]
    return Rate(sum(found), len(found))


def binned(values: Sequence[float], successes: Sequence[bool], edges: Sequence[float]) -> list[RateAt]:
    """Return one rate for each bin with values, in the order of the bins.

    Args:
        values: (n,) that assign trials to bins.
        successes: (n,) whether each trial succeeded.
        edges: Of the bins, ascending; the last bin includes its end and values beyond it.
    """
    at, hits = np.asarray(values, float), np.asarray(successes, bool)
    numbers = np.clip(np.searchsorted(edges, at, side="right") - 1, 0, len(edges) - 2)
    return [
        RateAt(
            float(at[numbers == number].mean()),
            float(edges[number]),
            float(edges[number + 1]),
            rate_of(hits[numbers == number].tolist()),
        )
        for number in np.unique(numbers)
    ]
