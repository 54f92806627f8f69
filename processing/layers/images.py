"""Ground size of the pixels of a photo."""

from __future__ import annotations

from math import hypot

from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransformContext, QgsDistanceArea, QgsPointXY

from ...core.errors import SemRefError
from ...storage.images import GdalImage
from ...storage.rasters import open_raster
from ..compat import is_metric


def stated_crs(path: str) -> QgsCoordinateReferenceSystem:
    """Return the CRS in a raster file; invalid without one."""
    return QgsCoordinateReferenceSystem.fromWkt(open_raster(path).GetProjection())


def pixel_size_m(image: GdalImage, crs: QgsCoordinateReferenceSystem) -> tuple[float, float] | None:
    """Return the ground size of a pixel along a row and a column, m, in the center; None without georeference."""
    transform = image.geotransform
    if transform is None or not crs.isValid():
        return None
    x0, dx_column, dx_row, y0, dy_column, dy_row = transform
    if is_metric(crs):
        return hypot(dx_column, dy_column), hypot(dx_row, dy_row)
    height, width = image.shape_hw
    x = x0 + dx_column * width / 2 + dx_row * height / 2
    y = y0 + dy_column * width / 2 + dy_row * height / 2
    measure = QgsDistanceArea()
    measure.setSourceCrs(crs, QgsCoordinateTransformContext())
    measure.setEllipsoid(crs.ellipsoidAcronym() or "EPSG:7030")
    middle = QgsPointXY(x, y)
    along_row = measure.measureLine(middle, QgsPointXY(x + dx_column, y + dy_column))
    return along_row, measure.measureLine(middle, QgsPointXY(x + dx_row, y + dy_row))


def stated_pixel_size_m(path: str) -> tuple[float, float] | None:
    """Return ``pixel_size_m`` of a file; None also for an unreadable file, which later reading reports."""
    try:
        crs = stated_crs(path)
        return pixel_size_m(GdalImage(path), crs) if crs.isValid() else None
    except SemRefError:
        return None
