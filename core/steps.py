"""Long computations: generators that yield (current step, share done 0…1) and return their result."""

from __future__ import annotations

from collections.abc import Generator
from typing import Any, Callable, TypeVar

Result = TypeVar("Result")
Step = TypeVar("Step")
Shown = TypeVar("Shown")

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


def mapped(steps: Generator[Step, None, Result], shown: Callable[[Step], Shown]) -> Generator[Shown, None, Result]:
    """Yield ``shown`` of each step of a part, which is never None; return its result."""
    step, found = advance(steps)
    while step is not None:
        yield shown(step)
        step, found = advance(steps)
    return found


def scaled(shares: Shares[Result], first: float, last: float) -> Shares[Result]:
    """Yield the shares of a part as shares from ``first`` to ``last``; return its result."""
    return mapped(shares, lambda share: first + (last - first) * share)


def part(what: str, shares: Shares[Result], first: float, last: float) -> Steps[Result]:
    """Yield the shares of a part as steps from ``first`` to ``last`` of the computation; return its result."""
    return mapped(scaled(shares, first, last), lambda share: (what, share))
