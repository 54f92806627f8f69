"""Propose the pixel size for training a network from the sizes of the buildings."""

from __future__ import annotations

from itertools import islice

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsFeatureRequest,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
)

from ...core.area_plan import training_resolution_cm
from ...processing.layers.guess_fields import BUILDING
from ...processing.layers.reference_systems import metric_crs

_READ = 2000


def proposed_resolution_cm(layer: QgsVectorLayer | None, given: dict[str, str], photo: QgsRasterLayer) -> int | None:
    """Return a pixel size in cm; None if the photo is not finer, or the layer has no buildings.

    Args:
        given: CLASS or CLASS_FIELD of the layer.
    """
    crs = photo.crs()
    if layer is None or not crs.isValid() or not layer.crs().isValid():
        return None
    context = QgsProject.instance().transformContext()
    crs = metric_crs(crs, QgsCoordinateReferenceSystem(), photo.extent(), context)
    moved = QgsCoordinateTransform(layer.crs(), crs, context)
    try:
        widths = _widths(layer, given, moved)
        seen = QgsCoordinateTransform(photo.crs(), crs, context).transformBoundingBox(photo.extent())
    except QgsCsException:
        return None
    return training_resolution_cm(widths, seen.width() / max(photo.width(), 1))


def _widths(layer: QgsVectorLayer, given: dict[str, str], moved: QgsCoordinateTransform) -> list[float]:
    """Return the shorter side of each building's smallest rectangle, in m."""
    field, is_all = given.get("CLASS_FIELD", ""), given.get("CLASS", "").casefold() == BUILDING
    request = QgsFeatureRequest()
    request.setSubsetOfAttributes([field] if field else [], layer.fields())
    found = []
    for feature in islice(layer.getFeatures(request), _READ):
        if is_all or (field and str(feature[field]).casefold() == BUILDING):
            geometry = feature.geometry()
            if geometry.isEmpty():
                continue
            geometry.transform(moved)
            _, _, _, width, height = geometry.orientedMinimumBoundingBox()
            found.append(min(width, height))
    return found
