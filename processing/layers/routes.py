"""Planned routes: lines of a layer or of a waypoint file, transformed to a database's CRS."""

from __future__ import annotations

import os
from contextlib import suppress
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
from .reference_systems import WGS84, misplaced, require_crs


@dataclass(frozen=True)
class Route:
    """A route.

    Attributes:
        lines: Lines, each (n, 2) x, y in ``crs``.
        crs: CRS of the layer; WGS 84 for waypoint files.
        name: Name of the layer or file.
    """

    lines: tuple[np.ndarray, ...]
    crs: QgsCoordinateReferenceSystem
    name: str


def route_of_source(source: QgsProcessingFeatureSource) -> Route:
    """Read the lines of a layer, in the layer's thread. Raises ParameterError without lines."""
    lines = []
    for feature in source.getFeatures():
        geometry = feature.geometry()
        parts = [] if geometry.isNull() else geometry.asGeometryCollection()
        # Curves become the lines that QGIS draws.
        for part in (part for part in parts if part.type() == LINE_GEOMETRY):
            lines.append(np.array([(point.x(), point.y()) for point in part.asPolyline()], np.float64).reshape(-1, 2))
    if not lines:
        raise ParameterError("“{name}” has no line. Draw a route, or change the selection.", name=source.sourceName())
    return _require_lines(Route(tuple(lines), source.sourceCrs(), source.sourceName()), source.sourceName())


def read_route(path: str) -> Route:
    """Read the route of a waypoint file. Raises ParameterError for a file without route."""
    lines = tuple(read_waypoint_file(path))
    return _require_lines(Route(lines, QgsCoordinateReferenceSystem(WGS84), os.path.basename(path)), path)


def lines_in(
    route: Route, crs: QgsCoordinateReferenceSystem, transform_context: QgsCoordinateTransformContext
) -> list[np.ndarray]:
    """Return the route's lines in another CRS. Raises ParameterError if they can't be transformed."""
    require_crs(route.crs, route.name)
    transform = QgsCoordinateTransform(route.crs, crs, transform_context)
    moved = []
    with suppress(QgsCsException):
        for line in route.lines:
            points = [transform.transform(QgsPointXY(x, y)) for x, y in line.tolist()]
            moved.append(np.array([(point.x(), point.y()) for point in points]))
    if len(moved) < len(route.lines) or not all(np.isfinite(line).all() for line in moved):
        raise misplaced(route.name, route.crs)
    return moved


def _require_lines(route: Route, name: str) -> Route:
    """Return the route without single points. Raises ParameterError if nothing remains."""
    lines = tuple(line for line in route.lines if len(line) > 1)
    if not lines:
        raise ParameterError(
            "{name} has no route: it has no line and fewer than two waypoints. Choose another route.", name=name
        )
    return Route(lines, route.crs, route.name)
