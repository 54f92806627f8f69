"""An image with the georeference of its fix: laid on the map as it was taken, for QGIS alone or for every program."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from osgeo import gdal

from ..core.errors import UnwritableError
from ..core.geometry.footprint import is_parallelogram, on_ground
from .gdal_errors import close, gdal_failure, gdal_failures
from .raster_writer import TILED
from .rasters import open_raster

GRID = 16
"""Points a side that tell GDAL how a tilted image lies; between them it bends a thin plate. Closer together at the
edges, they leave 1 pixel of 4,000 × 3,000 at most for a camera tilted by 30°, 0.01 in the middle of all. GDAL knows
homographies only from 3.11."""


def write_draped(image: str, target: str, crs_wkt: str, corners_xy: np.ndarray) -> None:
    """Writes a VRT of an image on the ground, transparent outside the image.

    Args:
        target: The VRT; another one is written beside it.
        crs_wkt: WKT of the map's CRS.
        corners_xy: (4, 2) map coordinates of the image's upper left, upper right, lower right and lower left corner.

    Raises:
        LabelMapError: The image can't be read.
        UnwritableError: The VRT can't be written.
    """
    source = open_raster(image)
    placed_path = f"{target}.placed.vrt"
    # The warper reads the file, which must be complete.
    _place(source, placed_path, crs_wkt, corners_xy).FlushCache()
    _turn(target, placed_path, source, corners_xy, format="VRT")


def write_geotiff(
    image: str, target: str, crs_wkt: str, corners_xy: np.ndarray, going_on: Callable[[], bool] = lambda: True
) -> None:
    """Writes a GeoTIFF of an image on the ground, north up, transparent outside the image.

    Photos are resampled bilinearly. One band is taken for labels: nearest neighbor, colors kept, 0 outside.

    Args:
        target: The GeoTIFF.
        crs_wkt: WKT of the map's CRS.
        corners_xy: As in ``write_draped``.
        going_on: Asked now and then; False ends the work with a LabelMapError.

    Raises:
        LabelMapError: The image can't be read.
        UnwritableError: The GeoTIFF can't be written.
    """
    source = open_raster(image)
    placed = _place(source, "", crs_wkt, corners_xy)
    with gdal_failures() as failures:
        _turn(
            target,
            placed,
            source,
            corners_xy,
            format="GTiff",
            resampleAlg="near" if source.RasterCount == 1 else "bilinear",
            creationOptions=list(TILED),
            callback=lambda *_: int(going_on()),
        )
    if failures:
        raise UnwritableError("{path} can't be written: {reason}.", path=target, reason=failures[0])


def _place(source: gdal.Dataset, path: str, crs_wkt: str, corners_xy: np.ndarray) -> gdal.Dataset:
    """A VRT of an image with its georeference; without a ``path`` in memory."""
    footprint = np.asarray(corners_xy, np.float64)
    placed = gdal.GetDriverByName("VRT").CreateCopy(path, source)
    if placed is None:
        raise UnwritableError("{path} can't be written: {reason}.", path=path, reason=gdal_failure())
    if is_parallelogram(footprint):
        placed.SetProjection(crs_wkt)
        placed.SetGeoTransform(geotransform(footprint, source))
    else:
        placed.SetGCPs(_control_points(footprint, source), crs_wkt)
    return placed


def _turn(
    target: str, placed: str | gdal.Dataset, source: gdal.Dataset, corners_xy: np.ndarray, **options: object
) -> None:
    """Warps what ``_place`` gave, north up. Raises UnwritableError."""
    labels = source.RasterCount == 1
    tilted = not is_parallelogram(np.asarray(corners_xy, np.float64))
    turned = gdal.Warp(target, placed, dstNodata=0 if labels else None, dstAlpha=not labels, tps=tilted, **options)
    if turned is None:
        raise UnwritableError("{path} can't be written: {reason}.", path=target, reason=gdal_failure())
    turned.FlushCache()
    close(turned)


def geotransform(corners_xy: np.ndarray, source: gdal.Dataset) -> tuple:
    """GDAL's six numbers of a level image whose corners' map coordinates are (4, 2), upper left first, clockwise."""
    (x0, y0), (x1, y1), _, (x3, y3) = np.asarray(corners_xy, np.float64).tolist()
    width, height = source.RasterXSize, source.RasterYSize
    return x0, (x1 - x0) / width, (x3 - x0) / height, y0, (y1 - y0) / width, (y3 - y0) / height


def _control_points(footprint: np.ndarray, source: gdal.Dataset) -> list:
    """A grid of points of a tilted image with the ground they show: four alone would make GDAL take an affine map."""
    width, height = source.RasterXSize, source.RasterYSize
    shares = (1 - np.cos(np.linspace(0, np.pi, GRID))) / 2
    columns, rows = np.meshgrid(width * shares, height * shares)
    pixels = np.column_stack([columns.ravel(), rows.ravel()])
    ground = on_ground(pixels, footprint, (height, width))
    return [gdal.GCP(x, y, 0.0, column, row) for (x, y), (column, row) in zip(ground.tolist(), pixels.tolist())]
