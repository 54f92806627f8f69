"""The map of *Set up an area*: private copies of its layers for other threads."""

from __future__ import annotations

from collections.abc import Iterator

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCoordinateTransformContext,
    QgsFeature,
    QgsFeatureRequest,
    QgsGeometry,
    QgsProcessingFeatureSourceDefinition,
    QgsRectangle,
    QgsVectorLayer,
    QgsVectorLayerFeatureSource,
)

from ...core.errors import AnnotationError
from ...core.labels.openstreetmap import Rules, tags_of
from ..compat import LINE_GEOMETRY, is_null
from ..layers.annotation import field_index, request_of, require_polygons
from ..layers.guess_fields import BUILDING, class_field_of, has_osm_tags, priority_field_of
from ..layers.line_areas import LineAreas
from ..layers.reference_systems import WGS84, transformed_box


class AreaMap:
    """Private copies of the land-cover layer and of lines for other threads, and how they get their classes.

    Attributes:
        lines: The copy of lines with tags of OpenStreetMap; None without lines.
        class_field: Field with the class; empty for tags of OpenStreetMap, and for a layer of buildings.
        has_tags: Whether the classes follow from tags of OpenStreetMap.
    """

    lines: QgsVectorLayer | None = None

    def __init__(self, layer: QgsVectorLayer | None, definition: object, class_field: str) -> None:
        """Copy the layer, in its thread. Raises AnnotationError."""
        layer = require_polygons(layer)
        if class_field:
            field_index(layer, class_field)
        self.has_tags = not class_field and has_osm_tags(layer.fields().names())
        self.class_field = class_field or ("" if self.has_tags else class_field_of(layer))
        self.priority_field = priority_field_of(layer) if self.class_field else ""
        self.layer = _private_copy(layer, definition)
        self.name, self.crs, self.extent = layer.name(), layer.crs(), self.layer.extent()
        self._features = QgsVectorLayerFeatureSource(self.layer)

    def add_lines(
        self, lines: QgsVectorLayer | None, definition: object, context: QgsCoordinateTransformContext
    ) -> None:
        """Copy lines with tags of OpenStreetMap, in their thread. Raises SemRefError."""
        if lines is None or not lines.isValid() or lines.geometryType() != LINE_GEOMETRY:
            raise AnnotationError("The lines can't be read. Choose a layer of lines.")
        if not self.has_tags:
            raise AnnotationError(
                "Lines can be added to tags of OpenStreetMap only, and “{layer}” has no tags. Choose another map, or "
                "leave out the lines.",
                layer=self.name,
            )
        self.lines = _private_copy(lines, definition)
        self._areas = LineAreas(lines.name(), lines.crs(), self.lines.extent(), self.crs, context)
        self._lines = QgsVectorLayerFeatureSource(self.lines)
        self._to_lines = QgsCoordinateTransform(self.crs, lines.crs(), context)

    def degrees(self, context: QgsCoordinateTransformContext) -> QgsRectangle:
        """Return the extent in longitudes and latitudes."""
        to_degrees = QgsCoordinateTransform(self.crs, QgsCoordinateReferenceSystem(WGS84), context)
        return transformed_box(to_degrees, self.extent)

    def polygons(self, extent: QgsRectangle, rules: Rules) -> Iterator[tuple[str, QgsGeometry]]:
        """Yield (class name, geometry) of each polygon that touches an extent in the layer's CRS; empty: no class."""
        for feature in self._features.getFeatures(QgsFeatureRequest().setFilterRect(extent)):
            if self.has_tags:
                rule = rules.of(_tags_of(feature))
                yield "" if rule is None else rule.class_name, feature.geometry()
            else:
                value = feature[self.class_field] if self.class_field else BUILDING
                yield "" if is_null(value) else str(value).strip(), feature.geometry()
        if self.lines is not None:
            yield from self._areas_of_lines(transformed_box(self._to_lines, extent), rules.for_lines)

    def _areas_of_lines(self, extent: QgsRectangle, rules: Rules) -> Iterator[tuple[str, QgsGeometry]]:
        for feature in self._lines.getFeatures(QgsFeatureRequest().setFilterRect(extent)):
            rule, area = self._areas.of(feature.geometry(), _tags_of(feature), rules)
            if rule is not None and area is not None:
                yield rule.class_name, area


def _tags_of(feature: QgsFeature) -> dict[str, str]:
    values = zip(feature.fields().names(), feature.attributes())
    return tags_of({name: value for name, value in values if not is_null(value)})


def _private_copy(layer: QgsVectorLayer, definition: object) -> QgsVectorLayer:
    """Return a layer that nobody edits or removes; features of layers in memory or in editing are copied."""
    is_part = isinstance(definition, QgsProcessingFeatureSourceDefinition)
    if not is_part and layer.providerType() != "memory" and not layer.isEditable():
        return layer.clone()
    copy = layer.materialize(request_of(layer, definition))
    copy.setRenderer(layer.renderer().clone())
    return copy
