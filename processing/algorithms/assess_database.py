"""semref:assessdatabase: map where a reference database localizes images, and where it does not."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
    QgsRectangle,
)

from ...core.errors import ParameterError
from ..base import parameters
from ..base.algorithm import LOCALIZATION, Declared, cancelable, check_canceled
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.scheduler import require_scheduler, scheduler, workers
from ..base.values import Values
from ..compat import DOUBLE, INTEGER, POLYGON, SOURCE_POLYGON
from ..jobs.assessing import AssessAlgorithm, setting_rows
from ..messages.numbers import shown
from ..messages.sentences import worded
from ..translation import tr

if TYPE_CHECKING:
    from ...core.assessment.cells import Cells
    from ...core.database.model import ReferenceDatabase
    from ..reports.assessment_report import AssessedFootprint


class AssessDatabase(AssessAlgorithm):
    ID = "assessdatabase"
    TITLE = "Assess reference database"
    GROUP = LOCALIZATION
    TAGS = ("coverage", "planning", "success", "probability", "footprint", "mission", "map", "look-alikes")
    SUMMARY = (
        "Maps where images can be localized with a reference database, from simulated images with the given "
        "errors. Each square has an expected success and error, numbers of landmarks and similar windows, and "
        "the reason where localization fails.\n\nThe result is too optimistic if the real errors are larger or "
        "the ground has changed. “Evaluate localization” tests with another label map."
    )

    FOOTPRINT = "FOOTPRINT"
    SPACING = "SPACING"
    TRIALS = "TRIALS"
    LOCALIZABLE_FRACTION = "LOCALIZABLE_FRACTION"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            parameters.database(),
            with_help(
                QgsProcessingParameterString(self.FOOTPRINT, "Footprint widths (m)", optional=True),
                "Edge length of the ground that an image shows. Separate the values for several flight heights by "
                "“;”. If not set, the window size of the database.",
            ),
            with_help(
                QgsProcessingParameterNumber(self.SPACING, "Spacing (m)", DOUBLE, optional=True, minValue=0.0),
                "Edge length of the squares. If not set, half the smallest footprint width.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.TRIALS, "Simulated images", INTEGER, 1000, minValue=20, maxValue=100_000
                ),
                "Number of simulated images for each footprint width, spread evenly over the ground. More images "
                "give narrower intervals.",
                advanced=True,
            ),
            *self.noise_parameters(),
            scheduler(),
            with_help(
                QgsProcessingParameterFeatureSink(self.OUTPUT, "Expected success", type=SOURCE_POLYGON),
                "Squares of ground. With several footprint widths there is one square for each; the map shows the "
                "first one.",
            ),
            parameters.report(
                "Page with a map, the success for each footprint width, the landmarks and the assumed errors."
            ),
            QgsProcessingOutputNumber(self.LOCALIZABLE_FRACTION, "Localizable fraction"),
        )

    def check(self, values: Values) -> None:
        from ...core.assessment.squares import footprint_sizes

        footprint_sizes(values.text(self.FOOTPRINT), 1.0)
        super().check(values)
        require_scheduler(values)

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, float]:
        from ...core.assessment.cells import ground_cells
        from ...core.assessment.squares import footprint_sizes
        from ...storage.file_states import state
        from ..reports.assessment_report import AssessedFootprint

        path = values.file(self.DATABASE)
        before = {path: state(path)}
        database, crs = self.read_all(values, feedback)
        footprints = footprint_sizes(values.text(self.FOOTPRINT), database.parameters.window_size)
        spacing = values.optional_number(self.SPACING, min(footprints) / 2)
        cells = cancelable(ground_cells, database, spacing, feedback=feedback)
        if not len(cells):
            raise ParameterError(
                "The database {path} contains neither labels nor landmarks. Build it again.", path=database.source
            )
        localizer = self.localizer(database, feedback)
        count = values.integer(self.TRIALS)
        assessments = [self.assessment(values, database, localizer, edge, feedback) for edge in footprints]
        planned = [assessment.plan(cells.centers, cells.size, count) for assessment in assessments]
        with workers(values, feedback, before) as run:
            tried = self.simulate(assessments, planned, feedback, 5, 100, run)
        results = []
        for assessment, (trials, correlated) in zip(assessments, tried):
            known = cells.centers, trials, correlated, cells.size
            estimates = cancelable(assessment.estimate, *known, feedback=feedback)
            footprint = assessment.footprint
            results.append(AssessedFootprint(footprint, estimates, trials, correlated, assessment.model))
        check_canceled(feedback)
        if values.has(self.REPORT):
            outputs.text(self.REPORT, self._report(values, database, cells, results))
        self._write_cells(values, outputs, database, cells, results, crs)
        threshold = self.threshold(values)
        self._log(results, threshold, feedback)
        return {self.LOCALIZABLE_FRACTION: float((results[0].estimates.success >= threshold).mean())}

    def _report(
        self, values: Values, database: ReferenceDatabase, cells: Cells, results: Sequence[AssessedFootprint]
    ) -> str:
        from ..reports.assessment_report import AssessmentReport

        conditions, threshold = self.conditions(values), self.threshold(values)
        correlation = self.with_correlation(values, database)
        settings = [
            (tr("Spacing (m)"), shown(cells.size, "g")),
            (tr("Simulated images"), str(values.integer(self.TRIALS))),
            *setting_rows(conditions, threshold, correlation, values.integer(self.SEED)),
        ]
        report = AssessmentReport(database, cells, results, conditions, threshold, correlation, settings)
        return report.html(os.path.basename(database.source))

    def _write_cells(
        self,
        values: Values,
        outputs: Outputs,
        database: ReferenceDatabase,
        cells: Cells,
        results: Sequence[AssessedFootprint],
        crs: QgsCoordinateReferenceSystem,
    ) -> None:
        from ...core.assessment.squares import FIELDS, square_rows
        from ..layers.class_styles import cells_renderer

        threshold, half = self.threshold(values), cells.size / 2
        renderer = cells_renderer(threshold, results[0].footprint, len(results) == 1)
        with outputs.layer(self.OUTPUT, FIELDS, POLYGON, crs, "cells", renderer=renderer) as sink:
            for result in results:
                arguments = database.windows, result.footprint, result.estimates, threshold, worded
                for (x, y), row in zip(cells.centers.tolist(), square_rows(cells, *arguments)):
                    square = QgsGeometry.fromRect(QgsRectangle(x - half, y - half, x + half, y + half))
                    sink.add(square, row)

    def _log(self, results: Sequence[AssessedFootprint], threshold: float, feedback: QgsProcessingFeedback) -> None:
        for result in results:
            feedback.pushInfo(
                tr(
                    "Footprint width {footprint:g} m: {share:.1%} of the ground has an expected success of "
                    "{threshold:.0%} or more; the mean is {mean:.1%}."
                ).format(
                    footprint=result.footprint,
                    share=float((result.estimates.success >= threshold).mean()),
                    threshold=threshold,
                    mean=float(result.estimates.success.mean()),
                )
            )
