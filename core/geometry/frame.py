"""The only conversion between map coordinates and pixels: a north-up grid of square pixels."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np


@dataclass(frozen=True)
class MapFrame:
    """Grid of a label map, an overview, an image, or a part of one.

    Pixel coordinates are (column, row) from the upper left corner of the first pixel; rows grow to the south.

    Attributes:
        crs: WKT of a metric CRS; "" if it does not matter.
        geotransform: GDAL's six numbers (x0, pixel, 0, y0, 0, −pixel) in map units, exactly as read; () without a
            georeference.
        shape_hw: (height, width) in pixels; (0, 0) if only the grid matters.
    """

    crs: str
    geotransform: tuple[float, ...]
    shape_hw: tuple[int, int] = (0, 0)

    @classmethod
    def at(
        cls, origin: Sequence[float], pixel_size: float, shape_hw: tuple[int, int] = (0, 0), crs: str = ""
    ) -> MapFrame:
        """Return the frame with the upper left corner of its first pixel at ``origin`` (x, y)."""
        return cls(crs, (origin[0], pixel_size, 0.0, origin[1], 0.0, -pixel_size), shape_hw)

    @property
    def origin(self) -> tuple[float, float]:
        """(x, y) of the first pixel's upper left corner, map units."""
        return self.geotransform[0], self.geotransform[3]

    @property
    def pixel_size(self) -> float:
        """Edge of a pixel, map units."""
        return self.geotransform[1]

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """(x_min, y_min, x_max, y_max), map units."""
        (x0, y0), pixel, (height, width) = self.origin, self.pixel_size, self.shape_hw
        return x0, y0 - pixel * height, x0 + pixel * width, y0

    def to_map(self, points_xy: np.ndarray) -> np.ndarray:
        """Return (…, 2) map coordinates (x, y) of (…, 2) pixel coordinates (column, row)."""
        points_xy, (x0, y0), pixel = np.asarray(points_xy), self.origin, self.pixel_size
        return np.stack([x0 + points_xy[..., 0] * pixel, y0 - points_xy[..., 1] * pixel], axis=-1)

    def to_pixels(self, points_xy: np.ndarray) -> np.ndarray:
        """Return (…, 2) pixel coordinates (column, row) of (…, 2) map coordinates (x, y)."""
        points_xy, (x0, y0), pixel = np.asarray(points_xy), self.origin, self.pixel_size
        return np.stack([(points_xy[..., 0] - x0) / pixel, (y0 - points_xy[..., 1]) / pixel], axis=-1)

    def part(self, column: int, row: int, shape_hw: tuple[int, int]) -> MapFrame:
        """Return the frame of ``shape_hw`` pixels that begins at (column, row)."""
        (x0, y0), pixel = self.origin, self.pixel_size
        return MapFrame.at((x0 + column * pixel, y0 - row * pixel), pixel, shape_hw, self.crs)

    def reduced(self, factor: int) -> MapFrame:
        """Return the frame of the map with pixels ``factor`` times as large; the last ones may extend beyond it."""
        height, width = self.shape_hw
        return MapFrame.at(self.origin, self.pixel_size * factor, (-(-height // factor), -(-width // factor)), self.crs)

    def of_shape(self, shape_hw: tuple[int, int]) -> MapFrame:
        """Return the same grid with another shape (height, width)."""
        return replace(self, shape_hw=shape_hw)
