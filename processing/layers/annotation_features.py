"""Read all features of a land-cover layer to check and repair them, without skipping any."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsFeature,
    QgsRectangle,
    QgsWkbTypes,
)

from ...core.annotation.classes import ClassLookup, raw_text
from ...core.annotation.findings import (
    ERROR,
    INFORMATION,
    NO_CLASS,
    NOTHING,
    OUTSIDE_CRS,
    THREE_DIMENSIONAL,
    UNKNOWN_CLASS,
    WARNING,
    Finding,
)
from ...core.annotation.polygons import AnnotatedFeature
from ..compat import is_null
from .annotation import AnnotationSource, drawing_priority
from .reference_systems import WGS84, transformed_box, transformed_geometry


@dataclass
class AnnotationReading:
    """Features of a layer in a metric CRS, findings about single features, and their attributes if wanted."""

    features: list[AnnotatedFeature] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    attributes: list[list] = field(default_factory=list)


def read_features(
    source: AnnotationSource,
    features: Iterable[QgsFeature],
    lookup: ClassLookup,
    crs: QgsCoordinateReferenceSystem,
    transform_context: QgsCoordinateTransformContext,
    with_attributes: bool = False,
) -> AnnotationReading:
    """Return the source's features with geometries in the metric ``crs``, and findings about single features."""
    transform = QgsCoordinateTransform(source.crs, crs, transform_context)
    is_inside = _is_in_area_of_use(source, transform_context)
    reading = AnnotationReading()
    for feature in features:
        geometry = feature.geometry()
        outside = not geometry.isNull() and not geometry.isEmpty() and not is_inside(geometry.boundingBox())
        placed = None if geometry.isNull() else transformed_geometry(transform, geometry)
        wkb = None if placed is None else placed.asWkb().data()
        about = {"wkb": wkb, "feature_id": feature.id(), "area": placed.area() if placed else None}
        if outside or (placed is None and not geometry.isNull()):
            reading.findings.append(Finding(OUTSIDE_CRS, ERROR if placed is None else WARNING, **about))
        if QgsWkbTypes.hasZ(geometry.wkbType()):
            reading.findings.append(Finding(THREE_DIMENSIONAL, INFORMATION, **about))
        value = _class_value(feature, source, lookup, about, reading.findings)
        if placed is None and not geometry.isNull():
            continue
        priority = drawing_priority(feature, source, lookup.draw_orders.get(value, 0.0))
        reading.features.append(AnnotatedFeature(feature.id(), wkb, value, priority))
        if with_attributes:
            reading.attributes.append(feature.attributes())
    return reading


def _class_value(
    feature: QgsFeature, source: AnnotationSource, lookup: ClassLookup, about: dict, findings: list[Finding]
) -> int:
    """Return the class value, NOTHING without a known class; append findings about it."""
    raw = source.raw_class(feature)
    if is_null(raw) or not raw_text(raw):
        findings.append(Finding(NO_CLASS, ERROR, **about))
        return NOTHING
    value = lookup.value(raw)
    if value is None:
        # A style with a category for all other values leaves them unlabeled on purpose.
        severity = WARNING if source.styled and source.unstyled_allowed else ERROR
        findings.append(Finding(UNKNOWN_CLASS, severity, **about, reason=raw_text(raw)))
        return NOTHING
    return value


def _is_in_area_of_use(
    source: AnnotationSource, transform_context: QgsCoordinateTransformContext
) -> Callable[[QgsRectangle], bool]:
    """Return a function that returns whether a box touches the area of use of the layer's CRS."""
    bounds = source.crs.bounds()
    to_degrees = QgsCoordinateTransform(source.crs, QgsCoordinateReferenceSystem(WGS84), transform_context)
    if bounds.isEmpty() or bounds.contains(transformed_box(to_degrees, source.extent)):
        # Usually the whole layer is inside, and no feature must be checked.
        return lambda _box: True
    return lambda box: bounds.intersects(transformed_box(to_degrees, box))
