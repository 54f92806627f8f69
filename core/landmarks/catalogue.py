"""All landmarks of a whole map, read band by band, equal to those of the map in one piece."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

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
)
from .regions import Region
from .tiles import TileLandmarks, crossing_regions, tile_landmarks

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
        self._cut: list[TileLandmarks] = []

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
            found = tile_landmarks(labels, (0, first), (height, width), self._values, self._minimum_area)
            self._rows.append(found.rows)
            self._cut.append(replace(found, rows=NO_ROWS))
            yield first, labels

    def crossing(self) -> Iterator[int]:
        """Measures the regions that cross bands, one a step; yields how many are left. Call after ``bands()``."""
        regions = crossing_regions(self._cut)
        for left, (value, region) in zip(range(len(regions) - 1, -1, -1), regions):
            row = measure_region(self._source, value, region, self._minimum_area, self._patch_pixels)
            if row is not None:
                self._rows.append(rows_array([row]))
            yield left

    @property
    def objects(self) -> Landmarks:
        """The landmarks of the whole map."""
        return objects_from_rows(np.concatenate(self._rows), self._source.shape_hw)


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
