"""Fair comparison of running times: candidates take turns within one run, and each turn gives one ratio."""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable, Sequence


def take_turns(candidates: dict[str, Callable[[], float | None]], repetitions: int) -> dict[str, list[float]]:
    """Runs all candidates one after another, ``repetitions`` times; gives the seconds of each.

    A candidate that measures itself returns its seconds. Every other turn runs the other way round, so that none
    always profits from what its forerunner left in the caches.
    """
    seconds: dict[str, list[float]] = {name: [] for name in candidates}
    for turn in range(repetitions):
        for name in list(candidates) if turn % 2 == 0 else reversed(candidates):
            begin = time.perf_counter()
            own = candidates[name]()
            seconds[name].append(time.perf_counter() - begin if own is None else own)
            print(f"  turn {turn + 1}/{repetitions}: {name} {seconds[name][-1]:.3g} s", file=sys.stderr, flush=True)
    return seconds


def on_processor(candidate: Callable[[], object]) -> Callable[[], float]:
    """The candidate, returning the seconds of all processors together that this process spent on it."""

    def run() -> float:
        begin = time.process_time()
        candidate()
        return time.process_time() - begin

    return run


def spread(values: Sequence[float], digits: int = 2) -> str:
    """Median and extremes: “1.05 (0.98–1.20)”."""
    return f"{statistics.median(values):.{digits}f} ({min(values):.{digits}f}–{max(values):.{digits}f})"


def ratios(numerators: Sequence[float], denominators: Sequence[float], digits: int = 2) -> str:
    """Spread of the ratios of measurements that were taken in the same turn."""
    return spread([a / b for a, b in zip(numerators, denominators)], digits)
