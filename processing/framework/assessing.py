"""What assessing a database and assessing a route share: noise and its parameters, reading, trials, reasons."""

from __future__ import annotations

import math
import time
from dataclasses import replace
from typing import Dict, List, Sequence, Tuple

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFile,
    QgsProcessingParameterNumber,
)

from ...core.errors import DatabaseError, ParameterError
from ..translation import tr
from .base import SemRefAlgorithm, cancelable, check_canceled

CORRELATED_SHARE = 5
"""Map correlation, which takes seconds an image, is tried on at most this part of the trials."""


class AssessAlgorithm(SemRefAlgorithm):
    """An algorithm that simulates images of a database."""

    DATABASE = "DATABASE"
    MISSED = "MISSED"
    INVENTED = "INVENTED"
    MISNAMED = "MISNAMED"
    RAGGED = "RAGGED"
    MAP_CORRELATION = "MAP_CORRELATION"
    THRESHOLD = "THRESHOLD"
    SEED = "SEED"

    def offer_database(self):
        self.offer(
            QgsProcessingParameterFile(self.DATABASE, tr("Reference database"), fileFilter=tr("GeoPackage (*.gpkg)")),
            tr("A GeoPackage made by “Build reference database”."),
        )

    def offer_noise(self):
        number = QgsProcessingParameterNumber
        self.offer(
            number(self.THRESHOLD, tr("Good enough from (%)"), number.Double, 90.0, minValue=1.0, maxValue=99.9),
            tr("Expected success from which a place counts as one where localization works."),
        )
        self.offer(
            QgsProcessingParameterBoolean(self.MAP_CORRELATION, tr("With map correlation (slow)"), False),
            tr(
                "Without it the constellation of landmarks alone is assessed. With it, as the method Automatic works: "
                "where landmarks give no fix, map correlation is tried on images cut from the database’s overview. "
                "That takes seconds an image on a large map, so it is tried on a fifth of the images at most."
            ),
        )
        for key, title, default, text in (
            (self.MISSED, tr("Landmarks missed (%)"), 20.0, tr("Share of the landmarks that are taken away.")),
            (
                self.INVENTED,
                tr("Landmarks invented (%)"),
                20.0,
                tr("Share of landmarks that are added, shaped like landmarks of other places of the map."),
            ),
            (self.MISNAMED, tr("Landmarks misnamed (%)"), 5.0, tr("Share of the landmarks that get another class.")),
        ):
            self.offer(number(key, title, number.Double, default, minValue=0.0, maxValue=100.0), text)
        self.offer(
            number(self.RAGGED, tr("Ragged edges (map units)"), number.Double, 1.0, minValue=0.0),
            tr("Standard deviation of how far edges are moved, alike over eight pixels."),
        )
        self.offer(
            number(self.SEED, tr("Seed"), number.Integer, 1, minValue=0),
            tr("Another number gives other trials, the same number the same."),
            advanced=True,
        )

    def noise(self, parameters, context):
        """How poor labels are taken to be, in map units. Raises ParameterError for noise that can't be."""
        from ...core.simulation.noise import LabelNoise

        keys = self.MISSED, self.INVENTED, self.MISNAMED
        shares = [self.parameterAsDouble(parameters, key, context) / 100 for key in keys]
        return LabelNoise(*shares, self.parameterAsDouble(parameters, self.RAGGED, context))

    def threshold(self, parameters, context) -> float:
        """0…1."""
        return self.parameterAsDouble(parameters, self.THRESHOLD, context) / 100

    def read_all(self, parameters, context, feedback):
        """(database with bounds and, if it has one, overview; its CRS)."""
        from ...storage.database.reader import read_overview, read_stored_database

        feedback.setProgressText(tr("Reading the database"))
        path = self.parameterAsFile(parameters, self.DATABASE, context)
        stored = cancelable(read_stored_database, path, feedback=feedback)
        crs = QgsCoordinateReferenceSystem.fromWkt(stored.database.parameters.crs)
        if not crs.isValid():
            raise DatabaseError(f"{path} has no readable parameter crs; build it again.")
        database = stored.database
        try:
            database = replace(database, overview=cancelable(read_overview, path, feedback=feedback))
        except DatabaseError:
            # Landmarks can be assessed all the same.
            if self.parameterAsBool(parameters, self.MAP_CORRELATION, context):
                raise
            feedback.pushWarning(tr("The database has no overview; where its ground ends is taken from its extent."))
        return database, crs

    def assessment(self, parameters, context, database, localizer, footprint: float, feedback):
        """The assessment of a footprint; says when images like that aren't searched for."""
        from ...core.assessment.assessment import Assessment

        correlation = self.parameterAsBool(parameters, self.MAP_CORRELATION, context)
        seed = self.parameterAsInt(parameters, self.SEED, context)
        made = cancelable(
            Assessment,
            database,
            localizer,
            footprint,
            self.noise(parameters, context),
            seed,
            correlation,
            feedback=feedback,
        )
        if not made.simulator.is_searched or correlation and not made.simulator.is_correlated:
            feedback.pushWarning(
                tr(
                    "Images that show {footprint:g} map units are not looked for without a known pixel size: too far "
                    "from the window size of {window:g}."
                ).format(footprint=footprint, window=database.parameters.window_size)
            )
        return made

    def index(self, localizer, feedback):
        """Builds the localizer's index once, cancelable."""
        feedback.setProgressText(tr("Preparing the landmarks"))
        cancelable(lambda: localizer.index, feedback=feedback)

    def simulate(self, assessment, queries: Sequence, feedback, first: float, last: float) -> Tuple[List, Dict]:
        """The trials, and those that map correlation was tried on by their numbers in ``queries``."""
        feedback.setProgressText(tr("Localizing simulated images"))
        middle = first + (last - first) * (0.3 if assessment.correlation else 1.0)
        started, trials, correlated = time.monotonic(), [], {}
        for query in queries:
            check_canceled(feedback)
            # Milliseconds each, so that a thread for every one would cost more than it helps.
            trials.append(assessment.run(query))
            feedback.setProgress(first + (middle - first) * len(trials) / len(queries))
        if assessment.correlation:
            chosen = assessment.to_correlate(trials, max(len(trials) // CORRELATED_SHARE, 1))
            for n, number in enumerate(chosen):
                check_canceled(feedback)
                correlated[number] = cancelable(assessment.run_correlation, queries[number], feedback=feedback)
                feedback.setProgress(middle + (last - middle) * (n + 1) / len(chosen))
        feedback.pushInfo(
            tr("{count} images simulated in {seconds:.0f} s.").format(
                count=len(trials) + len(correlated), seconds=time.monotonic() - started
            )
        )
        return trials, correlated


def method_title(correlation: bool) -> str:
    return tr("Automatic") if correlation else tr("Constellation")


def setting_rows(noise, threshold: float, correlation: bool, seed: int) -> List[Tuple[str, str]]:
    """What both reports list: (what, value)."""
    return [
        (tr("Method"), method_title(correlation)),
        (tr("Landmarks missed (%)"), f"{100 * noise.missed:g}"),
        (tr("Landmarks invented (%)"), f"{100 * noise.spurious:g}"),
        (tr("Landmarks misnamed (%)"), f"{100 * noise.mislabeled:g}"),
        (tr("Ragged edges (map units)"), f"{noise.jitter:g}"),
        (tr("Good enough from (%)"), f"{100 * threshold:g}"),
        (tr("Seed"), str(seed)),
    ]


def footprint_sizes(text: str, default: float) -> List[float]:
    """Numbers of a list separated by ``;``; the default for an empty one. Raises ParameterError."""
    sizes = []
    for part in (text or "").split(";"):
        if part.strip():
            try:
                sizes.append(float(part.replace(",", ".")))
            except ValueError:
                sizes.append(math.nan)
    if not all(0 < size < math.inf for size in sizes):
        raise ParameterError(f"FOOTPRINT is {text}; give edges of the ground in map units, separated by “;”.")
    return list(dict.fromkeys(sizes)) or [default]


def reason_text(reason: str, objects: float) -> str:
    """A sentence for the reason that keeps most images from a fix, '' for none."""
    return {
        "too_few_references": f"Too few landmarks: {objects:.0f} in view on average.",
        "ambiguous": "Look-alikes: another place, or the mirrored image, fits almost as well.",
        "no_match": f"Too little evidence: landmarks ({objects:.0f} in view) agree with the map too loosely.",
        "wrong_fix": "Some fixes would be wrong.",
    }.get(reason, "")
