"""Shares of trials with the interval that their number allows (Wilson 1927), also bin by bin."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

Z_95 = 1.959964
"""Two-sided 95 % quantile of the normal distribution."""


def wilson(successes: int, trials: int) -> tuple[float, float]:
    """95 % interval of a rate, (low, high) in 0…1; (0, 1) without trials."""
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
    """A rate of trials whose value lies in a bin.

    Attributes:
        at: mean of the values
        low: the bin's beginning
        high: its end
        rate: of the trials in it
    """

    at: float
    low: float
    high: float
    rate: Rate


def rate_of(successes: Iterable[bool]) -> Rate:
    """The rate of True among the trials."""
    found = [bool(success) for success in successes]
    return Rate(sum(found), len(found))


def binned(values: Sequence[float], successes: Sequence[bool], edges: Sequence[float]) -> list[RateAt]:
    """One rate for each bin that has values.

    Args:
        values: (n,) what the trials are sorted by
        successes: (n,) whether each was one
        edges: ends of the bins, rising; the last bin includes its end, and takes what lies beyond

    Returns:
        The rates, in the order of the bins.
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
