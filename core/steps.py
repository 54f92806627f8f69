"""Long computations: generators that yield (current step, share done 0…1) and return their result."""

from __future__ import annotations

from collections.abc import Generator
from typing import Any, TypeVar

Result = TypeVar("Result")

Steps = Generator[tuple[str, float], None, Result]
Shares = Generator[float, None, Result]
"""Of a part of a computation: yields the share done only."""


def advance(steps: Generator[Any, None, Result]) -> tuple[Any, Any]:
    """Return the next step and None, or None and the result at the end; a future can't pass StopIteration on."""
    try:
        return next(steps), None
    except StopIteration as end:
        return None, end.value


def result_of(steps: Generator[Any, None, Result]) -> Result:
    """Run a computation to its end and return its result, for callers that show no progress."""
    step, found = advance(steps)
    while step is not None:
        step, found = advance(steps)
    return found


def part(what: str, shares: Shares[Result], first: float, last: float) -> Steps[Result]:
    """Yield the shares of a part as steps from ``first`` to ``last`` of the computation; return its result."""
    share, found = advance(shares)
    while share is not None:
        yield what, first + (last - first) * share
        share, found = advance(shares)
    return found
