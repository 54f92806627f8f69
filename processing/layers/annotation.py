"""Read land-cover layers: polygons with a class field, prepared for rasterizing."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Callable

from qgis.core import (
    QgsCategorizedSymbolRenderer,
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsExpression,
    QgsFeature,
    QgsFeatureIterator,
    QgsFeatureRequest,
    QgsGeometry,
    QgsProcessingFeatureSourceDefinition,
    QgsRectangle,
    QgsVectorLayer,
    QgsVectorLayerFeatureSource,
    QgsWkbTypes,
)

from ...core.annotation.classes import ClassLookup, StyledClass, distinct, is_whole, lookup_of, raw_text
from ...core.errors import AnnotationError
from ...core.labels.class_proposal import FoundClass
from ...core.labels.class_table import ClassTable
from ...storage.rasterize import BurnPolygon
from ..compat import POLYGON_GEOMETRY, is_null
from ..translation import tr
from .reference_systems import transformed_geometry

_NO_PRIORITY = float("-inf")
"""Priority of features without a value; all others cover them."""


@dataclass(frozen=True)
class AnnotationSource:
    """A snapshot of a land-cover layer that a worker thread may read while the layer is edited or removed.

    Attributes:
        styled: Classes of the layer's categorized renderer (raw values, label, color), if it uses the class field.
        unstyled_allowed: Whether that renderer has a category for all other values.
        class_of_all: Class of all features, if no field is used.
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
        """Return the content of a feature's class field; ``class_lookup`` maps it to a class value."""
        return self.class_of_all or feature.attribute(self.class_index)

    def read(self, with_attributes: bool = False) -> QgsFeatureIterator:
        """Return the features; with all attributes, or only with class and priority."""
        request = QgsFeatureRequest(self.request)
        if with_attributes:
            request.setSubsetOfAttributes(list(range(len(self.features.fields()))))
        return self.features.getFeatures(request)

    @property
    def class_expression(self) -> str:
        """Expression for a style: the class field, or the class of all features as text."""
        if self.class_of_all:
            return QgsExpression.quotedString(self.class_of_all)
        return self.features.fields().at(self.class_index).name()


@dataclass
class AnnotationCounts:
    """Numbers of features that were used, repaired or skipped while rasterizing."""

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
        """Return (is a warning, sentence) for the log."""
        used = tr("Used: {features}, {multipart} of them multipart.")
        found = [(False, used.format(features=_features(self.used), multipart=self.multipart))]
        repaired = tr("Repaired invalid geometry: {features}, {polygons} polygons.")
        if self.repaired:
            found.append((True, repaired.format(features=_features(self.repaired), polygons=self.repaired_parts)))
        for warns, number, sentence in (
            (True, self.empty, tr("Skipped, without geometry: {features}.")),
            (True, self.without_area, tr("Skipped, without area: {features}.")),
            (True, self.without_class, tr("Skipped, class is NULL: {features}.")),
            (True, self.not_in_style, tr("Left unlabeled, no category in the layer's style: {features}.")),
            (True, self.unprojectable, tr("Skipped, could not be reprojected: {features}.")),
            (False, self.three_dimensional, tr("Heights (Z) left out: {features}.")),
        ):
            if number:
                found.append((warns, sentence.format(features=_features(number))))
        return found


def _features(number: int) -> str:
    return tr("1 feature") if number == 1 else tr("{number} features").format(number=number)


def annotation_source(
    layer: QgsVectorLayer | None, definition: object, class_field: str, priority_field: str, class_of_all: str = ""
) -> AnnotationSource:
    """Copy the needed data of a layer, in the layer's thread. Raises AnnotationError.

    Args:
        definition: Value of the parameter, which may limit the features to selected or filtered ones.
        priority_field: Name of the priority field; empty without one.
        class_of_all: Class of all features; the class field is then not used.
    """
    layer = require_polygons(layer)
    fields = layer.fields()
    class_index = -1 if class_of_all else field_index(layer, class_field)
    priority_index = field_index(layer, priority_field) if priority_field else -1
    if priority_index >= 0 and not fields.at(priority_index).isNumeric():
        raise AnnotationError(
            "The priority field “{priority_field}” is not numeric. Choose a numeric field.",
            priority_field=priority_field,
        )
    request = request_of(layer, definition)
    request.setSubsetOfAttributes([i for i in (class_index, priority_index) if i >= 0])
    count, extent = layer.featureCount(), _extent(layer)
    if isinstance(definition, QgsProcessingFeatureSourceDefinition) and definition.selectedFeaturesOnly:
        count, extent = layer.selectedFeatureCount(), layer.boundingBoxOfSelected()
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


def request_of(layer: QgsVectorLayer, definition: object) -> QgsFeatureRequest:
    """Return a request for the selected or filtered features of a parameter's value, up to its limit."""
    request = QgsFeatureRequest()
    if isinstance(definition, QgsProcessingFeatureSourceDefinition):
        # From QGIS 3.32 on.
        expression = getattr(definition, "filterExpression", "")
        if expression:
            request.setFilterExpression(expression)
        if definition.selectedFeaturesOnly:
            # A request has one filter.
            passing = {feature.id() for feature in layer.getFeatures(request)} if expression else None
            request.setFilterFids([one for one in layer.selectedFeatureIds() if passing is None or one in passing])
        request.setLimit(definition.featureLimit)
    return request


def _extent(layer: QgsVectorLayer) -> QgsRectangle:
    """Return the extent of a layer. Raises AnnotationError for infinite coordinates, which break providers."""
    try:
        return layer.extent()
    except Exception:
        raise AnnotationError(
            "{layer} has features with infinite coordinates. Delete these features.", layer=layer.name()
        ) from None


def require_polygons(layer: QgsVectorLayer | None) -> QgsVectorLayer:
    """Return a layer of polygons. Raises AnnotationError for another one, and without a layer."""
    if layer is None or not layer.isValid():
        raise AnnotationError("The polygons can't be read. Choose a polygon layer.")
    if layer.geometryType() != POLYGON_GEOMETRY:
        kind = QgsWkbTypes.displayString(layer.wkbType())
        raise AnnotationError("“{layer}” has {kind} geometry. Choose a polygon layer.", layer=layer.name(), kind=kind)
    return layer


def field_index(layer: QgsVectorLayer, name: str) -> int:
    """Return the index of a field. Raises AnnotationError for a field that the layer lacks."""
    index = layer.fields().lookupField(name)
    if index < 0:
        raise AnnotationError(
            "“{layer}” has no field “{name}”. Choose one of its fields: {names}.",
            layer=layer.name(),
            name=name,
            names=layer.fields().names(),
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
    """Return the classes of a layer: from the given table, or the layer's style, or the field's distinct values."""
    if given is not None:
        return ClassLookup(given)
    found = source.styled or [((value,), str(value), "") for value in _distinct_values(source, canceled)]
    if not found and not canceled():
        raise _no_class(source)
    return lookup_of(found, source.class_is_number)


def _no_class(source: AnnotationSource) -> AnnotationError:
    if source.count == 0:
        return AnnotationError(
            "“{source}” has no features to use. Choose a layer with polygons, or change the selection.",
            source=source.name,
        )
    return AnnotationError("No feature of “{source}” has a class. Fill the class field first.", source=source.name)


def class_texts(source: AnnotationSource, canceled: Callable[[], bool]) -> list[FoundClass]:
    """Return all classes of the layer's features and style, as in the class field. Raises AnnotationError."""
    styles = {raw_text(raw): (label, color) for raws, label, color in source.styled for raw in raws}
    texts = [raw_text(value) for value in _distinct_values(source, canceled)]
    texts += [text for text in styles if text not in texts]
    if not texts and not canceled():
        raise _no_class(source)
    is_value = source.class_is_number and all(is_whole(text) and 1 <= int(text) <= 255 for text in texts)
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
    features: Iterable[QgsFeature],
    lookup: ClassLookup,
    transform: QgsCoordinateTransform,
    counts: AnnotationCounts,
) -> Iterator[BurnPolygon]:
    """Yield the polygons of the source's features, and update ``counts``."""
    for feature in features:
        raw = source.raw_class(feature)
        geometry = feature.geometry()
        if geometry.isNull() or geometry.isEmpty():
            counts.empty += 1
            continue
        if is_null(raw) or not raw_text(raw):
            counts.without_class += 1
            continue
        value = lookup.value(raw)
        if value is None:
            if source.styled and source.unstyled_allowed:
                counts.not_in_style += 1
            else:
                counts.unknown[raw_text(raw)] += 1
            continue
        priority = drawing_priority(feature, source, lookup.draw_orders.get(value, 0.0))
        for wkb, bounds in _parts(geometry, transform, counts):
            yield BurnPolygon(wkb, value, priority, bounds)


def drawing_priority(feature: QgsFeature, source: AnnotationSource, draw_order: float) -> float:
    """Return the priority of a feature: the priority field if there is one, otherwise the class's draw order."""
    if source.priority_index < 0:
        return draw_order
    raw = feature.attribute(source.priority_index)
    return _NO_PRIORITY if is_null(raw) else float(raw)


def _parts(
    geometry: QgsGeometry, transform: QgsCoordinateTransform, counts: AnnotationCounts
) -> list[tuple[bytes, tuple[float, float, float, float]]]:
    """Return (WKB, bounds) of the valid single polygons of a feature.

    GDAL would fill overlapping parts of a multipolygon by the even-odd rule.
    """
    if QgsWkbTypes.hasZ(geometry.wkbType()):
        counts.three_dimensional += 1
    # GDAL can't rasterize arcs.
    placed = transformed_geometry(transform, geometry)
    if placed is None:
        counts.unprojectable += 1
        return []
    parts = placed.asGeometryCollection() if placed.isMultipart() else [placed]
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
