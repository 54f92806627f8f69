"""semref:assessdatabase – a map of where a reference database will localize, and where it won't."""

from __future__ import annotations

import os

import numpy as np
from qgis.core import (
    QgsGeometry,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
    QgsRectangle,
)

from ...core.errors import ParameterError, SemRefError
from ..compat import POLYGON, SOURCE_POLYGON
from ..framework.assessing import AssessAlgorithm, footprint_sizes, reason_text, setting_rows
from ..framework.base import LOCALIZATION, cancelable, check_canceled
from ..framework.sinks import Sink
from ..translation import tr

FIELDS = (
    ("footprint", "real"),
    ("success", "real"),
    ("success_low", "real"),
    ("success_high", "real"),
    ("error", "real"),
    ("objects", "real"),
    ("classes", "integer"),
    ("distinctiveness", "real"),
    ("look_alikes", "real"),
    ("wrong", "real"),
    ("trials", "integer"),
    ("verdict", "text"),
    ("reason", "text"),
)

VERDICTS = ("hardly_ever", "sometimes", "often", "reliably", "very_reliably")


class AssessDatabase(AssessAlgorithm):
    ID = "assessdatabase"
    BY_VALUES = False
    GROUP = LOCALIZATION
    TAGS = ("coverage", "planning", "success", "probability", "footprint", "mission", "map", "look-alikes")

    FOOTPRINT = "FOOTPRINT"
    SPACING = "SPACING"
    TRIALS = "TRIALS"
    OUTPUT = "OUTPUT"
    REPORT = "REPORT"
    LOCALIZABLE_FRACTION = "LOCALIZABLE_FRACTION"

    def title(self):
        return tr("Assess reference database")

    def summary(self):
        return tr(
            "Shows where images will be localized with a reference database, and where not: expected success and error "
            "of each square of ground under the noise that you state, number of landmarks, look-alikes, and the "
            "reason where it fails.\n\n"
            "Images of the database’s own landmarks are simulated, spoiled and localized by the localizer itself; a "
            "regression carries what they teach to squares with few trials. Nothing but the database is needed. It "
            "is an expectation: noise that you understate, and changes on the ground, make it too good. “Evaluate "
            "localization” tests a database with a label map of another date."
        )

    def initAlgorithm(self, config=None):
        number = QgsProcessingParameterNumber
        self.offer_database()
        self.offer(
            QgsProcessingParameterString(self.FOOTPRINT, tr("Footprints (map units)"), optional=True),
            tr(
                "Edge of the ground that an image shows; several separated by “;” for several heights. The window "
                "size if left out."
            ),
        )
        self.offer(
            number(self.SPACING, tr("Spacing (map units)"), number.Double, None, optional=True, minValue=0.0),
            tr("Edge of the squares; half the smallest footprint if left out."),
        )
        self.offer(
            number(self.TRIALS, tr("Simulated images"), number.Integer, 1000, minValue=20, maxValue=100_000),
            tr("For each footprint, spread evenly over the ground. More make the intervals narrower."),
        )
        self.offer_noise()
        self.offer(
            QgsProcessingParameterFeatureSink(self.OUTPUT, tr("Expected success"), SOURCE_POLYGON),
            tr("Squares of ground; of several footprints one square each, of which the first footprint’s are drawn."),
        )
        self.offer(
            QgsProcessingParameterFileDestination(self.REPORT, tr("Report"), tr("HTML files (*.html)"), optional=True),
            tr("Map, success by footprint, landmarks and what was assumed, in one file to read and print."),
        )
        self.addOutput(QgsProcessingOutputNumber(self.LOCALIZABLE_FRACTION, tr("Localizable fraction")))

    def checkParameterValues(self, parameters, context):
        possible, reason = super().checkParameterValues(parameters, context)
        if not possible:
            return False, reason
        try:
            footprint_sizes(self.parameterAsString(parameters, self.FOOTPRINT, context), 1.0)
            self.noise(parameters, context)
        except SemRefError as error:
            return False, str(error)
        return True, ""

    def work(self, parameters, context, feedback):
        from ...core.assessment.cells import ground_cells
        from ...core.localizer.localizer import Localizer

        database, crs = self.read_all(parameters, context, feedback)
        text = self.parameterAsString(parameters, self.FOOTPRINT, context)
        footprints = footprint_sizes(text, database.parameters.window_size)
        cells = cancelable(ground_cells, database, self._spacing(parameters, context, footprints), feedback=feedback)
        if not len(cells):
            raise ParameterError(f"{database.source} has neither labels nor landmarks; build it again.")
        localizer = Localizer(database)
        self.index(localizer, feedback)
        results = []
        for n, footprint in enumerate(footprints):
            share = [5 + 90 * (n + done) / len(footprints) for done in (0, 1)]
            results.append(self._assessed(parameters, context, database, localizer, footprint, cells, feedback, share))
        check_canceled(feedback)
        threshold = self.threshold(parameters, context)
        report = self._write_report(parameters, context, database, cells, results)
        destination = self._write_cells(parameters, context, database, cells, results, crs)
        self._say(results, threshold, feedback)
        fraction = float((results[0].estimates.success >= threshold).mean())
        return {self.OUTPUT: destination, **report, self.LOCALIZABLE_FRACTION: fraction}

    def _spacing(self, parameters, context, footprints) -> float:
        if parameters.get(self.SPACING) in (None, ""):
            return min(footprints) / 2
        return self.parameterAsDouble(parameters, self.SPACING, context)

    def _assessed(self, parameters, context, database, localizer, footprint, cells, feedback, share):
        from ..reports.assessment_report import AssessedFootprint

        assessment = self.assessment(parameters, context, database, localizer, footprint, feedback)
        count = self.parameterAsInt(parameters, self.TRIALS, context)
        queries = assessment.plan(cells.centers, cells.size, count)
        trials, correlated = self.simulate(assessment, queries, feedback, *share)
        estimates = cancelable(assessment.estimate, cells.centers, trials, correlated, cells.size, feedback=feedback)
        return AssessedFootprint(footprint, estimates, trials, correlated, assessment.model)

    def _write_report(self, parameters, context, database, cells, results):
        from ...storage.files import written_beside
        from ..reports.assessment_report import AssessmentReport

        path = self.parameterAsFileOutput(parameters, self.REPORT, context)
        if not path:
            return {}
        noise, threshold = self.noise(parameters, context), self.threshold(parameters, context)
        correlation = self.parameterAsBool(parameters, self.MAP_CORRELATION, context)
        seed = self.parameterAsInt(parameters, self.SEED, context)
        settings = [
            (tr("Spacing (map units)"), f"{cells.size:g}"),
            (tr("Simulated images"), str(self.parameterAsInt(parameters, self.TRIALS, context))),
            *setting_rows(noise, threshold, correlation, seed),
        ]
        report = AssessmentReport(database, cells, results, noise, threshold, correlation, settings)
        with written_beside(path) as temporary, open(temporary, "w", encoding="utf-8") as file:
            file.write(report.html(os.path.basename(database.source)))
        return {self.REPORT: path}

    def _write_cells(self, parameters, context, database, cells, results, crs):
        from ..exchange.assessment_styles import cell_renderer
        from ..exchange.output_style import style_output

        sink = Sink(self, parameters, self.OUTPUT, context, FIELDS, POLYGON, crs)
        threshold, half = self.threshold(parameters, context), cells.size / 2
        for result in results:
            unlike = _nearest_distinctiveness(database.windows, cells.centers, result.footprint)
            for n, (x, y) in enumerate(cells.centers.tolist()):
                square = QgsGeometry.fromRect(QgsRectangle(x - half, y - half, x + half, y + half))
                sink.add(square, _values(result, n, unlike[n], threshold))
        destination = sink.close()
        style_output(destination, cell_renderer(threshold, results[0].footprint, len(results) == 1), context)
        return destination

    def _say(self, results, threshold, feedback):
        for result in results:
            feedback.pushInfo(
                tr(
                    "Footprint {footprint:g}: {share:.1%} of the ground with an expected success of {threshold:.0%} or "
                    "more; on average {mean:.1%}."
                ).format(
                    footprint=result.footprint,
                    share=float((result.estimates.success >= threshold).mean()),
                    threshold=threshold,
                    mean=float(result.estimates.success.mean()),
                )
            )


def _values(result, n: int, distinctiveness: float, threshold: float) -> dict:
    from ..exchange.assessment_styles import success_classes

    estimates = result.estimates
    success = float(estimates.success[n])
    verdict = sum(success >= low for low, *_ in success_classes(threshold)[1:])
    error = float(estimates.error[n])
    return {
        "footprint": result.footprint,
        "success": success,
        "success_low": float(estimates.low[n]),
        "success_high": float(estimates.high[n]),
        "error": error if np.isfinite(error) else None,
        "objects": float(estimates.landmarks[n]),
        "classes": int(estimates.classes[n]),
        "distinctiveness": distinctiveness if np.isfinite(distinctiveness) else None,
        "look_alikes": float(estimates.look_alikes[n]),
        "wrong": float(estimates.wrong[n]),
        "trials": int(estimates.trials[n]),
        "verdict": VERDICTS[verdict],
        "reason": "" if success >= threshold else reason_text(estimates.reasons[n], float(estimates.landmarks[n])),
    }


def _nearest_distinctiveness(windows, places, footprint: float) -> list:
    """Of the window nearest to each place, of the level whose size is nearest to the footprint; NaN where unknown."""
    from ...core.constellation.neighbors import nearest

    sizes = np.unique(windows.sizes)
    if not len(sizes):
        return [np.nan] * len(places)
    chosen = np.flatnonzero(windows.sizes == sizes[np.abs(np.log(sizes / footprint)).argmin()])
    middle = windows.centers[chosen].mean(axis=0)
    points, queries = ((xy - middle).astype(np.float32) for xy in (windows.centers[chosen], places))
    number, squared = nearest(points, queries, 1)
    found = windows.distinctiveness[chosen[number[:, 0]]]
    # A window that doesn't hold the place says nothing about it.
    return np.where(squared[:, 0] <= (footprint / 2) ** 2, found, np.nan).tolist()
