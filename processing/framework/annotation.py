"""What the algorithms that read an annotation layer share: its parameters and how it is read."""

from __future__ import annotations

from collections import Counter
from typing import Optional

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsProcessingParameterFile,
)

from ...core.annotation.findings import ERROR, UNKNOWN_CLASS
from ..compat import SOURCE_POLYGON
from ..translation import tr
from .base import ANNOTATION, SemRefAlgorithm, check_canceled


class AnnotationAlgorithm(SemRefAlgorithm):
    """Base of algorithms with an annotation layer; ``self._source`` is a snapshot of it."""

    GROUP = ANNOTATION

    INPUT = "INPUT"
    CLASS_FIELD = "CLASS_FIELD"
    PRIORITY_FIELD = "PRIORITY_FIELD"
    CLASS_TABLE = "CLASS_TABLE"

    def offer_annotation(self) -> None:
        """Adds the parameters of the annotation layer."""
        self.offer(
            QgsProcessingParameterFeatureSource(self.INPUT, tr("Annotation layer"), [SOURCE_POLYGON]),
            tr("Polygons of land cover. They may overlap, be multipart, invalid or three-dimensional."),
        )
        self.offer(
            QgsProcessingParameterField(self.CLASS_FIELD, tr("Class field"), parentLayerParameterName=self.INPUT),
            tr("Text or number field that tells the class of each polygon."),
        )
        self.offer(
            QgsProcessingParameterField(
                self.PRIORITY_FIELD, tr("Priority field"), parentLayerParameterName=self.INPUT, optional=True
            ),
            tr(
                "Number field: where polygons overlap, the one with the higher value lies on top. Without it the draw "
                "order of the class table counts, else later polygons lie on top."
            ),
        )
        self.offer(
            QgsProcessingParameterFile(
                self.CLASS_TABLE, tr("Class table"), fileFilter=tr("CSV files (*.csv)"), optional=True
            ),
            tr(
                "CSV with the columns value, name, color, role and optionally draw_order, hsv_min, hsv_max. "
                "Every class value of the layer must be in it."
            ),
        )

    def read_layers(self, parameters, context, feedback):
        from ..exchange.annotation import annotation_source

        definition = parameters[self.INPUT]
        if isinstance(definition, QgsProcessingFeatureSourceDefinition):
            layer = self.parameterAsVectorLayer({self.INPUT: definition.source}, self.INPUT, context)
        else:
            layer = self.parameterAsVectorLayer(parameters, self.INPUT, context)
        self._source = annotation_source(
            layer,
            definition,
            self.parameterAsString(parameters, self.CLASS_FIELD, context),
            self.parameterAsString(parameters, self.PRIORITY_FIELD, context),
        )

    def classes(self, parameters, context, feedback):
        """The ClassLookup: of the class table if one is given, else of the layer's style, else of its values."""
        from ...storage.rasters import read_class_table
        from ..exchange.annotation import class_lookup

        table_path = self.parameterAsFile(parameters, self.CLASS_TABLE, context)
        table = read_class_table(table_path) if table_path else None
        lookup = class_lookup(self._source, table, feedback.isCanceled)
        check_canceled(feedback)
        return lookup

    def label_map_crs(self, context, feedback):
        """The metric CRS that a label map of the layer would have; says so when it is not the layer's own."""
        from ..exchange.reference_systems import describe_crs, metric_crs

        source = self._source
        crs = metric_crs(source.crs, QgsCoordinateReferenceSystem(), source.extent, context.transformContext())
        if crs != source.crs:
            feedback.pushWarning(
                tr("{source} does not measure in meters; the result is in {target}.").format(
                    source=describe_crs(source.crs), target=describe_crs(crs)
                )
            )
        return crs

    def read_features(self, lookup, crs, context, feedback, last: float, with_attributes: bool = False):
        """The AnnotationReading of the layer, showing progress up to ``last`` %."""
        from ..exchange.annotation_features import AnnotationReading, read_features

        reading = AnnotationReading()
        transform_context = context.transformContext()
        for n in read_features(self._source, lookup, crs, transform_context, reading, with_attributes):
            if n % 256 == 0:
                check_canceled(feedback)
                feedback.setProgress(last * n / max(self._source.count, 1))
        return reading

    def require_known_classes(self, reading, lookup) -> None:
        """Raises AnnotationError as rasterizing does for class values that the class table lacks."""
        from ..exchange.annotation import AnnotationCounts, require_known_classes

        unknown = (f.reason for f in reading.findings if f.kind == UNKNOWN_CLASS and f.severity == ERROR)
        require_known_classes(AnnotationCounts(unknown=Counter(unknown)), self._source, lookup.table)


def geometry_of(wkb: Optional[bytes], multi: bool = False) -> Optional[QgsGeometry]:
    """A geometry for a sink; ``multi``: as a multi-geometry."""
    if wkb is None:
        return None
    geometry = QgsGeometry()
    geometry.fromWkb(wkb)
    if multi:
        geometry.convertToMultiType()
    return geometry
