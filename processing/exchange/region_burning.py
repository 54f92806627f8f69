"""Burning numbered regions, to see what pixels make of them."""

from __future__ import annotations

from typing import Iterator, List, Sequence, Tuple

from osgeo import gdal

from ...core.annotation.check import DrawnRegion
from ...core.annotation.raster_losses import RegionRuns, join_runs, runs_of_strip
from .annotation import BurnPolygon
from .burning import STRIP_PIXELS, TILE_ROWS, BurnLayer


class RegionBurning:
    """Burns regions that don't overlap as a label map is burnt; iterate ``steps()`` to the end, then take ``runs``.

    Region n of the list has the number n + 1.
    """

    def __init__(self, regions: Sequence[DrawnRegion], width: int, height: int, geotransform: tuple, crs_wkt: str):
        polygons = [BurnPolygon(region.wkb, n, 0.0, region.bounds) for n, region in enumerate(regions, start=1)]
        self._layer = BurnLayer(polygons, crs_wkt)
        self._size = width, height
        self._geotransform = geotransform
        self._crs_wkt = crs_wkt
        self._strips: List[RegionRuns] = []

    @property
    def runs(self) -> RegionRuns:
        return join_runs(self._strips)

    def steps(self) -> Iterator[Tuple[str, float]]:
        """Yields (what is being done, share done 0…1)."""
        width, height = self._size
        x0, pixel, _, y0, _, _ = self._geotransform
        rows = max(TILE_ROWS, STRIP_PIXELS // 4 // width)
        for first in range(0, height, rows):
            strip = gdal.GetDriverByName("MEM").Create("", width, min(rows, height - first), 1, gdal.GDT_Int32)
            strip.SetGeoTransform((x0, pixel, 0.0, y0 - first * pixel, 0.0, -pixel))
            strip.SetProjection(self._crs_wkt)
            self._layer.burn(strip)
            self._strips.append(runs_of_strip(strip.ReadAsArray(), first))
            yield "Burning landmarks", min(first + rows, height) / height
