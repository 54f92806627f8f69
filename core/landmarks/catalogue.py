"""All landmarks of a whole map, read band by band, equal to those of the map in one piece."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ..labels.sources import LabelSource
from .border_following import follow_outer_border
from .joining import connected_components, touching_runs
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
from .regions import Region, whole_region

BAND_PIXELS = 24_000_000
"""Pixels read at a time; 24 MB of labels and twice that for masks."""

PATCH_PIXELS = 16_000_000
"""An object that crosses bands is read again in one piece up to this many pixels; a larger one is traced."""


class CatalogueBuilder:
    """Collects the landmarks of a map: iterate ``bands()``, then ``crossing()`` to the end, then take ``objects``.

    The bands are yielded, so that one pass over the map serves others too (overview, hash). 8-connected regions that
    cross from band to band are joined and measured whole.
    """

    def __init__(  # noqa: PLR0913 - the last three are how it works, and tests make them small
        self,
        source: LabelSource,
        class_values: Sequence[int],
        minimum_area_px: float,
        band_pixels: int = BAND_PIXELS,
        patch_pixels: int = PATCH_PIXELS,
        band_multiple: int = 1,
    ) -> None:
        """Takes a map.

        Args:
            source: The label map.
            class_values: Classes of landmarks.
            minimum_area_px: Smaller regions are no landmarks.
            band_pixels: Pixels read at a time.
            patch_pixels: A region that crosses bands is read in one piece up to so many pixels.
            band_multiple: Band heights are multiples of it, as a reducing consumer needs.
        """
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
        """How many bands the map is read in."""
        return -(-self._source.shape_hw[0] // self._band_rows)

    def bands(self) -> Iterator[tuple[int, np.ndarray]]:
        """Reads the map and collects the regions that lie in one band.

        Yields:
            The first row of a band, and its labels (h, W) uint8.
        """
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
            row = measure_region(self._source, value, group, self._minimum_area, self._patch_pixels)
            if row is not None:
                self._rows.append(rows_array([row]))
            yield left

    @property
    def objects(self) -> Landmarks:
        """The landmarks of the whole map."""
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
    region: Region,
    minimum_area_px: float,
    patch_pixels: int = PATCH_PIXELS,
) -> tuple | None:
    """Measures one region.

    Args:
        source: The label map.
        value: The region's class.
        region: Where it is.
        minimum_area_px: Smaller ones are no landmarks.
        patch_pixels: A region is read in one piece up to so many pixels, else its border is followed.

    Returns:
        Its row (class, center x, y, area, left, top, right, bottom); None when it is too small.
    """
    left, top, right, bottom = region.bounds
    # A polygon through pixel centers is never larger than its bounding box.
    if (right - left) * (bottom - top) < minimum_area_px:
        return None
    if (right - left) * (bottom - top) > patch_pixels:
        return follow_outer_border(source, value, region.first_pixel, minimum_area_px)
    labels = source.read(left, top, right - left, bottom - top)
    start = np.array([region.first_pixel[0] - left, region.first_pixel[1] - top])
    for contour in outer_contours(class_mask(labels, value)):
        if (contour[:, 0] == start).all(axis=1).any():
            row = contour_row(contour, value, minimum_area_px)
            return None if row is None else shift_row(row, left, top)
    return None


class _Seam:
    """Joins the pieces of one class over the seams between bands."""

    def __init__(self) -> None:
        self._pieces: list[Region] = []
        self._links: list[np.ndarray] = [np.empty((0, 2), np.int64)]
        self._bottom_runs = np.empty((0, 3), np.int64)

    def add_band(self, mask: np.ndarray, contours: list, first: int) -> None:
        """Takes the contours of a band's regions that reach its neighbors; the band begins in row ``first``."""
        base = len(self._pieces)
        for contour in contours:
            points = contour[:, 0]
            left, top = points.min(axis=0).tolist()
            right, bottom = (points.max(axis=0) + 1).tolist()
            first_column = int(points[points[:, 1] == top, 0].min())
            self._pieces.append(Region((left, top + first, right, bottom + first), (first_column, top + first)))
        above, below = self._bottom_runs, _runs(mask, contours, 0, base)
        rows = np.repeat([0, 1], [len(above), len(below)])
        starts, stops, pieces = np.concatenate([above, below]).T
        self._links.append(pieces[touching_runs(rows, starts, stops)])
        self._bottom_runs = _runs(mask, contours, len(mask) - 1, base)

    def groups(self) -> list[Region]:
        """The regions that the pieces are parts of."""
        joined: dict[int, list[Region]] = {}
        components = connected_components(len(self._pieces), np.concatenate(self._links))
        for piece, component in zip(self._pieces, components.tolist()):
            joined.setdefault(component, []).append(piece)
        return [whole_region(pieces) for pieces in joined.values()]


def _runs(mask: np.ndarray, contours: list, row: int, base: int) -> np.ndarray:
    """(K, 3) first column, column after the last, piece of every run of set pixels in a band's first or last row.

    A contour turns at both ends of such a run, so ``CHAIN_APPROX_SIMPLE`` keeps them: they tell whose run it is.
    """
    owner = np.full(mask.shape[1], -1, np.int64)
    for index, contour in enumerate(contours):
        points = contour[:, 0]
        owner[points[points[:, 1] == row, 0]] = base + index
    steps = np.diff(np.concatenate([[0], (mask[row] > 0).astype(np.int8), [0]]))
    starts, stops = np.flatnonzero(steps == 1), np.flatnonzero(steps == -1)
    found = np.column_stack([starts, stops, owner[starts]])
    return found[found[:, 2] >= 0]
