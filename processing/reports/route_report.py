"""The report of a route: a profile of expected success along it, its gaps, and where to shift them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

import numpy as np

from ...core.assessment.assessment import Estimates
from ...core.assessment.flights import FlownRoute
from ...core.assessment.route import RouteGap, RoutePoints, ShiftHint
from ...core.simulation.conditions import Conditions
from ..translation import tr
from ..wording.numbers import Local, shown
from . import page
from .assessment_report import assumed, reason_titles
from .route_flights import flown_parts

WIDTH, HEIGHT = 960, 300
LEFT, RIGHT, TOP, BOTTOM = 56, 56, 16, 46


@dataclass(frozen=True)
class AssessedRoute:
    """Points of a route with what to expect there. inside: (N,) on the map; stretches: without an expected fix, with a
    hint or None each; footprint, spacing: map units; speed: m/s or None; flown: flights along it, None for none."""

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
) -> str:
    """The whole page; ``name``: the database's."""
    profiles = []
    for line in range(len(route.points.lengths)):
        title = tr("Route {number}").format(number=line + 1)
        caption = tr(
            "{route}: expected success with its 95 % interval (left axis) and landmarks in view (dashed, right axis) "
            "along {length:.1f} km. Shaded: stretches without an expected fix; dotted line: good enough."
        )
        length = route.points.lengths[line] / 1000
        profiles.append(page.figure(profile(route, line), caption.format(route=title, length=Local(length))))
    return page.page(
        tr("Assessment of a route"),
        name,
        _key_figures(route),
        page.next_steps(tr("What to do next"), _next(route)),
        page.paragraph(assumed(conditions, correlation)),
        page.section(tr("Profile"), *profiles),
        page.section(tr("Stretches without an expected fix"), *_gap_table(route)),
        *_in_flight(route),
        page.section(tr("Settings"), page.table([tr("Setting"), tr("Value")], settings)),
    )


def _in_flight(route: AssessedRoute) -> list[str]:
    if route.flown is None:
        return []
    return [page.section(tr("In flight"), *flown_parts(route.flown, route.threshold, route.footprint))]


def profile(route: AssessedRoute, line: int) -> str:
    """Success and landmarks along one line, as an elevation profile is drawn."""
    members = np.flatnonzero(route.points.lines == line)
    along, estimates = route.points.along[members], route.estimates.part(members)
    length = max(route.points.lengths[line], 1e-9)
    most = _round_up(float(estimates.landmarks.max()))
    right, bottom = WIDTH - RIGHT, HEIGHT - BOTTOM

    def x(meters: float) -> float:
        return LEFT + (right - LEFT) * meters / length

    def y(share: float) -> float:
        return bottom - (bottom - TOP) * share

    parts = [
        f'<rect x="{x(gap.start):.1f}" y="{TOP}" width="{max(x(gap.end) - x(gap.start), 1):.1f}" '
        f'height="{bottom - TOP}" style="fill:var(--bad);opacity:0.12"/>'
        for gap in route.stretches
        if gap.line == line
    ]
    for share in (0, 0.25, 0.5, 0.75, 1):
        parts.append(f'<path d="M{LEFT} {y(share):.1f}H{right}" style="stroke:var(--line)"/>')
        parts.append(_text(LEFT - 6, y(share) + 4, f"{100 * share:.0f} %", "end", "soft"))
        parts.append(_text(right + 6, y(share) + 4, f"{share * most:.0f}", "start", "soft"))
    for tick in _ticks(length):
        parts.append(f'<path d="M{x(tick):.1f} {bottom}v4" style="stroke:var(--soft)"/>')
        parts.append(_text(x(tick), bottom + 17, shown(tick / 1000, "g"), "middle", "soft"))
    parts.append(_text((LEFT + right) / 2, HEIGHT - 8, tr("along the route, km"), "middle"))
    parts.append(_turned(12, (TOP + bottom) / 2, tr("expected success")))
    parts.append(_turned(WIDTH - 6, (TOP + bottom) / 2, tr("landmarks in view")))
    upper = [f"{x(a):.1f} {y(v):.1f}" for a, v in zip(along, estimates.high)]
    lower = [f"{x(a):.1f} {y(v):.1f}" for a, v in zip(along, estimates.low)]
    parts.append(f'<path d="M{"L".join(upper + lower[::-1])}Z" style="fill:var(--s0);opacity:0.18"/>')
    seen = "L".join(f"{x(a):.1f} {y(v / most):.1f}" for a, v in zip(along, estimates.landmarks))
    parts.append(f'<path d="M{seen}" style="fill:none;stroke:var(--s1);stroke-width:1.4;stroke-dasharray:5,3"/>')
    line_path = "L".join(f"{x(a):.1f} {y(v):.1f}" for a, v in zip(along, estimates.success))
    parts.append(f'<path d="M{line_path}" style="fill:none;stroke:var(--s0);stroke-width:2.4"/>')
    parts.append(
        f'<path d="M{LEFT} {y(route.threshold):.1f}H{right}" '
        'style="stroke:var(--text);stroke-dasharray:2,3;stroke-width:1"/>'
    )
    name = escape(tr("Profile"))
    return (
        f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{name}" xmlns="http://www.w3.org/2000/svg">\n'
        f"<title>{name}</title>\n" + "\n".join(parts) + "\n</svg>"
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
    at_least = tr("{threshold} or more expected").format(threshold=page.percent(route.threshold, 0))
    return page.key_figures(
        [
            (page.number(longest, "m") if longest else "0", tr("without an expected fix"), note),
            (page.percent(good), tr("of the points good enough"), at_least),
            (page.number(sum(route.points.lengths) / 1000, "km"), tr("length"), ""),
            (
                page.number(float(np.median(errors)) if len(errors) else None, "m"),
                tr("expected error"),
                tr("of right fixes, median"),
            ),
        ]
    )


def _next(route: AssessedRoute) -> list[str]:
    export = tr("Take the database along: “Export for onboard use”, with this route as area.")
    if not route.stretches:
        return [tr("A fix is expected everywhere along the route."), export]
    steps = []
    if any(hint is not None for hint in route.hints):
        steps.append(tr("Shift the stretches that have a hint below, and assess the route again."))
    longest = max(gap.length for gap in route.stretches)
    told = page.number(longest / 1000, "km")
    if route.speed:
        told += f" ({page.number(longest / route.speed, 's')})"
    text = tr("Bridge what is left by odometry: the longest stretch without an expected fix is {length}.")
    return [*steps, text.format(length=told), export]


def _gap_table(route: AssessedRoute) -> list[str]:
    if not route.stretches:
        return [page.paragraph(tr("None: a fix is expected everywhere."))]
    header = [
        tr("Route"),
        tr("from (m)"),
        tr("to (m)"),
        tr("length (m)"),
        *([tr("seconds")] if route.speed else []),
        tr("landmarks in view"),
        tr("reason"),
        tr("hint"),
    ]
    rows = []
    for gap, hint in sorted(zip(route.stretches, route.hints), key=lambda pair: -pair[0].length):
        rows.append(
            [
                str(gap.line + 1),
                shown(gap.start, ",.0f"),
                shown(gap.end, ",.0f"),
                shown(gap.length, ",.0f"),
                *([shown(gap.length / route.speed, ",.0f")] if route.speed else []),
                f"{route.estimates.landmarks[gap.points].mean():.0f}",
                _reason(route, gap),
                _hint(hint),
            ]
        )
    numbers = range(1, 6 if route.speed else 5)
    note = tr(
        "Longest first. A stretch goes from the last point that is good enough to the next one. Hints tell the mean "
        "expected success of the stretch if it is flown parallel, to the left or right of the direction of flight."
    )
    return [page.table(header, rows, numbers), page.paragraph(note)]


def _reason(route: AssessedRoute, gap: RouteGap) -> str:
    if not route.inside[gap.points].any():
        return tr("outside the map")
    reasons = [route.estimates.reasons[n] for n in gap.points.tolist()]
    return reason_titles().get(max(reasons, key=reasons.count), page.NOTHING)


def _hint(hint: ShiftHint | None) -> str:
    if hint is None:
        return tr("no better line found beside it")
    text = (
        tr("{shift:.0f} m to the left: {after} instead of {before}")
        if hint.offset < 0
        else tr("{shift:.0f} m to the right: {after} instead of {before}")
    )
    shares = page.percent(hint.success, 0), page.percent(hint.before, 0)
    return text.format(shift=Local(abs(hint.offset)), after=shares[0], before=shares[1])


def _round_up(value: float) -> float:
    """The next of 4, 8, 20, 40, 80, 200, …: four even ticks are whole numbers."""
    decade = 10 ** math.floor(math.log10(max(value, 4) / 4))
    return next(step * 4 * decade for step in (1, 2, 5, 10) if value <= step * 4 * decade)


def _ticks(length: float) -> list[float]:
    """Some six round distances, meters."""
    raw = length / 6
    decade = 10 ** math.floor(math.log10(raw))
    step = next(s * decade for s in (1, 2, 5, 10) if raw <= s * decade)
    return [n * step for n in range(int(length / step + 1e-9) + 1)]


def _text(x: float, y: float, text: str, anchor: str, kind: str = "") -> str:
    return f'<text class="{kind}" x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{escape(text)}</text>'


def _turned(x: float, y: float, text: str) -> str:
    return f'<text transform="translate({x} {y:.1f}) rotate(-90)" text-anchor="middle">{escape(text)}</text>'
