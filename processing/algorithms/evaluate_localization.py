"""semref:evaluatelocalization: measure how well a database localizes, by seeded trials with ground truth."""

from __future__ import annotations

import os
import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRange,
)

from ...core.errors import LabelMapError, ParameterError
from ...core.localization import Method
from ..base import parameters
from ..base.algorithm import LOCALIZATION, Declared, SemRefAlgorithm, cancelable, check_canceled
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.scheduler import require_scheduler, scheduler, with_progress, workers
from ..base.values import Values
from ..compat import DOUBLE, INTEGER, POINT, SOURCE_POINT
from ..jobs.assessing import noise_ranges
from ..messages.sentences import worded
from ..translation import tr

if TYPE_CHECKING:
    from ...core.database.model import ReferenceDatabase
    from ...core.evaluation.evaluation import Evaluation, TrialRanges
    from ...core.evaluation.trial import Trial
    from ...storage.label_maps import GdalLabels

RANGES: dict[str, tuple[float, float]] = {
    "SCALE": (0.8, 1.25),
    "ROTATION": (0.0, 360.0),
    "OFFSET": (0.0, 0.5),
    parameters.MISSED: (20.0, 20.0),
    parameters.INVENTED: (20.0, 20.0),
    parameters.MISNAMED: (5.0, 5.0),
    parameters.RAGGED: (0.0, 1.0),
    parameters.BACKGROUND: (5.0, 5.0),
    parameters.DISPLACED: (1.1, 1.1),
    parameters.SHIFTED: (0.5, 0.5),
    parameters.LEANING: (0.0, 1.0),
    parameters.LENS: (0.0, 1.0),
    parameters.TILT: (0.0, 3.0),
}
"""Default ranges by key."""

ORDER = (Method.AUTOMATIC, Method.CONSTELLATION, Method.MAP_CORRELATION, Method.TOPOLOGY_VECTOR)
"""The first of the selected methods is the one of the noise table and the outputs."""

_TRIALS_A_TASK = 4
"""Trials of some hundred milliseconds each."""


class EvaluateLocalization(SemRefAlgorithm):
    ID = "evaluatelocalization"
    TITLE = "Evaluate localization"
    GROUP = LOCALIZATION
    TAGS = ("accuracy", "trials", "benchmark", "success rate", "false accept", "noise", "report", "table")
    SUMMARY = (
        "Tests a reference database with images of known position. They are cut from a label map, rotated, "
        "scaled, given label errors, and localized with one or more methods. The report compares the "
        "methods.\n\nUse a label map of another date than that of the database, with a map displacement of 0. The "
        "map of the database itself is too optimistic."
    )

    SEED = parameters.SEED
    METHODS = "METHODS"
    TRIALS = "TRIALS"
    MIRRORED = "MIRRORED"
    SCALE = "SCALE"
    ROTATION = "ROTATION"
    OFFSET = "OFFSET"
    MINIMUM_REFERENCES = "MINIMUM_REFERENCES"
    RIGHT_WITHIN = "RIGHT_WITHIN"
    JSON = "JSON"
    SUCCESS_RATE = "SUCCESS_RATE"
    MEDIAN_ERROR = "MEDIAN_ERROR"
    FALSE_ACCEPT_RATE = "FALSE_ACCEPT_RATE"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            parameters.database(),
            parameters.label_map(
                "Label map that images are cut from: the map of the database, or another map of the same ground. "
                "It needs the CRS and the classes of the database; the pixel size may differ."
            ),
            with_help(
                QgsProcessingParameterEnum(
                    self.METHODS,
                    "Methods",
                    options=[worded(method.title) for method in Method],
                    allowMultiple=True,
                    defaultValue=[0, 1],
                ),
                "Methods to compare on the same images. The output numbers and the noise table use the first "
                "selected method in the order Automatic, Constellation, Map correlation, Published method.",
            ),
            with_help(
                QgsProcessingParameterNumber(self.TRIALS, "Trials", INTEGER, 200, minValue=1, maxValue=1_000_000),
                "Number of images. The report needs about 1.5 times as many additional images for noise and "
                "offset, and 66 for its tables.",
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.MIRRORED, "Mirrored images (%)", DOUBLE, 25.0, minValue=0.0, maxValue=90.0
                ),
                "Share of trials that show a mirrored part of the map. Such an image has no correct position, so "
                "each computed position is false.",
            ),
            *self._range_parameters(),
            with_help(
                QgsProcessingParameterNumber(
                    self.MINIMUM_REFERENCES, "Minimum landmarks in the window", INTEGER, 3, minValue=0
                ),
                "Trials are placed around windows with at least this number of landmarks. 20 excludes open country.",
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.RIGHT_WITHIN, "Right within (m)", DOUBLE, optional=True, minValue=0.0
                ),
                "Largest error of a position that counts as right. If not set, 2 % of the footprint width. A "
                "position of “Published method” is right if it names the nearest window.",
                advanced=True,
            ),
            parameters.seed(),
            parameters.network(),
            parameters.comparison(),
            scheduler(),
            with_help(
                QgsProcessingParameterFeatureSink(self.OUTPUT, "Trials", type=SOURCE_POINT),
                "One point for each trial and method at the true position, with the computed position and its error.",
            ),
            parameters.report("Page with tables and charts."),
            with_help(
                QgsProcessingParameterFileDestination(
                    self.JSON, "Numbers", fileFilter=tr("JSON files (*.json)"), optional=True, createByDefault=False
                ),
                "All numbers of the report, for scripts.",
            ),
            QgsProcessingOutputNumber(self.SUCCESS_RATE, "Success rate"),
            QgsProcessingOutputNumber(self.MEDIAN_ERROR, "Median error"),
            QgsProcessingOutputNumber(self.FALSE_ACCEPT_RATE, "False positions"),
        )

    def _range_parameters(self) -> list[Declared]:
        defaults = {key: f"{low:g},{high:g}" for key, (low, high) in RANGES.items()}
        ranges = (
            (self.SCALE, tr("Scale"), tr("Footprint width of an image, as a multiple of the window size.")),
            (
                self.OFFSET,
                tr("Offset"),
                tr(
                    "Distance from the center of an image to the center of the nearest window, as a share of the "
                    "stride. 0 to 0 means on the windows, 0 to 0.5 anywhere."
                ),
            ),
            (self.ROTATION, tr("Rotation (°)"), tr("Heading of the top of an image, clockwise from grid north.")),
            *parameters.noises(),
            *parameters.shared_errors(),
        )
        # Optional, because QGIS ignores the default of a mandatory range.
        return [
            with_help(
                QgsProcessingParameterRange(key, title, type=DOUBLE, defaultValue=defaults[key], optional=True),
                text,
                advanced=key not in (self.SCALE, self.OFFSET),
            )
            for key, title, text in ranges
        ]

    def check(self, values: Values) -> None:
        self._ranges(values)
        require_scheduler(values)

    def _ranges(self, values: Values) -> TrialRanges:
        """Return the ranges. Raises ParameterError for impossible ranges."""
        from ...core.evaluation.evaluation import TrialRanges

        ranges = noise_ranges(values, RANGES, values.range)
        return TrialRanges(**{key.lower(): found for key, found in ranges.items()})

    def read_layers(self, values: Values) -> None:
        self._layer = values.label_map(self.LABELS)

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, float | None]:
        from ...cluster.task_names import EVALUATE
        from ...core.evaluation.summary import summarize
        from ...storage.file_states import state
        from ..reports.evaluation_report import tried_ground

        methods, files = self._methods(values), (values.file(self.DATABASE), self._layer.path)
        before = {path: state(path) for path in files}
        evaluation, database, crs = self._evaluation(values, feedback)
        for method in methods:
            evaluation.localizer.check(method)
        is_reported = values.has(self.REPORT) or values.has(self.JSON)
        mirrored = values.number(self.MIRRORED) / 100
        # Reports need additional trials.
        jobs = evaluation.plan(list(methods), values.integer(self.TRIALS), mirrored, is_reported)
        feedback.pushInfo(tr("{count} images to localize.").format(count=len(jobs)))
        feedback.pushInfo(tried_ground(evaluation.tried_windows, values.integer(self.MINIMUM_REFERENCES)))
        feedback.setProgressText(tr("Localizing"))
        started = time.monotonic()
        with workers(values, feedback, before) as run:
            if run is None:
                tried = (cancelable(evaluation.run, *job, feedback=feedback) for job in jobs)
            else:
                tried = run.answers(EVALUATE, self._job, jobs, database, _TRIALS_A_TASK)
            trials = [trial for of_image in with_progress(tried, len(jobs), feedback, 0, 98) for trial in of_image]
        feedback.pushInfo(tr("{seconds:.0f} s.").format(seconds=time.monotonic() - started))
        # Everything is written last, so that a cancel leaves nothing behind.
        check_canceled(feedback)
        self._write_texts(values, outputs, trials, methods, evaluation)
        self._write_points(outputs, trials, crs)
        self._log(trials, methods, feedback)
        first = summarize(trials, next(iter(methods)))
        return {
            self.SUCCESS_RATE: first.right.share,
            self.MEDIAN_ERROR: first.median_error,
            self.FALSE_ACCEPT_RATE: first.false_accepts.share,
        }

    def _methods(self, values: Values) -> dict[Method, str]:
        """Return the selected methods with their titles, the one of the outputs first."""
        chosen = values.choices(self.METHODS)
        if not chosen:
            raise ParameterError("“Methods” is empty. Select at least one method.")
        # The others are compared with the published method.
        return {method: worded(method.title) for method in ORDER if method.number in chosen}

    def _evaluation(
        self, values: Values, feedback: QgsProcessingFeedback
    ) -> tuple[Evaluation, ReferenceDatabase, QgsCoordinateReferenceSystem]:
        """Return (Evaluation, database, its CRS). Raises SemRefError if map and database do not belong together."""
        from ...core.evaluation.evaluation import Evaluation
        from ...storage.database.reader import read_database
        from ...storage.label_maps import GdalLabels
        from ..layers.layer_inputs import map_frame
        from ..layers.reference_systems import database_crs

        feedback.setProgressText(tr("Reading the database"))
        database = read_database(values.file(self.DATABASE), with_overview=True)
        crs = database_crs(database)
        labels = GdalLabels(self._layer.path)
        self._check_map(labels, database, crs)
        settings = (
            map_frame(labels, self._layer),
            self._ranges(values),
            values.integer(self.SEED),
            values.integer(self.MINIMUM_REFERENCES),
            values.optional_number(self.RIGHT_WITHIN),
        )
        self._job = database.source, self._layer.path, settings
        return Evaluation(database, labels, *settings), database, crs

    def _check_map(self, labels: GdalLabels, database: ReferenceDatabase, crs: QgsCoordinateReferenceSystem) -> None:
        """Raises LabelMapError unless the label map has the CRS and the classes of the database."""
        from ...storage.label_maps import require_classes_of
        from ..layers.reference_systems import describe_crs

        if self._layer.crs != crs:
            raise LabelMapError(
                "The CRS of {path} ({crs}) differs from the CRS of the database ({database_crs}). Warp the label map "
                "to the CRS of the database.",
                path=self._layer.path,
                crs=describe_crs(self._layer.crs),
                database_crs=describe_crs(crs),
            )
        require_classes_of(labels, database.class_table, self._layer.path)

    def _write_texts(
        self,
        values: Values,
        outputs: Outputs,
        trials: Sequence[Trial],
        methods: dict[Method, str],
        evaluation: Evaluation,
    ) -> None:
        from ...core.evaluation.as_json import evaluation_json
        from ..reports.evaluation_report import EvaluationReport, tried_ground

        names = tuple(map(os.path.basename, self._job[:2]))
        given = self._settings(values)
        if values.has(self.REPORT):
            titles = {p.name(): p.description() for p in self.parameterDefinitions()}
            settings = [(titles[key], _setting_text(value)) for key, value in given.items()]
            ground = tried_ground(evaluation.tried_windows, values.integer(self.MINIMUM_REFERENCES))
            outputs.text(self.REPORT, EvaluationReport(*names, trials, methods, settings, ground).html())
        if values.has(self.JSON):
            settings = {self.DATABASE: names[0], self.LABELS: names[1], **given}
            outputs.text(self.JSON, evaluation_json(trials, list(methods), settings, evaluation.tried_windows))

    def _settings(self, values: Values) -> dict[str, Any]:
        return {
            self.TRIALS: values.integer(self.TRIALS),
            self.MIRRORED: values.number(self.MIRRORED),
            **{name.upper(): list(limits) for name, limits in vars(self._ranges(values)).items()},
            self.MINIMUM_REFERENCES: values.integer(self.MINIMUM_REFERENCES),
            self.RIGHT_WITHIN: values.optional_number(self.RIGHT_WITHIN),
            self.SEED: values.integer(self.SEED),
        }

    def _write_points(self, outputs: Outputs, trials: Sequence[Trial], crs: QgsCoordinateReferenceSystem) -> None:
        from ...core.evaluation.as_json import FIELDS, values_of
        from ...core.evaluation.evaluation import MAP, MIRRORED

        with outputs.layer(self.OUTPUT, FIELDS, POINT, crs, "trials") as sink:
            for trial in trials:
                if trial.query.kind in (MAP, MIRRORED):
                    sink.add(QgsGeometry.fromPointXY(QgsPointXY(*trial.query.view.position)), values_of(trial, worded))

    def _log(self, trials: Sequence[Trial], methods: dict[Method, str], feedback: QgsProcessingFeedback) -> None:
        from ...core.evaluation.summary import summarize
        from ..reports.page import number, rate_text

        for method, title in methods.items():
            summary = summarize(trials, method)
            feedback.pushInfo(
                tr("{method}: right {right}, wrong {wrong}, false positions {accepts}, median error {error}").format(
                    method=title,
                    right=rate_text(summary.right),
                    wrong=rate_text(summary.wrong),
                    accepts=rate_text(summary.false_accepts),
                    error=number(summary.median_error, "m"),
                )
            )


def _setting_text(value: Any) -> str:
    """Return a setting as the report shows it: ranges as “0.8–1.25”, None as “2 % of the footprint width”."""
    if isinstance(value, list):
        return "–".join(f"{limit:g}" for limit in value)
    return tr("2 % of the footprint width") if value is None else f"{value:g}"
