"""A label map as polygons: small regions merged, shared borders simplified alike on both sides."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from typing import Callable

import numpy as np
from osgeo import gdal, ogr

from ..core.annotation.coverage import can_simplify, from_wkb, on_map, simplified, with_nodes
from ..core.errors import LabelMapError
from ..core.labels.class_table import UNLABELED
from .gdal_errors import gdal_failures
from .rasters import open_raster

_ROWS_AT_ONCE = 2048

WITHOUT_GEOREFERENCE = (0.0, 1.0, 0.0, 0.0, 0.0, -1.0)
"""GDAL's six numbers of pixels with y up, as the other algorithms give places on such images."""


class LabelPolygons:
    """Makes the polygons of a label map; iterate ``steps()`` to the end, then ``classes`` and ``polygons`` are there.

    Attributes:
        classes: (n,) class value of each.
        polygons: (n,) shapely polygons in map coordinates; 4-connected regions, together they cover what is labeled.
    """

    def __init__(self, path: str, minimum_area: float, tolerance: float) -> None:
        """Nothing is read yet.

        Args:
            path: Of the label map.
            minimum_area: Square map units; smaller regions go to their largest neighbor. 0 keeps all.
            tolerance: Map units; lines are straightened where they then enclose less than a triangle of that edge and
                height (``shapely.coverage_simplify``), all borders alike on both sides. 0 keeps the pixels' edges.
        """
        self._path, self._minimum_area, self._tolerance = path, minimum_area, tolerance
        self.classes = np.empty(0, np.uint8)
        self.polygons = np.empty(0, object)

    def steps(self, proceed: Callable[[], bool] = lambda: True) -> Iterator[tuple[str, float]]:
        """Yields (what is being done, share done 0…1).

        Args:
            proceed: Asked now and then; once False the work ends with a LabelMapError.

        Raises:
            LabelMapError: GDAL can't read the map or make the polygons, or was told to stop.
        """
        with tempfile.TemporaryDirectory(prefix="semref-outline-") as folder:
            yield "Merging small regions", 0.0
            raster = self._sieved(os.path.join(folder, "sieved.tif"), proceed)
            transform = _transform(raster)
            yield "Outlining regions", 0.3
            layer = _outlined(raster.GetRasterBand(1), proceed)
            values, outlines = _read(layer)
            yield "Simplifying borders", 0.6
            if len(outlines):
                outlines = with_nodes(outlines, _junctions(raster.GetRasterBand(1)), raster.RasterXSize + 1)
            if self._tolerance > 0 and can_simplify() and len(outlines):
                outlines = simplified(outlines, self._tolerance / np.sqrt(_pixel_area(transform)))
            self.classes, self.polygons = values, on_map(outlines, transform)
            # The last references, before their folder is removed.
            del layer, raster
        yield "Simplifying borders", 1.0

    def _sieved(self, path: str, proceed: Callable[[], bool]) -> gdal.Dataset:
        """The label map without its smallest regions."""
        source = open_raster(self._path)
        transform = _transform(source)
        pixels = int(np.ceil(self._minimum_area / _pixel_area(transform)))
        if pixels <= 1:
            return source
        options = ["TILED=YES", "COMPRESS=DEFLATE", "ZLEVEL=1", "BIGTIFF=IF_SAFER"]
        size = source.RasterXSize, source.RasterYSize
        with gdal_failures() as failures:
            target = gdal.GetDriverByName("GTiff").Create(path, *size, 1, gdal.GDT_Byte, options)
            if target is not None:
                target.SetGeoTransform(transform)
                band = source.GetRasterBand(1)
                gdal.SieveFilter(band, None, target.GetRasterBand(1), pixels, 4, callback=lambda *_: int(proceed()))
                target.FlushCache()
        _raise(failures)
        return target


def _outlined(band: gdal.Band, proceed: Callable[[], bool]) -> ogr.DataSource:
    """Polygons in pixel coordinates, in memory."""
    driver = ogr.GetDriverByName("Memory") or ogr.GetDriverByName("MEM")
    found = driver.CreateDataSource("")
    layer = found.CreateLayer("polygons", geom_type=ogr.wkbPolygon)
    layer.CreateField(ogr.FieldDefn("value", ogr.OFTInteger))
    # Polygonize uses the band's own georeference: a view without one gives pixels.
    view = gdal.GetDriverByName("VRT").CreateCopy("", band.GetDataset())
    view.SetGeoTransform((0.0, 1.0, 0.0, 0.0, 0.0, 1.0))
    with gdal_failures() as failures:
        plain = view.GetRasterBand(1)
        gdal.Polygonize(plain, None, layer, 0, [], callback=lambda *_: int(proceed()))
    _raise(failures)
    return found


def _read(source: ogr.DataSource) -> tuple[np.ndarray, np.ndarray]:
    """(n,) class values and (n,) polygons, without those of unlabeled ground."""
    values, outlines = [], []
    for feature in source.GetLayer(0):
        value = feature.GetField(0)
        if value != UNLABELED:
            values.append(value)
            outlines.append(bytes(feature.GetGeometryRef().ExportToWkb()))
    return np.array(values, np.uint8), from_wkb(outlines)


def _junctions(band: gdal.Band) -> np.ndarray:
    """(m, 2) sorted corners of pixels, (row, column), where three regions or more meet: a border's ends."""
    height, width = band.YSize, band.XSize
    found = []
    for first in range(0, height + 1, _ROWS_AT_ONCE):
        last = min(first + _ROWS_AT_ONCE, height + 1)
        labels = np.zeros((last - first + 1, width + 2), np.uint8)
        top, bottom = max(0, first - 1), min(height, last)
        labels[top - first + 1 : bottom - first + 1, 1:-1] = band.ReadAsArray(0, top, width, bottom - top)
        a, b, c, d = labels[:-1, :-1], labels[:-1, 1:], labels[1:, :-1], labels[1:, 1:]
        not_a = [(one, one != a) for one in (b, c, d)]
        meet = np.zeros(a.shape, bool)
        for (one, differs), (other, differs_too) in ((not_a[0], not_a[1]), (not_a[0], not_a[2]), (not_a[1], not_a[2])):
            meet |= differs & differs_too & (one != other)
        rows, columns = np.nonzero(meet)
        found.append(np.column_stack([rows + first, columns]))
    return np.concatenate(found)


def _transform(raster: gdal.Dataset) -> tuple[float, ...]:
    return raster.GetGeoTransform(can_return_null=True) or WITHOUT_GEOREFERENCE


def _pixel_area(transform: tuple[float, ...]) -> float:
    return abs(transform[1] * transform[5] - transform[2] * transform[4])


def _raise(failures: list[str]) -> None:
    if failures:
        raise LabelMapError("storage.no_polygons", reason=failures[0])
