"""Shares of trials with the interval that their number allows (Wilson 1927)."""

from __future__ import annotations

import math

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


def share(successes: int, trials: int) -> str:
    """“97 % (92–99)”: rate and interval in percent, with a decimal beyond 500 trials."""
    digits = 0 if trials <= 500 else 1
    low, high = wilson(successes, trials)
    return f"{100 * successes / max(trials, 1):.{digits}f} % ({100 * low:.{digits}f}–{100 * high:.{digits}f})"
