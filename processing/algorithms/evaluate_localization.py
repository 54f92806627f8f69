"""semref:evaluatelocalization – how well a database localizes, by seeded trials with known truth."""

from __future__ import annotations

import os
import time

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingOutputNumber,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRange,
    QgsProcessingParameterRasterLayer,
)

from ...core.errors import DatabaseError, LabelMapError, ParameterError, SemRefError
from ..compat import POINT, SOURCE_POINT
from ..framework.base import LOCALIZATION, SemRefAlgorithm, cancelable, check_canceled
from ..framework.sinks import Sink
from ..translation import tr
from ..wording.sentences import worded

FIELDS = (
    ("trial", "integer"),
    ("kind", "text"),
    ("method", "text"),
    ("status", "text"),
    ("right", "integer"),
    ("error", "real"),
    ("heading_error", "real"),
    ("scale_error", "real"),
    ("confidence", "real"),
    ("error_95", "real"),
    ("true_x", "real"),
    ("true_y", "real"),
    ("x", "real"),
    ("y", "real"),
    ("window", "text"),
    ("heading", "real"),
    ("scale", "real"),
    ("offset", "real"),
    ("missed", "real"),
    ("invented", "real"),
    ("misnamed", "real"),
    ("ragged", "real"),
    ("landmarks", "integer"),
    ("references", "integer"),
    ("inliers", "integer"),
    ("distance", "real"),
    ("log_odds", "real"),
    ("reason", "text"),
)

GRID_CELLS = 16
MOST_IN_A_CELL = 20
"""A cell of the grid of noise has TRIALS / GRID_CELLS images, but 2 at least and so many at most; so has a step of the
offset."""


class EvaluateLocalization(SemRefAlgorithm):
    ID = "evaluatelocalization"
    BY_VALUES = False
    GROUP = LOCALIZATION
    TAGS = ("accuracy", "trials", "benchmark", "success rate", "false accept", "noise", "report", "table")

    DATABASE = "DATABASE"
    LABELS = "LABELS"
    METHODS = "METHODS"
    TRIALS = "TRIALS"
    MIRRORED = "MIRRORED"
    SCALE = "SCALE"
    ROTATION = "ROTATION"
    OFFSET = "OFFSET"
    MISSED = "MISSED"
    INVENTED = "INVENTED"
    MISNAMED = "MISNAMED"
    RAGGED = "RAGGED"
    MINIMUM_REFERENCES = "MINIMUM_REFERENCES"
    RIGHT_WITHIN = "RIGHT_WITHIN"
    SEED = "SEED"
    OUTPUT = "OUTPUT"
    REPORT = "REPORT"
    JSON = "JSON"
    SUCCESS_RATE = "SUCCESS_RATE"
    MEDIAN_ERROR = "MEDIAN_ERROR"
    FALSE_ACCEPT_RATE = "FALSE_ACCEPT_RATE"

    def title(self):
        return tr("Evaluate localization")

    def summary(self):
        return tr(
            "Tries a reference database: images with known truth are cut from a label map, turned, scaled, moved off "
            "the windows and spoiled, then localized with one method or several.\n\n"
            "The report compares the methods, with the two tables of He & Wu 2025, success against offset and noise, "
            "errors, false accepts and what the confidence is worth. Same seed, same result. Use a label map of "
            "another date than the database’s for an honest answer: on its own map a database always does better."
        )

    def initAlgorithm(self, config=None):
        number = QgsProcessingParameterNumber
        self.offer(
            QgsProcessingParameterFile(self.DATABASE, tr("Reference database"), fileFilter=tr("GeoPackage (*.gpkg)")),
            tr("A GeoPackage made by “Build reference database”."),
        )
        self.offer(
            QgsProcessingParameterRasterLayer(self.LABELS, tr("Label map")),
            tr(
                "The map that images are cut from: the database’s own or another of the same ground, in the database’s "
                "CRS and with its classes; the pixel size may differ."
            ),
        )
        self.offer(
            QgsProcessingParameterEnum(
                self.METHODS, tr("Methods"), self._method_titles(), allowMultiple=True, defaultValue=[0, 1]
            ),
            tr(
                "Tried on the same images, side by side. The outputs’ rates and the grid of noise are those of the "
                "first of automatic, constellation, map correlation, topology vector that is chosen."
            ),
        )
        self.offer(
            number(self.TRIALS, tr("Trials"), number.Integer, 200, minValue=1, maxValue=1_000_000),
            tr(
                "Number of images. The report needs about 1.5 times as many again for noise and offset, and 66 for its "
                "tables."
            ),
        )
        self.offer(
            number(self.MIRRORED, tr("Mirrored images (%)"), number.Double, 25.0, minValue=0.0, maxValue=90.0),
            tr(
                "Part of the trials that show a mirrored piece of the map. They look like the map but can never be "
                "right: a fix of one is a false accept."
            ),
        )
        for key, title, default, text in self._ranges_offered():
            # Optional, because QGIS ignores the default of a range that is not.
            kind = QgsProcessingParameterRange(key, title, number.Double, default, optional=True)
            self.offer(kind, text, advanced=key not in (self.SCALE, self.OFFSET))
        self.offer(
            number(self.MINIMUM_REFERENCES, tr("Landmarks in the window"), number.Integer, 3, minValue=0),
            tr("Trials lie around windows that have at least so many landmarks; 20 leaves open country out."),
        )
        self.offer(
            number(self.RIGHT_WITHIN, tr("Right within (map units)"), number.Double, None, optional=True, minValue=0.0),
            tr(
                "How far off a fix may be to count as right. If left out, 2 % of the edge of the ground that the image "
                "shows. The topology vector is right when it names the nearest window."
            ),
            advanced=True,
        )
        self.offer(
            number(self.SEED, tr("Seed"), number.Integer, 1, minValue=0),
            tr("Another number gives other trials, the same number the same."),
            advanced=True,
        )
        self.offer(
            QgsProcessingParameterFeatureSink(self.OUTPUT, tr("Trials"), SOURCE_POINT),
            tr("A point for each trial and method at the true position, with what was found and how far off it is."),
        )
        file = QgsProcessingParameterFileDestination
        self.offer(
            file(self.REPORT, tr("Report"), tr("HTML files (*.html)"), optional=True),
            tr("Tables and charts in one file to read and print."),
        )
        self.offer(
            file(self.JSON, tr("Numbers"), tr("JSON files (*.json)"), optional=True, createByDefault=False),
            tr("All that the report shows, for scripts."),
        )
        self.addOutput(QgsProcessingOutputNumber(self.SUCCESS_RATE, tr("Success rate")))
        self.addOutput(QgsProcessingOutputNumber(self.MEDIAN_ERROR, tr("Median error")))
        self.addOutput(QgsProcessingOutputNumber(self.FALSE_ACCEPT_RATE, tr("False accept rate")))

    def _method_titles(self):
        """In the order of ``Method``."""
        return [tr("Automatic"), tr("Topology vector"), tr("Constellation"), tr("Map correlation")]

    def _ranges_offered(self):
        """Key, title, default and help of each range that trials draw from."""
        return (
            (self.SCALE, tr("Scale"), "0.8,1.25", tr("Ground that an image shows, as a multiple of the window size.")),
            (
                self.OFFSET,
                tr("Offset"),
                "0,0.5",
                tr(
                    "Distance of an image’s center from the nearest window’s, as a share of the stride: 0 to 0 lies on "
                    "the windows, 0 to 0.5 anywhere."
                ),
            ),
            (self.ROTATION, tr("Rotation (°)"), "0,360", tr("Heading of an image’s top, clockwise from grid north.")),
            (self.MISSED, tr("Landmarks missed (%)"), "20,20", tr("Share of the landmarks that are taken away.")),
            (
                self.INVENTED,
                tr("Landmarks invented (%)"),
                "20,20",
                tr("Share of landmarks that are added, shaped like landmarks of other places of the map."),
            ),
            (self.MISNAMED, tr("Landmarks misnamed (%)"), "5,5", tr("Share of the landmarks that get another class.")),
            (
                self.RAGGED,
                tr("Ragged edges (map units)"),
                "0,1",
                tr("Standard deviation of how far edges are moved, alike over eight pixels."),
            ),
        )

    def checkParameterValues(self, parameters, context):
        possible, reason = super().checkParameterValues(parameters, context)
        if not possible:
            return False, reason
        try:
            self._ranges(parameters, context)
        except SemRefError as error:
            return False, str(error)
        return True, ""

    def _ranges(self, parameters, context):
        """Raises ParameterError for ranges that can't be."""
        from ...core.evaluation.evaluation import TrialRanges

        keys = [key for key, *_ in self._ranges_offered()]
        return TrialRanges(**{key.lower(): tuple(self.parameterAsRange(parameters, key, context)) for key in keys})

    def read_layers(self, parameters, context, feedback):
        from ..exchange.layers import label_map_layer

        self._layer = label_map_layer(self.parameterAsRasterLayer(parameters, self.LABELS, context), self.LABELS)

    def work(self, parameters, context, feedback):
        from ...core.evaluation.summary import summarize

        methods = self._methods(parameters, context)
        evaluation, database, crs = self._evaluation(parameters, context, feedback)
        for method in methods:
            evaluation.localizer.check(method)
        report, numbers = (self.parameterAsFileOutput(parameters, key, context) for key in (self.REPORT, self.JSON))
        count = self.parameterAsInt(parameters, self.TRIALS, context)
        mirrored = min(round(count * self.parameterAsDouble(parameters, self.MIRRORED, context) / 100), count - 1)
        jobs = [(query, list(methods)) for query in evaluation.trials(count - mirrored, mirrored)]
        if report or numbers:
            a_cell = min(max(count // GRID_CELLS, 2), MOST_IN_A_CELL)
            jobs += [(query, list(methods)[:1]) for query in evaluation.noise_grid(a_cell)]
            jobs += [(query, list(methods)) for query in evaluation.moves(a_cell)]
            jobs += [(query, list(methods)) for query in evaluation.tables()]
        trials = self._try(evaluation, jobs, feedback)
        first = summarize(trials, next(iter(methods)))
        # Everything is written last: a cancel before leaves nothing behind.
        check_canceled(feedback)
        results = self._write_texts(parameters, context, trials, methods, report, numbers, database)
        results[self.OUTPUT] = self._write_points(parameters, context, trials, crs)
        results[self.SUCCESS_RATE] = first.right.share
        results[self.MEDIAN_ERROR] = first.median_error
        results[self.FALSE_ACCEPT_RATE] = first.false_accepts.share
        self._say(trials, methods, feedback)
        return results

    def _methods(self, parameters, context):
        """Chosen methods with their titles, the one that the outputs are about first."""
        from ...core.localization import Method

        chosen = self.parameterAsEnums(parameters, self.METHODS, context)
        if not chosen:
            raise ParameterError("METHODS is empty; choose at least one method.")
        titles = self._method_titles()
        # Automatic, constellation, map correlation; the published method is what they are compared with.
        return {Method.of_number(n): titles[n] for n in (0, 2, 3, 1) if n in chosen}

    def _evaluation(self, parameters, context, feedback):
        """(Evaluation, database, its CRS); raises SemRefError when map and database don't belong together."""
        from ...core.evaluation.evaluation import Evaluation
        from ...storage.database.reader import read_database
        from ...storage.rasters import GdalLabels
        from ..exchange.layers import map_frame

        feedback.setProgressText(tr("Reading the database"))
        database = read_database(self.parameterAsFile(parameters, self.DATABASE, context), with_overview=True)
        crs = QgsCoordinateReferenceSystem.fromWkt(database.parameters.crs)
        if not crs.isValid():
            raise DatabaseError(f"{database.source} has no readable parameter crs; build it again.")
        labels = GdalLabels(self._layer.path)
        self._check_map(labels, database, crs)
        evaluation = Evaluation(
            database,
            labels,
            map_frame(labels, self._layer),
            self._ranges(parameters, context),
            self.parameterAsInt(parameters, self.SEED, context),
            self.parameterAsInt(parameters, self.MINIMUM_REFERENCES, context),
            self._right_within(parameters, context),
        )
        return evaluation, database, crs

    def _check_map(self, labels, database, crs):
        """Raises LabelMapError unless the label map has the database's CRS and classes."""
        from ...storage.rasters import named_classes, stored_class_table
        from ..exchange.reference_systems import describe_crs

        if self._layer.crs != crs:
            raise LabelMapError(
                f"{self._layer.path} is in {describe_crs(self._layer.crs)} and the database in {describe_crs(crs)}; "
                "warp the label map to the database’s CRS."
            )
        for found in stored_class_table(labels.dataset, self._layer.path) or named_classes(labels.dataset):
            known = database.class_table.by_value(found.value)
            if known is not None and known.name != found.name:
                raise LabelMapError(
                    f"{self._layer.path} calls the class {found.value} “{found.name}” and the database “{known.name}”; "
                    "rasterize the map with the database’s class table."
                )

    def _try(self, evaluation, jobs, feedback):
        """All trials; raises Canceled within a moment."""
        feedback.pushInfo(tr("{count} images to localize.").format(count=len(jobs)))
        feedback.setProgressText(tr("Localizing"))
        trials, started = [], time.monotonic()
        for n, (query, methods) in enumerate(jobs):
            check_canceled(feedback)
            trials += cancelable(evaluation.run, query, methods, feedback=feedback)
            feedback.setProgress(98 * (n + 1) / len(jobs))
        feedback.pushInfo(tr("{seconds:.0f} s.").format(seconds=time.monotonic() - started))
        return trials

    def _write_texts(self, parameters, context, trials, methods, report, numbers, database):
        """Report and JSON where they are wanted; their paths by key."""
        from ...storage.files import written_beside
        from ..reports.evaluation_json import evaluation_json
        from ..reports.evaluation_report import EvaluationReport

        names = os.path.basename(database.source), os.path.basename(self._layer.path)
        given = self._settings(parameters, context)
        written = {}
        if report:
            titles = {p.name(): p.description() for p in self.parameterDefinitions()}
            settings = [(titles[key], _setting_text(value)) for key, value in given.items()]
            written[self.REPORT] = report, EvaluationReport(*names, trials, methods, settings).html()
        if numbers:
            settings = {self.DATABASE: names[0], self.LABELS: names[1], **given}
            written[self.JSON] = numbers, evaluation_json(trials, list(methods), settings)
        for path, text in written.values():
            with written_beside(path) as temporary, open(temporary, "w", encoding="utf-8") as file:
                file.write(text)
        return {key: path for key, (path, _) in written.items()}

    def _settings(self, parameters, context):
        """Values by key as they were used."""
        ranges = vars(self._ranges(parameters, context))
        return {
            self.TRIALS: self.parameterAsInt(parameters, self.TRIALS, context),
            self.MIRRORED: self.parameterAsDouble(parameters, self.MIRRORED, context),
            **{name.upper(): list(limits) for name, limits in ranges.items()},
            self.MINIMUM_REFERENCES: self.parameterAsInt(parameters, self.MINIMUM_REFERENCES, context),
            self.RIGHT_WITHIN: self._right_within(parameters, context),
            self.SEED: self.parameterAsInt(parameters, self.SEED, context),
        }

    def _right_within(self, parameters, context):
        """Map units; None when it was left out."""
        if parameters.get(self.RIGHT_WITHIN) in (None, ""):
            return None
        return self.parameterAsDouble(parameters, self.RIGHT_WITHIN, context)

    def _write_points(self, parameters, context, trials, crs):
        from ...core.evaluation.evaluation import MAP, MIRRORED
        from ..reports.evaluation_json import values_of

        sink = Sink(self, parameters, self.OUTPUT, context, FIELDS, POINT, crs)
        for trial in trials:
            if trial.query.kind in (MAP, MIRRORED):
                sink.add(QgsGeometry.fromPointXY(QgsPointXY(*trial.query.view.position)), values_of(trial, worded))
        return sink.close()

    def _say(self, trials, methods, feedback):
        from ...core.evaluation.summary import summarize
        from ..reports.page import number, rate_text

        for method, title in methods.items():
            summary = summarize(trials, method)
            feedback.pushInfo(
                tr("{method}: right {right}, wrong {wrong}, false accepts {accepts}, median error {error}").format(
                    method=title,
                    right=rate_text(summary.right),
                    wrong=rate_text(summary.wrong),
                    accepts=rate_text(summary.false_accepts),
                    error=number(summary.median_error, "m"),
                )
            )


def _setting_text(value) -> str:
    """As the report shows it: ranges as “0.8–1.25”, what was left out as “2 % of the ground’s edge”."""
    if isinstance(value, list):
        return "–".join(f"{limit:g}" for limit in value)
    return tr("2 % of the ground’s edge") if value is None else f"{value:g}"
