"""Burning regions with GDAL, numbered, strip by strip: to see what pixels make of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from osgeo import gdal

from ..core.annotation.raster_losses import RegionRuns, join_runs, runs_of_strip
from ..core.geometry.frame import MapFrame
from .label_map_file import TILE_ROWS
from .rasterize import STRIP_PIXELS, BurnLayer, BurnPolygon

if TYPE_CHECKING:
    from ..core.annotation.check import DrawnRegion


class RegionBurning:
    """Burns regions that don't overlap as a label map is burnt; iterate ``steps()`` to the end, then take ``runs``.

    Region n of the list has the number n + 1.
    """

    def __init__(self, regions: Sequence[DrawnRegion], frame: MapFrame) -> None:
        polygons = [BurnPolygon(region.wkb, n, 0.0, region.bounds) for n, region in enumerate(regions, start=1)]
        self._layer = BurnLayer(polygons, frame.crs)
        self._frame = frame
        self._strips: list[RegionRuns] = []

    @property
    def runs(self) -> RegionRuns:
        """Of all regions burned so far."""
        return join_runs(self._strips)

    def steps(self) -> Iterator[tuple[str, float]]:
        """Yields (what is being done, share done 0…1)."""
        height, width = self._frame.shape_hw
        rows = max(TILE_ROWS, STRIP_PIXELS // 4 // width)
        for first in range(0, height, rows):
            strip = self._frame.part(0, first, (min(rows, height - first), width))
            self._strips.append(runs_of_strip(self._layer.burnt(strip, gdal.GDT_Int32), first))
            yield "Burning landmarks", min(first + rows, height) / height
