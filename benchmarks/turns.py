"""Compare running times fairly: the candidates take turns in one run, and each turn gives one ratio."""

from __future__ import annotations

import statistics
import sys
import time
from collections.abc import Callable, Sequence


def take_turns(candidates: dict[str, Callable[[], float | None]], repetitions: int) -> dict[str, list[float]]:
    """Run all candidates one after the other, ``repetitions`` times, and return the seconds of each.

    A candidate that measures itself returns its seconds. Every second turn runs in reverse order, so that no candidate
    always profits from caches that the previous one filled.
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
    """Wrap a candidate so that it returns the processor seconds of this process."""

    def run() -> float:
        begin = time.process_time()
        candidate()
        return time.process_time() - begin

    return run


def spread(values: Sequence[float], digits: int = 2) -> str:
    """Return median and extremes, as in “1.05 (0.98–1.20)”."""
    return f"{statistics.median(values):.{digits}f} ({min(values):.{digits}f}–{max(values):.{digits}f})"


def ratios(numerators: Sequence[float], denominators: Sequence[float], digits: int = 2) -> str:
    """Return the spread of the ratios of measurements in the same turn."""
    return spread([a / b for a, b in zip(numerators, denominators)], digits)
