"""The sketch of a flight: its tracks, positions, headings and error ellipses as inline SVG, north up."""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape
from typing import TYPE_CHECKING

from ..translation import tr

if TYPE_CHECKING:
    from .flight_report import FlightPoint

WIDTH, HEIGHT = 960, 560
MARGIN = 44
RADIUS = 4.0
"""Of the disc at a position, pixels."""

NEEDLE = 13.0
"""From its center to where the image's top points, pixels."""


def kinds() -> tuple[tuple[str, str], ...]:
    """(color, words) of positions by a fix of their own, by the flight, and against their own fix."""
    return (
        ("var(--s0)", tr("Fix of the image itself")),
        ("var(--s1)", tr("Placed by the flight")),
        ("var(--bad)", tr("Its own fix was outvoted")),
    )


def flight_map(placed: Sequence[FlightPoint], name: str) -> str:
    """The sketch of images that have a position, with a scale bar."""
    reach = [point.ellipse[0] if point.ellipse else 0.0 for point in placed]
    xs = [v for point, far in zip(placed, reach) for v in (point.position[0] - far, point.position[0] + far)]
    ys = [v for point, far in zip(placed, reach) for v in (point.position[1] - far, point.position[1] + far)]
    across, up = max(max(xs) - min(xs), 1e-9), max(max(ys) - min(ys), 1e-9)
    unit = min((WIDTH - 2 * MARGIN) / across, (HEIGHT - 2 * MARGIN) / up)
    height = max(up * unit + 2 * MARGIN, 120)
    left = (WIDTH - across * unit) / 2

    def at(position: tuple[float, float]) -> tuple[float, float]:
        return left + (position[0] - min(xs)) * unit, MARGIN + (max(ys) - position[1]) * unit

    parts = []
    for track in sorted({point.track for point in placed}):
        path = "L".join("{:.1f} {:.1f}".format(*at(point.position)) for point in placed if point.track == track)
        parts.append(f'<path d="M{path}" style="fill:none;stroke:var(--soft);stroke-width:1.4"/>')
    parts += [_ellipse(point, at(point.position), unit) for point in placed if point.ellipse]
    parts += [_disc(point, at(point.position)) for point in placed]
    parts += _scale_bar(unit, height)
    return (
        f'<svg viewBox="0 0 {WIDTH} {height:.0f}" role="img" aria-label="{escape(name)}" '
        f'xmlns="http://www.w3.org/2000/svg">\n<title>{escape(name)}</title>\n' + "\n".join(parts) + "\n</svg>"
    )


def legend() -> str:
    """The kinds of positions beside each other."""
    entries = "".join(
        '<span style="white-space:nowrap;margin-right:18px"><svg viewBox="0 0 12 12" style="display:inline-block;'
        f'width:12px;height:12px;vertical-align:-1px">{_mark(6, 6, 4, color, number)}</svg> {escape(text)}</span> '
        for number, (color, text) in enumerate(kinds())
    )
    return f'<p class="legend">{entries}</p>'


def _kind(point: FlightPoint) -> int:
    return 2 if point.outvoted else 0 if point.source == "own" else 1


def _mark(x: float, y: float, radius: float, color: str, number: int) -> str:
    """Filled for an own fix, a ring by the flight, a cross against its own fix: told apart without colors."""
    if number == 2:
        r = radius
        path = f"M{x - r:.1f} {y - r:.1f}l{2 * r} {2 * r}m0 {-2 * r}l{-2 * r} {2 * r}"
        return f'<path d="{path}" style="fill:none;stroke:{color};stroke-width:2"/>'
    fill = color if number == 0 else "var(--ground)"
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" style="fill:{fill};stroke:{color};stroke-width:1.8"/>'


def _disc(point: FlightPoint, at: tuple[float, float]) -> str:
    color, number = kinds()[_kind(point)][0], _kind(point)
    needle = ""
    if point.heading_deg is not None:
        turn = math.radians(point.heading_deg)
        end = at[0] + NEEDLE * math.sin(turn), at[1] - NEEDLE * math.cos(turn)
        needle = (
            f'<path d="M{at[0]:.1f} {at[1]:.1f}L{end[0]:.1f} {end[1]:.1f}" style="stroke:{color};stroke-width:1.6"/>'
        )
    title = f"<title>{escape(f'{point.number}: {point.name}')}</title>"
    return f"<g>{title}{needle}{_mark(*at, RADIUS, color, number)}</g>"


def _ellipse(point: FlightPoint, at: tuple[float, float], unit: float) -> str:
    major, minor, direction = point.ellipse
    color = kinds()[_kind(point)][0]
    return (
        f'<ellipse cx="{at[0]:.1f}" cy="{at[1]:.1f}" rx="{minor * unit:.1f}" ry="{major * unit:.1f}" '
        f'transform="rotate({direction:.1f} {at[0]:.1f} {at[1]:.1f})" '
        f'style="fill:{color};fill-opacity:0.15;stroke:{color};stroke-width:0.8"/>'
    )


def _scale_bar(unit: float, height: float) -> list[str]:
    """A round length of at most a quarter of the width, lower left."""
    most = WIDTH / 4 / unit
    decade = 10 ** math.floor(math.log10(most))
    length = next(step * decade for step in (5, 2, 1) if step * decade <= most)
    x, y, end = MARGIN / 2, height - 14, MARGIN / 2 + length * unit
    text = f"{length / 1000:g} km" if length >= 1000 else f"{length:g} m"
    return [
        f'<path d="M{x} {y - 4}v4H{end:.1f}v-4" style="fill:none;stroke:var(--text)"/>',
        f'<text x="{end + 6:.1f}" y="{y}">{escape(text)}</text>',
    ]
