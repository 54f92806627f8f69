"""Topology vectors of all windows of a map, equal to describing each window separately but much faster.

A region inside a window is the same in every window around it, so it is measured once for the whole map. Only regions
that a window border cuts are measured again, each in the smallest patch that contains it: those on the upper and lower
border once for a row of windows, those on the left and right border once for a window.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from operator import itemgetter

import cv2
import numpy as np

from ..landmarks.landmarks import (
    BOTTOM,
    CENTER_X,
    CENTER_Y,
    CLASS,
    LEFT,
    NO_ROWS,
    RIGHT,
    TOP,
    Landmarks,
    class_mask,
    contour_row,
    rows_array,
    rows_from_objects,
    shift_row,
    shift_rows,
)
from .grid import WindowGrid
from .topology_vector import MINIMUM_REFERENCES, TIE_DECIMALS, class_ranks, topology_vectors

KNOWN_CUTS = 200_000
"""Number of cuts cached from strip to strip; the cache is then cleared, to limit memory."""


@dataclass(frozen=True)
class DescribedWindows:
    """M windows of a grid, row by row.

    Attributes:
        columns: (M,) first pixel column of each.
        rows: (M,) first pixel row of each.
        counts: (M,) int64 landmarks in each.
        vectors: (M, 3·X) float32, zeros where ``counts`` is below MINIMUM_REFERENCES.
    """

    columns: np.ndarray
    rows: np.ndarray
    counts: np.ndarray
    vectors: np.ndarray


def describe_windows(  # noqa: PLR0913 - labels, landmark settings, and vector settings
    labels_hw: np.ndarray,
    grid: WindowGrid,
    objects: Landmarks,
    reference_values: Sequence[int],
    minimum_area_px: float,
    references_per_vector: int,
) -> DescribedWindows:
    """Describe the windows of a grid.

    Args:
        labels_hw: (H, W) uint8, the whole area of the grid.
        objects: Every landmark that overlaps the labels, with at least the same minimum area, uncut.
        minimum_area_px: Smaller regions are not landmarks.
        references_per_vector: X, largest number of landmarks in a vector.
    """
    all_rows, columns = rows_from_objects(objects), grid.columns
    cuts: dict[tuple, list] = {}
    found = []
    for row in grid.rows.tolist():
        near = all_rows[(all_rows[:, BOTTOM] > row) & (all_rows[:, TOP] < row + grid.size)]
        strip = _Strip(labels_hw[row : row + grid.size], shift_rows(near, 0, -row), row, columns, cuts)
        found.append(strip.describe(grid.size, reference_values, minimum_area_px, references_per_vector))
    counts, vectors = (np.concatenate(some) for some in zip(*found))
    return DescribedWindows(np.tile(columns, len(grid.rows)), np.repeat(grid.rows, len(columns)), counts, vectors)


@dataclass(frozen=True)
class _Border:
    """Two opposite sides of a frame that cuts regions.

    Attributes:
        frame: (left, top, right, bottom), pixels of the strip.
        sides: TOP and BOTTOM, or LEFT and RIGHT.
        done: Sides that were processed before.
    """

    frame: tuple[int, int, int, int]
    sides: Sequence[int]
    done: Sequence[int] = ()

    def is_first_of(self, bounds: tuple[int, int, int, int]) -> bool:
        """Return whether a region with these bounds touches one of the sides, but no side in ``done``."""
        touches = any(bounds[side - LEFT] == self.frame[side - LEFT] for side in self.sides)
        return touches and all(bounds[other - LEFT] != self.frame[other - LEFT] for other in self.done)


class _Strip:
    """One row of windows: its labels and the regions near it, in pixel coordinates of the strip."""

    def __init__(
        self,
        labels: np.ndarray,
        near: np.ndarray,
        first_row: int,
        columns: np.ndarray,
        known_cuts: dict[tuple, list],
    ) -> None:
        """Store the data of one row of windows.

        Args:
            labels: (size, W) uint8.
            near: (N, 8) region rows of the map that overlap the strip.
            first_row: First row of the strip, in the coordinates of ``known_cuts``.
            columns: (M,) first columns of the windows in the strip.
            known_cuts: Cache that the strips of one grid share.
        """
        self._known_cuts = known_cuts
        self.labels = labels
        self._near = near
        self._first_row = first_row
        self._columns = columns

    def describe(
        self, size: int, reference_values: Sequence[int], minimum_area: float, references_per_vector: int
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return counts and vectors of the windows, see ``DescribedWindows``."""
        columns = self._columns
        counts = np.zeros(len(columns), np.int64)
        nearest: list[np.ndarray] = [NO_ROWS] * len(columns)
        for k, rows in enumerate(self._regions_by_window(size, minimum_area)):
            counts[k] = len(rows)
            nearest[k] = _nearest(rows, np.array([columns[k] + size / 2, size / 2]), references_per_vector)
        vectors = np.zeros((len(columns), 3 * references_per_vector), np.float32)
        described = np.flatnonzero(counts >= MINIMUM_REFERENCES)
        if len(described):
            vectors[described] = _vectors([nearest[k] for k in described], reference_values, references_per_vector)
        return counts, vectors

    def _regions_by_window(self, size: int, minimum_area: float) -> Iterator[np.ndarray]:
        regions = self._regions(minimum_area)
        listed = regions.tolist()
        on_left = _rows_by_line(regions, self._columns)
        on_right = _rows_by_line(regions, self._columns + size - 1)
        begins = np.searchsorted(regions[:, LEFT], self._columns, side="right").tolist()
        ends = np.searchsorted(regions[:, LEFT], self._columns + size, side="left").tolist()
        for k, column in enumerate(self._columns.tolist()):
            inside = regions[begins[k] : ends[k]]
            inside = inside[inside[:, RIGHT] < column + size]
            frame = (column, 0, column + size, size)
            crossing = sorted({*on_left.get(k, ()), *on_right.get(k, ())})
            cut = self._cut([listed[n] for n in crossing], _Border(frame, _VERTICAL), minimum_area)
            yield np.concatenate([inside, rows_array(cut)]) if cut else inside

    def _regions(self, minimum_area: float) -> np.ndarray:
        """Return region rows as cut by the strip, ordered by their left end."""
        height, width = self.labels.shape
        frame = (0, 0, width, height)
        reaches = _reaches(self._near, frame)
        cut = []
        for sides, done in ((_HORIZONTAL, ()), (_VERTICAL, _HORIZONTAL)):
            reached = reaches[sides[0]] | reaches[sides[1]]
            cut += self._cut(self._near[reached].tolist(), _Border(frame, sides, done), minimum_area)
        whole = self._near[~np.any(list(reaches.values()), axis=0)]
        rows = np.concatenate([whole, rows_array(cut)])
        return rows[np.argsort(rows[:, LEFT], kind="stable")]

    def _cut(self, crossing: list, border: _Border, minimum_area: float) -> list:
        """Return rows (tuples) of the parts inside a frame of the regions (rows) ``crossing`` one of two sides.

        Every part of a cut region has pixels on a side of the frame, and every pixel of a landmark class on this side
        belongs to one of the regions ``crossing`` it (or to a too small one). So the contours that touch a side are
        exactly the wanted ones. Those on a side in ``done`` were found before.
        """
        found = []
        for value in sorted({int(row[CLASS]) for row in crossing}):
            for patch in _patches([row for row in crossing if row[CLASS] == value], border.frame, border.sides):
                if border.sides == _VERTICAL and patch[1] > 0 and patch[3] < len(self.labels):
                    found += self._cut_in_many_strips(value, patch, border, minimum_area)
                else:
                    found += self._cut_in_patch(value, patch, border, minimum_area)
        return found

    def _cut_in_many_strips(
        self, value: int, patch: tuple[int, int, int, int], border: _Border, minimum_area: float
    ) -> list:
        """Cut at a vertical line well inside the strip: the result is valid for the strips above and below, too."""
        row = self._first_row
        left, top, right, bottom = patch
        frame = border.frame
        key = border.sides, value, left, top + row, right, bottom + row, frame[0], frame[2], LEFT in border.done
        known = self._known_cuts.get(key)
        if known is None:
            if len(self._known_cuts) >= KNOWN_CUTS:
                self._known_cuts.clear()
            cut = self._cut_in_patch(value, patch, border, minimum_area)
            known = [shift_row(found, 0, row) for found in cut]
            self._known_cuts[key] = known
        return [shift_row(found, 0, -row) for found in known]

    def _cut_in_patch(self, value: int, patch: tuple[int, int, int, int], border: _Border, minimum_area: float) -> list:
        left, top, right, bottom = patch
        found = []
        mask = class_mask(self.labels[top:bottom, left:right], value)
        # A region on a side of the patch is in no hole of another region.
        for contour in cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)[0]:
            x, y, width, height = cv2.boundingRect(contour)
            if border.is_first_of((left + x, top + y, left + x + width, top + y + height)):
                row = contour_row(contour, value, minimum_area)
                found += [] if row is None else [shift_row(row, left, top)]
        return found


_HORIZONTAL, _VERTICAL = (TOP, BOTTOM), (LEFT, RIGHT)


def _reaches(rows: np.ndarray, frame: tuple[int, int, int, int]) -> dict[int, np.ndarray]:
    """Return for each side of ``frame`` a mask of the regions that touch or cross that side's line of pixels."""
    return {
        LEFT: rows[:, LEFT] <= frame[0],
        TOP: rows[:, TOP] <= frame[1],
        RIGHT: rows[:, RIGHT] >= frame[2],
        BOTTOM: rows[:, BOTTOM] >= frame[3],
    }


def _patches(
    crossing: list, frame: tuple[int, int, int, int], sides: Sequence[int]
) -> Iterator[tuple[int, int, int, int]]:
    """Yield (left, top, right, bottom) of patches inside ``frame`` that contain whole regions of one class.

    Regions with overlapping extents along the sides share a patch. So patches do not overlap along the sides, and no
    region is in two of them.
    """
    along = 1 if sides == _VERTICAL else 0
    patch: tuple[int, int, int, int] | None = None
    for row in sorted(crossing, key=itemgetter(LEFT + along)):
        left, top = max(int(row[LEFT]), frame[0]), max(int(row[TOP]), frame[1])
        right, bottom = min(int(row[RIGHT]), frame[2]), min(int(row[BOTTOM]), frame[3])
        if patch is not None and (left, top)[along] <= patch[along + 2]:
            patch = min(patch[0], left), min(patch[1], top), max(patch[2], right), max(patch[3], bottom)
            continue
        if patch is not None:
            yield patch
        patch = left, top, right, bottom
    if patch is not None:
        yield patch


def _rows_by_line(rows: np.ndarray, lines: np.ndarray) -> dict[int, list[int]]:
    """Return for each vertical line (pixel column) with regions: line index → indices of those regions."""
    first = np.searchsorted(lines, rows[:, LEFT], side="left")
    after = np.searchsorted(lines, rows[:, RIGHT], side="left")
    found: dict[int, list[int]] = {}
    for region in np.flatnonzero(after > first).tolist():
        for line in range(first[region], after[region]):
            found.setdefault(line, []).append(region)
    return found


def _nearest(rows: np.ndarray, center: np.ndarray, count: int) -> np.ndarray:
    """Return (n, 3) offset x, y and class of the ``count`` regions nearest to ``center``, with ties of the last."""
    offsets = rows[:, (CENTER_X, CENTER_Y, CLASS)]
    offsets[:, :2] -= center
    if len(rows) <= count:
        return offsets
    squared = offsets[:, 0] ** 2 + offsets[:, 1] ** 2
    reach = np.sqrt(np.partition(squared, count - 1)[count - 1]) + 10.0**-TIE_DECIMALS
    return offsets[squared <= reach**2]


def _vectors(nearest: list[np.ndarray], reference_values: Sequence[int], references_per_vector: int) -> np.ndarray:
    longest = max(len(rows) for rows in nearest)
    offsets = np.full((len(nearest), longest, 2), np.inf)
    ranks = np.zeros((len(nearest), longest))
    for k, rows in enumerate(nearest):
        offsets[k, : len(rows)] = rows[:, :2]
        ranks[k, : len(rows)] = class_ranks(rows[:, 2], reference_values)
    return topology_vectors(offsets, ranks, references_per_vector)
