"""Coordinate reference systems: metric ones for label maps, longitude and latitude for results."""

from __future__ import annotations

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsCsException,
    QgsDistanceArea,
    QgsPointXY,
    QgsRectangle,
)

from ...core.database.model import ReferenceDatabase
from ...core.errors import DatabaseError, ParameterError
from ...core.geometry.lon_lat import LonLatPolynomial, fit_lon_lat
from ..compat import is_metric

WGS84 = "EPSG:4326"

_UTM_NORTH, _UTM_SOUTH = 32600, 32700
_UPS_NORTH, _UPS_SOUTH = 32661, 32761


def describe_crs(crs: QgsCoordinateReferenceSystem) -> str:
    """“EPSG:32632 WGS 84 / UTM zone 32N” – for messages."""
    return f"{crs.authid()} {crs.description()}".strip() or "unnamed CRS"


def transformed_box(transform: QgsCoordinateTransform, box: QgsRectangle) -> QgsRectangle:
    """Return the box around ``box`` in the other CRS; null where that has no such place."""
    try:
        return transform.transformBoundingBox(box)
    except QgsCsException:
        return QgsRectangle()


def transformed_point(transform: QgsCoordinateTransform, point: QgsPointXY) -> QgsPointXY | None:
    """Return the point in the other CRS; None where that has no such place."""
    try:
        return QgsPointXY(transform.transform(point))
    except QgsCsException:
        return None


def database_crs(database: ReferenceDatabase) -> QgsCoordinateReferenceSystem:
    """The CRS that a database is in. Raises DatabaseError for one that can't be read."""
    crs = QgsCoordinateReferenceSystem.fromWkt(database.parameters.crs)
    if not crs.isValid():
        raise DatabaseError("{path} has no readable parameter crs; build it again.", path=database.source)
    return crs


def metric_crs(
    source: QgsCoordinateReferenceSystem,
    target: QgsCoordinateReferenceSystem,
    extent: QgsRectangle,
    transform_context: QgsCoordinateTransformContext,
) -> QgsCoordinateReferenceSystem:
    """The CRS for a label map: ``target`` if given, else ``source`` if it is metric, else a UTM zone for ``extent``.

    Raises ParameterError when ``target`` is not metric or ``source`` is unknown.
    """
    if not source.isValid():
        raise ParameterError(
            "The annotation layer has no coordinate reference system; set one in the layer's properties."
        )
    if target.isValid():
        if not is_metric(target):
            raise ParameterError(
                "{crs} does not measure in meters; choose a projected CRS in meters as TARGET_CRS.",
                crs=describe_crs(target),
            )
        return target
    return source if is_metric(source) else utm_zone(source, extent, transform_context)


def utm_zone(
    crs: QgsCoordinateReferenceSystem, extent: QgsRectangle, transform_context: QgsCoordinateTransformContext
) -> QgsCoordinateReferenceSystem:
    """The UTM zone (near the poles UPS) of the middle of ``extent``, on WGS 84."""
    to_degrees = QgsCoordinateTransform(crs, QgsCoordinateReferenceSystem(WGS84), transform_context)
    middle = transformed_point(to_degrees, extent.center())
    if middle is None or not (abs(middle.x()) <= 360 and abs(middle.y()) <= 90):
        raise ParameterError(
            "The layer's extent does not fit its CRS {crs}; correct the CRS or choose TARGET_CRS.",
            crs=describe_crs(crs),
        )
    longitude, latitude = middle.x(), middle.y()
    if latitude > 84:
        code = _UPS_NORTH
    elif latitude < -80:
        code = _UPS_SOUTH
    else:
        zone = int((longitude + 180) % 360 // 6) + 1
        code = (_UTM_NORTH if latitude >= 0 else _UTM_SOUTH) + zone
    return QgsCoordinateReferenceSystem(f"EPSG:{code}")


def meters_from(
    lon_lat: tuple[float, float],
    extent: tuple[float, float, float, float],
    crs: QgsCoordinateReferenceSystem,
    transform_context: QgsCoordinateTransformContext,
) -> float | None:
    """How far a place is from a box on the ground, 0 within it; None for a CRS that tells no longitude and latitude.

    The box is taken as one of longitudes and latitudes, a little larger than it is.

    Args:
        lon_lat: Longitude and latitude, degrees.
        extent: (x_min, y_min, x_max, y_max) of the box.
        crs: Of the box.
    """
    degrees = QgsCoordinateReferenceSystem(WGS84)
    transform = QgsCoordinateTransform(crs, degrees, transform_context)
    box = transformed_box(transform, QgsRectangle(*extent)) if transform.isValid() else QgsRectangle()
    if box.isEmpty() or not box.isFinite():
        return None
    measure = QgsDistanceArea()
    measure.setSourceCrs(degrees, transform_context)
    measure.setEllipsoid("EPSG:7030")
    longitude, latitude = lon_lat
    nearest_latitude = min(max(latitude, box.yMinimum()), box.yMaximum())
    found = []
    for turned in (longitude - 360, longitude, longitude + 360):
        nearest = QgsPointXY(min(max(turned, box.xMinimum()), box.xMaximum()), nearest_latitude)
        found.append((abs(turned - nearest.x()), measure.measureLine(QgsPointXY(turned, latitude), nearest)))
    return min(found)[1]


def longitudes_latitudes(
    points: np.ndarray, crs: QgsCoordinateReferenceSystem, transform_context: QgsCoordinateTransformContext
) -> tuple[np.ndarray, np.ndarray]:
    """(N, 2) map coordinates → longitudes (N,), latitudes (N,) in degrees, EPSG:4326; NaN for an unplaced CRS."""
    transform = QgsCoordinateTransform(crs, QgsCoordinateReferenceSystem(WGS84), transform_context)
    if not transform.isValid():
        nowhere = np.full(len(points), np.nan)
        return nowhere, nowhere.copy()
    moved = [transform.transform(QgsPointXY(x, y)) for x, y in np.asarray(points).tolist()]
    return np.array([p.x() for p in moved]), np.array([p.y() for p in moved])


def fitted_lon_lat(
    extent: tuple[float, float, float, float],
    crs: QgsCoordinateReferenceSystem,
    transform_context: QgsCoordinateTransformContext,
) -> LonLatPolynomial | None:
    """Longitude and latitude over ``extent`` (x_min, y_min, x_max, y_max) as polynomials; None where that can't be."""
    try:
        return fit_lon_lat(lambda points: longitudes_latitudes(points, crs, transform_context), extent)
    except QgsCsException:
        return None
