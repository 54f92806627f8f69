"""Shares of trials as the pages show them."""

from __future__ import annotations


def share(successes: int, trials: int) -> str:
    """“97 % (92–99)”: rate and interval in percent, with a decimal beyond 500 trials."""
    from semref.core.evaluation.rates import wilson

    digits = 0 if trials <= 500 else 1
    low, high = wilson(successes, trials)
    return f"{100 * successes / max(trials, 1):.{digits}f} % ({100 * low:.{digits}f}–{100 * high:.{digits}f})"
