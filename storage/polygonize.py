"""Polygonize a label map: merge small regions, and simplify shared borders equally on both sides."""

from __future__ import annotations

import os
import tempfile
from typing import Callable

import numpy as np
from osgeo import gdal

from ..core.annotation.outlines import can_simplify, outline_regions, simplify, to_map
from ..core.errors import LabelMapError
from ..core.steps import Steps, part
from .gdal_errors import gdal_failures
from .rasters import open_raster, pixel_area, transform_of


def polygonize(
    path: str, minimum_area: float, tolerance: float, proceed: Callable[[], bool] = lambda: True
) -> Steps[tuple[np.ndarray, np.ndarray]]:
    """Return (n,) class values and (n,) shapely polygons of a label map.

    The polygons are 4-connected regions in map coordinates, which cover all labeled ground.

    Args:
        minimum_area: Square map units; smaller regions become part of their largest neighbor. 0 keeps all.
        tolerance: Map units; see ``shapely.coverage_simplify``, which removes a vertex if its triangle is smaller than
            one with this edge and height. 0 keeps the pixel edges.
        proceed: Called repeatedly while small regions are merged; False ends the work with a LabelMapError.

    Raises:
        ImageError: The map can't be read.
        LabelMapError: GDAL fails, or ``proceed`` returned False.
    """
    with tempfile.TemporaryDirectory(prefix="semref-outline-") as folder:
        yield "Merging small regions", 0.0
        raster = _sieve(path, os.path.join(folder, "sieved.tif"), minimum_area, proceed)
        transform = transform_of(raster)
        yield "Outlining regions", 0.3
        outlining = outline_regions(rows_of(raster.GetRasterBand(1)), (raster.RasterYSize, raster.RasterXSize))
        values, outlines = yield from part("Outlining regions", outlining, 0.3, 0.6)
        yield "Simplifying borders", 0.6
        if tolerance > 0 and can_simplify() and len(outlines):
            outlines = simplify(outlines, tolerance / np.sqrt(pixel_area(transform)))
        polygons = to_map(outlines, transform)
        # Close the file before its folder is removed.
        del raster
    yield "Simplifying borders", 1.0
    return values, polygons


def _sieve(path: str, target: str, minimum_area: float, proceed: Callable[[], bool]) -> gdal.Dataset:
    """Return the label map without small regions."""
    source = open_raster(path)
    transform = transform_of(source)
    pixels = int(np.ceil(minimum_area / pixel_area(transform)))
    if pixels <= 1:
        return source
    options = ["TILED=YES", "COMPRESS=DEFLATE", "ZLEVEL=1", "BIGTIFF=IF_SAFER"]
    size = source.RasterXSize, source.RasterYSize
    with gdal_failures() as failures:
        sieved = gdal.GetDriverByName("GTiff").Create(target, *size, 1, gdal.GDT_Byte, options)
        if sieved is not None:
            sieved.SetGeoTransform(transform)
            band = source.GetRasterBand(1)
            gdal.SieveFilter(band, None, sieved.GetRasterBand(1), pixels, 4, callback=lambda *_: int(proceed()))
            sieved.FlushCache()
    _raise(failures)
    return sieved


def rows_of(band: gdal.Band) -> Callable[[int, int], np.ndarray]:
    """Return a function that reads rows [first, last) of labels. It raises LabelMapError."""

    def read(first: int, last: int) -> np.ndarray:
        found = None
        with gdal_failures() as failures:
            found = band.ReadAsArray(0, first, band.XSize, last - first)
        _raise(failures)
        return found

    return read


def _raise(failures: list[str]) -> None:
    if failures:
        raise LabelMapError("The polygons can’t be made: {reason}.", reason=failures[0])
