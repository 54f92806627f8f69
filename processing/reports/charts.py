"""Charts as inline SVG, drawn in the colors of the page's style: lines with bands, bars, heat maps, reliability.

Series differ in color, dash and marker, so they can be told apart by everyone and in black and white.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

from ...core.evaluation.rates import RateAt
from ..wording.numbers import shown

WIDTH, HEIGHT = 480, 300
WIDEST_PX = 620
"""On screen and paper, so that its letters are hardly larger than the page's."""

LEFT, RIGHT, TOP, BOTTOM = 64, 24, 14, 44
LEGEND_ROW = 20
_HALF_PX, _MARK_PX = (WIDTH - LEFT - RIGHT) / 2, 30
"""Of a row of the legend; what stands before a name."""

TITLE_ROW = 24
CELL_WIDTH, CELL_HEIGHT = 54, 34
CHARACTER = 8.0
"""Room for a character of a name; names are cut after NAME_LENGTH of them."""

NAME_LENGTH = 24
SERIES = 4
"""Series that have a color of their own; more repeat them with other dashes and markers."""

DASHES = ("", "6 3", "2 3", "9 3 2 3")
CIVIDIS = ("#00204d", "#31446b", "#666970", "#958f78", "#cbba69", "#ffea46")
"""Evenly perceived steps from dark to light that the color-blind see alike (Nuñez et al. 2018)."""


@dataclass(frozen=True)
class Series:
    """A named line or row of bars: y of each x, with the interval (low, high) of each y if it is known.

    marked: whether the points get markers; stepped: y stays until the next x; color: of CSS, by the series' number if
    empty.
    """

    name: str
    x: Sequence[float]
    y: Sequence[float]
    low: Sequence[float] | None = None
    high: Sequence[float] | None = None
    marked: bool = True
    stepped: bool = False
    color: str = ""


def rate_series(title: str, rates: Sequence[RateAt], x: Sequence[float] = ()) -> Series:
    """Rates with their intervals, at their means or at ``x``."""
    return Series(
        title,
        x or [one.at for one in rates],
        [one.rate.share for one in rates],
        [one.rate.interval[0] for one in rates],
        [one.rate.interval[1] for one in rates],
    )


@dataclass(frozen=True)
class Axis:
    """title; limits (smallest, largest); ticks with their texts; logarithmic or not."""

    title: str
    limits: tuple[float, float]
    ticks: Sequence[tuple[float, str]]
    logarithmic: bool = False

    def place(self, value: float) -> float:
        """0…1 along the axis; values beyond it at its end."""
        low, high = self.limits
        if self.logarithmic:
            low, high, value = math.log(low), math.log(high), math.log(max(value, 1e-300))
        return min(max((value - low) / (high - low), 0.0), 1.0)


def percent_axis(title: str) -> Axis:
    """From 0 to 100 %."""
    return Axis(title, (0.0, 1.0), [(n / 4, f"{25 * n} %") for n in range(5)])


def linear_axis(title: str, low: float, high: float, steps: int = 5) -> Axis:
    """Even ticks from low to high."""
    ticks = [low + (high - low) * n / steps for n in range(steps + 1)]
    return Axis(title, (low, high), [(tick, shown(tick, ".3g")) for tick in ticks])


def logarithmic_axis(title: str, smallest: float, largest: float) -> Axis:
    """Whole decades around smallest and largest, both above 0."""
    first, last = math.floor(math.log10(smallest)), math.ceil(math.log10(largest))
    last = max(last, first + 1)
    ticks = [(10.0**n, shown(10.0**n, ",g")) for n in range(first, last + 1)]
    return Axis(title, (10.0**first, 10.0**last), ticks, True)


def line_chart(series: Sequence[Series], x_axis: Axis, y_axis: Axis, name: str, diagonal: bool = False) -> str:
    """Lines with their intervals as bands; ``diagonal`` draws the line on which both axes agree."""
    frame = _Frame(x_axis, y_axis, [one.name for one in series])
    parts = frame.axes()
    if diagonal:
        (x0, y0), (x1, y1) = frame.point(x_axis.limits[0], y_axis.limits[0]), frame.point(*_ends(x_axis, y_axis))
        parts.append(f'<path d="M{x0:.1f} {y0:.1f}L{x1:.1f} {y1:.1f}" {_stroke("var(--soft)", "4 4", 1)}/>')
    for number, one in enumerate(series):
        parts += _line(frame, one, number)
    return frame.svg(parts + _legend(frame, [one.name for one in series]), name)


def bar_chart(groups: Sequence[str], series: Sequence[Series], x_title: str, y_axis: Axis, name: str) -> str:
    """Bars side by side in named groups, with whiskers; a series' x are the numbers of its groups, from 0."""
    x_axis = Axis(x_title, (0.0, max(float(len(groups)), 1.0)), [(n + 0.5, text) for n, text in enumerate(groups)])
    frame = _Frame(x_axis, y_axis, [one.name for one in series])
    parts = frame.axes(x_grid=False)
    width = 0.76 / max(len(series), 1)
    for number, one in enumerate(series):
        for at, (group, y) in enumerate(zip(one.x, one.y)):
            left = group + 0.12 + number * width
            (x0, top), (x1, floor) = frame.point(left, y), frame.point(left + width * 0.9, y_axis.limits[0])
            # On a logarithmic axis that begins at one, one is seen, too.
            top = min(top, floor - (2.0 if y_axis.logarithmic else 0.5))
            parts.append(
                f'<rect x="{x0:.1f}" y="{top:.1f}" width="{x1 - x0:.1f}" height="{floor - top:.1f}" '
                f'style="fill:{one.color or _color(number)}"/>'
            )
            if one.low is not None:
                middle = (x0 + x1) / 2
                ends = [frame.point(left, value)[1] for value in (one.low[at], one.high[at])]
                parts.append(f'<path d="M{middle:.1f} {ends[0]:.1f}V{ends[1]:.1f}" {_stroke("var(--text)", "", 1)}/>')
    colors = [one.color for one in series]
    return frame.svg(parts + _legend(frame, [one.name for one in series], False, colors), name)


def heat_map(
    values: Sequence[Sequence[float | None]],
    texts: Sequence[Sequence[str]],
    row_names: Sequence[str],
    column_names: Sequence[str],
    y_title: str,
    x_title: str,
    name: str,
) -> str:
    """Cells colored from 0 (dark) to 1 (light) with their texts, as a table: the first row lies at the top.

    There is room for names of any length; very long ones are cut.
    """
    rows, columns = ([_cut(text) for text in names] for names in (row_names, column_names))
    left = TITLE_ROW + 10 + CHARACTER * max(map(_room, rows))
    # Names of columns stand aslant above them.
    top = TITLE_ROW + 10 + 0.71 * CHARACTER * max(map(_room, columns))
    bottom, right = top + CELL_HEIGHT * len(rows), left + CELL_WIDTH * len(columns)
    parts = [_text((left + right) / 2, 14, x_title), _text(14, (top + bottom) / 2, y_title, "middle", -90)]
    for n, text in enumerate(columns):
        parts.append(_text(left + CELL_WIDTH * (n + 0.5), top - 8, text, "start", -45, "soft"))
    for n, (line, line_texts) in enumerate(zip(values, texts)):
        y = top + CELL_HEIGHT * n
        parts.append(_text(left - 8, y + CELL_HEIGHT / 2 + 4, rows[n], "end", 0, "soft"))
        parts += [_cell(left + CELL_WIDTH * m, y, *cell) for m, cell in enumerate(zip(line, line_texts))]
    width = right + 0.71 * CHARACTER * _room(columns[-1])
    return _svg(parts, name, width, bottom + 6, f' style="max-width:{width:.0f}px;max-height:none"')


def reliability_diagram(series: Sequence[Series], x_title: str, y_title: str, name: str) -> str:
    """Share that was right against the confidence that was told; on the diagonal both agree."""
    return line_chart(series, percent_axis(x_title), percent_axis(y_title), name, diagonal=True)


def ramp(value: float) -> tuple[str, str]:
    """(color of a cell, color of the text on it) for a value of 0…1."""
    place = min(max(value, 0.0), 1.0) * (len(CIVIDIS) - 1)
    first = min(int(place), len(CIVIDIS) - 2)
    low, high = (_channels(CIVIDIS[n]) for n in (first, first + 1))
    mixed = [round(a + (b - a) * (place - first)) for a, b in zip(low, high)]
    brightness = 0.299 * mixed[0] + 0.587 * mixed[1] + 0.114 * mixed[2]
    return "#" + "".join(f"{channel:02x}" for channel in mixed), "#000000" if brightness > 130 else "#ffffff"


def _channels(color: str) -> list[int]:
    return [int(color[n : n + 2], 16) for n in (1, 3, 5)]


class _Frame:
    """Where values lie in a chart with axes; ``names``: the entries of the legend above it."""

    def __init__(self, x_axis: Axis, y_axis: Axis, names: Sequence[str]) -> None:
        self.x_axis, self.y_axis = x_axis, y_axis
        self.top = TOP + LEGEND_ROW * math.ceil(len(names) / _entries_a_row(names))
        self.bottom = self.top + HEIGHT - TOP - BOTTOM
        self.height = self.bottom + BOTTOM

    def point(self, x: float, y: float) -> tuple[float, float]:
        return (
            LEFT + self.x_axis.place(x) * (WIDTH - LEFT - RIGHT),
            self.bottom - self.y_axis.place(y) * (self.bottom - self.top),
        )

    def axes(self, x_grid: bool = True, y_grid: bool = True) -> list[str]:
        parts = []
        for value, text in self.y_axis.ticks:
            _, y = self.point(self.x_axis.limits[0], value)
            if y_grid:
                parts.append(f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" {_stroke("var(--line)", "", 1)}/>')
            parts.append(f'<text class="soft" x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end">{escape(text)}</text>')
        for value, text in self.x_axis.ticks:
            x, _ = self.point(value, self.y_axis.limits[0])
            if x_grid:
                parts.append(f'<path d="M{x:.1f} {self.top}V{self.bottom}" {_stroke("var(--line)", "", 1)}/>')
            parts.append(
                f'<text class="soft" x="{x:.1f}" y="{self.bottom + 16}" text-anchor="middle">{escape(text)}</text>'
            )
        middle = (LEFT + WIDTH - RIGHT) / 2
        title = escape(self.x_axis.title)
        parts.append(f'<text x="{middle}" y="{self.height - 8}" text-anchor="middle">{title}</text>')
        across = (self.top + self.bottom) / 2
        parts.append(
            f'<text transform="translate(12 {across:.1f}) rotate(-90)" text-anchor="middle">'
            f"{escape(self.y_axis.title)}</text>"
        )
        return parts

    def svg(self, parts: Sequence[str], name: str) -> str:
        return _svg(parts, name, WIDTH, self.height, f' style="max-width:{WIDEST_PX}px"')


def _ends(x_axis: Axis, y_axis: Axis) -> tuple[float, float]:
    return x_axis.limits[1], y_axis.limits[1]


def _color(number: int) -> str:
    return f"var(--s{number % SERIES})"


def _look(number: int) -> int:
    """Of dash and marker: those of the next color in each further round, so that no two of 16 series look the same."""
    return (number + number // SERIES) % SERIES


def _stroke(color: str, dash: str, width: float) -> str:
    dashes = f";stroke-dasharray:{dash.replace(' ', ',')}" if dash else ""
    return f'style="fill:none;stroke:{color};stroke-width:{width}{dashes}"'


def _line(frame: _Frame, one: Series, number: int) -> list[str]:
    points = [frame.point(x, y) for x, y in zip(one.x, one.y)]
    if not points:
        return []
    parts = []
    if one.low is not None:
        outline = [frame.point(x, y) for x, y in zip(one.x, one.high)]
        outline += [frame.point(x, y) for x, y in zip(one.x, one.low)][::-1]
        path = "L".join(f"{x:.1f} {y:.1f}" for x, y in outline)
        parts.append(f'<path d="M{path}Z" style="fill:{_color(number)};opacity:0.16"/>')
    join = (lambda x, y: f"H{x:.1f}V{y:.1f}") if one.stepped else (lambda x, y: f"L{x:.1f} {y:.1f}")
    path = f"M{points[0][0]:.1f} {points[0][1]:.1f}" + "".join(join(x, y) for x, y in points[1:])
    parts.append(f'<path d="{path}" {_stroke(_color(number), DASHES[_look(number)], 2)}/>')
    return parts + ([_marker(x, y, number) for x, y in points] if one.marked else [])


def _marker(x: float, y: float, number: int) -> str:
    """Disc, square, triangle, diamond, by the series' number."""
    if _look(number) == 0:
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.6" style="fill:{_color(number)}"/>'
    corners = {1: "-3.4-3.4h6.8v6.8h-6.8z", 2: "0-4.6l4.3 7.6h-8.6z", 3: "0-4.8l4.8 4.8l-4.8 4.8l-4.8-4.8z"}
    return f'<path d="M{x:.1f} {y:.1f}m{corners[_look(number)]}" style="fill:{_color(number)}"/>'


def _entries_a_row(names: Sequence[str]) -> int:
    fit = all(_MARK_PX + CHARACTER * _room(name) <= _HALF_PX + RIGHT for name in names)
    return 2 if fit else 1


def _legend(frame: _Frame, names: Sequence[str], lines: bool = True, colors: Sequence[str] = ()) -> list[str]:
    """Two entries a row, above the chart; one where a name is long."""
    parts = []
    abreast = _entries_a_row(names)
    for number, name in enumerate(names):
        row, place = divmod(number, abreast)
        x, y = LEFT + _HALF_PX * place, TOP + LEGEND_ROW * row - 2
        if lines:
            parts.append(f'<path d="M{x:.1f} {y}h24" {_stroke(_color(number), DASHES[_look(number)], 2)}/>')
            parts.append(_marker(x + 12, y, number))
        else:
            color = (colors[number] if colors else "") or _color(number)
            parts.append(f'<rect x="{x + 6:.1f}" y="{y - 6}" width="12" height="12" style="fill:{color}"/>')
        parts.append(f'<text x="{x + _MARK_PX:.1f}" y="{y + 4}">{escape(name)}</text>')
    return parts


def _svg(parts: Sequence[str], name: str, width: float, height: float, more: str = "") -> str:
    return (
        f'<svg viewBox="0 0 {width:.0f} {height:.0f}" role="img" aria-label="{escape(name)}"{more} '
        f'xmlns="http://www.w3.org/2000/svg">\n<title>{escape(name)}</title>\n' + "\n".join(parts) + "\n</svg>"
    )


def _cut(name: str) -> str:
    return name if len(name) <= NAME_LENGTH else name[: NAME_LENGTH - 1] + "…"


def _room(name: str) -> float:
    """Characters, of which Chinese ones are twice as wide."""
    return sum(2 if ord(character) > 0x2E80 else 1 for character in name)


def _cell(x: float, y: float, value: float | None, text: str) -> str:
    fill, ink = ("none", "var(--text)") if value is None else ramp(value)
    return (
        f'<rect x="{x + 1:.1f}" y="{y + 1:.1f}" width="{CELL_WIDTH - 2}" height="{CELL_HEIGHT - 2}" '
        f'style="fill:{fill}"/>'
        f'<text x="{x + CELL_WIDTH / 2:.1f}" y="{y + CELL_HEIGHT / 2 + 4:.1f}" text-anchor="middle" style="fill:{ink}">'
        f"{escape(text)}</text>"
    )


def _text(x: float, y: float, text: str, anchor: str = "middle", turn: float = 0, kind: str = "") -> str:
    turned = f' transform="rotate({turn:g} {x:.1f} {y:.1f})"' if turn else ""
    marked = f' class="{kind}"' if kind else ""
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{marked}{turned}>{escape(text)}</text>'
