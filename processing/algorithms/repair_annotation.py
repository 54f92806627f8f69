"""semref:repairannotation: repair a land-cover layer, so that each landmark is one valid polygon."""

from __future__ import annotations

from qgis.core import QgsProcessingFeedback, QgsProcessingParameterFeatureSink, QgsProcessingParameterNumber

from ...core.annotation.findings import ERROR, OUTSIDE_CRS
from ...core.errors import ParameterError
from ..base import parameters
from ..base.algorithm import Declared, check_canceled, follow, interruptible
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import DOUBLE, MULTI_POLYGON, POLYGON, SOURCE_POLYGON
from ..jobs.annotation import AnnotationAlgorithm, geometry_of
from ..messages.annotation_messages import FIELDS, change_sentence, row_of
from ..packages.components import NEEDED, SHAPELY
from ..translation import tr

READ, REPAIRED = 20.0, 95.0
"""Progress in percent after reading and repairing."""


class RepairAnnotation(AnnotationAlgorithm):
    ID = "repairannotation"
    TITLE = "Repair land-cover layer"
    TAGS = ("clean", "topology", "fix geometries", "dissolve", "overlap", "gap", "sliver", "land cover")
    PACKAGES = (*NEEDED, SHAPELY)
    SUMMARY = (
        "Repairs a land-cover layer, so that each landmark is one polygon. Geometries become valid, touching "
        "polygons of one class are merged, and small gaps and slivers go to a neighbor.\n\nIn an overlap the "
        "polygon with the higher priority is kept, otherwise the smaller polygon. Each polygon keeps the "
        "attributes of the feature that covers most of it."
    )

    MAXIMUM_GAP = "MAXIMUM_GAP"
    CHANGES = "CHANGES"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            *parameters.annotation(),
            with_help(
                QgsProcessingParameterNumber(
                    self.MAXIMUM_GAP, "Maximum gap (m²)", DOUBLE, 1.0, optional=True, minValue=0.0
                ),
                "Uncovered areas up to this size, enclosed by polygons, are filled. Thin areas are filled at any size.",
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.MINIMUM_AREA, "Minimum area (m²)", DOUBLE, 0.0, optional=True, minValue=0.0
                ),
                "Pieces smaller than this area are merged with a neighbor that they touch. Pieces without a "
                "neighbor stay. Thin pieces are merged at any size.",
            ),
            with_help(
                QgsProcessingParameterFeatureSink(self.OUTPUT, "Repaired layer", type=SOURCE_POLYGON),
                "Valid single polygons with the fields of the land-cover layer, in a CRS with meters.",
            ),
            with_help(
                QgsProcessingParameterFeatureSink(
                    self.CHANGES, "Changes", type=SOURCE_POLYGON, optional=True, createByDefault=False
                ),
                "One feature for each change, with its location and the ids of the features.",
            ),
        )

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> None:
        from ...core.annotation.repair import repair_features
        from ..layers.class_styles import repaired_renderer

        lookup = self.classes(values, feedback)
        crs = self.label_map_crs(values, feedback)
        reading = self.read_features(values, lookup, crs, feedback, READ, with_attributes=True)
        self.require_known_classes(reading, lookup)
        limits = values.number(self.MAXIMUM_GAP), values.number(self.MINIMUM_AREA)
        steps = interruptible(repair_features(reading.features, *limits), feedback)
        polygons, repairs = follow(steps, feedback, READ, REPAIRED)
        if not polygons:
            raise ParameterError(
                "“{source}” contains no polygon with an area and a class, so there is nothing to repair. Check the "
                "class field.",
                source=self._source.name,
            )
        # Outputs are written last, so that a cancel leaves nothing behind.
        check_canceled(feedback)
        renderer = repaired_renderer(lookup, self._source)
        fields = self._source.features.fields()
        with outputs.layer(self.OUTPUT, fields, POLYGON, crs, renderer=renderer, is_own=False) as sink:
            for polygon in polygons:
                sink.add_row(geometry_of(polygon.wkb), reading.attributes[polygon.feature])
        changes = [f for f in reading.findings if f.kind != OUTSIDE_CRS or f.severity == ERROR] + repairs
        feedback.pushInfo(
            tr("{before} features became {after} polygons; {changes} changes.").format(
                before=self._source.count, after=len(polygons), changes=len(changes)
            )
        )
        names = {c.value: c.name for c in lookup.table}
        with outputs.layer(self.CHANGES, FIELDS, MULTI_POLYGON, crs, "changes") as sink:
            for change in changes:
                sink.add(geometry_of(change.wkb, multi=True), row_of(change, change_sentence(change, names)))
