"""Annotation layers: polygons with a class field, as people have them, made ready for burning into a label map."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Callable

from qgis.core import (
    QgsCategorizedSymbolRenderer,
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsExpression,
    QgsFeature,
    QgsFeatureRequest,
    QgsGeometry,
    QgsProcessingFeatureSourceDefinition,
    QgsRectangle,
    QgsVectorLayer,
    QgsVectorLayerFeatureSource,
    QgsWkbTypes,
)

from ...core.annotation.classes import ClassLookup, StyledClass, distinct, lookup_of, raw_text
from ...core.errors import AnnotationError
from ...core.labels.class_proposal import FoundClass
from ...core.labels.class_table import ClassTable
from ...storage.rasterize import BurnPolygon
from ..compat import POLYGON_GEOMETRY, is_null
from ..translation import tr

_NO_PRIORITY = float("-inf")
"""Features without a priority lie below all others."""


@dataclass(frozen=True)
class AnnotationSource:
    """A snapshot of an annotation layer that a worker thread may read while the layer is edited or removed.

    ``styled``: the classes of the layer's categorised renderer (raw values, label, color), if it classifies
    ``class_field``; ``unstyled_allowed``: whether that renderer has a category for all other values; ``class_of_all``:
    the class of every feature where no field is used.
    """

    name: str
    crs: QgsCoordinateReferenceSystem
    extent: QgsRectangle
    features: QgsVectorLayerFeatureSource
    request: QgsFeatureRequest
    count: int
    class_index: int
    class_is_number: bool
    priority_index: int
    styled: tuple[StyledClass, ...]
    unstyled_allowed: bool
    class_of_all: str = ""

    def raw_class(self, feature: QgsFeature) -> object:
        """What a feature has for its class, NULL for nothing; ``class_lookup`` gives its value."""
        return self.class_of_all or feature.attribute(self.class_index)

    @property
    def class_expression(self) -> str:
        """What a style classifies by: the field, or the class of all as a text."""
        if self.class_of_all:
            return QgsExpression.quotedString(self.class_of_all)
        return self.features.fields().at(self.class_index).name()


@dataclass
class AnnotationCounts:
    """What happened to the features on their way into the label map."""

    used: int = 0
    repaired: int = 0
    repaired_parts: int = 0
    empty: int = 0
    without_area: int = 0
    without_class: int = 0
    not_in_style: int = 0
    three_dimensional: int = 0
    multipart: int = 0
    unprojectable: int = 0
    unknown: Counter = field(default_factory=Counter)

    def sentences(self) -> list[tuple[bool, str]]:
        """(is a warning, sentence) for everything that is worth saying."""
        used = tr("Used: {features}, {multipart} of them multipart.")
        said = [(False, used.format(features=_features(self.used), multipart=self.multipart))]
        repaired = tr("Repaired invalid geometry: {features}, {polygons} polygons.")
        if self.repaired:
            said.append((True, repaired.format(features=_features(self.repaired), polygons=self.repaired_parts)))
        for warns, number, sentence in (
            (True, self.empty, tr("Skipped, without geometry: {features}.")),
            (True, self.without_area, tr("Skipped, without area: {features}.")),
            (True, self.without_class, tr("Skipped, class is NULL: {features}.")),
            (True, self.not_in_style, tr("Left unlabeled, no category in the layer's style: {features}.")),
            (True, self.unprojectable, tr("Skipped, could not be reprojected: {features}.")),
            (False, self.three_dimensional, tr("Heights (Z) left out: {features}.")),
        ):
            if number:
                said.append((warns, sentence.format(features=_features(number))))
        return said


def _features(number: int) -> str:
    return tr("1 feature") if number == 1 else tr("{number} features").format(number=number)


def annotation_source(
    layer: QgsVectorLayer | None, definition: object, class_field: str, priority_field: str, class_of_all: str = ""
) -> AnnotationSource:
    """Takes what is needed out of a layer, in the thread it lives in. Raises AnnotationError.

    ``definition``: the parameter's value; "selected features only" and a filter expression in it are heeded.
    ``class_of_all``: the class of every feature; the class field is not used then.
    """
    if layer is None or not layer.isValid():
        raise AnnotationError("INPUT is not a vector layer that can be read; choose a polygon layer.")
    if layer.geometryType() != POLYGON_GEOMETRY:
        kind = QgsWkbTypes.displayString(layer.wkbType())
        raise AnnotationError(
            "“{layer}” holds {kind} geometry; an annotation layer holds polygons.", layer=layer.name(), kind=kind
        )
    fields = layer.fields()
    class_index = -1 if class_of_all else _field_index(layer, class_field, "CLASS_FIELD")
    priority_index = _field_index(layer, priority_field, "PRIORITY_FIELD") if priority_field else -1
    if priority_index >= 0 and not fields.at(priority_index).isNumeric():
        raise AnnotationError(
            "The priority field “{priority_field}” does not hold numbers; choose one that does.",
            priority_field=priority_field,
        )
    request = QgsFeatureRequest()
    request.setSubsetOfAttributes([i for i in (class_index, priority_index) if i >= 0])
    count, extent = layer.featureCount(), _extent(layer)
    if isinstance(definition, QgsProcessingFeatureSourceDefinition):
        if definition.selectedFeaturesOnly:
            request.setFilterFids(layer.selectedFeatureIds())
            count, extent = layer.selectedFeatureCount(), layer.boundingBoxOfSelected()
        if getattr(definition, "filterExpression", ""):
            request.setFilterExpression(definition.filterExpression)
    styled, unstyled_allowed = ((), False) if class_of_all else _styled_classes(layer, class_field)
    return AnnotationSource(
        layer.name(),
        layer.crs(),
        extent,
        QgsVectorLayerFeatureSource(layer),
        request,
        count,
        class_index,
        not class_of_all and fields.at(class_index).isNumeric(),
        priority_index,
        styled,
        unstyled_allowed,
        class_of_all,
    )


def _extent(layer: QgsVectorLayer) -> QgsRectangle:
    """Where a layer lies. Raises AnnotationError where infinite coordinates make QGIS's providers raise anything."""
    try:
        return layer.extent()
    except Exception:
        raise AnnotationError(
            "{layer} has places that are no numbers; remove the features that have them.", layer=layer.name()
        ) from None


def _field_index(layer: QgsVectorLayer, name: str, key: str) -> int:
    index = layer.fields().lookupField(name)
    if index < 0:
        names = [field.name() for field in layer.fields()]
        raise AnnotationError(
            "{key}: “{layer}” has no field “{name}”; its fields are {names}.",
            key=key,
            layer=layer.name(),
            name=name,
            names=names,
        )
    return index


def _styled_classes(layer: QgsVectorLayer, class_field: str) -> tuple[tuple[StyledClass, ...], bool]:
    renderer = layer.renderer()
    if not isinstance(renderer, QgsCategorizedSymbolRenderer):
        return (), False
    if renderer.classAttribute().strip('"').casefold() != class_field.casefold():
        return (), False
    found, others = [], False
    for category in renderer.categories():
        values = category.value() if isinstance(category.value(), list) else [category.value()]
        own = tuple(value for value in values if not is_null(value) and value != "")
        if own:
            found.append((own, category.label() or str(own[0]), category.symbol().color().name()))
        if len(own) < len(values):
            others = others or category.renderState()
    return tuple(found), others


def class_lookup(source: AnnotationSource, given: ClassTable | None, canceled: Callable[[], bool]) -> ClassLookup:
    """The classes of an annotation: from the given table, else the layer's style, else the field's distinct values."""
    if given is not None:
        return ClassLookup(given)
    found = source.styled or [((value,), str(value), "") for value in _distinct_values(source, canceled)]
    if not found and not canceled():
        raise AnnotationError("“{source}” has no feature with a class; fill its class field first.", source=source.name)
    return lookup_of(found, source.class_is_number)


def class_texts(source: AnnotationSource, canceled: Callable[[], bool]) -> list[FoundClass]:
    """Every class that the layer's features or its style have, as the class field holds it; raises AnnotationError."""
    styles = {raw_text(raw): (label, color) for raws, label, color in source.styled for raw in raws}
    texts = [raw_text(value) for value in _distinct_values(source, canceled)]
    texts += [text for text in styles if text not in texts]
    if not texts and not canceled():
        raise AnnotationError("“{source}” has no feature with a class; fill its class field first.", source=source.name)
    is_value = source.class_is_number and all(text.isdigit() and 1 <= int(text) <= 255 for text in texts)
    return [FoundClass(t, *styles.get(t, (t, "")), int(t) if is_value else None) for t in texts]


def _distinct_values(source: AnnotationSource, canceled: Callable[[], bool]) -> list[object]:
    if source.class_of_all:
        return [source.class_of_all]
    request = QgsFeatureRequest(source.request)
    request.setFlags(QgsFeatureRequest.NoGeometry)

    def filled() -> Iterator[object]:
        for feature in source.features.getFeatures(request):
            raw = feature.attribute(source.class_index)
            if canceled():
                return
            if not is_null(raw):
                yield raw

    found = distinct(filled())
    return [] if canceled() else found


def burn_polygons(
    source: AnnotationSource,
    lookup: ClassLookup,
    transform: QgsCoordinateTransform | None,
    counts: AnnotationCounts,
) -> Iterator[list[BurnPolygon]]:
    """The polygons of each feature, one list a feature (empty when it is skipped); ``counts`` is kept up to date."""
    for feature in source.features.getFeatures(source.request):
        raw = source.raw_class(feature)
        geometry = feature.geometry()
        if geometry.isNull() or geometry.isEmpty():
            counts.empty += 1
            yield []
            continue
        if is_null(raw) or not raw_text(raw):
            counts.without_class += 1
            yield []
            continue
        value = lookup.value(raw)
        if value is None:
            if source.styled and source.unstyled_allowed:
                counts.not_in_style += 1
            else:
                counts.unknown[raw_text(raw)] += 1
            yield []
            continue
        priority = drawing_priority(feature, source, lookup.draw_orders.get(value, 0.0))
        yield [BurnPolygon(wkb, value, priority, bounds) for wkb, bounds in _parts(geometry, transform, counts)]


def drawing_priority(feature: QgsFeature, source: AnnotationSource, draw_order: float) -> float:
    """Higher lies on top: the priority field if there is one, else the class's draw order."""
    if source.priority_index < 0:
        return draw_order
    raw = feature.attribute(source.priority_index)
    return _NO_PRIORITY if is_null(raw) else float(raw)


def _parts(
    geometry: QgsGeometry, transform: QgsCoordinateTransform | None, counts: AnnotationCounts
) -> list[tuple[bytes, tuple[float, float, float, float]]]:
    """Valid single polygons of a feature. GDAL would fill the parts of a multipolygon by even and odd."""
    if QgsWkbTypes.hasZ(geometry.wkbType()):
        counts.three_dimensional += 1
    # GDAL burns no arcs.
    geometry.convertToStraightSegment()
    if transform is not None:
        try:
            geometry.transform(transform)
        except QgsCsException:
            counts.unprojectable += 1
            return []
    parts = geometry.asGeometryCollection() if geometry.isMultipart() else [geometry]
    counts.multipart += len(parts) > 1
    found, repaired = [], False
    for part in parts:
        if not part.isGeosValid():
            repaired = True
            counts.repaired_parts += 1
            part = part.makeValid()
        for polygon in part.asGeometryCollection() if part.isMultipart() else [part]:
            if polygon.type() == POLYGON_GEOMETRY and polygon.area() > 0:
                box = polygon.boundingBox()
                bounds = (box.xMinimum(), box.yMinimum(), box.xMaximum(), box.yMaximum())
                found.append((polygon.asWkb().data(), bounds))
    counts.repaired += repaired and bool(found)
    if found:
        counts.used += 1
    else:
        counts.without_area += 1
    return found
