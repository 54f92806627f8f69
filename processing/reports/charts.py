"""Charts as inline SVG in the colors of the page: lines with bands, profiles.

Series differ in color, dash and marker, so that they are distinct in black and white. A drawing is a list of elements,
which the page's template writes and escapes.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from ...core.evaluation.rates import RateAt
from ..messages.numbers import shown
from . import page

WIDTH, HEIGHT = 480, 300
WIDEST_PX = 620
"""Largest width, so that the text of a chart is not larger than the text of the page."""

LEFT, RIGHT, TOP, BOTTOM = 64, 24, 14, 44
LEGEND_ROW = 20
_HALF_PX, _MARK_PX = (WIDTH - LEFT - RIGHT) / 2, 30
"""Widths of a legend column and of the symbol before a name."""

PROFILE_WIDTH, PROFILE_RIGHT = 960, 56
"""Width of a chart with the full page width, and its margin for an axis on the right."""

CHARACTER = 8.0
"""Width of a character."""

SERIES = 4
"""Number of colors; further series repeat them with other dashes and markers."""

DASHES = ("", "6,3", "2,3", "9,3,2,3")


@dataclass(frozen=True)
class Series:
    """A named line.

    Attributes:
        low: Lower limits of y, or None.
        high: Upper limits of y, or None.
        stepped: Whether y is constant until the next x.
    """

    name: str
    x: Sequence[float]
    y: Sequence[float]
    low: Sequence[float] | None = None
    high: Sequence[float] | None = None
    marked: bool = True
    stepped: bool = False


def rate_series(title: str, rates: Sequence[RateAt]) -> Series:
    """Return a series of rates with their intervals, at their means."""
    return Series(
        title,
        [one.at for one in rates],
        [one.rate.share for one in rates],
        [one.rate.interval[0] for one in rates],
        [one.rate.interval[1] for one in rates],
    )


@dataclass(frozen=True)
class Axis:
    """An axis; ``limits``: (smallest, largest); ``ticks``: (value, text)."""

    title: str
    limits: tuple[float, float]
    ticks: Sequence[tuple[float, str]]
    logarithmic: bool = False

    def place(self, value: float) -> float:
        """Return the place of a value along the axis, 0…1, clipped at the ends."""
        low, high = self.limits
        if self.logarithmic:
            low, high, value = math.log(low), math.log(high), math.log(max(value, 1e-300))
        return min(max((value - low) / (high - low), 0.0), 1.0)


def percent_axis(title: str) -> Axis:
    return Axis(title, (0.0, 1.0), [(n / 4, f"{25 * n} %") for n in range(5)])


def linear_axis(title: str, high: float) -> Axis:
    """Return an axis from 0 with six even ticks."""
    ticks = [high * n / 5 for n in range(6)]
    return Axis(title, (0.0, high), [(tick, shown(tick, ".3g")) for tick in ticks])


def logarithmic_axis(title: str, smallest: float, largest: float) -> Axis:
    """Return an axis with whole decades that contain smallest and largest, both above 0."""
    first, last = math.floor(math.log10(smallest)), math.ceil(math.log10(largest))
    last = max(last, first + 1)
    ticks = [(10.0**n, shown(10.0**n, ",g")) for n in range(first, last + 1)]
    return Axis(title, (10.0**first, 10.0**last), ticks, True)


class Element(NamedTuple):
    """An SVG element; ``title``: its tool tip."""

    tag: str
    attributes: dict[str, object]
    text: str = ""
    title: str = ""


def shape(tag: str, style: str, title: str = "", **attributes: object) -> Element:
    """Return an element; numbers are rounded to 0.1 pixel, except those given as text."""
    return Element(
        tag, {**{name: _short(value) for name, value in attributes.items()}, "style": style or None}, title=title
    )


def stroke(color: str, width: float | str = 1, dash: str = "") -> str:
    """Return the CSS style of a line."""
    return f"fill:none;stroke:{color};stroke-width:{width}" + (f";stroke-dasharray:{dash}" if dash else "")


def polyline(points: Sequence[tuple[float, float]], style: str, closed: bool = False) -> Element:
    """Return a line through points, or a closed outline."""
    return shape("path", style, d="M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points) + ("Z" if closed else ""))


def lettering(
    x: float, y: float, text: str, anchor: str = "middle", turn: float = 0, soft: bool = False, style: str = ""
) -> Element:
    """Return a text anchored at a point and rotated about it by ``turn`` degrees."""
    attributes = {
        "x": _short(x),
        "y": _short(y),
        "text-anchor": anchor,
        "class": "soft" if soft else None,
        "transform": f"rotate({turn:g} {x:.1f} {y:.1f})" if turn else None,
        "style": style or None,
    }
    return Element("text", attributes, text)


def drawing(elements: Sequence[Element], name: str, width: float, height: float, style: str = "") -> str:
    """Return a picture of elements with the width of the page, or of its style."""
    return page.macros().svg(name, f"{width:.0f}", f"{height:.0f}", style or None, elements)


def _short(value: object) -> object:
    return f"{value:.1f}" if isinstance(value, float) else value


def line_chart(series: Sequence[Series], x_axis: Axis, y_axis: Axis, name: str, diagonal: bool = False) -> str:
    """Return a chart of lines with their intervals as bands; ``diagonal``: draw the line of equal values."""
    frame = _Frame(x_axis, y_axis, [one.name for one in series])
    parts = frame.axes()
    if diagonal:
        ends = [frame.point(x, y) for x, y in zip(x_axis.limits, y_axis.limits)]
        parts.append(polyline(ends, stroke("var(--soft)", 1, "4,4")))
    for number, one in enumerate(series):
        parts += _line(frame, one, number)
    return frame.drawing(parts + frame.legend(), name)


def profile_chart(
    success: Series,
    seen: Series,
    x_axis: Axis,
    seen_axis: Axis,
    shaded: Sequence[tuple[float, float]],
    enough: float,
    name: str,
) -> str:
    """Return a profile of success along a route.

    Args:
        success: Shares with their interval, left axis.
        seen: Numbers of landmarks, right axis.
        seen_axis: Right axis, with as many ticks as the left one.
        shaded: (from, to) of stretches.
    """
    frame = _Frame(x_axis, percent_axis(success.name), [], PROFILE_WIDTH, PROFILE_RIGHT)
    parts = [
        shape("rect", "fill:var(--bad);opacity:0.12", x=x0, y=frame.top, width=max(x1 - x0, 1.0), height=frame.tall)
        for x0, x1 in ([frame.point(x, 0)[0] for x in ends] for ends in shaded)
    ]
    parts += frame.axes()
    right, middle = PROFILE_WIDTH - PROFILE_RIGHT, frame.top + frame.tall / 2
    parts += [
        lettering(right + 6, frame.bottom - seen_axis.place(value) * frame.tall + 4, text, "start", soft=True)
        for value, text in seen_axis.ticks
    ]
    parts.append(lettering(PROFILE_WIDTH - 6, middle, seen.name, turn=-90))
    parts.append(polyline([frame.point(x, enough) for x in x_axis.limits], stroke("var(--text)", 1, "2,3")))
    parts += _band(frame, success, "var(--s0)")
    counts = [frame.point(x, seen_axis.place(y)) for x, y in zip(seen.x, seen.y)]
    parts.append(polyline(counts, stroke("var(--s1)", 1.4, "5,3")))
    parts.append(polyline([frame.point(x, y) for x, y in zip(success.x, success.y)], stroke("var(--s0)", 2.4)))
    return frame.drawing(parts, name)


class _Frame:
    """Layout of a chart with axes; ``names``: entries of the legend above it."""

    def __init__(
        self, x_axis: Axis, y_axis: Axis, names: Sequence[str], width: int = WIDTH, right: int = RIGHT
    ) -> None:
        self.x_axis, self.y_axis, self.names = x_axis, y_axis, names
        self.width, self.right = width, width - right
        fit = all(_MARK_PX + CHARACTER * _width_of(name) <= _HALF_PX + RIGHT for name in names)
        self.abreast = 2 if fit else 1
        self.top = TOP + LEGEND_ROW * math.ceil(len(names) / self.abreast)
        self.tall = HEIGHT - TOP - BOTTOM
        self.bottom = self.top + self.tall
        self.height = self.bottom + BOTTOM

    def point(self, x: float, y: float) -> tuple[float, float]:
        return (LEFT + self.x_axis.place(x) * (self.right - LEFT), self.bottom - self.y_axis.place(y) * self.tall)

    def axes(self) -> list[Element]:
        parts, grid = [], stroke("var(--line)")
        for value, text in self.y_axis.ticks:
            _, y = self.point(self.x_axis.limits[0], value)
            parts.append(polyline([(LEFT, y), (self.right, y)], grid))
            parts.append(lettering(LEFT - 6, y + 4, text, "end", soft=True))
        for value, text in self.x_axis.ticks:
            x, _ = self.point(value, self.y_axis.limits[0])
            parts.append(polyline([(x, self.top), (x, self.bottom)], grid))
            parts.append(lettering(x, self.bottom + 16, text, soft=True))
        parts.append(lettering((LEFT + self.right) / 2, self.height - 8, self.x_axis.title))
        parts.append(lettering(12, (self.top + self.bottom) / 2, self.y_axis.title, turn=-90))
        return parts

    def legend(self) -> list[Element]:
        """Return the legend above the chart, with two entries per row if they fit."""
        parts = []
        for number, name in enumerate(self.names):
            row, place = divmod(number, self.abreast)
            x, y = LEFT + _HALF_PX * place, TOP + LEGEND_ROW * row - 2
            parts.append(shape("path", _look(number), d=f"M{x:.1f} {y}h24"))
            parts.append(_marker(x + 12, y, number))
            parts.append(lettering(x + _MARK_PX, y + 4, name, "start"))
        return parts

    def drawing(self, parts: Sequence[Element], name: str) -> str:
        return drawing(parts, name, self.width, self.height, f"max-width:{WIDEST_PX}px" if self.width == WIDTH else "")


def _color(number: int) -> str:
    return f"var(--s{number % SERIES})"


def _dash(number: int) -> int:
    """Return the number of dash and marker, shifted after each round of colors, so that 16 series are distinct."""
    return (number + number // SERIES) % SERIES


def _look(number: int) -> str:
    return stroke(_color(number), 2, DASHES[_dash(number)])


def _band(frame: _Frame, one: Series, color: str) -> list[Element]:
    if one.low is None:
        return []
    outline = [frame.point(x, y) for x, y in zip(one.x, one.high)]
    outline += [frame.point(x, y) for x, y in zip(one.x, one.low)][::-1]
    return [polyline(outline, f"fill:{color};opacity:0.16", closed=True)]


def _line(frame: _Frame, one: Series, number: int) -> list[Element]:
    points = [frame.point(x, y) for x, y in zip(one.x, one.y)]
    if not points:
        return []
    # A step has a corner at the earlier height.
    corners = [(x, y) for (_, y), (x, _) in zip(points, points[1:])] if one.stepped else []
    path = [corner for pair in zip(points, corners) for corner in pair] + points[-1:] if one.stepped else points
    markers = [_marker(x, y, number) for x, y in points] if one.marked else []
    return [*_band(frame, one, _color(number)), polyline(path, _look(number)), *markers]


def _marker(x: float, y: float, number: int) -> Element:
    """Return the marker of a series: disc, square, triangle or diamond."""
    fill = f"fill:{_color(number)}"
    if _dash(number) == 0:
        return shape("circle", fill, cx=x, cy=y, r=3.6)
    corners = {1: "-3.4-3.4h6.8v6.8h-6.8z", 2: "0-4.6l4.3 7.6h-8.6z", 3: "0-4.8l4.8 4.8l-4.8 4.8l-4.8-4.8z"}
    return shape("path", fill, d=f"M{x:.1f} {y:.1f}m{corners[_dash(number)]}")


def _width_of(name: str) -> float:
    """Return the width of a name in characters; Chinese characters count twice."""
    return sum(2 if ord(character) > 0x2E80 else 1 for character in name)
