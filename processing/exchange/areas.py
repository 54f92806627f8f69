"""Areas that a user draws: polygons, or corridors along lines and around points."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsCsException,
    QgsGeometry,
    QgsProcessingFeatureSource,
    QgsRectangle,
)

from ...core.errors import ParameterError
from .reference_systems import describe_crs

_SEGMENTS = 12
"""Of a quarter of a circle, where a corridor turns."""


@dataclass(frozen=True)
class DrawnArea:
    """Geometries taken out of a layer, and their CRS."""

    geometries: tuple[QgsGeometry, ...]
    crs: QgsCoordinateReferenceSystem


def drawn_area(source: QgsProcessingFeatureSource | None) -> DrawnArea | None:
    """Takes the geometries out of a layer, in the thread it lives in; None without one."""
    if source is None:
        return None
    geometries = (feature.geometry() for feature in source.getFeatures())
    return DrawnArea(tuple(g for g in geometries if not g.isNull()), source.sourceCrs())


def area_rings(
    area: DrawnArea,
    distance: float,
    crs: QgsCoordinateReferenceSystem,
    extent: tuple[float, float, float, float],
    transform_context: QgsCoordinateTransformContext,
) -> list[np.ndarray]:
    """Rings (n, 2) in ``crs`` of all that lies within ``distance`` of an area and in ``extent`` (x_min, y_min, …).

    Raises ParameterError when nothing does.
    """
    to_map = QgsCoordinateTransform(area.crs, crs, transform_context)
    moved = []
    for geometry in area.geometries:
        geometry = QgsGeometry(geometry)
        try:
            geometry.transform(to_map)
        except QgsCsException:
            raise ParameterError("exchange.clip_crs", crs=describe_crs(area.crs)) from None
        # Repaired first, as a crossing outline would be buffered wrongly.
        moved.append(geometry.makeValid().buffer(distance, _SEGMENTS))
    whole = QgsGeometry.unaryUnion(moved).intersection(QgsGeometry.fromRect(QgsRectangle(*extent)))
    rings = [ring for polygon in _polygons(whole) for ring in polygon]
    if not rings:
        raise ParameterError("exchange.clip_outside", distance=distance)
    return [np.array([(point.x(), point.y()) for point in ring]) for ring in rings]


def _polygons(geometry: QgsGeometry) -> list:
    parts = (part.asPolygon() for part in geometry.asGeometryCollection() if part.area() > 0)
    return [polygon for polygon in parts if polygon]
