"""Sizes for a reference database and a training, from the landmarks of a map and the ground that a photo shows."""

from __future__ import annotations

from dataclasses import dataclass
from math import floor, log10, sqrt

import numpy as np

STEPS_CM = (5, 10, 15, 20, 25, 30, 40, 50, 60, 80, 100)
SMALLEST_PERCENT, PIXELS_WIDE = 10, 14
"""The building at this percentile of widths shall be this number of pixels wide in the training."""

_FINER = 0.8
"""Pixels of the imagery that are at least this share of the proposed size are used as they are."""

_AREAS_M2 = (4, 6, 10, 15, 20, 30, 50, 100)
_LEFT_OUT_PERCENT, _PART_SEEN = 5, 0.5
"""A landmark counts if it has half the area of the landmark at this percentile: a model never shows all of it."""

_PIXELS_M = (0.1, 0.2, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0)
_PIXELS_OF_SMALLEST = 50
_MOST_PIXELS = 1_000_000_000
"""Pixels of a label map; more take hours to rasterize."""

_STRIDES = 4
"""Strides in a window."""

_BYTES, _BYTES_OF_WINDOW, _BYTES_OF_LANDMARK = 200_000, 150, 280
"""Of a database without windows, of a window and of a landmark; within 10 % for six databases of 0.3 to 2.9 MB."""

_SQUARES = 200

FEW_LANDMARKS = 8
"""Photos with fewer landmarks have no position."""


@dataclass(frozen=True)
class MeasuredLandmarks:
    """Landmarks of a map within an extent.

    Attributes:
        areas_m2: (N,) areas.
        widths_m: (M,) shorter sides of the smallest rectangles of some landmarks.
        centers: (N, 2) map coordinates, m.
        extent: (x_min, y_min, x_max, y_max), m.
    """

    areas_m2: np.ndarray
    widths_m: np.ndarray
    centers: np.ndarray
    extent: tuple[float, float, float, float]


@dataclass(frozen=True)
class AreaPlan:
    """Sizes for an area.

    Attributes:
        landmarks: Landmarks of the map that are large enough.
        per_photo: Median of their number in a photo that is centered on a landmark.
        resolution_cm: Pixel size for training; None for that of the imagery.
        megabytes: Estimated size of the database.
    """

    pixel_size_m: float
    window_m: float
    stride_m: float
    minimum_area_m2: float
    landmarks: int
    per_photo: int
    resolution_cm: int | None
    megabytes: float


def plan_area(found: MeasuredLandmarks, photo_m: tuple[float, float], imagery_pixel_m: float | None = None) -> AreaPlan:
    """Return the sizes for a map with at least one landmark.

    Args:
        photo_m: Ground width and height of a typical photo, m.
        imagery_pixel_m: Pixel size of the imagery for training, m; None without imagery.
    """
    x_min, y_min, x_max, y_max = found.extent
    width, height = max(x_max - x_min, 1.0), max(y_max - y_min, 1.0)
    least = _PART_SEEN * float(np.percentile(found.areas_m2, _LEFT_OUT_PERCENT))
    minimum = max((area for area in _AREAS_M2 if area <= least), default=_AREAS_M2[0])
    coarsest = max(sqrt(minimum / _PIXELS_OF_SMALLEST), sqrt(width * height / _MOST_PIXELS))
    pixel = max((size for size in _PIXELS_M if size <= coarsest), default=_PIXELS_M[0])
    window = _two_digits(min(*photo_m, width, height))
    stride = window / _STRIDES
    counted = found.centers[found.areas_m2 >= minimum]
    windows = ((width - window) / stride + 1) * ((height - window) / stride + 1)
    return AreaPlan(
        pixel,
        window,
        stride,
        minimum,
        len(counted),
        _per_photo(counted, sqrt(photo_m[0] * photo_m[1])),
        training_resolution_cm(found.widths_m, imagery_pixel_m),
        (_BYTES + _BYTES_OF_WINDOW * windows + _BYTES_OF_LANDMARK * len(counted)) / 1e6,
    )


def training_resolution_cm(widths_m: np.ndarray | list[float], imagery_pixel_m: float | None) -> int | None:
    """Return the pixel size for training; None if the imagery is not clearly finer, or without imagery or widths."""
    if imagery_pixel_m is None or not len(widths_m):
        return None
    wanted_cm = 100 * float(np.percentile(widths_m, SMALLEST_PERCENT)) / PIXELS_WIDE
    proposed = max((step for step in STEPS_CM if step <= wanted_cm), default=None)
    return proposed if proposed and 100 * imagery_pixel_m < _FINER * proposed else None


def _per_photo(centers: np.ndarray, edge_m: float) -> int:
    """Return the median number of landmarks of squares that are centered on a landmark."""
    if not len(centers):
        return 0
    some = centers[:: max(1, len(centers) // _SQUARES)]
    offsets = (centers[:, None] - some) / edge_m
    return round(float(np.median(np.all((offsets >= -0.5) & (offsets < 0.5), axis=2).sum(axis=0))))


def _two_digits(meters: float) -> float:
    """Round down to two significant digits."""
    step = 10.0 ** (floor(log10(meters)) - 1)
    return floor(meters / step + 1e-9) * step
