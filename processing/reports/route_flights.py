"""What simulated flights along a route came to, as part of its report."""

from __future__ import annotations

import numpy as np

from ...core.assessment.flights import FlownRoute
from ..translation import tr
from . import page

LARGE_SHARE = 0.1
"""A radius above this share of the footprint is told as a stretch of its own."""


def flown_parts(flown: FlownRoute | None, threshold: float, footprint: float) -> list[str]:
    """Tables of the routes, and of the stretches where flights do poorly.

    Args:
        flown: What came of the flights; None without any, which has no parts.
        threshold: Share of the flights that is good enough, 0…1.
        footprint: Edge of the ground that an image shows, map units.
    """
    if flown is None:
        return []
    header = [
        tr("Route"),
        tr("first position after (m)"),
        tr("images with a position after it"),
        tr("95 % radius, median (m)"),
        tr("largest (m)"),
        tr("tracks lost a flight"),
    ]
    rows = [_row(flown, line, threshold) for line in range(len(flown.points.lengths))]
    note = tr(
        "{flights} simulated flights along each route, with an image each {distance:.0f} m, as known in flight. The "
        "first position counts where {threshold} of the flights had theirs; radii are medians of the flights that have "
        "a position."
    ).format(
        flights=len(flown.is_placed),
        distance=_distance(flown),
        threshold=page.percent(threshold, 0),
    )
    parts = [page.table(header, rows, range(1, 6)), page.paragraph(note)]
    poor = poor_stretches(flown, threshold, LARGE_SHARE * footprint)
    if not poor:
        return [*parts, page.paragraph(tr("After that a position is expected everywhere, with a small radius."))]
    header = [tr("Route"), tr("from (m)"), tr("to (m)"), tr("what is expected")]
    told = [[str(line + 1), f"{start:.0f}", f"{end:.0f}", what] for line, start, end, what in poor]
    return [*parts, page.table(header, told, (1, 2))]


def poor_stretches(flown: FlownRoute, threshold: float, large: float) -> list[tuple[int, float, float, str]]:
    """(line, start, end, what) after the first position, where flights have none or know it poorly.

    Args:
        flown: What came of the flights.
        threshold: Share of the flights that is good enough.
        large: Radius from which on it is told, map units.
    """
    found = []
    for line in range(len(flown.points.lengths)):
        members = np.flatnonzero(flown.points.lines == line)
        first = flown.first(line, threshold)
        along = flown.points.along[members]
        after = np.zeros(len(members), bool) if first is None else along >= first
        is_missing = after & (flown.placed[members] < threshold)
        with np.errstate(invalid="ignore"):
            is_large = after & ~is_missing & (flown.radius[members] > large)
        for bad in (is_missing, is_large):
            numbers = np.flatnonzero(bad)
            for run in np.split(numbers, np.flatnonzero(np.diff(numbers) > 1) + 1):
                if len(run):
                    what = _what(flown, members[run], bad is is_missing)
                    found.append((line, float(along[run[0]]), float(along[run[-1]]), what))
    return sorted(found)


def _what(flown: FlownRoute, numbers: np.ndarray, is_missing: bool) -> str:
    if is_missing:
        least = page.percent(float(flown.placed[numbers].min()), 0)
        return tr("only {share} of the flights keep a position").format(share=least)
    return tr("the 95 % radius grows to {radius:.0f} m").format(radius=float(np.nanmax(flown.radius[numbers])))


def _row(flown: FlownRoute, line: int, threshold: float) -> list[str]:
    members = np.flatnonzero(flown.points.lines == line)
    first = flown.first(line, threshold)
    after = members if first is None else members[flown.points.along[members] >= first]
    radius = flown.radius[after]
    known = radius[np.isfinite(radius)]
    return [
        str(line + 1),
        page.NOTHING if first is None else f"{first:.0f}",
        page.percent(float(flown.placed[after].mean()), 0),
        f"{np.median(known):.0f}" if len(known) else page.NOTHING,
        f"{known.max():.0f}" if len(known) else page.NOTHING,
        f"{flown.lost[members].sum():.1f}",
    ]


def _distance(flown: FlownRoute) -> float:
    apart = np.diff(flown.points.along)
    return float(np.median(apart[apart > 0])) if (apart > 0).any() else 0.0
