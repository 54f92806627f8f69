"""Check fixes of a flight against their times: which of them the aircraft can't have reached from the others."""

from __future__ import annotations

import numpy as np


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
