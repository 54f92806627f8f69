"""Coordinate reference systems: metric CRS for label maps, longitude and latitude for results."""

from __future__ import annotations

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsCsException,
    QgsDistanceArea,
    QgsGeometry,
    QgsPointXY,
    QgsRectangle,
)

from ...core.database.model import ReferenceDatabase
from ...core.errors import DatabaseError, ParameterError
from ...core.geometry.lon_lat import LonLatPolynomial, fit_lon_lat
from ..compat import is_metric

WGS84 = "EPSG:4326"

TRUE_TO_SCALE = 0.01
"""Largest relative scale error of a CRS in meters. In Europe, the scale of web maps is off by about a third."""

_UTM_NORTH, _UTM_SOUTH = 32600, 32700
_UPS_NORTH, _UPS_SOUTH = 32661, 32761


def describe_crs(crs: QgsCoordinateReferenceSystem) -> str:
    """Return “EPSG:32632 WGS 84 / UTM zone 32N” for messages."""
    return f"{crs.authid()} {crs.description()}".strip() or "unnamed CRS"


def transformed_box(transform: QgsCoordinateTransform, box: QgsRectangle) -> QgsRectangle:
    """Return the box around ``box`` in the other CRS; null if it can't be transformed."""
    try:
        return transform.transformBoundingBox(box)
    except QgsCsException:
        return QgsRectangle()


def transformed_point(transform: QgsCoordinateTransform, point: QgsPointXY) -> QgsPointXY | None:
    """Return the point in the other CRS; None if it can't be transformed."""
    try:
        return QgsPointXY(transform.transform(point))
    except QgsCsException:
        return None


def transformed_geometry(transform: QgsCoordinateTransform, geometry: QgsGeometry) -> QgsGeometry | None:
    """Return the geometry in the other CRS, with segments instead of arcs; None if it can't be transformed."""
    moved = QgsGeometry(geometry)
    moved.convertToStraightSegment()
    try:
        moved.transform(transform)
    except QgsCsException:
        return None
    return moved


def misplaced(layer: str, crs: QgsCoordinateReferenceSystem) -> ParameterError:
    """Return the error of a layer with coordinates that its CRS does not have; ``layer``: its name."""
    return ParameterError(
        "“{layer}” does not fit its CRS {crs}. Correct the CRS of the layer.", layer=layer, crs=describe_crs(crs)
    )


def require_crs(crs: QgsCoordinateReferenceSystem, layer: str) -> None:
    """Raise ParameterError for a layer without a CRS; ``layer``: its name."""
    if not crs.isValid():
        raise ParameterError("“{layer}” has no CRS. Set the CRS of the layer.", layer=layer)


def database_crs(database: ReferenceDatabase) -> QgsCoordinateReferenceSystem:
    """Return the CRS of a database. Raises DatabaseError if it can't be read."""
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
    """Return the CRS for a label map: ``target`` if valid, ``source`` if true to scale, or a UTM zone for ``extent``.

    Raises:
        ParameterError: ``target`` is not metric, or ``source`` is unknown.
    """
    if not source.isValid():
        raise ParameterError(
            "The polygon layer has no coordinate reference system. Set the CRS in the layer properties."
        )
    if target.isValid():
        if not is_metric(target):
            raise ParameterError(
                "{crs} is not in meters. Choose a projected CRS in meters as target CRS.", crs=describe_crs(target)
            )
        return target
    is_true = is_true_to_scale(source, extent.center(), transform_context)
    return source if is_true else utm_zone(source, extent, transform_context)


def is_true_to_scale(
    crs: QgsCoordinateReferenceSystem, place: QgsPointXY, transform_context: QgsCoordinateTransformContext
) -> bool:
    """Return whether a unit of the CRS is 1 m on the ground. A local CRS and a place outside the CRS count as true."""
    if not is_metric(crs):
        return False
    scale = ground_scale(crs, place, transform_context)
    return scale is None or abs(scale - 1) <= TRUE_TO_SCALE


def ground_scale(
    crs: QgsCoordinateReferenceSystem, place: QgsPointXY, transform_context: QgsCoordinateTransformContext
) -> float | None:
    """Return the ground length, m, of a map unit to the east; None for a local CRS and a place outside the CRS."""
    step = 100.0
    transform = QgsCoordinateTransform(crs, QgsCoordinateReferenceSystem(WGS84), transform_context)
    if not transform.isValid() or transformed_point(transform, place) is None:
        return None
    measure = ellipsoidal_measure(crs, transform_context)
    return measure.measureLine(place, QgsPointXY(place.x() + step, place.y())) / step or None


def utm_zone(
    crs: QgsCoordinateReferenceSystem, extent: QgsRectangle, transform_context: QgsCoordinateTransformContext
) -> QgsCoordinateReferenceSystem:
    """Return the UTM zone, or UPS near the poles, of the center of ``extent``, on WGS 84."""
    to_degrees = QgsCoordinateTransform(crs, QgsCoordinateReferenceSystem(WGS84), transform_context)
    middle = transformed_point(to_degrees, extent.center())
    if middle is None or not (abs(middle.x()) <= 360 and abs(middle.y()) <= 90):
        raise ParameterError(
            "The layer's extent does not fit its CRS {crs}. Correct the CRS of the layer, or choose a target CRS.",
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


def ellipsoidal_measure(
    crs: QgsCoordinateReferenceSystem, transform_context: QgsCoordinateTransformContext
) -> QgsDistanceArea:
    """Return a measure of distances in m on the ellipsoid of a CRS; in a plane for an invalid one."""
    measure = QgsDistanceArea()
    measure.setSourceCrs(crs, transform_context)
    # Not the project's ellipsoid, which may be none: degrees would be taken for meters.
    measure.setEllipsoid(crs.ellipsoidAcronym() or "EPSG:7030" if crs.isValid() else "NONE")
    return measure


def meters_from(
    lon_lat: tuple[float, float],
    extent: tuple[float, float, float, float],
    crs: QgsCoordinateReferenceSystem,
    transform_context: QgsCoordinateTransformContext,
) -> float | None:
    """Return the distance of a place from a box in m, 0 inside; None for a CRS without longitude and latitude.

    The box is replaced by its bounds in longitude and latitude, which are slightly larger.

    Args:
        lon_lat: Longitude and latitude, degrees.
        extent: (x_min, y_min, x_max, y_max) of the box.
    """
    degrees = QgsCoordinateReferenceSystem(WGS84)
    transform = QgsCoordinateTransform(crs, degrees, transform_context)
    box = transformed_box(transform, QgsRectangle(*extent)) if transform.isValid() else QgsRectangle()
    if box.isEmpty() or not box.isFinite():
        return None
    measure, (longitude, latitude) = ellipsoidal_measure(degrees, transform_context), lon_lat
    nearest_latitude = min(max(latitude, box.yMinimum()), box.yMaximum())
    found = []
    for turned in (longitude - 360, longitude, longitude + 360):
        nearest = QgsPointXY(min(max(turned, box.xMinimum()), box.xMaximum()), nearest_latitude)
        found.append((abs(turned - nearest.x()), measure.measureLine(QgsPointXY(turned, latitude), nearest)))
    return min(found)[1]


def longitudes_latitudes(
    points: np.ndarray, crs: QgsCoordinateReferenceSystem, transform_context: QgsCoordinateTransformContext
) -> tuple[np.ndarray, np.ndarray]:
    """Return longitudes (N,) and latitudes (N,) in degrees of (N, 2) map coordinates; NaN for a local CRS."""
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
    """Fit longitude and latitude over ``extent`` (x_min, y_min, x_max, y_max) by polynomials; None if impossible."""
    try:
        return fit_lon_lat(lambda points: longitudes_latitudes(points, crs, transform_context), extent)
    except QgsCsException:
        return None
