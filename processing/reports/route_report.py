"""Report of a route: map, profile of expected success, gaps, and suggested shifts."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from qgis.PyQt.QtCore import QDate, QLocale

from ...core.assessment.assessment import Estimates
from ...core.assessment.flights import FlownRoute
from ...core.assessment.route import RouteGap, RoutePoints, ShiftHint
from ...core.simulation.conditions import Conditions
from ..layers.class_styles import success_classes
from ..messages.numbers import Local, shown
from ..messages.numbers import count as number_text
from ..translation import tr
from . import charts, page, parts
from .assessment_report import assumptions, reason_titles
from .maps import route_map, success_legend

LARGE_SHARE = 0.1
"""The report lists stretches with a 95 % radius above this share of the footprint width."""


@dataclass(frozen=True)
class AssessedRoute:
    """Estimates for the points of a route.

    Attributes:
        inside: (N,) whether a point is on the map.
        stretches: Stretches without an expected position.
        hints: Suggested shift of each stretch, or None.
        footprint: Footprint width, m.
        spacing: Distance of points, m.
        threshold: Sufficient success, 0…1.
        speed: In m/s, or None.
        flown: Simulated flights, or None.
    """

    points: RoutePoints
    estimates: Estimates
    inside: np.ndarray
    stretches: Sequence[RouteGap]
    hints: Sequence[ShiftHint | None]
    footprint: float
    spacing: float
    threshold: float
    speed: float | None
    flown: FlownRoute | None = None


def route_html(
    route: AssessedRoute,
    name: str,
    conditions: Conditions,
    correlation: bool,
    settings: Sequence[tuple[str, str]],
    below: bytes = b"",
) -> str:
    """Return the page; ``name``: names of route and database; ``below``: JPEG for the map."""
    profiles = []
    for line in range(len(route.points.lengths)):
        title = tr("Route {number}").format(number=line + 1)
        caption = tr(
            "{route}: expected success with its 95 % interval (left axis) and landmarks in view (dashed, right axis) "
            "along {length:.1f} km. Shaded: stretches without an expected position. Dotted line: threshold."
        )
        length = route.points.lengths[line] / 1000
        profiles.append(page.figure(profile(route, line), caption.format(route=title, length=Local(length))))
    return page.page(
        tr("Assessment of a route"),
        name,
        _key_figures(route),
        parts.next_steps(_next(route)),
        page.paragraph(assumptions(conditions, correlation)),
        page.section(tr("Map"), *_map(route, below)),
        page.section(tr("Profile"), *profiles),
        page.section(tr("Stretches without an expected position"), *_gap_table(route)),
        page.section(tr("In flight"), *flown_parts(route.flown, route.threshold, route.footprint)),
        parts.settings_section(settings),
    )


def _map(route: AssessedRoute, below: bytes) -> list[str]:
    classes = success_classes(route.threshold)
    picture = route_map(route.points, route.estimates.success, classes, below, tr("Map of the route"))
    caption = tr("Route by expected success, {count} points, {date}. North is up.")
    today = QLocale().toString(QDate.currentDate(), QLocale.FormatType.ShortFormat)
    figure = page.figure(picture, caption.format(count=number_text(len(route.points)), date=today))
    return [success_legend(classes), figure]


def profile(route: AssessedRoute, line: int) -> str:
    """Return the profile of success and landmarks along one line."""
    members = np.flatnonzero(route.points.lines == line)
    along, estimates = route.points.along[members] / 1000, route.estimates.part(members)
    length = max(route.points.lengths[line], 1e-9) / 1000
    most = _round_up(float(estimates.landmarks.max()))
    return charts.profile_chart(
        charts.Series(tr("Expected success"), along, estimates.success, estimates.low, estimates.high),
        charts.Series(tr("Landmarks in view"), along, estimates.landmarks),
        charts.Axis(
            tr("Distance along the route (km)"), (0.0, length), [(tick, shown(tick, "g")) for tick in _ticks(length)]
        ),
        charts.Axis("", (0.0, most), [(most * n / 4, f"{most * n / 4:.0f}") for n in range(5)]),
        [(gap.start / 1000, gap.end / 1000) for gap in route.stretches if gap.line == line],
        route.threshold,
        tr("Profile"),
    )


def _key_figures(route: AssessedRoute) -> str:
    longest = max((gap.length for gap in route.stretches), default=0.0)
    seconds = tr("{seconds:.0f} s at {speed:g} m/s")
    note = (
        seconds.format(seconds=Local(longest / route.speed), speed=Local(route.speed))
        if route.speed
        else tr("longest stretch")
    )
    errors = route.estimates.error[np.isfinite(route.estimates.error)]
    good = float((route.estimates.success >= route.threshold).mean())
    at_least = tr("expected success {threshold} or more").format(threshold=page.percent(route.threshold, 0))
    return page.key_figures(
        [
            (page.number(longest, "m") if longest else "0", tr("Without an expected position"), note),
            (page.percent(good), tr("Points with sufficient success"), at_least),
            (page.number(sum(route.points.lengths) / 1000, "km"), tr("Length"), ""),
            (
                page.number(float(np.median(errors)) if len(errors) else None, "m"),
                tr("Expected error"),
                tr("median of correct positions"),
            ),
        ]
    )


def _next(route: AssessedRoute) -> list[str]:
    export = tr("Export the database with “Export for onboard use”, with this route as area.")
    if not route.stretches:
        return [tr("A position is expected everywhere along the route."), export]
    steps = []
    if any(hint is not None for hint in route.hints):
        steps.append(tr("Shift the stretches with a suggestion below, and assess the route again."))
    longest = max(gap.length for gap in route.stretches)
    shown_length = page.number(longest / 1000, "km")
    if route.speed:
        shown_length += f" ({page.number(longest / route.speed, 's')})"
    text = tr("Use odometry on stretches without an expected position. The longest one is {length}.")
    return [*steps, text.format(length=shown_length), export]


def _gap_table(route: AssessedRoute) -> list[str]:
    if not route.stretches:
        return [page.paragraph(tr("There are no such stretches. A position is expected everywhere."))]
    hints = {id(gap): hint for gap, hint in zip(route.stretches, route.hints)}
    columns = [
        (tr("Route"), lambda gap: str(gap.line + 1)),
        (tr("From (m)"), lambda gap: shown(gap.start, ",.0f")),
        (tr("To (m)"), lambda gap: shown(gap.end, ",.0f")),
        (tr("Length (m)"), lambda gap: shown(gap.length, ",.0f")),
        *([(tr("Time (s)"), lambda gap: shown(gap.length / route.speed, ",.0f"))] if route.speed else []),
        (tr("Landmarks in view"), lambda gap: f"{route.estimates.landmarks[gap.points].mean():.0f}"),
        (tr("Reason"), lambda gap: _reason(route, gap)),
        (tr("Suggestion"), lambda gap: _hint(hints[id(gap)])),
    ]
    longest_first = sorted(route.stretches, key=lambda gap: -gap.length)
    numbers = range(1, 6 if route.speed else 5)
    note = tr(
        "The longest stretch is first. A stretch is between two points with sufficient success. Suggestions show the "
        "mean expected success of a parallel line, to the left or right of the flight direction."
    )
    return [page.records(longest_first, columns, numbers), page.paragraph(note)]


def _reason(route: AssessedRoute, gap: RouteGap) -> str:
    titles, outside = reason_titles(), tr("outside the map")
    reasons = [
        titles.get(route.estimates.reasons[n], page.NOTHING) if route.inside[n] else outside
        for n in gap.points.tolist()
    ]
    return max(reasons, key=reasons.count)


def _hint(hint: ShiftHint | None) -> str:
    if hint is None:
        return tr("no better parallel line")
    text = (
        tr("{shift:.0f} m to the left: {after} instead of {before}")
        if hint.offset < 0
        else tr("{shift:.0f} m to the right: {after} instead of {before}")
    )
    shares = page.percent(hint.success, 0), page.percent(hint.before, 0)
    return text.format(shift=Local(abs(hint.offset)), after=shares[0], before=shares[1])


def _round_up(value: float) -> float:
    """Return the next of 4, 8, 20, 40, 80, 200, …, so that four even ticks are whole numbers."""
    return 4 * _round_step(max(value, 4) / 4)


def _ticks(length: float) -> list[float]:
    step = _round_step(length / 6)
    return [n * step for n in range(int(length / step + 1e-9) + 1)]


def _round_step(least: float) -> float:
    """Return the smallest of …, 0.5, 1, 2, 5, 10, 20, … that is at least ``least``."""
    decade = 10 ** math.floor(math.log10(least))
    return next(step * decade for step in (1, 2, 5, 10) if least <= step * decade)


def flown_parts(flown: FlownRoute | None, threshold: float, footprint: float) -> list[str]:
    """Return tables of the simulated flights and of stretches with poor results.

    Args:
        flown: Results of the flights; None without flights.
        threshold: Sufficient share of the flights, 0…1.
        footprint: Footprint width, m.
    """
    if flown is None:
        return []
    header = [
        tr("Route"),
        tr("First position after (m)"),
        tr("Later images with a position"),
        tr("95 % radius, median (m)"),
        tr("95 % radius, largest (m)"),
        tr("Lost tracks per flight"),
    ]
    rows = [_flown_row(flown, line, threshold) for line in range(len(flown.points.lengths))]
    note = tr(
        "{flights} simulated flights along each route with an image every {distance:.0f} m, processed as in flight. "
        "First position: where {threshold} of the flights had their first position. Radii are medians of the flights "
        "with a position."
    ).format(flights=len(flown.is_placed), distance=_distance(flown), threshold=page.percent(threshold, 0))
    parts = [page.table(header, rows, range(1, 6)), page.paragraph(note)]
    poor = poor_stretches(flown, threshold, LARGE_SHARE * footprint)
    if not poor:
        return [
            *parts,
            page.paragraph(tr("After the first position, a position with a small 95 % radius is expected everywhere.")),
        ]
    header = [tr("Route"), tr("From (m)"), tr("To (m)"), tr("Expectation")]
    rows = [[str(line + 1), f"{start:.0f}", f"{end:.0f}", what] for line, start, end, what in poor]
    return [*parts, page.table(header, rows, (1, 2))]


def poor_stretches(flown: FlownRoute, threshold: float, large: float) -> list[tuple[int, float, float, str]]:
    """Return (line, start, end, text) of stretches after the first position without position or with a large radius.

    Args:
        threshold: Sufficient share of the flights.
        large: Large 95 % radius, m.
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
                    what = _poor(flown, members[run], bad is is_missing)
                    found.append((line, float(along[run[0]]), float(along[run[-1]]), what))
    return sorted(found)


def _poor(flown: FlownRoute, numbers: np.ndarray, is_missing: bool) -> str:
    if is_missing:
        least = page.percent(float(flown.placed[numbers].min()), 0)
        return tr("only {share} of the flights have a position").format(share=least)
    return tr("95 % radius up to {radius:.0f} m").format(radius=float(np.nanmax(flown.radius[numbers])))


def _flown_row(flown: FlownRoute, line: int, threshold: float) -> list[str]:
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
