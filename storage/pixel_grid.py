"""Compute the pixel grid of a label map of polygons."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

from ..core import limits
from ..core.errors import ParameterError

if TYPE_CHECKING:
    from ..core.geometry.frame import MapFrame

Bounds = tuple[float, float, float, float]
"""Left, bottom, right, top."""


def pixel_grid(bounds: Bounds, pixel_size: float, crs_wkt: str) -> MapFrame:
    """Return the smallest grid around ``bounds`` that is aligned to multiples of the pixel size.

    Maps of the same pixel size thus share their pixel corners.

    Raises:
        ParameterError: The pixel size is not positive, or the grid is too large.
    """
    # QGIS must start without loading numpy.
    from ..core.geometry.frame import MapFrame

    if not pixel_size > 0 or not math.isfinite(pixel_size):
        raise ParameterError("The pixel size is {pixel_size:g} m; it must be more than 0.", pixel_size=pixel_size)
    # Rounding errors of a bound must not add a row of pixels.
    slack = 1e-6
    left, bottom = (math.floor(v / pixel_size + slack) for v in bounds[:2])
    right, top = (math.ceil(v / pixel_size - slack) for v in bounds[2:])
    width, height = max(right - left, 1), max(top - bottom, 1)
    if width * height > limits.MAP_PIXELS or max(width, height) > 2**31 - 1:
        raise ParameterError(
            "The label map would have {width} × {height} pixels; choose larger pixels or a smaller extent.",
            width=width,
            height=height,
        )
    return MapFrame.at((left * pixel_size, top * pixel_size), pixel_size, (height, width), crs_wkt)


def union_of_bounds(bounds: Iterable[Bounds]) -> Bounds:
    """Return (left, bottom, right, top) around several bounds."""
    lefts, bottoms, rights, tops = zip(*bounds)
    return min(lefts), min(bottoms), max(rights), max(tops)
