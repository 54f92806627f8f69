"""Sketches of the ground as inline SVG, north up: squares of an assessment, the track of a flight, a route."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..translation import tr
from . import page
from .charts import Element, drawing, lettering, polyline, shape, stroke

if TYPE_CHECKING:
    from .flight_report import FlightPoint

WIDTH, HEIGHT = 960, 560
MARGIN = 44
RADIUS = 4.0
"""Of the disc at a position, pixels."""

NEEDLE = 13.0
"""From its center to where the image's top points, pixels."""

SuccessClass = tuple[float, float, str, str]
"""From, to, color and text of a class of expected success."""


class Ground:
    """Where map coordinates lie in a sketch that is as large as the page has room for; with a scale bar."""

    def __init__(self, x_min: float, y_min: float, x_max: float, y_max: float) -> None:
        across, up = max(x_max - x_min, 1e-9), max(y_max - y_min, 1e-9)
        self.unit = min((WIDTH - 2 * MARGIN) / across, (HEIGHT - 2 * MARGIN) / up)
        self.height = max(up * self.unit + 2 * MARGIN, 120)
        self._left, self._x_min, self._y_max = (WIDTH - across * self.unit) / 2, x_min, y_max

    def at(self, position: Sequence[float]) -> tuple[float, float]:
        return self._left + (position[0] - self._x_min) * self.unit, MARGIN + (self._y_max - position[1]) * self.unit

    def drawing(self, elements: Sequence[Element], name: str) -> str:
        return drawing([*elements, *self._scale_bar()], name, WIDTH, self.height)

    def _scale_bar(self) -> list[Element]:
        """A round length of at most a quarter of the width, lower left."""
        most = WIDTH / 4 / self.unit
        decade = 10 ** math.floor(math.log10(most))
        length = next(step * decade for step in (5, 2, 1) if step * decade <= most)
        x, y, end = MARGIN / 2, self.height - 14, MARGIN / 2 + length * self.unit
        text = f"{length / 1000:g} km" if length >= 1000 else f"{length:g} m"
        return [
            shape("path", stroke("var(--text)"), d=f"M{x} {y - 4}v4H{end:.1f}v-4"),
            lettering(end + 6, y, text, "start"),
        ]


def success_legend(classes: Sequence[SuccessClass]) -> str:
    """The classes beside each other, from good to bad."""
    return color_legend([(color, text) for _, _, color, text in classes[::-1]])


def color_legend(colors: Sequence[tuple[str, str]]) -> str:
    """Colors with what they mean, beside each other."""
    return page.macros().legend(
        [
            ([shape("rect", f"fill:{color};stroke:var(--soft)", x=0.5, y=0.5, width=11, height=11)], text)
            for color, text in colors
        ]
    )


def cell_map(
    columns: np.ndarray, rows: np.ndarray, success: np.ndarray, classes: Sequence[SuccessClass], name: str
) -> str:
    """Squares at columns (C,) and rows (C,) colored by success (C,) 0…1."""
    kinds = _kinds(success, classes)
    order = np.lexsort((columns, rows))
    columns, rows, kinds = columns[order], rows[order], kinds[order]
    # Neighbors of one kind in a row are one rectangle.
    breaks = (np.diff(columns) != 1) | (np.diff(rows) != 0) | (np.diff(kinds) != 0)
    starts = np.concatenate([[0], np.flatnonzero(breaks) + 1])
    lengths = np.diff(np.append(starts, len(columns)))
    # A hair wider than they are, so that no gaps show between neighbors.
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
    """Numbers of the classes of success."""
    return sum((success >= low).astype(int) for low, *_ in classes[1:])


def flight_legend() -> str:
    """The kinds of positions beside each other."""
    texts = tr("Fix of the image itself"), tr("Placed by the flight"), tr("Its own fix was outvoted")
    return page.macros().legend([([_mark(6, 6, 4, kind)], text) for kind, text in enumerate(texts)])


def flight_map(placed: Sequence[FlightPoint], name: str) -> str:
    """The images that have a position: discs, headings and error ellipses."""
    far = np.array([point.ellipse[0] if point.ellipse else 0.0 for point in placed])[:, None]
    places = np.array([point.position for point in placed])
    ground = Ground(*(places - far).min(0), *(places + far).max(0))
    parts = []
    for track in sorted({point.track for point in placed}):
        path = [ground.at(point.position) for point in placed if point.track == track]
        parts.append(polyline(path, stroke("var(--soft)", 1.4)))
    parts += [_ellipse(point, *ground.at(point.position), ground.unit) for point in placed if point.ellipse]
    for point in placed:
        parts += _disc(point, *ground.at(point.position))
    return ground.drawing(parts, name)


_COLORS = "var(--s0)", "var(--s1)", "var(--bad)"
"""Of positions by a fix of their own, by the flight, and against their own fix."""


def _kind(point: FlightPoint) -> int:
    return 2 if point.outvoted else 0 if point.source == "own" else 1


def _mark(x: float, y: float, r: float, kind: int, title: str = "") -> Element:
    """Filled for an own fix, a ring by the flight, a cross against its own fix: told apart without colors."""
    color = _COLORS[kind]
    if kind == 2:
        path = f"M{x - r:.1f} {y - r:.1f}l{2 * r} {2 * r}m0 {-2 * r}l{-2 * r} {2 * r}"
        return shape("path", stroke(color, 2), title, d=path)
    fill = color if kind == 0 else "var(--ground)"
    return shape("circle", f"fill:{fill};stroke:{color};stroke-width:1.8", title, cx=x, cy=y, r=r)


def _disc(point: FlightPoint, x: float, y: float) -> list[Element]:
    kind, needle = _kind(point), []
    if point.heading_deg is not None:
        turn = math.radians(point.heading_deg)
        end = x + NEEDLE * math.sin(turn), y - NEEDLE * math.cos(turn)
        needle = [polyline([(x, y), end], stroke(_COLORS[kind], 1.6))]
    return [*needle, _mark(x, y, RADIUS, kind, f"{point.number}: {point.name}")]


def _ellipse(point: FlightPoint, x: float, y: float, unit: float) -> Element:
    major, minor, direction = point.ellipse
    color = _COLORS[_kind(point)]
    turn = f"rotate({direction:.1f} {x:.1f} {y:.1f})"
    style = f"fill:{color};fill-opacity:0.15;stroke:{color};stroke-width:0.8"
    return shape("ellipse", style, cx=x, cy=y, rx=minor * unit, ry=major * unit, transform=turn)
