"""Burning polygons into a label map with GDAL, strip by strip."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import Iterator, List, Tuple

import numpy as np
from osgeo import gdal, ogr, osr

from ...core.labels.class_table import ClassTable
from ...core.labels.counts import count_labels
from ...storage.label_map_file import TILE_ROWS, LabelMapFile
from .annotation import BurnPolygon

STRIP_PIXELS = 16_000_000
"""Pixels burnt and written at a time."""


class LabelMapBurning:
    """Writes a label map; iterate ``steps()`` to the end, then ``counts`` has the (256,) pixels of each value."""

    def __init__(
        self,
        path: str,
        width: int,
        height: int,
        geotransform: tuple,
        crs_wkt: str,
        table: ClassTable,
        polygons: List[BurnPolygon],
    ) -> None:
        self._path = path
        self._size = width, height
        self._geotransform = geotransform
        self._crs_wkt = crs_wkt
        self._table = table
        self._layer = BurnLayer(polygons, crs_wkt)
        self.counts = np.zeros(256, np.int64)

    def steps(self) -> Iterator[Tuple[str, float]]:
        """Yields (what is being done, share of the map written 0…1)."""
        width, height = self._size
        rows = max(TILE_ROWS, STRIP_PIXELS // width // TILE_ROWS * TILE_ROWS)
        file = LabelMapFile(self._path, width, height, self._geotransform, self._crs_wkt, self._table)
        # One thread compresses a strip while this one burns the next.
        with file as label_map, ThreadPoolExecutor(1) as writer:
            yield "Burning polygons", 0.0
            writing = None
            for first in range(0, height, rows):
                labels = self._burn(first, min(rows, height - first))
                self.counts += count_labels(labels)
                if writing is not None:
                    writing.result()
                writing = writer.submit(label_map.write_rows, first, labels)
                yield "Burning polygons", (first + len(labels)) / height
            writing.result()

    def _burn(self, first_row: int, rows: int) -> np.ndarray:
        x0, pixel, _, y0, _, _ = self._geotransform
        strip = gdal.GetDriverByName("MEM").Create("", self._size[0], rows, 1, gdal.GDT_Byte)
        strip.SetGeoTransform((x0, pixel, 0.0, y0 - first_row * pixel, 0.0, -pixel))
        strip.SetProjection(self._crs_wkt)
        self._layer.burn(strip)
        return strip.ReadAsArray()


class BurnLayer:
    """Polygons in memory, bottom first, to be burnt strip by strip with GDAL."""

    def __init__(self, polygons: List[BurnPolygon], crs_wkt: str) -> None:
        driver = gdal.GetDriverByName("Memory") or gdal.GetDriverByName("MEM")
        self._dataset = driver.Create("", 0, 0, 0, gdal.GDT_Unknown)
        self._layer = self._dataset.CreateLayer("polygons", osr.SpatialReference(crs_wkt), ogr.wkbPolygon)
        self._layer.CreateField(ogr.FieldDefn("value", ogr.OFTInteger))
        definition = self._layer.GetLayerDefn()
        for polygon in sorted(polygons, key=lambda p: p.priority):
            feature = ogr.Feature(definition)
            feature.SetField(0, polygon.value)
            feature.SetGeometryDirectly(ogr.CreateGeometryFromWkb(polygon.wkb))
            self._layer.CreateFeature(feature)

    def burn(self, strip: gdal.Dataset) -> None:
        """Burns what touches ``strip`` (in memory, with geotransform and the same CRS) into its first band."""
        x0, pixel, _, y0, _, _ = strip.GetGeoTransform()
        right, bottom = x0 + strip.RasterXSize * pixel, y0 - strip.RasterYSize * pixel
        self._layer.SetSpatialFilterRect(x0, bottom, right, y0)
        gdal.RasterizeLayer(strip, [1], self._layer, options=["ATTRIBUTE=value"])
