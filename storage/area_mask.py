"""Polygons as a mask of an image, burnt piece by piece."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from osgeo import gdal

from ..core.geometry.frame import MapFrame
from .burning import BurnLayer, BurnPolygon

_PIXELS = MapFrame("", (0.0, 1.0, 0.0, 0.0, 0.0, -1.0))
"""An image's pixels as a map: x is the column, y the row, negative."""


class AreaMask:
    """The pixels of an image whose centers lie in polygons: a PixelMask."""

    def __init__(self, polygons: Sequence[bytes]) -> None:
        """Takes WKB of polygons, x the column and y the negative row of the image."""
        self._layer = BurnLayer([BurnPolygon(wkb, 1, 0.0, (0.0, 0.0, 0.0, 0.0)) for wkb in polygons], "")

    def read(self, column: int, row: int, width: int, height: int) -> np.ndarray:
        """(height, width) bool: which pixels of a piece of the image lie in the polygons."""
        return self._layer.burnt(_PIXELS.part(column, row, (height, width)), gdal.GDT_Byte) > 0
