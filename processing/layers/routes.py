"""Planned routes: lines of a layer or of a waypoint file, brought to a database's CRS."""

from __future__ import annotations

import os
from dataclasses import dataclass

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsCsException,
    QgsPointXY,
    QgsProcessingFeatureSource,
)

from ...core.errors import ParameterError
from ...storage.route_files import read_waypoint_file
from ..compat import LINE_GEOMETRY
from .reference_systems import WGS84, describe_crs


@dataclass(frozen=True)
class Route:
    """Lines, each (n, 2) x, y of ``crs``; longitude, latitude of waypoint files. name: of the layer or file."""

    lines: tuple[np.ndarray, ...]
    crs: QgsCoordinateReferenceSystem
    name: str


def route_of_source(source: QgsProcessingFeatureSource) -> Route:
    """The lines of a layer, in the thread it lives in."""
    lines = []
    for feature in source.getFeatures():
        geometry = feature.geometry()
        parts = [] if geometry.isNull() else geometry.asGeometryCollection()
        # Of curves the lines that they are drawn as.
        for part in (part for part in parts if part.type() == LINE_GEOMETRY):
            lines.append(np.array([(point.x(), point.y()) for point in part.asPolyline()], np.float64).reshape(-1, 2))
    return _checked(Route(tuple(lines), source.sourceCrs(), source.sourceName()), "ROUTE")


def read_route(path: str) -> Route:
    """The route of a waypoint file. Raises ParameterError for a file without one."""
    return _checked(
        Route(tuple(read_waypoint_file(path)), QgsCoordinateReferenceSystem(WGS84), os.path.basename(path)), path
    )


def lines_in(
    route: Route, crs: QgsCoordinateReferenceSystem, transform_context: QgsCoordinateTransformContext
) -> list[np.ndarray]:
    """The route's lines in another CRS. Raises ParameterError when they can't be there."""
    if not route.crs.isValid():
        raise ParameterError("ROUTE has no CRS; set its layer's CRS.")
    transform = QgsCoordinateTransform(route.crs, crs, transform_context)
    moved = []
    try:
        for line in route.lines:
            points = [transform.transform(QgsPointXY(x, y)) for x, y in line.tolist()]
            moved.append(np.array([(point.x(), point.y()) for point in points]))
    except QgsCsException:
        raise ParameterError(
            "ROUTE does not fit its CRS {crs}; correct the CRS.", crs=describe_crs(route.crs)
        ) from None
    if not all(np.isfinite(line).all() for line in moved):
        raise ParameterError("ROUTE does not fit its CRS {crs}; correct the CRS.", crs=describe_crs(route.crs))
    return moved


def _checked(route: Route, name: str) -> Route:
    lines = tuple(line for line in route.lines if len(line) > 1)
    if not lines:
        raise ParameterError(
            "{name} has no route: no line, and fewer than two waypoints; choose another one.", name=name
        )
    return Route(lines, route.crs, route.name)
