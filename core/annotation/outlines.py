"""Outlines of the regions of a label map, as polygons that share borders vertex by vertex.

A ring follows the edges of pixels with its region on its right (rows count downwards): clockwise around the region,
counter-clockwise in its holes. It has a vertex where it turns and where other regions meet at its edge. Edges of one
direction on a grid line are in order. So the n-th vertex that a ring leaves in that direction is followed by the n-th
vertex that a ring reaches in it.

Polygons with such borders (a coverage) are simplified in the same way on both sides.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Callable

import numpy as np
import shapely

from ..labels.class_table import UNLABELED
from ..steps import Shares
from .polygons import to_wkb

RIGHT, DOWN, LEFT, UP = range(4)
_STRAIGHT, _TO_OWN_SIDE, _AWAY = 0, 1, 3
"""Turns: numbers to add to a direction."""

_ROWS_AT_ONCE = 2048

_STARTS_AT_ONCE = 1 << 16

Rows = Callable[[int, int], np.ndarray]
"""(first, last + 1) row of a label map → (rows, W) uint8 or uint16."""


def outline_regions(rows: Rows, shape_hw: tuple[int, int]) -> Shares[tuple[np.ndarray, np.ndarray]]:
    """Return the 4-connected labeled regions of a label map as polygons; yield the share done (0…1).

    Args:
        shape_hw: (height, width) of the label map in pixels.

    Returns:
        (n,) uint16 labels and (n,) valid shapely polygons in pixels (column, row). On shared borders both sides have
        the same vertices. Each ring starts at its topmost vertex, of several at the leftmost.
    """
    corners = yield from _Corners.of(rows, shape_hw)
    if not len(corners.places):
        return np.empty(0, np.uint16), np.empty(0, object)
    order, ends = yield from corners.rings()
    sizes = np.diff(ends, prepend=0)
    begins = ends - sizes
    x, y = corners.columns[order], corners.rows[order]
    after = np.arange(1, len(order) + 1)
    after[ends - 1] = begins
    is_hole = np.add.reduceat(x * y[after] - x[after] * y, begins) < 0
    outer = yield from _outer(corners, order, begins, is_hole, rows)
    by_polygon = np.lexsort((is_hole, outer))
    topmost = _smallest(corners.places[order], begins) - begins
    begins, sizes, topmost = (some[by_polygon] for some in (begins, sizes, topmost))
    # Backwards, so that with y up they have OGC's orientation; each ends at its first vertex.
    ring_ends = np.cumsum(sizes + 1)
    step = np.arange(ring_ends[-1]) - np.repeat(ring_ends - sizes - 1, sizes + 1)
    first, size, begin = (np.repeat(some, sizes + 1) for some in (topmost, sizes, begins))
    closed = begin + (first - step) % size
    polygon_begins = np.flatnonzero(~is_hole[by_polygon])
    points = np.column_stack([x[closed], y[closed]]).astype(np.float64)
    offsets = np.append(0, ring_ends), np.append(polygon_begins, len(ends))
    polygons = shapely.from_ragged_array(shapely.GeometryType.POLYGON, points, offsets)
    return corners.labels[order[begins[polygon_begins]]], np.asarray(polygons, object)


def _outer(
    corners: _Corners, order: np.ndarray, begins: np.ndarray, is_hole: np.ndarray, rows: Rows
) -> Shares[np.ndarray]:
    """Return (rings,) index of the outer ring of each hole; for other rings their own index."""
    outer, holes = np.arange(len(begins)), np.flatnonzero(is_hole)
    if not len(holes):
        return outer
    # Of a hole's leftmost edges: the region around the hole is left of them.
    columns = np.where(corners.leaving[order] == DOWN, corners.columns[order], corners.shape_hw[1] + 1)
    leftmost = order[_smallest(columns, begins)[holes]]
    left_of = yield from corners.left_of(leftmost, rows)
    outer[holes] = _spread(order, begins)[left_of]
    # The ring that bounds the region there may be another hole, but that one extends farther left.
    while is_hole[outer].any():
        outer = outer[outer]
    return outer


def _smallest(values: np.ndarray, begins: np.ndarray) -> np.ndarray:
    """Return (rings,) index of each ring's first smallest value."""
    count = len(values)
    return np.minimum.reduceat(values * count + np.arange(count), begins) % count


@dataclass(frozen=True)
class _Corners:
    """Vertices of rings, sorted by the direction in which the ring reaches them, then by position.

    Attributes:
        shape_hw: (height, width) of the label map.
        places: (N,) int64 row · (width + 1) + column of the grid of corners of pixels.
        coming: (N,) uint8 direction.
        leaving: (N,) uint8 direction.
        labels: (N,) uint16 of the region.
        touches: (N,) bool, whether only the diagonal pixel also has that label, not the pixels beside it.
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
    def of(rows: Rows, shape_hw: tuple[int, int]) -> Shares[_Corners]:
        found: list[list[tuple[np.ndarray, ...]]] = [[], [], [], []]
        for first, labels in _framed(rows, shape_hw):
            yield 0.5 * first / shape_hw[0]
            a, b, c, d = labels[:-1, :-1], labels[:-1, 1:], labels[1:, :-1], labels[1:, 1:]
            # On the right and on the left, before the vertex and after it.
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
            for number, kind in enumerate((np.int64, np.uint8, np.uint16, bool))
        )
        return _Corners(shape_hw, places, coming, leaving, labels, touches)

    def rings(self) -> Shares[tuple[np.ndarray, np.ndarray]]:
        """Return (N,) indices of vertices ring by ring, and (rings,) end of each; no ring touches itself."""
        following = self._following()
        order, ends = yield from _rings(following)
        ring_of = _spread(order, np.append(0, ends[:-1]))
        opposite = [
            [np.flatnonzero(self.touches & (self.coming == direction)) for direction in pair]
            for pair in ((DOWN, UP), (RIGHT, LEFT))
        ]
        one, other = np.concatenate(opposite, axis=1)
        both = ring_of[one] == ring_of[other]
        if not both.any():
            return order, ends
        # A ring that reaches one point twice is two rings that touch there: exchange their continuations.
        one, other = one[both], other[both]
        for some in (following, self.leaving):
            some[one], some[other] = some[other], some[one]
        return (yield from _rings(following))

    def _following(self) -> np.ndarray:
        """Return (N,) int64 index of the next vertex of each."""
        found = np.empty(len(self.places), np.int64)
        for direction in range(4):
            along = self._along(direction)
            starts, ends = (np.flatnonzero(some == direction) for some in (self.leaving, self.coming))
            found[starts[np.argsort(along[starts])]] = ends[np.argsort(along[ends])]
        return found

    def _along(self, direction: int) -> np.ndarray:
        """Return (N,) int64 sort key of vertices along a line."""
        return self.places if direction in (RIGHT, LEFT) else self.columns * (self.shape_hw[0] + 1) + self.rows

    def left_of(self, leftmost: np.ndarray, rows: Rows) -> Shares[np.ndarray]:
        """Return (m,) indices of the vertices at the end of the edges that bound the regions on the left.

        Args:
            leftmost: (m,) indices of vertices that rings leave downwards.
        """
        places, width = self.places[leftmost], self.shape_hw[1] + 1
        changes = places.copy()
        for first, labels in _framed(rows, self.shape_hw):
            # Row n of the frame is row first + n - 1 of the map.
            here = np.flatnonzero((places >= first * width) & (places < (first + len(labels) - 1) * width))
            yield 0.8 + 0.2 * first / self.shape_hw[0]
            if len(here):
                changed = first * width + np.flatnonzero(labels[1:, 1:] != labels[1:, :-1])
                changes[here] = changed[np.searchsorted(changed, places[here]) - 1]
        ends = np.flatnonzero(self.coming == UP)
        along = self._along(UP)[ends]
        by_place = np.argsort(along)
        wanted = changes % width * (self.shape_hw[0] + 1) + changes // width
        return ends[by_place[np.searchsorted(along[by_place], wanted, "right") - 1]]


def _framed(rows: Rows, shape_hw: tuple[int, int]) -> Iterator[tuple[int, np.ndarray]]:
    """Yield first rows of corners, and the labels above and below them with a frame of unlabeled pixels."""
    height, width = shape_hw
    for first in range(0, height + 1, _ROWS_AT_ONCE):
        last = min(first + _ROWS_AT_ONCE, height + 1)
        labels = np.full((last - first + 1, width + 2), UNLABELED, np.uint16)
        top, bottom = max(0, first - 1), min(height, last)
        labels[top - first + 1 : bottom - first + 1, 1:-1] = rows(top, bottom)
        yield first, labels


def _rings(following: np.ndarray) -> Shares[tuple[np.ndarray, np.ndarray]]:
    """Return (N,) indices of vertices ring by ring, and (rings,) end of each."""
    # One by one with plain integers: numpy would need many passes of pointer doubling over all of them.
    after, order, ends = array("q", following.tobytes()), array("q"), array("q")
    add = order.append
    for first in range(len(after)):
        if first % _STARTS_AT_ONCE == 0:
            yield 0.5 + 0.3 * first / len(after)
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
    """Return (N,) index of each vertex's ring."""
    ring_of = np.empty(len(order), np.int64)
    ring_of[order] = np.repeat(np.arange(len(begins)), np.diff(begins, append=len(order)))
    return ring_of


def can_simplify() -> bool:
    """Return whether shapely and GEOS can simplify polygons with shared borders (shapely 2.1 and GEOS 3.12 can)."""
    return hasattr(shapely, "coverage_simplify") and shapely.geos_version >= (3, 12, 0)


def areas_and_wkb(polygons: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (n,) areas and (n,) well-known binaries; for all at once, which is several times as fast as one by one."""
    return shapely.area(polygons), np.asarray(to_wkb(polygons), object)


def simplify(polygons: np.ndarray, tolerance: float) -> np.ndarray:
    """Return (n,) polygons of a coverage with simplified borders, equal on both sides; needs ``can_simplify``.

    Args:
        polygons: (n,) shapely polygons that share borders vertex by vertex.
        tolerance: Corners with a triangle smaller than its square are removed (Visvalingam and Whyatt 1993).
    """
    return np.asarray(shapely.coverage_simplify(polygons, tolerance), object)


def to_map(polygons: np.ndarray, transform: Sequence[float]) -> np.ndarray:
    """Return (n,) polygons in map coordinates from pixel coordinates; ``transform``: GDAL's six numbers."""
    x0, x_column, x_row, y0, y_column, y_row = transform

    def moved(points: np.ndarray) -> np.ndarray:
        columns, rows = points.T
        return np.column_stack([x0 + columns * x_column + rows * x_row, y0 + columns * y_column + rows * y_row])

    return shapely.transform(polygons, moved)
