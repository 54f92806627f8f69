"""Outlines of the regions of a label map, as polygons that share borders vertex by vertex.

A ring runs along the edges of pixels with its region at its right hand (rows count downwards): clockwise around the
region, the other way round in its holes. It has a vertex where it turns and where other regions meet at its edge. Along
a line of the grid, edges of one direction lie one behind the other; so sorted, the n-th vertex that one leaves in that
direction is followed by the n-th that one comes to in it.

Polygons with such borders (a coverage) are simplified alike on both sides.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Callable

import numpy as np
import shapely

from ..labels.class_table import UNLABELED
from .polygons import to_wkb

RIGHT, DOWN, LEFT, UP = range(4)
_STRAIGHT, _TO_OWN_SIDE, _AWAY = 0, 1, 3
"""Turns: what to add to a direction."""

_ROWS_AT_ONCE = 2048

_STARTS_AT_ONCE = 1 << 16

Rows = Callable[[int, int], np.ndarray]
"""(first, one after the last) row of a label map → (rows, W) uint8."""


def outlined(
    rows: Rows, shape_hw: tuple[int, int], proceed: Callable[[], bool] = lambda: True
) -> tuple[np.ndarray, np.ndarray]:
    """Return the 4-connected regions of a label map but those without a label.

    Args:
        shape_hw: (height, width) of the label map in pixels.
        proceed: Asked now and then; once False nothing is found any more.

    Returns:
        (n,) uint8 labels and (n,) shapely polygons in pixels (column, row), valid; where borders are shared, both sides
        have the same vertices. Each ring begins with its topmost vertex, of several with the leftmost.
    """
    nothing = np.empty(0, np.uint8), np.empty(0, object)
    try:
        corners = _Corners.of(rows, shape_hw, proceed)
        return _polygons(corners, rows, proceed) if len(corners.places) else nothing
    except _StoppedError:
        return nothing


def _polygons(corners: _Corners, rows: Rows, proceed: Callable[[], bool]) -> tuple[np.ndarray, np.ndarray]:
    """Return what ``outlined`` gives, of at least one region. Raises _StoppedError."""
    order, ends = corners.rings(proceed)
    sizes = np.diff(ends, prepend=0)
    begins = ends - sizes
    x, y = corners.columns[order], corners.rows[order]
    after = np.arange(1, len(order) + 1)
    after[ends - 1] = begins
    is_hole = np.add.reduceat(x * y[after] - x[after] * y, begins) < 0
    outer = _outer(corners, order, begins, is_hole, rows, proceed)
    by_polygon = np.lexsort((is_hole, outer))
    topmost = _smallest(corners.places[order], begins) - begins
    begins, sizes, topmost = (some[by_polygon] for some in (begins, sizes, topmost))
    # Backwards, so that with y up they run as OGC has it; each ends where it begins.
    ring_ends = np.cumsum(sizes + 1)
    step = np.arange(ring_ends[-1]) - np.repeat(ring_ends - sizes - 1, sizes + 1)
    first, size, begin = (np.repeat(some, sizes + 1) for some in (topmost, sizes, begins))
    closed = begin + (first - step) % size
    polygon_begins = np.flatnonzero(~is_hole[by_polygon])
    points = np.column_stack([x[closed], y[closed]]).astype(np.float64)
    offsets = np.append(0, ring_ends), np.append(polygon_begins, len(ends))
    polygons = shapely.from_ragged_array(shapely.GeometryType.POLYGON, points, offsets)
    return corners.labels[order[begins[polygon_begins]]], np.asarray(polygons, object)


def _outer(  # noqa: PLR0913 - rings as they were found
    corners: _Corners,
    order: np.ndarray,
    begins: np.ndarray,
    is_hole: np.ndarray,
    rows: Rows,
    proceed: Callable[[], bool],
) -> np.ndarray:
    """Return (rings,) number of the ring around each, of one that is no hole its own."""
    outer, holes = np.arange(len(begins)), np.flatnonzero(is_hole)
    if not len(holes):
        return outer
    # Of a hole's edges that lie farthest left: its region is left of there.
    columns = np.where(corners.leaving[order] == DOWN, corners.columns[order], corners.shape_hw[1] + 1)
    leftmost = order[_smallest(columns, begins)[holes]]
    outer[holes] = _spread(order, begins)[corners.left_of(leftmost, rows, proceed)]
    # What bounds the region there may be another hole, but that one reaches farther left.
    while is_hole[outer].any():
        outer = outer[outer]
    return outer


def _smallest(values: np.ndarray, begins: np.ndarray) -> np.ndarray:
    """Return (rings,) place of each ring's first smallest value."""
    count = len(values)
    return np.minimum.reduceat(values * count + np.arange(count), begins) % count


@dataclass(frozen=True)
class _Corners:
    """Vertices of rings, sorted by the direction in which one comes to them, then by place.

    Attributes:
        shape_hw: (height, width) of the label map.
        places: (N,) int64 row · (width + 1) + column of the grid of corners of pixels.
        coming: (N,) uint8 direction.
        leaving: (N,) uint8 direction.
        labels: (N,) uint8 of the region.
        touches: (N,) bool, whether the pixel across the corner, and neither beside it, has that label, too.
    """

    shape_hw: tuple[int, int]
    places: np.ndarray
    coming: np.ndarray
    leaving: np.ndarray
    labels: np.ndarray
    touches: np.ndarray

    @property
    def columns(self) -> np.ndarray:
        return self.places % (self.shape_hw[1] + 1)

    @property
    def rows(self) -> np.ndarray:
        return self.places // (self.shape_hw[1] + 1)

    @staticmethod
    def of(rows: Rows, shape_hw: tuple[int, int], proceed: Callable[[], bool]) -> _Corners:
        found: list[list[tuple[np.ndarray, ...]]] = [[], [], [], []]
        for first, labels in _framed(rows, shape_hw):
            if not proceed():
                raise _StoppedError
            a, b, c, d = labels[:-1, :-1], labels[:-1, 1:], labels[1:, :-1], labels[1:, 1:]
            # At the right hand and at the left one, before the vertex and beyond it.
            seen = ((c, a, d, b), (a, b, c, d), (b, d, a, c), (d, c, b, a))
            for direction, (own, across, ahead, beyond) in enumerate(seen):
                turns = (ahead != own) | (across != beyond)
                at = np.flatnonzero(turns & (own != across) & (own != UNLABELED))
                own, ahead, beyond = (part.ravel()[at] for part in (own, ahead, beyond))
                turn = np.where(ahead != own, _TO_OWN_SIDE, np.where(beyond == own, _AWAY, _STRAIGHT))
                leaving = ((direction + turn) % 4).astype(np.uint8)
                touches = (turn == _TO_OWN_SIDE) & (beyond == own)
                found[direction].append((first * (shape_hw[1] + 1) + at, leaving, own, touches))
        counts = [sum(len(part[0]) for part in some) for some in found]
        coming = np.repeat(np.arange(4, dtype=np.uint8), counts)
        places, leaving, labels, touches = (
            np.concatenate([part[number] for some in found for part in some] or [np.empty(0, kind)])
            for number, kind in enumerate((np.int64, np.uint8, np.uint8, bool))
        )
        return _Corners(shape_hw, places, coming, leaving, labels, touches)

    def rings(self, proceed: Callable[[], bool]) -> tuple[np.ndarray, np.ndarray]:
        """Return (N,) numbers of vertices ring by ring, and (rings,) where each ends there; no ring meets itself."""
        following = self._following()
        order, ends = _rings(following, proceed)
        ring_of = _spread(order, np.append(0, ends[:-1]))
        opposite = [
            [np.flatnonzero(self.touches & (self.coming == direction)) for direction in pair]
            for pair in ((DOWN, UP), (RIGHT, LEFT))
        ]
        one, other = np.concatenate(opposite, axis=1)
        both = ring_of[one] == ring_of[other]
        if not both.any():
            return order, ends
        # A ring that comes to one place twice is two that touch there: each goes on where the other would have.
        one, other = one[both], other[both]
        for some in (following, self.leaving):
            some[one], some[other] = some[other], some[one]
        return _rings(following, proceed)

    def _following(self) -> np.ndarray:
        """Return (N,) int64 number of the vertex after each."""
        found = np.empty(len(self.places), np.int64)
        for direction in range(4):
            along = self._along(direction)
            starts, ends = (np.flatnonzero(some == direction) for some in (self.leaving, self.coming))
            found[starts[np.argsort(along[starts])]] = ends[np.argsort(along[ends])]
        return found

    def _along(self, direction: int) -> np.ndarray:
        """Return (N,) int64 by which vertices of a line follow each other."""
        return self.places if direction in (RIGHT, LEFT) else self.columns * (self.shape_hw[0] + 1) + self.rows

    def left_of(self, leftmost: np.ndarray, rows: Rows, proceed: Callable[[], bool]) -> np.ndarray:
        """Return (m,) numbers of the vertices to which the edge comes that bounds a region at its left.

        Args:
            leftmost: (m,) numbers of vertices which one leaves downwards.
            proceed: Asked now and then.
        """
        places, width = self.places[leftmost], self.shape_hw[1] + 1
        changes = places.copy()
        for first, labels in _framed(rows, self.shape_hw):
            # Row n of the frame is row first + n - 1 of the map.
            here = np.flatnonzero((places >= first * width) & (places < (first + len(labels) - 1) * width))
            if not proceed():
                raise _StoppedError
            if len(here):
                changed = first * width + np.flatnonzero(labels[1:, 1:] != labels[1:, :-1])
                changes[here] = changed[np.searchsorted(changed, places[here]) - 1]
        ends = np.flatnonzero(self.coming == UP)
        along = self._along(UP)[ends]
        by_place = np.argsort(along)
        wanted = changes % width * (self.shape_hw[0] + 1) + changes // width
        return ends[by_place[np.searchsorted(along[by_place], wanted, "right") - 1]]


def _framed(rows: Rows, shape_hw: tuple[int, int]) -> Iterator[tuple[int, np.ndarray]]:
    """Return (number of the first row of corners, labels of the rows above and below each, with a frame without a label)."""
    height, width = shape_hw
    for first in range(0, height + 1, _ROWS_AT_ONCE):
        last = min(first + _ROWS_AT_ONCE, height + 1)
        labels = np.full((last - first + 1, width + 2), UNLABELED, np.uint8)
        top, bottom = max(0, first - 1), min(height, last)
        labels[top - first + 1 : bottom - first + 1, 1:-1] = rows(top, bottom)
        yield first, labels


class _StoppedError(Exception):
    """Nothing more is to be found."""


def _rings(following: np.ndarray, proceed: Callable[[], bool]) -> tuple[np.ndarray, np.ndarray]:
    """Return (N,) numbers of vertices ring by ring, and (rings,) where each ends there. Raises _StoppedError."""
    # One by one, but in plain numbers: numpy would have to double its steps through all of them again and again.
    after, order, ends = array("q", following.tobytes()), array("q"), array("q")
    add = order.append
    for first in range(len(after)):
        if first % _STARTS_AT_ONCE == 0 and not proceed():
            raise _StoppedError
        if after[first] < 0:
            continue
        place = first
        while after[place] >= 0:
            add(place)
            here, place = place, after[place]
            after[here] = -1
        ends.append(len(order))
    return np.frombuffer(order, np.int64), np.frombuffer(ends, np.int64)


def _spread(order: np.ndarray, begins: np.ndarray) -> np.ndarray:
    """Return (N,) number of each vertex's ring."""
    ring_of = np.empty(len(order), np.int64)
    ring_of[order] = np.repeat(np.arange(len(begins)), np.diff(begins, append=len(order)))
    return ring_of


def can_simplify() -> bool:
    """Return whether this shapely and GEOS can simplify polygons that share borders (shapely 2.1 and GEOS 3.12 can)."""
    return hasattr(shapely, "coverage_simplify") and shapely.geos_version >= (3, 12, 0)


def areas_and_wkb(polygons: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (n,) areas and (n,) well-known binaries; of all at once, for asking each polygon takes several times as long."""
    return shapely.area(polygons), np.asarray(to_wkb(polygons), object)


def simplified(polygons: np.ndarray, tolerance: float) -> np.ndarray:
    """Return (n,) polygons of a coverage, borders straightened alike on both sides; needs ``can_simplify``.

    Args:
        polygons: (n,) shapely polygons that share borders vertex by vertex.
        tolerance: Corners go whose triangle is smaller than the square of it (Visvalingam and Whyatt 1993).
    """
    return np.asarray(shapely.coverage_simplify(polygons, tolerance), object)


def on_map(polygons: np.ndarray, transform: Sequence[float]) -> np.ndarray:
    """Return (n,) polygons in pixel coordinates (column, row), in map coordinates; ``transform``: GDAL's six numbers."""
    x0, x_column, x_row, y0, y_column, y_row = transform

    def moved(points: np.ndarray) -> np.ndarray:
        columns, rows = points.T
        return np.column_stack([x0 + columns * x_column + rows * x_row, y0 + columns * y_column + rows * y_row])

    return shapely.transform(polygons, moved)
