"""Base of the assessments of a database and of a route: label errors, reading, and simulated trials."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from typing import TYPE_CHECKING, Callable

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingFeedback,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterNumber,
)

from ...core.localization import Method
from ..base import parameters
from ..base.algorithm import SemRefAlgorithm, cancelable, check_canceled
from ..base.parameters import with_help
from ..base.scheduler import Workers, with_progress
from ..base.values import Values
from ..compat import DOUBLE
from ..messages.numbers import shown
from ..messages.sentences import worded
from ..reports.network_noise import read_network
from ..translation import tr
from .localizing import with_overview

if TYPE_CHECKING:
    from ...core.assessment.assessment import Assessment, PlaceQuery
    from ...core.database.model import ReferenceDatabase
    from ...core.evaluation.trial import Trial
    from ...core.localizer.localizer import Localizer
    from ...core.simulation.conditions import Conditions

_SIMULATED_A_TASK = 25
"""Trials of some milliseconds each."""

USUAL: dict[str, tuple[float, float | None]] = {
    parameters.MISSED: (20.0, 100.0),
    parameters.INVENTED: (20.0, 100.0),
    parameters.MISNAMED: (5.0, 100.0),
    parameters.RAGGED: (1.0, None),
    parameters.BACKGROUND: (5.0, 100.0),
    parameters.DISPLACED: (1.1, None),
    parameters.SHIFTED: (0.5, None),
    parameters.LEANING: (0.5, 100.0),
    parameters.LENS: (0.5, 10.0),
    parameters.TILT: (2.0, 30.0),
}
"""(default, largest value) of each error by key, in percent, m or degrees."""


NETWORK_FACTORS = (None, 0.5, 1.0, 2.0)
"""Factor of the label errors by option of NETWORK; None uses the values of the parameters."""

OF_NETWORKS = ("MISSED", "INVENTED", "MISNAMED", "RAGGED", "BACKGROUND", "SHIFTED")
"""Errors of the network; the others are errors of the map and the camera."""


def noise_ranges(
    values: Values, usual: Mapping[str, tuple[float, float]], read: Callable[[str], tuple[float, float]]
) -> dict[str, tuple[float, float]]:
    """Return the label errors: of a comparison report, otherwise of the label quality, otherwise of the parameters.

    Args:
        values: Values with NETWORK and COMPARISON.
        usual: (lowest, highest) of a usable network, by key.

    Raises:
        ParameterError: The report or a value cannot be used.
    """
    factor, path = NETWORK_FACTORS[values.choice(parameters.NETWORK)], values.file(parameters.COMPARISON)
    compared = read_network(path) if path else {}

    def range_of(key: str) -> tuple[float, float]:
        if key in compared and key in OF_NETWORKS:
            return compared[key], compared[key]
        if factor is not None and key in OF_NETWORKS:
            return factor * usual[key][0], factor * usual[key][1]
        return read(key)

    return {key: range_of(key) for key in usual}


def _noise(key: str, title: str, text: str) -> QgsProcessingParameterDefinition:
    usual, most = USUAL[key]
    parameter = QgsProcessingParameterNumber(key, title, DOUBLE, usual, minValue=0.0)
    if most is not None:
        parameter.setMaximum(most)
    return with_help(parameter, text, advanced=True)


class AssessAlgorithm(SemRefAlgorithm):
    """Base of algorithms that simulate images of a database."""

    SEED = parameters.SEED
    MAP_CORRELATION = "MAP_CORRELATION"
    THRESHOLD = "THRESHOLD"

    def noise_parameters(self) -> tuple[QgsProcessingParameterDefinition, ...]:
        """Return the threshold, the method and the label errors."""
        return (
            with_help(
                QgsProcessingParameterNumber(
                    self.THRESHOLD, "Success threshold (%)", DOUBLE, 90.0, minValue=1.0, maxValue=99.9
                ),
                "Expected success from which a place counts as localizable, for example 90.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterBoolean(self.MAP_CORRELATION, "With map correlation", defaultValue=True),
                "Assess the method “Automatic”: where the landmarks give no position, map correlation is tested "
                "on images of the overview. This takes about 1 s per image on a large map, so at most an eighth "
                "of the images are tested. If off, only the constellation of landmarks is assessed.",
                advanced=True,
            ),
            *(_noise(*what) for what in parameters.noises()),
            parameters.seed(),
            *(_noise(*what) for what in parameters.shared_errors()),
            parameters.network(),
            parameters.comparison(),
        )

    def check(self, values: Values) -> None:
        self.conditions(values)

    def conditions(self, values: Values) -> Conditions:
        """Return the assumed errors of labels and cameras, in map units. Raises ParameterError."""
        from ...core.simulation.conditions import conditions_of

        usual = {key: (number, number) for key, (number, _) in USUAL.items()}
        ranges = noise_ranges(values, usual, lambda key: (values.number(key),) * 2)
        return conditions_of({key.lower(): number for key, (number, _) in ranges.items()})

    def with_correlation(self, values: Values, database: ReferenceDatabase) -> bool:
        """Return whether map correlation is assessed: it is selected and the database has an overview."""
        return values.switch(self.MAP_CORRELATION) and database.overview is not None

    def threshold(self, values: Values) -> float:
        """Return the success threshold, 0…1."""
        return values.number(self.THRESHOLD) / 100

    def read_all(
        self, values: Values, feedback: QgsProcessingFeedback
    ) -> tuple[ReferenceDatabase, QgsCoordinateReferenceSystem]:
        """Return (database with bounds and, if there is one, its overview; its CRS)."""
        from ...storage.database.reader import read_database
        from ..layers.reference_systems import database_crs

        feedback.setProgressText(tr("Reading the database"))
        path = values.file(self.DATABASE)
        database = cancelable(read_database, path, False, True, feedback=feedback)
        crs = database_crs(database)
        warning = tr(
            "The database has no overview. Only the constellation is assessed, and the extent is used as the border "
            "of the ground."
        )
        return with_overview(database, path, warning, feedback), crs

    def assessment(
        self,
        values: Values,
        database: ReferenceDatabase,
        localizer: Localizer,
        footprint: float,
        feedback: QgsProcessingFeedback,
    ) -> Assessment:
        """Return the assessment of a footprint width; warn if images of this size are not searched."""
        from ...core.assessment.assessment import Assessment

        correlation = self.with_correlation(values, database)
        arguments = database, localizer, footprint, self.conditions(values), values.integer(self.SEED), correlation
        made = cancelable(Assessment, *arguments, feedback=feedback)
        if not made.simulator.is_searched or correlation and not made.simulator.is_correlated:
            feedback.pushWarning(
                tr(
                    "Images with a footprint width of {footprint:g} m are not searched without a known pixel size: it "
                    "differs too much from the window size ({window:g} m)."
                ).format(footprint=footprint, window=database.parameters.window_size)
            )
        return made

    def localizer(self, database: ReferenceDatabase, feedback: QgsProcessingFeedback) -> Localizer:
        """Return a localizer of the database with its index built."""
        from ...core.localizer.localizer import Localizer

        localizer = Localizer(database)
        feedback.setProgressText(tr("Preparing the landmarks"))
        cancelable(lambda: localizer.index, feedback=feedback)
        return localizer

    def simulate(
        self,
        assessments: Sequence[Assessment],
        planned: Sequence[Sequence[PlaceQuery]],
        feedback: QgsProcessingFeedback,
        first: float,
        last: float,
        run: Workers | None = None,
    ) -> list[tuple[list[Trial], dict[int, Trial]]]:
        """Simulate and localize the planned images of each assessment.

        Args:
            assessments: Assessments of one database that differ in their footprints only.
            run: Workers; None to compute in this process.

        Returns:
            (trials, trials of map correlation by their numbers in the queries) of each assessment.
        """
        from ...cluster.task_names import ASSESS, CORRELATE
        from ...core.assessment.assessment import CORRELATED_SHARE, to_correlate

        def answers(task: str, here: Callable[..., Trial], asked: list[tuple[int, PlaceQuery]], size: int) -> Iterator:
            if run is None:
                return (here(assessments[n], query) for n, query in asked)
            one, pieces = assessments[0], [(assessments[n].footprint, query) for n, query in asked]
            settings = one.conditions, one.seed, one.correlation
            job = one.database.source, one.database.overview is not None, settings
            return run.answers(task, job, pieces, one.database, size)

        def simulate_one(assessment: Assessment, query: PlaceQuery) -> Trial:
            # A trial takes milliseconds, so a thread for each would cost more time than it saves.
            check_canceled(feedback)
            return assessment.run(query)

        def correlate_one(assessment: Assessment, query: PlaceQuery) -> Trial:
            return cancelable(assessment.run_correlation, query, feedback=feedback)

        feedback.setProgressText(tr("Localizing simulated images"))
        started, seed, with_correlation = time.monotonic(), assessments[0].seed, assessments[0].correlation
        middle = first + (last - first) * (0.3 if with_correlation else 1.0)
        asked = [(n, query) for n, queries in enumerate(planned) for query in queries]
        found = answers(ASSESS, simulate_one, asked, _SIMULATED_A_TASK)
        trials = iter(list(with_progress(found, len(asked), feedback, first, middle)))
        tried: list[tuple[list[Trial], dict[int, Trial]]] = [(list(islice(trials, len(one))), {}) for one in planned]
        chosen = [
            (n, number)
            for n, (some, _) in enumerate(tried if with_correlation else ())
            for number in to_correlate(seed, some, max(len(some) // CORRELATED_SHARE, 1))
        ]
        if chosen:
            again = answers(CORRELATE, correlate_one, [(n, planned[n][number]) for n, number in chosen], 1)
            for (n, number), trial in zip(chosen, with_progress(again, len(chosen), feedback, middle, last)):
                tried[n][1][number] = trial
        text = tr("{count} simulated images in {seconds:.0f} s.")
        feedback.pushInfo(text.format(count=len(asked) + len(chosen), seconds=time.monotonic() - started))
        return tried


def setting_rows(conditions: Conditions, threshold: float, correlation: bool, seed: int) -> list[tuple[str, str]]:
    """Return the settings in both reports: (title, value)."""
    noise = conditions.noise
    of_labels = 100 * noise.missed, 100 * noise.spurious, 100 * noise.mislabeled, noise.jitter
    shared = 100 * noise.background, noise.displaced, conditions.class_shift, 100 * noise.leaning
    numbers = (*of_labels, *shared, 100 * conditions.lens, conditions.tilt_deg)
    titles = (title for _, title, _ in (*parameters.noises(), *parameters.shared_errors()))
    method = Method.AUTOMATIC if correlation else Method.CONSTELLATION
    return [
        (tr("Method"), worded(method.title)),
        *((title, shown(number, "g")) for title, number in zip(titles, numbers)),
        (tr("Success threshold (%)"), shown(100 * threshold, "g")),
        (tr("Seed"), str(seed)),
    ]
