"""Search images without a position again, within reach of the positions of other images.

On less ground fewer places can be confused, so an image that is ambiguous on the whole map can get a position there.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..localization import Localization, Prior

SMALLER = 0.8
"""An image is searched again if its ground within reach got smaller by this factor: it saves time."""


@dataclass(frozen=True)
class Reach:
    """Ground that the center of an image can be on, as seen from the position of another image.

    Attributes:
        position: Map (x, y) of the other image's center.
        radius: Maximum speed × time between the images, and the error of the other position, map units.
        allowed_risk: Maximum error probability there: what the other position leaves of it.
        start: Number of the other image.
    """

    position: tuple[float, float]
    radius: float
    allowed_risk: float
    start: int

    def narrow(self, prior: Prior) -> Prior | None:
        """Return a prior limited to this ground; None if its own search area does not contain all of it."""
        if prior.position is not None and prior.radius is not None:
            away = float(np.hypot(*np.subtract(self.position, prior.position)))
            if away + self.radius > prior.radius:
                return None
        return replace(prior, position=self.position, radius=self.radius)


@dataclass(frozen=True)
class _Start:
    """A position to search from; ``error``: distance from its center that the aircraft can be off at both images."""

    position: tuple[float, float]
    time_s: float
    error: float
    risk: float


def search_within_reach(
    results: Sequence[Localization | None],
    times_s: Sequence[float | None],
    maximum_speed: float,
    allowed_risk: float,
    search: Callable[[int, Reach], Localization | None],
) -> dict[int, Localization]:
    """Return the fixes of images that were found within reach of others, by the images' numbers.

    A new fix has the error probability of both, and further searches start from it. None start from jumps.

    Args:
        results: Of the images by themselves; None with an error.
        times_s: Seconds; None if unknown.
        maximum_speed: Map units per second.
        allowed_risk: Maximum error probability of a fix.
        search: Localizes an image again, by its number; None without a result.
    """
    starts = _starts(results, times_s, maximum_speed)
    times = {n: time_s for n, time_s in enumerate(times_s) if time_s is not None}
    searched = {n: np.inf for n, one in enumerate(results) if one and not one.is_fix and n in times}
    found: dict[int, Localization] = {}
    slack = maximum_speed * time_slack(np.array(list(times.values())))
    while starts:
        reaches = {n: _reach(starts, times[n], maximum_speed, allowed_risk, slack) for n in searched}
        smaller = [n for n, reach in reaches.items() if reach.radius < SMALLER * searched[n] and reach.allowed_risk > 0]
        if not smaller:
            break
        n = min(smaller, key=lambda n: reaches[n].radius)
        searched[n] = reaches[n].radius
        again = search(n, reaches[n])
        if again is not None and again.is_fix and again.risk is not None:
            risk = again.risk + starts[reaches[n].start].risk
            found[n] = replace(again, risk=risk, confidence=1 - risk)
            starts |= _start(n, found[n], times[n])
            del searched[n]
    return found


def _starts(
    results: Sequence[Localization | None], times_s: Sequence[float | None], maximum_speed: float
) -> dict[int, _Start]:
    """Return the fixes with a time and an error probability that are no jumps, by the images' numbers."""
    starts: dict[int, _Start] = {}
    for n, (found, time_s) in enumerate(zip(results, times_s)):
        if found is not None and found.is_fix:
            starts |= _start(n, found, time_s)
    known = list(starts.values())
    times, errors = np.array([one.time_s for one in known]), np.array([one.error for one in known])
    positions, confidences = np.array([one.position for one in known]), np.array([1 - one.risk for one in known])
    flags = jumps(times, positions, errors, confidences, maximum_speed)
    return {n: one for (n, one), is_jump in zip(starts.items(), flags) if not is_jump}


def _start(n: int, found: Localization, time_s: float | None) -> dict[int, _Start]:
    if found.position is None or found.risk is None or time_s is None:
        return {}
    # Both images may be tilted as much as this one.
    off = 0.0 if found.nadir is None else 2 * float(np.hypot(*np.subtract(found.nadir, found.position)))
    return {n: _Start(found.position, time_s, (found.error_95_m or 0.0) + off, found.risk)}


def _reach(starts: dict[int, _Start], time_s: float, maximum_speed: float, allowed_risk: float, slack: float) -> Reach:
    """Return the smallest ground within reach of a start; ``slack``: what rounded times add to the distance."""
    radius, number = min((maximum_speed * abs(time_s - one.time_s) + one.error, n) for n, one in starts.items())
    start = starts[number]
    return Reach(start.position, radius + slack, allowed_risk - start.risk, number)


def time_slack(times_s: np.ndarray) -> float:
    """Return by how many seconds a difference may be wrong: 1 if all times are whole, as cameras state them, else 0."""
    return 1.0 if (np.mod(times_s, 1.0) == 0).all() else 0.0


def jumps(
    times_s: np.ndarray,
    positions: np.ndarray,
    errors: np.ndarray,
    confidences: np.ndarray,
    maximum_speed: float,
) -> np.ndarray:
    """Return (N,) bool: fixes that an aircraft of ``maximum_speed`` can't have reached from, or left for, the others.

    As few as possible are flagged: the longest chain in time remains in which every fix can be reached from the
    previous one, by dynamic programming; of equally long ones that with the largest sum of confidences. Two fixes agree
    if their distance is at most speed × time + both their errors. The time may be off by ``time_slack``.

    Args:
        times_s: (N,) seconds, in any order.
        positions: (N, 2) map coordinates (x, y).
        errors: (N,) largest error of each, map units.
        confidences: (N,) 0 to 1.
        maximum_speed: Map units per second.
    """
    count = len(times_s)
    order = np.argsort(times_s, kind="stable")
    times, errors = np.asarray(times_s, np.float64)[order], np.asarray(errors, np.float64)[order]
    points = np.asarray(positions, np.float64).reshape(-1, 2)[order]
    # Confidences together count less than one fix.
    worths = 1 + np.asarray(confidences, np.float64)[order] / (count + 1)
    slack = time_slack(times)
    totals, previous = worths.copy(), np.full(count, -1)
    for n in range(1, count):
        apart = np.hypot(*(points[:n] - points[n]).T)
        reachable = apart <= maximum_speed * (times[n] - times[:n] + slack) + errors[:n] + errors[n]
        if reachable.any():
            best = int(np.argmax(np.where(reachable, totals[:n], -1)))
            totals[n] += totals[best]
            previous[n] = best
    flagged = np.ones(count, bool)
    last = int(np.argmax(totals)) if count else -1
    while last >= 0:
        flagged[order[last]] = False
        last = previous[last]
    return flagged
