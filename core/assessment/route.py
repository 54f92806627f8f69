"""A planned route, point by point: stretches without an expected fix, their length, and better parallel lines."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .. import limits
from ..errors import ParameterError

SHIFTS = (-1.0, -0.5, 0.5, 1.0)
"""Tested shifts of a stretch, as shares of the largest shift; below 0 left of the direction of flight."""

WORTH_SHIFTING = 0.1
"""Least increase of a stretch's mean success for a suggested shift."""


@dataclass(frozen=True)
class RoutePoints:
    """N points along lines.

    Attributes:
        lines: (N,) number of the line, from 0.
        along: (N,) distance from its start, m.
        places: (N, 2) map x, y.
        headings_deg: (N,) direction of flight, clockwise from grid north.
        lengths: Of each line, m.
    """

    lines: np.ndarray
    along: np.ndarray
    places: np.ndarray
    headings_deg: np.ndarray
    lengths: tuple[float, ...]

    def __len__(self) -> int:
        return len(self.along)

    def shifted(self, chosen: np.ndarray, offset: float) -> np.ndarray:
        """Return (n, 2) chosen points shifted by ``offset`` m to the right of the direction of flight; < 0: left."""
        turn = np.radians(self.headings_deg[chosen])
        return self.places[chosen] + offset * np.column_stack([np.cos(turn), -np.sin(turn)])


@dataclass(frozen=True)
class RouteGap:
    """A stretch of a line without an expected fix.

    Attributes:
        line: Number of the line, from 0.
        start: Last good point before it, m from the line's start.
        end: First good point after it, m from the line's start.
        points: (n,) numbers of the points that are not good enough.
    """

    line: int
    start: float
    end: float
    points: np.ndarray

    @property
    def length(self) -> float:
        """Length in m."""
        return self.end - self.start


@dataclass(frozen=True)
class ShiftHint:
    """A better parallel line for a stretch.

    Attributes:
        offset: m to the right of the direction of flight; below 0 to the left.
        success: Mean expected success there, 0…1.
        before: Mean expected success on the line itself, 0…1.
    """

    offset: float
    success: float
    before: float


def route_points(lines: Sequence[np.ndarray], spacing: float) -> RoutePoints:
    """Return points along lines, line by line, ends included; lines without a length are left out.

    Args:
        lines: (n, 2) map x, y of the corners of each.
        spacing: Between points, m.

    Raises:
        ParameterError: The spacing can't be used, or no line has a length.
    """
    if not 0 < spacing < math.inf:
        raise ParameterError("The distance between points is {spacing:g} m; it must be more than 0 m.", spacing=spacing)
    lines = [line for line in lines if len(line) > 1 and _steps(line).sum() > 0]
    if not lines:
        raise ParameterError("The route has no line with a length. Draw a line through at least two points.")
    lengths = tuple(float(_steps(line).sum()) for line in lines)
    count = sum(math.ceil(length / spacing) + 1 for length in lengths)
    if count > limits.ROUTE_POINTS:
        least = sum(lengths) / limits.ROUTE_POINTS
        raise ParameterError(
            "The distance between points is {spacing:g} m, which gives {count} points. Enter {least:.3g} m or more.",
            spacing=spacing,
            count=count,
            least=1.01 * least,
        )
    numbers, along, places, headings = [], [], [], []
    for number, (line, length) in enumerate(zip(lines, lengths)):
        at = np.append(np.arange(0, length - 1e-6 * spacing, spacing), length)
        ends = np.concatenate([[0.0], np.cumsum(_steps(line))])
        # The segment that ends at a point, so that the last point has a direction too.
        steps = _steps(line)
        segment = np.clip(np.searchsorted(ends, at, side="right") - 1, 0, len(steps) - 1)
        segment = np.where(steps[segment] > 0, segment, np.flatnonzero(steps > 0)[-1])
        share = (at - ends[segment]) / steps[segment]
        step = line[segment + 1] - line[segment]
        numbers.append(np.full(len(at), number))
        along.append(at)
        places.append(line[segment] + share[:, None] * step)
        headings.append(np.degrees(np.arctan2(step[:, 0], step[:, 1])) % 360)
    return RoutePoints(
        np.concatenate(numbers), np.concatenate(along), np.concatenate(places), np.concatenate(headings), lengths
    )


def gaps(points: RoutePoints, success: np.ndarray, threshold: float) -> list[RouteGap]:
    """Return the stretches with less success (N,) than ``threshold``, in the order of flight."""
    good, found = success >= threshold, []
    for line, length in enumerate(points.lengths):
        members = np.flatnonzero(points.lines == line)
        bad = np.flatnonzero(~good[members])
        for run in np.split(bad, np.flatnonzero(np.diff(bad) > 1) + 1):
            if len(run):
                start = points.along[members[run[0] - 1]] if run[0] else 0.0
                end = points.along[members[run[-1] + 1]] if run[-1] + 1 < len(members) else length
                found.append(RouteGap(line, float(start), float(end), members[run]))
    return found


def stretch(points: RoutePoints, n: int) -> np.ndarray:
    """Return (m, 2) map x, y of a point's part of the line: half the way to its neighbors on the line, m 2 or 3."""
    own, line = points.places[n], points.lines[n]
    sides = [m for m in (n - 1, n + 1) if 0 <= m < len(points) and points.lines[m] == line]
    halves = [(points.places[m] + own) / 2 for m in sides]
    if len(halves) == 2:
        return np.array([halves[0], own, halves[1]])
    return np.array([own, *halves]) if sides and sides[0] > n else np.array([*halves, own])


def best_shift(before: np.ndarray, offsets: Sequence[float], successes: Sequence[np.ndarray]) -> ShiftHint | None:
    """Return the best shift of a stretch, the shortest of similar ones; None if no shift is worth it.

    Args:
        before: (n,) success of its points on the line.
        offsets: Tested shifts, m.
        successes: (n,) success at each of them.
    """
    means = [float(success.mean()) for success in successes]
    now = float(before.mean())
    if not means or max(means) < now + WORTH_SHIFTING:
        return None
    near = [n for n, mean in enumerate(means) if mean >= max(means) - WORTH_SHIFTING / 2]
    best = min(near, key=lambda n: (abs(offsets[n]), -means[n]))
    return ShiftHint(float(offsets[best]), means[best], now)


def _steps(line: np.ndarray) -> np.ndarray:
    """Return (n − 1,) lengths of a line's segments."""
    return np.hypot(*np.diff(line, axis=0).T)
