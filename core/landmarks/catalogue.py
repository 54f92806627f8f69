"""All landmarks of a whole map, read band by band, equal to those of the map in one piece."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ..labels.sources import LabelSource
from .border_following import follow_outer_border
from .landmarks import (
    NO_ROWS,
    Landmarks,
    class_mask,
    contour_row,
    objects_from_rows,
    outer_contours,
    rows_array,
    shift_row,
    shift_rows,
)

BAND_PIXELS = 24_000_000
"""Pixels read at a time; 24 MB of labels and twice that for masks."""

PATCH_PIXELS = 16_000_000
"""An object that crosses bands is read again in one piece up to this many pixels; a larger one is traced."""


class CatalogueBuilder:
    """Collects the objects of a map: iterate ``bands()`` to the end, then take ``objects``.

    The bands are yielded as (first row, labels (h, W) uint8), so that one pass over the map serves others too
    (overview, hash). 8-connected regions that cross from band to band are joined and measured whole.
    """

    def __init__(
        self,
        source: LabelSource,
        class_values: Sequence[int],
        minimum_area_px: float,
        band_pixels: int = BAND_PIXELS,
        patch_pixels: int = PATCH_PIXELS,
        band_multiple: int = 1,
    ) -> None:
        """``band_multiple``: band heights are multiples of it, as a reducing consumer needs."""
        self._source = source
        self._values = sorted(class_values)
        self._minimum_area = minimum_area_px
        self._patch_pixels = patch_pixels
        height, width = source.shape_hw
        rows = max(band_multiple, band_pixels // width // band_multiple * band_multiple)
        self._band_rows = min(rows, height)
        self._rows: list[np.ndarray] = [NO_ROWS]
        self._seams: dict[int, _Seam] = {value: _Seam() for value in self._values}

    @property
    def band_count(self) -> int:
        return -(-self._source.shape_hw[0] // self._band_rows)

    def bands(self) -> Iterator[tuple[int, np.ndarray]]:
        height, width = self._source.shape_hw
        for first in range(0, height, self._band_rows):
            labels = self._source.read(0, first, width, min(self._band_rows, height - first))
            for value in self._values:
                self._collect(value, class_mask(labels, value), first)
            yield first, labels

    def crossing(self) -> Iterator[int]:
        """Measures the regions that cross bands, one a step; yields how many are left. Call after ``bands()``."""
        groups = [(value, group) for value in self._values for group in self._seams[value].groups()]
        for left, (value, group) in zip(range(len(groups) - 1, -1, -1), groups):
            row = measure_region(
                self._source, value, group.bounds, group.first_pixel, self._minimum_area, self._patch_pixels
            )
            if row is not None:
                self._rows.append(rows_array([row]))
            yield left

    @property
    def objects(self) -> Landmarks:
        return objects_from_rows(np.concatenate(self._rows), self._source.shape_hw)

    def _collect(self, value: int, mask: np.ndarray, first: int) -> None:
        """Whole regions of a band become rows; those that reach a neighboring band become seam pieces."""
        map_height = self._source.shape_hw[0]
        last = first + len(mask) - 1
        open_top, open_bottom = first > 0, last < map_height - 1
        touching_top = mask[0].any() and open_top
        touching_bottom = mask[-1].any() and open_bottom
        whole, pieces = [], []
        for contour in outer_contours(mask):
            # Only a contour that reaches the band's first or last row can go on outside it.
            if touching_top or touching_bottom:
                ys = contour[:, 0, 1]
                if (touching_top and ys.min() == 0) or (touching_bottom and ys.max() == len(mask) - 1):
                    pieces.append(contour)
                    continue
            row = contour_row(contour, value, self._minimum_area)
            if row is not None:
                whole.append(row)
        if whole:
            self._rows.append(shift_rows(rows_array(whole), 0, first))
        self._seams[value].add_band(mask, pieces, first)


def measure_region(
    source: LabelSource,
    value: int,
    bounds: tuple[int, int, int, int],
    first_pixel: tuple[int, int],
    minimum_area_px: float,
    patch_pixels: int = PATCH_PIXELS,
) -> tuple | None:
    """Region row of the region within ``bounds`` (left, top, right, bottom) with this first pixel (column, row).

    None when the region is smaller than ``minimum_area_px``.
    """
    left, top, right, bottom = bounds
    # A polygon through pixel centers is never larger than its bounding box.
    if (right - left) * (bottom - top) < minimum_area_px:
        return None
    if (right - left) * (bottom - top) > patch_pixels:
        return follow_outer_border(source, value, first_pixel, minimum_area_px)
    labels = source.read(left, top, right - left, bottom - top)
    start = np.array([first_pixel[0] - left, first_pixel[1] - top])
    for contour in outer_contours(class_mask(labels, value)):
        if (contour[:, 0] == start).all(axis=1).any():
            row = contour_row(contour, value, minimum_area_px)
            return None if row is None else shift_row(row, left, top)
    return None


class _Group:
    """Pieces of one region: bounds (left, top, right, bottom) and its first pixel (column, row) in raster order."""

    def __init__(self, bounds: tuple[int, int, int, int], first_pixel: tuple[int, int]) -> None:
        self.bounds = bounds
        self.first_pixel = first_pixel

    def join(self, other: _Group) -> None:
        a, b = self.bounds, other.bounds
        self.bounds = (min(a[0], b[0]), min(a[1], b[1]), max(a[2], b[2]), max(a[3], b[3]))
        self.first_pixel = min(self.first_pixel, other.first_pixel, key=lambda pixel: (pixel[1], pixel[0]))


class _Seam:
    """Joins the pieces of one class over the seams between bands (union–find)."""

    def __init__(self) -> None:
        self._parents: list[int] = []
        self._groups: list[_Group] = []
        self._bottom_runs: list[tuple[int, int, int]] = []

    def add_band(self, mask: np.ndarray, contours: list, first: int) -> None:
        base = len(self._groups)
        for contour in contours:
            points = contour[:, 0]
            left, top = points.min(axis=0)
            right, bottom = points.max(axis=0) + 1
            first_column = points[points[:, 1] == top, 0].min()
            self._parents.append(len(self._parents))
            self._groups.append(
                _Group(
                    (int(left), int(top) + first, int(right), int(bottom) + first),
                    (int(first_column), int(top) + first),
                )
            )
        top_runs = _runs(mask, contours, 0, base)
        self._join(self._bottom_runs, top_runs)
        self._bottom_runs = _runs(mask, contours, len(mask) - 1, base)

    def groups(self) -> list[_Group]:
        joined: dict[int, _Group] = {}
        for index, group in enumerate(self._groups):
            root = self._root(index)
            if root in joined:
                joined[root].join(group)
            else:
                joined[root] = _Group(group.bounds, group.first_pixel)
        return list(joined.values())

    def _join(self, above: list[tuple[int, int, int]], below: list[tuple[int, int, int]]) -> None:
        """Runs (first, last, piece) of two adjacent rows, each in order; 8-connected ones are one region."""
        i = j = 0
        while i < len(above) and j < len(below):
            if above[i][0] <= below[j][1] + 1 and below[j][0] <= above[i][1] + 1:
                self._parents[self._root(above[i][2])] = self._root(below[j][2])
            if above[i][1] < below[j][1]:
                i += 1
            else:
                j += 1

    def _root(self, index: int) -> int:
        while self._parents[index] != index:
            self._parents[index] = self._parents[self._parents[index]]
            index = self._parents[index]
        return index


def _runs(mask: np.ndarray, contours: list, row: int, base: int) -> list[tuple[int, int, int]]:
    """(first column, last column, piece) of every run of set pixels in a band's first or last row.

    A contour turns at both ends of such a run, so ``CHAIN_APPROX_SIMPLE`` keeps them: they tell whose run it is.
    """
    owner = np.full(mask.shape[1], -1, np.int64)
    for index, contour in enumerate(contours):
        points = contour[:, 0]
        owner[points[points[:, 1] == row, 0]] = base + index
    steps = np.diff(np.concatenate([[0], (mask[row] > 0).astype(np.int8), [0]]))
    starts, ends = np.flatnonzero(steps == 1), np.flatnonzero(steps == -1) - 1
    return [(int(a), int(b), int(owner[a])) for a, b in zip(starts, ends) if owner[a] >= 0]
