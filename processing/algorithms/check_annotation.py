"""semref:checkannotation: find errors in a land-cover layer."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterNumber,
)

from ...core.annotation.findings import CHECKED_KINDS, ERROR, Finding
from ...storage.pixel_grid import pixel_grid, union_of_bounds
from ..base import parameters
from ..base.algorithm import Declared, cancelable, check_canceled, follow, interruptible
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import DOUBLE, MULTI_POLYGON, SOURCE_POLYGON, wkt_for_gdal
from ..jobs.annotation import AnnotationAlgorithm, geometry_of
from ..messages.annotation_messages import FIELDS, kind_titles, row_of, sentence, severity_title
from ..packages.components import NEEDED, SHAPELY
from ..translation import tr

if TYPE_CHECKING:
    from ...core.annotation.classes import ClassLookup
    from ...core.annotation.polygons import AnnotatedFeature

READ, CHECKED, BURNT, DONE = 20.0, 70.0, 90.0, 95.0
"""Progress in percent after reading, checking, burning at a pixel size, and checking the pixels."""


class CheckAnnotation(AnnotationAlgorithm):
    ID = "checkannotation"
    TITLE = "Check land-cover layer"
    TAGS = ("validate", "topology", "quality", "overlap", "gap", "sliver", "invalid geometry", "land cover")
    PACKAGES = (*NEEDED, SHAPELY)
    SUMMARY = (
        "Finds errors in a land-cover layer: invalid geometries, overlaps, duplicates, gaps, slivers, and missing "
        "or unknown classes. It also finds landmarks that touch, are too small, or are lost, merged or split at a "
        "pixel size.\n\nEach finding is a feature with a kind, a severity and a message. “Repair land-cover "
        "layer” repairs most findings."
    )

    MAXIMUM_GAP = "MAXIMUM_GAP"
    PIXEL_SIZE = "PIXEL_SIZE"
    ISSUES = "ISSUES"
    ISSUE_COUNT = "ISSUE_COUNT"
    ERROR_COUNT = "ERROR_COUNT"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            *parameters.annotation(),
            with_help(
                QgsProcessingParameterNumber(
                    self.MINIMUM_AREA, "Minimum area (m²)", DOUBLE, 100.0, optional=True, minValue=0.0
                ),
                "Landmarks smaller than this area are reported, because “Build reference database” does not use "
                "them. A typical value is 100.",
            ),
            with_help(
                QgsProcessingParameterNumber(self.PIXEL_SIZE, "Pixel size (m)", DOUBLE, optional=True, minValue=0.001),
                "Pixel size for “Rasterize land-cover layer”. Landmarks that are lost, merged or split at this "
                "pixel size are reported too. If not set, this is not checked.",
            ),
            with_help(
                QgsProcessingParameterNumber(self.MAXIMUM_GAP, "Maximum gap (m²)", DOUBLE, 1.0, minValue=0.0),
                "Uncovered areas up to this size, enclosed by polygons, are reported as gaps. Thin areas are "
                "reported at any size.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterFeatureSink(self.ISSUES, "Issues", type=SOURCE_POLYGON),
                "One feature for each finding, in the CRS of the label map.",
            ),
            parameters.report("Page with the findings by kind and class.", by_default=False),
            QgsProcessingOutputNumber(self.ISSUE_COUNT, "Number of findings"),
            QgsProcessingOutputNumber(self.ERROR_COUNT, "Number of errors"),
        )

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ..reports.annotation_report import annotation_html

        lookup = self.classes(values, feedback)
        crs = self.label_map_crs(values, feedback)
        reading = self.read_features(values, lookup, crs, feedback, READ)
        findings = reading.findings + self._find(values, reading.features, lookup, crs, feedback)
        findings.sort(key=lambda finding: CHECKED_KINDS.index(finding.kind))
        feedback.setProgress(DONE)
        # Outputs are written last, so that a cancel leaves nothing behind.
        check_canceled(feedback)
        names = {c.value: c.name for c in lookup.table}
        with outputs.layer(self.ISSUES, FIELDS, MULTI_POLYGON, crs, "issues") as sink:
            for finding in findings:
                sink.add(geometry_of(finding.wkb, multi=True), row_of(finding, sentence(finding, names)))
        for (kind, severity), number in Counter((f.kind, f.severity) for f in findings).items():
            feedback.pushInfo(f"{kind_titles()[kind]} ({severity_title(severity)}): {number}")
        errors = sum(finding.severity == ERROR for finding in findings)
        feedback.pushInfo(
            tr("{issues} findings, {errors} of them are errors.").format(issues=len(findings), errors=errors)
        )
        if values.has(self.REPORT):
            outputs.text(self.REPORT, annotation_html(self._source.name, self._source.count, findings, names))
        return {self.ISSUE_COUNT: len(findings), self.ERROR_COUNT: errors}

    def _find(
        self,
        values: Values,
        features: list[AnnotatedFeature],
        lookup: ClassLookup,
        crs: QgsCoordinateReferenceSystem,
        feedback: QgsProcessingFeedback,
    ) -> list[Finding]:
        """Return findings on the features and, if a pixel size is given, on what pixels do to them."""
        from ...core.annotation.check import check_features, find_raster_losses
        from ...storage.rasterize import burn_regions

        minimum_area = values.number(self.MINIMUM_AREA)
        landmark_classes = lookup.table.reference_values or tuple(c.value for c in lookup.table)
        steps = check_features(features, minimum_area, values.number(self.MAXIMUM_GAP), landmark_classes)
        findings, landmarks = follow(interruptible(steps, feedback), feedback, READ, CHECKED)
        pixel_size = values.optional_number(self.PIXEL_SIZE)
        if pixel_size is None or not landmarks:
            return findings
        bounds = union_of_bounds([landmark.bounds for landmark in landmarks])
        burning = burn_regions(landmarks, pixel_grid(bounds, pixel_size, wkt_for_gdal(crs)))
        runs = follow(interruptible(burning, feedback), feedback, CHECKED, BURNT)
        return findings + cancelable(find_raster_losses, landmarks, runs, minimum_area, pixel_size, feedback=feedback)
