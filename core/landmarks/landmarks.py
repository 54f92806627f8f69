"""Extract landmarks from labels, in the same way for maps, windows and query images (docs/explanation/method.md)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import cv2
import numpy as np

CENTER_OF_FIRST_PIXEL = 0.5
"""OpenCV counts from the center of the first pixel, SemRef from its corner. This is the only conversion."""

CENTER_STEPS = 2**34
"""Centers are whole multiples of 1/CENTER_STEPS pixel from the first column and row of their region. So shifting them
by whole pixels is exact on maps of up to 2¹⁹ pixels a side, and a region has exactly the same center in every piece of
the map. The step is far below what counts as a tie (``TIE_DECIMALS``)."""

_NO_PARENT = -1
_PARENT = 3


@dataclass(frozen=True)
class Landmarks:
    """Landmarks of one image or map, ordered by class, then from top to bottom.

    Attributes:
        centers_xy: (N, 2) float64 centers of gravity, pixel coordinates (column, row).
        classes: (N,) uint8 class values.
        areas_px: (N,) float64 contour areas in pixels (``cv2.contourArea``, holes filled).
        bounds: (N, 4) int64 first column, first row, last column + 1, last row + 1.
        touches_edge: (N,) bool, whether the landmark touches the border of the image and may continue outside.
    """

    centers_xy: np.ndarray
    classes: np.ndarray
    areas_px: np.ndarray
    bounds: np.ndarray
    touches_edge: np.ndarray

    def __len__(self) -> int:
        return len(self.classes)

    def select(self, index: np.ndarray) -> Landmarks:
        """Return the landmarks for a boolean mask or an index array, in that order."""
        return Landmarks(*(column[index] for column in vars(self).values()))


def extract_landmarks(labels_hw: np.ndarray, class_values: Sequence[int], minimum_area_px: float) -> Landmarks:
    """Return every connected region of some classes that is large enough.

    Per class: mask → outer boundary of every 8-connected region (``RETR_CCOMP``, those without a parent) →
    ``cv2.contourArea`` → ``cv2.moments`` → center of gravity (paper §2.2.2 (2)). Regions without area (single pixels,
    lines) have no center of gravity and are never landmarks.

    Args:
        labels_hw: (H, W) uint8.
        minimum_area_px: Smallest contour area, pixels.
    """
    area_px = whole_half_pixels(minimum_area_px)
    rows = [region_rows(class_mask(labels_hw, value), value, area_px) for value in sorted(class_values)]
    return objects_from_rows(np.concatenate([NO_ROWS, *rows]), labels_hw.shape)


def class_mask(labels_hw: np.ndarray, value: int) -> np.ndarray:
    """Return the (H, W) uint8 mask with 1 where the label is ``value``."""
    # cv2.compare fails for an image of one pixel.
    return (labels_hw == np.uint8(value)).view(np.uint8)


def minimum_area_px(minimum_area_m2: float, pixel_size_m: float) -> float:
    """Return the area threshold in pixels."""
    return whole_half_pixels(minimum_area_m2 / pixel_size_m**2)


def whole_half_pixels(area_px: float) -> float:
    """Return the smallest contour area of at least ``area_px``; contour areas are multiples of half a pixel.

    So a threshold of 100 m² has the same effect on map and image, even if rounding makes it 100.00000000000001 pixels.
    """
    return float(np.ceil(2 * area_px - 1e-6)) / 2


# While they are collected, regions are rows of one float array with these columns.
CLASS, CENTER_X, CENTER_Y, AREA, LEFT, TOP, RIGHT, BOTTOM = range(8)
NO_ROWS = np.empty((0, 8), np.float64)


def outer_contours(mask: np.ndarray) -> list:
    """Return the outer boundary of every 8-connected region of ``mask`` (H, W) uint8, as OpenCV contours."""
    contours, hierarchy = cv2.findContours(mask, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_SIMPLE)
    if not contours:
        return []
    parents = hierarchy[0, :, _PARENT].tolist()
    return [contour for contour, parent in zip(contours, parents) if parent == _NO_PARENT]


def region_rows(mask: np.ndarray, value: int, minimum_area: float) -> np.ndarray:
    """Return (N, 8) rows of the regions of ``mask`` that are large enough."""
    rows = (contour_row(contour, value, minimum_area) for contour in outer_contours(mask))
    return rows_array([row for row in rows if row is not None])


def contour_row(contour: np.ndarray, value: int, minimum_area: float) -> tuple | None:
    """Return a region's row from its outer contour, or None if it is too small."""
    # A contour of one or two points has no area; this quickly skips most specks.
    if len(contour) < 3:
        return None
    area = cv2.contourArea(contour)
    if area < minimum_area or area <= 0:
        return None
    moments = cv2.moments(contour)
    left, top, width, height = cv2.boundingRect(contour)
    # Six times a moment of a polygon with integer coordinates is an integer.
    six_areas = round(6 * moments["m00"])
    return (
        value,
        center_coordinate(left, round(6 * moments["m10"]) - left * six_areas, six_areas),
        center_coordinate(top, round(6 * moments["m01"]) - top * six_areas, six_areas),
        area,
        left,
        top,
        left + width,
        top + height,
    )


def center_coordinate(first: int, six_moments: int, six_areas: int) -> float:
    """Return a center's pixel coordinate from six times the moment about ``first`` and six times the area."""
    return first + round(six_moments / six_areas * CENTER_STEPS) / CENTER_STEPS + CENTER_OF_FIRST_PIXEL


def rows_array(rows: list) -> np.ndarray:
    """Return row tuples as (N, 8) float64."""
    return np.array(rows, np.float64).reshape(-1, NO_ROWS.shape[1])


def shift_rows(rows: np.ndarray, column: int, row: int) -> np.ndarray:
    """Convert rows of a piece to coordinates of the larger image, in place."""
    rows[:, (CENTER_X, LEFT, RIGHT)] += column
    rows[:, (CENTER_Y, TOP, BOTTOM)] += row
    return rows


def shift_row(row: tuple, column: int, row_offset: int) -> tuple:
    """Return one row tuple shifted as by ``shift_rows``."""
    value, x, y, area, left, top, right, bottom = row
    return value, x + column, y + row_offset, area, left + column, top + row_offset, right + column, bottom + row_offset


def objects_from_rows(rows: np.ndarray, shape_hw: Iterable[int]) -> Landmarks:
    """Return landmarks from region rows, ordered; ``shape_hw`` is the (height, width) of the whole image."""
    height, width = shape_hw
    rows = rows[np.lexsort((rows[:, CENTER_X], rows[:, LEFT], rows[:, TOP], rows[:, CLASS]))]
    bounds = rows[:, LEFT : BOTTOM + 1].astype(np.int64)
    touches = (bounds[:, 0] <= 0) | (bounds[:, 1] <= 0) | (bounds[:, 2] >= width) | (bounds[:, 3] >= height)
    centers = rows[:, CENTER_X : CENTER_Y + 1].copy()
    return Landmarks(centers, rows[:, CLASS].astype(np.uint8), rows[:, AREA].copy(), bounds, touches)


def rows_from_objects(objects: Landmarks) -> np.ndarray:
    """Return (N, 8) float64 rows of landmarks: the inverse of ``objects_from_rows``."""
    return np.column_stack(
        [objects.classes, objects.centers_xy, objects.areas_px, objects.bounds.reshape(-1, 4)]
    ).astype(np.float64)
