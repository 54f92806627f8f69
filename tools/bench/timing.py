"""Fair comparison of running times: candidates take turns within one run, and each turn gives one ratio."""

from __future__ import annotations

import os
import statistics
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Spread:
    """Median and extremes of repeated measurements."""

    median: float
    least: float
    most: float

    def text(self, digits: int = 2) -> str:
        """“1.05 (0.98–1.20)”."""
        return f"{self.median:.{digits}f} ({self.least:.{digits}f}–{self.most:.{digits}f})"


def spread(values: Sequence[float]) -> Spread:
    return Spread(statistics.median(values), min(values), max(values))


def ratios(numerators: Sequence[float], denominators: Sequence[float]) -> Spread:
    """Spread of the ratios of measurements that were taken in the same turn."""
    return spread([a / b for a, b in zip(numerators, denominators)])


def on_processor(candidate: Callable[[], object]) -> Callable[[], float]:
    """The candidate, telling the seconds of all processors together that this process spent on it."""

    def run() -> float:
        begin = time.process_time()
        candidate()
        return time.process_time() - begin

    return run


def on_processor_of_children(candidate: Callable[[], object]) -> Callable[[], float]:
    """As ``on_processor``, with the processes that it starts and waits for."""

    def run() -> float:
        begin = os.times()
        candidate()
        end = os.times()
        return sum(end[:4]) - sum(begin[:4])

    return run


def take_turns(candidates: dict[str, Callable[[], float | None]], repetitions: int) -> dict[str, list[float]]:
    """Runs all candidates one after another, `repetitions` times; the seconds of each.

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
