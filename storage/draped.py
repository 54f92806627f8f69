"""An image with the georeference of its fix, to lie on the map as it was taken."""

from __future__ import annotations

import numpy as np
from osgeo import gdal

from ..core.errors import LabelMapError
from ..core.geometry.footprint import is_parallelogram, on_ground
from .gdal_errors import gdal_failure
from .rasters import open_raster

GRID = 16
"""Points a side that tell GDAL how a tilted image lies; between them it bends a thin plate. Closer together at the
edges, they leave 1 pixel of 4,000 × 3,000 at most for a camera tilted by 30°, 0.01 in the middle of all. GDAL knows
homographies only from 3.11."""


def write_draped(image: str, target: str, crs_wkt: str, corners_xy: np.ndarray) -> None:
    """Writes a VRT of an image on the ground, transparent outside the image.

    Args:
        image: The file.
        target: The VRT; another one is written beside it.
        crs_wkt: WKT of the map's CRS.
        corners_xy: (4, 2) map coordinates of the image's upper left, upper right, lower right and lower left corner.

    Raises:
        LabelMapError: The image can't be read, or the VRT not written.
    """
    source = open_raster(image)
    footprint = np.asarray(corners_xy, np.float64)
    placed_path = f"{target}.placed.vrt"
    placed = gdal.GetDriverByName("VRT").CreateCopy(placed_path, source)
    if placed is None:
        raise LabelMapError("storage.unwritable", path=placed_path, reason=gdal_failure())
    level = is_parallelogram(footprint)
    if level:
        placed.SetProjection(crs_wkt)
        placed.SetGeoTransform(_geotransform(footprint, source))
    else:
        placed.SetGCPs(_control_points(footprint, source), crs_wkt)
    # The warper reads the file, which must be complete.
    del placed
    labels = source.RasterCount == 1
    turned = gdal.Warp(
        target, placed_path, format="VRT", dstNodata=0 if labels else None, dstAlpha=not labels, tps=not level
    )
    if turned is None:
        raise LabelMapError("storage.unwritable", path=target, reason=gdal_failure())
    turned.FlushCache()


def _geotransform(footprint: np.ndarray, source: gdal.Dataset) -> tuple:
    """GDAL's six numbers of a level image."""
    (x0, y0), (x1, y1), _, (x3, y3) = footprint.tolist()
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
