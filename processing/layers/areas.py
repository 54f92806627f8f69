"""Areas of a layer: polygons, or corridors along lines and around points."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from hashlib import sha256

import numpy as np
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsGeometry,
    QgsProcessingFeatureSource,
    QgsRectangle,
)
from qgis.PyQt.QtGui import QTransform

from ...core.errors import ParameterError
from ...storage.rasterize import AreaMask
from .reference_systems import misplaced, require_crs, transformed_geometry

_SEGMENTS = 12
"""Segments of a quarter circle where a corridor turns."""


@dataclass(frozen=True)
class DrawnArea:
    """Geometries of a layer, their CRS, and the name of the layer."""

    geometries: tuple[QgsGeometry, ...]
    crs: QgsCoordinateReferenceSystem
    name: str

    @property
    def extent(self) -> QgsRectangle:
        """Extent in its CRS; empty without geometries."""
        extent = QgsRectangle()
        for geometry in self.geometries:
            extent.combineExtentWith(geometry.boundingBox())
        return extent

    @property
    def fingerprint(self) -> str:
        found = sha256(self.crs.authid().encode())
        for geometry in self.geometries:
            found.update(geometry.asWkb().data())
        return found.hexdigest()


def drawn_area(source: QgsProcessingFeatureSource | None) -> DrawnArea | None:
    """Copy the geometries of a layer, in the layer's thread; None without a layer."""
    if source is None:
        return None
    geometries = (feature.geometry() for feature in source.getFeatures())
    return DrawnArea(tuple(g for g in geometries if not g.isNull()), source.sourceCrs(), source.sourceName())


def area_rings(
    area: DrawnArea,
    distance: float,
    crs: QgsCoordinateReferenceSystem,
    extent: tuple[float, float, float, float],
    transform_context: QgsCoordinateTransformContext,
) -> list[np.ndarray]:
    """Return rings (n, 2) in ``crs`` of an area with a buffer, cut at an extent.

    Args:
        distance: Width of the buffer, map units of ``crs``.
        extent: (x_min, y_min, x_max, y_max) in ``crs``.

    Raises:
        ParameterError: No ring remains.
    """
    # Repair first: a buffer of a self-crossing outline would be wrong.
    moved = [part.buffer(distance, _SEGMENTS) for part in _reproject(area, crs, transform_context)]
    whole = QgsGeometry.unaryUnion(moved).intersection(QgsGeometry.fromRect(QgsRectangle(*extent)))
    rings = [ring for polygon in _polygons(whole) for ring in polygon]
    if not rings:
        raise ParameterError(
            "The area or route is empty or outside the database’s map. Choose another layer, or for lines and points "
            "a larger distance than {distance:g} m.",
            distance=distance,
        )
    return [np.array([(point.x(), point.y()) for point in ring]) for ring in rings]


def area_extent(
    area: DrawnArea, crs: QgsCoordinateReferenceSystem, context: QgsCoordinateTransformContext
) -> QgsRectangle:
    """Return the extent of an area in another CRS. Raises ParameterError."""
    box = QgsRectangle()
    for geometry in _reproject(area, crs, context):
        box.combineExtentWith(geometry.boundingBox())
    return box


def area_mask(
    area: DrawnArea,
    crs: QgsCoordinateReferenceSystem,
    geotransform: Sequence[float] | None,
    shape_hw: tuple[int, int],
    context: QgsCoordinateTransformContext,
) -> AreaMask:
    """Return the mask of the pixels inside the polygons of an area.

    Args:
        geotransform: GDAL's six numbers of the image; None without a georeference.
        shape_hw: (height, width) of the image.

    Raises:
        ParameterError: The image has no georeference, or no polygon touches it.
    """
    if geotransform is None:
        raise ParameterError("The image has no georeference, so the mask cannot be applied. Leave “Mask” empty.")
    x0, x_column, x_row, y0, y_column, y_row = geotransform
    to_pixels, _ = QTransform(x_column, y_column, x_row, y_row, x0, y0).inverted()
    upwards = to_pixels * QTransform.fromScale(1, -1)
    height, width = shape_hw
    image = QgsRectangle(0, -height, width, 0)
    polygons = []
    for geometry in _reproject(area, crs, context):
        geometry.transform(upwards)
        parts = (part for part in geometry.asGeometryCollection() if part.area() > 0)
        polygons += [part.asWkb().data() for part in parts if part.boundingBox().intersects(image)]
    if not polygons:
        raise ParameterError("The mask and the image do not overlap. Select another mask, or leave “Mask” empty.")
    return AreaMask(polygons)


def _reproject(
    area: DrawnArea, crs: QgsCoordinateReferenceSystem, context: QgsCoordinateTransformContext
) -> list[QgsGeometry]:
    """Return an area's geometries in another CRS, valid and without arcs. Raises ParameterError."""
    if crs.isValid():
        require_crs(area.crs, area.name)
    to_map = QgsCoordinateTransform(area.crs, crs, context)
    moved = []
    for given in area.geometries:
        geometry = transformed_geometry(to_map, given)
        if geometry is None:
            raise misplaced(area.name, area.crs)
        moved.append(geometry.makeValid())
    return moved


def _polygons(geometry: QgsGeometry) -> list:
    parts = (part.asPolygon() for part in geometry.asGeometryCollection() if part.area() > 0)
    return [polygon for polygon in parts if polygon]
