"""Maps as inline SVG, north up: squares of an assessment, the track of a flight, a route."""

from __future__ import annotations

import base64
import math
from collections.abc import Sequence

import numpy as np

from ...core.assessment.route import RoutePoints, stretch
from ..layers import palette
from ..layers.localized_image import LocalizedImage
from ..translation import tr
from . import page
from .charts import Element, drawing, lettering, polyline, shape, stroke

WIDTH, HEIGHT = 960, 560
MARGIN = 44
RADIUS = 4.0
"""Radius of the disc at a position, pixels."""

NEEDLE = 13.0
"""Length of the line that shows the heading, pixels."""

HALO = "font-size:18px;paint-order:stroke;stroke:var(--ground);stroke-width:4"
"""Style of text on any background; a map on paper is half as large."""

ROUTE_HEIGHT = 400
"""Smallest height of a route's map, to show its surroundings."""

RIMS = (("9", palette.INK), ("7.5", palette.CASING))
"""Widths and colors of the outlines of a route, as in its layer."""

PICTURE_PX = 2 * WIDTH
"""Width of the picture below a route, sufficient for paper."""

SuccessClass = tuple[float, float, str, str]
"""(from, to, color, text) of a class of expected success."""


class PageMap:
    """Transform of map coordinates to a map on the page, with a scale bar."""

    def __init__(self, x_min: float, y_min: float, x_max: float, y_max: float, least_height: float = 120) -> None:
        across, up = max(x_max - x_min, 1e-9), max(y_max - y_min, 1e-9)
        self.unit = min((WIDTH - 2 * MARGIN) / across, (HEIGHT - 2 * MARGIN) / up)
        self.height = max(up * self.unit + 2 * MARGIN, least_height)
        # Map coordinates of the upper left corner
        self._x = (x_min + x_max) / 2 - WIDTH / 2 / self.unit
        self._y = (y_min + y_max) / 2 + self.height / 2 / self.unit

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """(x_min, y_min, x_max, y_max) of the map."""
        return self._x, self._y - self.height / self.unit, self._x + WIDTH / self.unit, self._y

    def at(self, position: Sequence[float]) -> tuple[float, float]:
        return (position[0] - self._x) * self.unit, (self._y - position[1]) * self.unit

    def drawing(self, elements: Sequence[Element], name: str) -> str:
        return drawing([*elements, *self._scale_bar()], name, WIDTH, self.height)

    def _scale_bar(self) -> list[Element]:
        """Return a bar of a round length, at most a quarter of the width, lower left."""
        most = WIDTH / 4 / self.unit
        decade = 10 ** math.floor(math.log10(most))
        length = next(step * decade for step in (5, 2, 1) if step * decade <= most)
        x, y, end = MARGIN / 2, self.height - 14, MARGIN / 2 + length * self.unit
        text, bar = f"{length / 1000:g} km" if length >= 1000 else f"{length:g} m", f"M{x} {y - 4}v4H{end:.1f}v-4"
        return [
            shape("path", stroke("var(--ground)", 4), d=bar),
            shape("path", stroke("var(--text)"), d=bar),
            lettering(end + 6, y, text, "start", style=HALO),
        ]


def success_legend(classes: Sequence[SuccessClass]) -> str:
    """Return a legend of the classes, from best to worst."""
    return color_legend([(color, text) for _, _, color, text in classes[::-1]])


def color_legend(colors: Sequence[tuple[str, str]]) -> str:
    """Return a legend of (color, text)."""
    return page.macros().legend(
        [
            ([shape("rect", f"fill:{color};stroke:var(--soft)", x=0.5, y=0.5, width=11, height=11)], text)
            for color, text in colors
        ]
    )


def cell_map(
    columns: np.ndarray, rows: np.ndarray, success: np.ndarray, classes: Sequence[SuccessClass], name: str
) -> str:
    """Return a map of squares at columns (C,) and rows (C,) colored by success (C,) 0…1."""
    kinds = _kinds(success, classes)
    order = np.lexsort((columns, rows))
    columns, rows, kinds = columns[order], rows[order], kinds[order]
    # Merge neighbors of one class in a row to a rectangle.
    breaks = (np.diff(columns) != 1) | (np.diff(rows) != 0) | (np.diff(kinds) != 0)
    starts = np.concatenate([[0], np.flatnonzero(breaks) + 1])
    lengths = np.diff(np.append(starts, len(columns)))
    # Slightly larger, to avoid visible gaps.
    squares = [
        shape(
            "rect",
            f"fill:{classes[kinds[n]][2]}",
            x=f"{columns[n]}",
            y=f"{rows[n]}",
            width=f"{wide + 0.03:g}",
            height="1.03",
        )
        for n, wide in zip(starts, lengths)
    ]
    return drawing(squares, name, int(columns.max()) + 1, int(rows.max()) + 1, "max-height:560px")


def _kinds(success: np.ndarray, classes: Sequence[SuccessClass]) -> np.ndarray:
    """Return the class numbers of success values."""
    return sum((success >= low).astype(int) for low, *_ in classes[1:])


def route_ground(points: RoutePoints) -> PageMap:
    return PageMap(*points.places.min(0), *points.places.max(0), ROUTE_HEIGHT)


def route_map(
    points: RoutePoints, success: np.ndarray, classes: Sequence[SuccessClass], below: bytes, name: str
) -> str:
    """Return a map of a route colored by success (N,) 0…1; ``below``: JPEG of the map's extent, or empty."""
    ground, parts = route_ground(points), []
    if below:
        href = f"data:image/jpeg;base64,{base64.b64encode(below).decode('ascii')}"
        parts.append(shape("image", "", href=href, x=0, y=0, width=WIDTH, height=ground.height))
    lines = [np.flatnonzero(points.lines == line) for line in range(len(points.lengths))]
    round_ends = ";stroke-linecap:round;stroke-linejoin:round"
    for width, color in RIMS:
        for members in lines:
            path = [ground.at(place) for place in points.places[members]]
            parts.append(polyline(path, stroke(color, width) + round_ends))
    kinds = _kinds(success, classes)
    for members in lines:
        for run in np.split(members, np.flatnonzero(np.diff(kinds[members])) + 1):
            path = [ground.at(place) for n in run for place in stretch(points, n)]
            parts.append(polyline(path, stroke(classes[kinds[run[0]]][2], 5) + round_ends))
    starts = [(ground.at(points.places[members[0]]), str(number)) for number, members in enumerate(lines, start=1)]
    numbers = [lettering(x, y - 10, number, style=HALO) for (x, y), number in starts]
    return ground.drawing(parts + (numbers if len(lines) > 1 else []), name)


def flight_legend() -> str:
    texts = tr("Own position"), tr("Position from the flight"), tr("Own position outvoted")
    return page.macros().legend([([_mark(6, 6, 4, kind)], text) for kind, text in enumerate(texts)])


def flight_map(placed: Sequence[tuple[int, LocalizedImage]], name: str) -> str:
    """Return a map of the placed images of a flight, with their numbers: discs, headings and 95 % ellipses."""
    far = np.array([item.ellipse.semi_major if item.ellipse else 0.0 for _, item in placed])[:, None]
    places = np.array([item.position for _, item in placed])
    ground = PageMap(*(places - far).min(0), *(places + far).max(0))
    parts = []
    for track in sorted({item.pose.track for _, item in placed}):
        path = [ground.at(item.position) for _, item in placed if item.pose.track == track]
        parts.append(polyline(path, stroke("var(--soft)", 1.4)))
    parts += [_ellipse(item, *ground.at(item.position), ground.unit) for _, item in placed if item.ellipse]
    for number, item in placed:
        parts += _disc(item, f"{number}: {item.name}", *ground.at(item.position))
    return ground.drawing(parts, name)


_COLORS = "var(--s0)", "var(--s1)", "var(--bad)"
"""Colors of own positions, positions from the flight, and outvoted own positions."""


def _kind(item: LocalizedImage) -> int:
    return 2 if item.is_outvoted else 0 if item.source == "own" else 1


def _mark(x: float, y: float, r: float, kind: int, title: str = "") -> Element:
    """Return a disc for an own position, a ring for the flight, or a cross for an outvoted own position."""
    color = _COLORS[kind]
    if kind == 2:
        path = f"M{x - r:.1f} {y - r:.1f}l{2 * r} {2 * r}m0 {-2 * r}l{-2 * r} {2 * r}"
        return shape("path", stroke(color, 2), title, d=path)
    fill = color if kind == 0 else "var(--ground)"
    return shape("circle", f"fill:{fill};stroke:{color};stroke-width:1.8", title, cx=x, cy=y, r=r)


def _disc(item: LocalizedImage, title: str, x: float, y: float) -> list[Element]:
    kind, needle = _kind(item), []
    if item.result.heading_deg is not None:
        turn = math.radians(item.result.heading_deg)
        end = x + NEEDLE * math.sin(turn), y - NEEDLE * math.cos(turn)
        needle = [polyline([(x, y), end], stroke(_COLORS[kind], 1.6))]
    return [*needle, _mark(x, y, RADIUS, kind, title)]


def _ellipse(item: LocalizedImage, x: float, y: float, unit: float) -> Element:
    known, color = item.ellipse, _COLORS[_kind(item)]
    turn = f"rotate({known.orientation_deg:.1f} {x:.1f} {y:.1f})"
    style = f"fill:{color};fill-opacity:0.15;stroke:{color};stroke-width:0.8"
    return shape("ellipse", style, cx=x, cy=y, rx=known.semi_minor * unit, ry=known.semi_major * unit, transform=turn)
