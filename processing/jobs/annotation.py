"""Base of the algorithms that read a land-cover layer: its parameters, and how it is read."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsGeometry, QgsProcessingFeedback

from ...core.annotation.findings import ERROR, UNKNOWN_CLASS
from ...core.errors import ParameterError
from ...core.labels.class_table import ClassTable
from ...storage.pixel_grid import Bounds, union_of_bounds
from ..base import parameters
from ..base.algorithm import ANNOTATION, SemRefAlgorithm, check_canceled, each
from ..base.values import Values
from ..translation import tr

if TYPE_CHECKING:
    from ...core.annotation.classes import ClassLookup
    from ...storage.rasterize import BurnPolygon
    from ..layers.annotation import AnnotationSource
    from ..layers.annotation_features import AnnotationReading

CLASS_TABLES = Path(__file__).resolve().parents[2] / "resources" / "class_tables"
PRESETS = {
    "OpenStreetMap": str(CLASS_TABLES / "openstreetmap.csv"),
    "LCDB v5 (New Zealand)": str(CLASS_TABLES / "lcdb.csv"),
    "CORINE Land Cover": str(CLASS_TABLES / "corine.csv"),
    "Urban Atlas": str(CLASS_TABLES / "urban_atlas.csv"),
}
"""Class tables in the plugin, by the names of their nomenclatures, in the order of PRESET (without 0, no preset)."""


class AnnotationAlgorithm(SemRefAlgorithm):
    """Base of algorithms with a land-cover layer; ``self._source`` is a snapshot of it."""

    GROUP = ANNOTATION
    _source: AnnotationSource

    CLASS = parameters.CLASS
    PRIORITY_FIELD = parameters.PRIORITY_FIELD

    def check(self, values: Values) -> None:
        if values.has(self.INPUT) and not (values.text(self.CLASS_FIELD) or values.text(self.CLASS).strip()):
            raise ParameterError(
                "The polygons have no class. Select the class field, or enter the class of all polygons."
            )

    def read_layers(self, values: Values) -> None:
        from ..layers.annotation import annotation_source

        self._source = annotation_source(
            values.vector(self.INPUT),
            values.raw(self.INPUT),
            values.text(self.CLASS_FIELD),
            values.text(self.PRIORITY_FIELD),
            values.text(self.CLASS).strip(),
        )

    def classes(self, values: Values, feedback: QgsProcessingFeedback) -> ClassLookup:
        """Return the classes of the class table, otherwise of the layer's style, otherwise of its values."""
        from ..layers.annotation import class_lookup

        lookup = class_lookup(self._source, values.class_table(self.CLASS_TABLE), feedback.isCanceled)
        check_canceled(feedback)
        return lookup

    def label_map_crs(
        self, values: Values, feedback: QgsProcessingFeedback, asked: QgsCoordinateReferenceSystem | None = None
    ) -> QgsCoordinateReferenceSystem:
        """Return the metric CRS of the label map: the selected one, otherwise the layer's, otherwise a UTM zone
        (logged)."""
        from ..layers.reference_systems import describe_crs, metric_crs

        source, asked = self._source, asked or QgsCoordinateReferenceSystem()
        crs = metric_crs(source.crs, asked, source.extent, values.transform_context)
        if crs != source.crs and not asked.isValid():
            text = tr("A unit of the layer’s CRS ({source}) is not a meter on the ground. The result is in {target}.")
            feedback.pushWarning(text.format(source=describe_crs(source.crs), target=describe_crs(crs)))
        return crs

    def read_features(
        self,
        values: Values,
        lookup: ClassLookup,
        crs: QgsCoordinateReferenceSystem,
        feedback: QgsProcessingFeedback,
        last: float,
        with_attributes: bool = False,
    ) -> AnnotationReading:
        """Read the layer and show progress up to ``last`` %."""
        from ..layers.annotation_features import read_features

        features = each(self._source.read(with_attributes), feedback, self._source.count, last)
        return read_features(self._source, features, lookup, crs, values.transform_context, with_attributes)

    def burn_polygons(
        self, values: Values, feedback: QgsProcessingFeedback, crs: QgsCoordinateReferenceSystem, last: float
    ) -> tuple[list[BurnPolygon], ClassTable]:
        """Return the polygons to burn and the class table; log what was repaired and skipped; progress ends at ``last``
        %."""
        from ...core.annotation.classes import require_known_classes
        from ..layers.annotation import AnnotationCounts, burn_polygons

        source = self._source
        lookup = self.classes(values, feedback)
        transform = QgsCoordinateTransform(source.crs, crs, values.transform_context)
        counts = AnnotationCounts()
        features = each(source.read(), feedback, source.count, last)
        polygons = list(burn_polygons(source, features, lookup, transform, counts))
        for warns, sentence in counts.sentences():
            (feedback.pushWarning if warns else feedback.pushInfo)(sentence)
        require_known_classes(counts.unknown, source.name, lookup.table)
        if not polygons:
            raise ParameterError(
                "“{source}” contains no polygon with an area and a class, so there is nothing to rasterize. Check the "
                "class field.",
                source=source.name,
            )
        return polygons, lookup.table

    def require_known_classes(self, reading: AnnotationReading, lookup: ClassLookup) -> None:
        """Raises AnnotationError for class values that the class table lacks, as rasterizing does."""
        from ...core.annotation.classes import require_known_classes

        unknown = (f.reason for f in reading.findings if f.kind == UNKNOWN_CLASS and f.severity == ERROR)
        require_known_classes(Counter(unknown), self._source.name, lookup.table)


def filling_polygon(value: int, bounds: Iterable[Bounds]) -> BurnPolygon:
    """Return a polygon of class ``value`` that covers the extent of all polygons; it must be burned first."""
    from qgis.core import QgsRectangle

    from ...storage.rasterize import BurnPolygon

    reach = union_of_bounds(bounds)
    outline = QgsGeometry.fromRect(QgsRectangle(*reach))
    return BurnPolygon(bytes(outline.asWkb().data()), value, -math.inf, reach)


def geometry_of(wkb: bytes | None, multi: bool = False) -> QgsGeometry | None:
    """Return a geometry for a sink; ``multi``: as a multi-geometry."""
    if wkb is None:
        return None
    geometry = QgsGeometry()
    geometry.fromWkb(wkb)
    if multi:
        geometry.convertToMultiType()
    return geometry
