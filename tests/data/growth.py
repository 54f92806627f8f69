"""Measure how the time of a function grows with its input."""

import time
from typing import Callable

LINEAR = 10.0
"""Linear work takes 4 times as long for 4 times the input, on a busy machine up to 7; quadratic work takes 16 times."""


def growth(function: Callable, made: Callable[[int], object], count: int) -> float:
    """Return the time for ``made(4 * count)`` divided by that for ``made(count)``, the best of three runs each."""
    small, large = (made(n) for n in (count, 4 * count))
    return min(seconds(function, large) for _ in range(3)) / max(min(seconds(function, small) for _ in range(3)), 1e-4)


def seconds(function: Callable, given: object) -> float:
    began = time.process_time()
    function(given)
    return time.process_time() - began
