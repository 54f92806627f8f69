"""semref:checkannotation – what is wrong with a land-cover layer, each finding a feature."""

from __future__ import annotations

from collections import Counter

from qgis.core import (
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
)

from ...core.annotation.findings import CHECKED_KINDS, ERROR
from ..compat import MULTI_POLYGON, SOURCE_POLYGON, wkt_for_gdal
from ..framework.annotation import AnnotationAlgorithm, geometry_of
from ..framework.base import cancelable, check_canceled, follow, interruptible
from ..framework.sinks import Sink
from ..packages.components import OPENCV, SHAPELY
from ..translation import tr
from ..wording.annotation_messages import FIELDS, row_of, sentence
from .rasterize_annotation import pixel_grid, union_of_bounds

READ, CHECKED, BURNT, DONE = 20.0, 70.0, 90.0, 95.0
"""Percent of the progress after reading, checking, burning at a pixel size, and looking at the pixels."""


class CheckAnnotation(AnnotationAlgorithm):
    ID = "checkannotation"
    TAGS = ("validate", "topology", "quality", "overlap", "gap", "sliver", "invalid geometry", "land cover")
    PACKAGES = (OPENCV, SHAPELY)

    MINIMUM_AREA = "MINIMUM_AREA"
    MAXIMUM_GAP = "MAXIMUM_GAP"
    PIXEL_SIZE = "PIXEL_SIZE"
    ISSUES = "ISSUES"
    REPORT = "REPORT"
    ISSUE_COUNT = "ISSUE_COUNT"
    ERROR_COUNT = "ERROR_COUNT"

    def title(self):
        return tr("Check annotation")

    def summary(self):
        return tr(
            "Finds what is wrong with a land-cover layer before it becomes a label map: invalid geometries, overlaps "
            "that nothing decides, duplicates, gaps and slivers, missing and unknown classes, and landmarks that "
            "touch, are too small, or that pixels of a given size would lose, merge or split.\n\n"
            "Each finding is a feature with its kind, severity (error, warning, information), a sentence and the ids "
            "of the features concerned. A model can stop when the number of errors is not 0. “Repair annotation” "
            "mends most of it."
        )

    def initAlgorithm(self, config=None):
        self.offer_annotation()
        number = QgsProcessingParameterNumber
        self.offer(
            number(self.MINIMUM_AREA, tr("Minimum area (m²)"), number.Double, 100.0, optional=True, minValue=0.0),
            tr("Smaller landmarks are reported: “Build reference database” leaves them out."),
        )
        self.offer(
            number(self.PIXEL_SIZE, tr("Pixel size (m)"), number.Double, None, optional=True, minValue=0.001),
            tr(
                "The pixel size that the layer is to be rasterized with: landmarks that such pixels would lose, merge "
                "or split are reported too. Not looked at if left out."
            ),
        )
        self.offer(
            number(self.MAXIMUM_GAP, tr("Largest gap (m²)"), number.Double, 1.0, minValue=0.0),
            tr("Uncovered places up to this area, enclosed by polygons, are gaps; thin ones are at any area."),
            advanced=True,
        )
        self.offer(
            QgsProcessingParameterFeatureSink(self.ISSUES, tr("Issues"), SOURCE_POLYGON),
            tr("One feature a finding, in the coordinate reference system of the label map."),
        )
        self.offer(
            QgsProcessingParameterFileDestination(
                self.REPORT, tr("Report"), tr("HTML files (*.html)"), optional=True, createByDefault=False
            ),
            tr("Findings by kind and class in one file to read and print."),
        )
        self.addOutput(QgsProcessingOutputNumber(self.ISSUE_COUNT, tr("Number of findings")))
        self.addOutput(QgsProcessingOutputNumber(self.ERROR_COUNT, tr("Number of errors")))

    def work(self, parameters, context, feedback):
        from ..exchange.output_style import style_output
        from ..exchange.styles import issues_renderer

        lookup = self.classes(parameters, context, feedback)
        crs = self.label_map_crs(context, feedback)
        reading = self.read_features(lookup, crs, context, feedback, READ)
        findings = reading.findings + self._checked(reading.features, lookup, parameters, context, feedback, crs)
        findings.sort(key=lambda finding: CHECKED_KINDS.index(finding.kind))
        feedback.setProgress(DONE)
        # Sinks are made last: a cancel before leaves nothing behind.
        check_canceled(feedback)
        names = {c.value: c.name for c in lookup.table}
        sink = Sink(self, parameters, self.ISSUES, context, FIELDS, MULTI_POLYGON, crs)
        for finding in findings:
            sink.add(geometry_of(finding.wkb, multi=True), row_of(finding, sentence(finding, names)))
        for (kind, severity), number in Counter((f.kind, f.severity) for f in findings).items():
            feedback.pushInfo(f"{kind} ({severity}): {number}")
        errors = sum(finding.severity == ERROR for finding in findings)
        feedback.pushInfo(tr("{issues} findings, {errors} of them errors").format(issues=len(findings), errors=errors))
        destination = sink.close()
        style_output(destination, issues_renderer(), context)
        results = {self.ISSUES: destination, self.ISSUE_COUNT: len(findings), self.ERROR_COUNT: errors}
        report = self.parameterAsFileOutput(parameters, self.REPORT, context)
        if report:
            results[self.REPORT] = self._write_report(report, findings, names)
        return results

    def _write_report(self, path, findings, names) -> str:
        from ...storage.files import written_beside
        from ..reports.annotation_report import AnnotationReport

        source = self._source
        html = AnnotationReport(source.name, source.count, findings, names).html()
        with written_beside(path) as temporary, open(temporary, "w", encoding="utf-8") as file:
            file.write(html)
        return path

    def _checked(self, features, lookup, parameters, context, feedback, crs):
        """Findings on how the features lie, and what pixels do to them if their size is given."""
        from ...core.annotation.check import AnnotationCheck, CheckSettings, find_raster_losses
        from ...storage.burning import RegionBurning

        minimum_area = self.parameterAsDouble(parameters, self.MINIMUM_AREA, context)
        landmark_classes = lookup.table.reference_values or tuple(c.value for c in lookup.table)
        settings = CheckSettings(
            minimum_area, self.parameterAsDouble(parameters, self.MAXIMUM_GAP, context), landmark_classes
        )
        check = AnnotationCheck(features, settings)
        follow(interruptible(check.steps(), feedback), feedback, READ, CHECKED)
        if parameters.get(self.PIXEL_SIZE) in (None, "") or not check.landmarks:
            return check.findings
        pixel_size = self.parameterAsDouble(parameters, self.PIXEL_SIZE, context)
        bounds = union_of_bounds([landmark.bounds for landmark in check.landmarks])
        burning = RegionBurning(check.landmarks, pixel_grid(bounds, pixel_size, wkt_for_gdal(crs)))
        follow(interruptible(burning.steps(), feedback), feedback, CHECKED, BURNT)
        losses = cancelable(
            find_raster_losses, check.landmarks, burning.runs, minimum_area, pixel_size, feedback=feedback
        )
        return check.findings + losses
