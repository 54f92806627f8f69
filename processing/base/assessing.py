"""What assessing a database and assessing a route share: noise and its parameters, reading, trials, reasons."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice
from typing import TYPE_CHECKING, Callable

from qgis.core import QgsProcessingParameterBoolean, QgsProcessingParameterDefinition, QgsProcessingParameterNumber

from ...core.errors import DatabaseError
from ...core.localization import Method
from ..compat import DOUBLE
from ..messages.numbers import shown
from ..messages.sentences import worded
from ..reports.network_noise import read_network
from ..translation import tr
from . import parameters
from .algorithm import SemRefAlgorithm, cancelable, check_canceled
from .parameters import with_help
from .scheduler import with_progress

if TYPE_CHECKING:
    from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingFeedback

    from ...core.assessment.assessment import Assessment, PlaceQuery
    from ...core.database.model import ReferenceDatabase
    from ...core.evaluation.trial import Trial
    from ...core.localizer.localizer import Localizer
    from ...core.simulation.conditions import Conditions
    from .scheduler import Workers
    from .values import Values

_SIMULATED_A_TASK = 25
"""Of some milliseconds each."""

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
"""What is assumed by default, and the largest value, by key: percent, map units, degrees."""


NETWORK_FACTORS = (None, 0.5, 1.0, 2.0)
"""By option of NETWORK: multiplies what is assumed of a network; None leaves it to the numbers that are given."""

OF_NETWORKS = ("MISSED", "INVENTED", "MISNAMED", "RAGGED", "BACKGROUND", "SHIFTED")
"""The errors that are a network's; the others are the map's and the camera's."""


def noise_ranges(
    values: Values, usual: Mapping[str, tuple[float, float]], read: Callable[[str], tuple[float, float]]
) -> dict[str, tuple[float, float]]:
    """How poor labels are: by a comparison's report, else by the network in a word, else by the parameters themselves.

    Args:
        values: With NETWORK and COMPARISON.
        usual: (lowest, highest) that is assumed of a usable network, by key.
        read: Gives the range that a parameter has.

    Raises:
        ParameterError: The report can't be used, or a value.
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
    parameter = QgsProcessingParameterNumber(key, title, type=DOUBLE, defaultValue=usual, minValue=0.0)
    if most is not None:
        parameter.setMaximum(most)
    return with_help(parameter, text, advanced=True)


class AssessAlgorithm(SemRefAlgorithm):
    """An algorithm that simulates images of a database."""

    DATABASE, REPORT, SEED = parameters.DATABASE, parameters.REPORT, parameters.SEED
    MAP_CORRELATION = "MAP_CORRELATION"
    THRESHOLD = "THRESHOLD"

    def noise_parameters(self) -> tuple[QgsProcessingParameterDefinition, ...]:
        """What is good enough, how images are localized, and how poor their labels are."""
        return (
            with_help(
                QgsProcessingParameterNumber(
                    self.THRESHOLD,
                    tr("Good enough from (%)"),
                    type=DOUBLE,
                    defaultValue=90.0,
                    minValue=1.0,
                    maxValue=99.9,
                ),
                tr("Expected success from which a place counts as one where localization works."),
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterBoolean(self.MAP_CORRELATION, tr("With map correlation"), defaultValue=True),
                tr(
                    "As the method Automatic works: where landmarks give no fix, map correlation is tried on images "
                    "cut from the database’s overview. That takes about a second an image on a large map, so it is "
                    "tried on an eighth of the images at most. Without it the constellation of landmarks alone is "
                    "assessed."
                ),
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
        """How poor labels and cameras are taken to be, in map units. Raises ParameterError for what can't be."""
        from ...core.simulation.conditions import conditions_of

        usual = {key: (number, number) for key, (number, _) in USUAL.items()}
        ranges = noise_ranges(values, usual, lambda key: (values.number(key),) * 2)
        return conditions_of({key.lower(): number for key, (number, _) in ranges.items()})

    def with_correlation(self, values: Values, database: ReferenceDatabase) -> bool:
        """Whether map correlation is assessed as well: it is wanted, and the database has what it needs."""
        return values.switch(self.MAP_CORRELATION) and database.overview is not None

    def threshold(self, values: Values) -> float:
        """0…1."""
        return values.number(self.THRESHOLD) / 100

    def read_all(
        self, values: Values, feedback: QgsProcessingFeedback
    ) -> tuple[ReferenceDatabase, QgsCoordinateReferenceSystem]:
        """(database with bounds and, if it has one, overview; its CRS)."""
        from ...storage.database.connection import DatabaseChangedError
        from ...storage.database.reader import read_database, read_overview
        from ..layers.reference_systems import database_crs

        feedback.setProgressText(tr("Reading the database"))
        path = values.file(self.DATABASE)
        database = cancelable(read_database, path, False, True, feedback=feedback)
        crs = database_crs(database)
        try:
            overview = cancelable(read_overview, path, database.parameters, feedback=feedback)
            database = replace(database, overview=overview)
        except DatabaseChangedError:
            raise
        except DatabaseError:
            # Landmarks can be assessed all the same.
            warning = tr(
                "The database has no overview: the constellation alone is assessed, and where the ground ends is taken "
                "from the extent."
            )
            feedback.pushWarning(warning)
        return database, crs

    def assessment(
        self,
        values: Values,
        database: ReferenceDatabase,
        localizer: Localizer,
        footprint: float,
        feedback: QgsProcessingFeedback,
    ) -> Assessment:
        """The assessment of a footprint; says when images like that aren't searched for."""
        from ...core.assessment.assessment import Assessment

        correlation = self.with_correlation(values, database)
        arguments = database, localizer, footprint, self.conditions(values), values.integer(self.SEED), correlation
        made = cancelable(Assessment, *arguments, feedback=feedback)
        if not made.simulator.is_searched or correlation and not made.simulator.is_correlated:
            feedback.pushWarning(
                tr(
                    "Images that show {footprint:g} map units are not looked for without a known pixel size: too far "
                    "from the window size of {window:g}."
                ).format(footprint=footprint, window=database.parameters.window_size)
            )
        return made

    def localizer(self, database: ReferenceDatabase, feedback: QgsProcessingFeedback) -> Localizer:
        """A localizer of the database, its index built once, cancelable."""
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
            assessments: Of one database, alike but for their footprints.
            planned: The queries of each.
            feedback: Shows progress and takes a cancel.
            first: Progress in percent before.
            last: And after.
            run: Workers that do it; None to do it here.

        Returns:
            (trials, those that map correlation was tried on by their numbers in the queries) of each assessment.
        """
        from ...cluster.task_names import ASSESS, CORRELATE
        from ...core.assessment.assessment import CORRELATED_SHARE, AssessmentJob, to_correlate

        def answers(task: str, here: Callable[..., Trial], asked: list[tuple[int, PlaceQuery]], size: int) -> Iterator:
            if run is None:
                return (here(assessments[n], query) for n, query in asked)
            pieces = [(assessments[n].footprint, query) for n, query in asked]
            return run.answers(task, AssessmentJob.of(assessments[0]), pieces, assessments[0].database, size)

        def simulate_one(assessment: Assessment, query: PlaceQuery) -> Trial:
            # Milliseconds each, so that a thread for every one would cost more than it helps.
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
        text = tr("{count} images simulated in {seconds:.0f} s.")
        feedback.pushInfo(text.format(count=len(asked) + len(chosen), seconds=time.monotonic() - started))
        return tried


def setting_rows(conditions: Conditions, threshold: float, correlation: bool, seed: int) -> list[tuple[str, str]]:
    """What both reports list: (what, value)."""
    noise = conditions.noise
    shared = (100 * noise.background, noise.displaced, conditions.class_shift, 100 * noise.leaning)
    numbers = (*shared, 100 * conditions.lens, conditions.tilt_deg)
    method = Method.AUTOMATIC if correlation else Method.CONSTELLATION
    return [
        (tr("Method"), worded(method.title)),
        (tr("Landmarks missed (%)"), shown(100 * noise.missed, "g")),
        (tr("Landmarks invented (%)"), shown(100 * noise.spurious, "g")),
        (tr("Landmarks misnamed (%)"), shown(100 * noise.mislabeled, "g")),
        (tr("Ragged edges (map units)"), shown(noise.jitter, "g")),
        *((title, shown(number, "g")) for (_, title, _), number in zip(parameters.shared_errors(), numbers)),
        (tr("Good enough from (%)"), shown(100 * threshold, "g")),
        (tr("Seed"), str(seed)),
    ]
