"""Assessments whose images are simulated elsewhere, piece by piece: what each piece needs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..database.model import ReferenceDatabase
from ..localizer.localizer import Localizer
from ..simulation.conditions import Conditions
from ..simulation.noise import LabelNoise
from .assessment import Assessment


@dataclass(frozen=True)
class AssessmentJob:
    """What is the same for all images; as of ``Assessment``.

    Attributes:
        database: Path of the reference database.
        has_overview: Whether its overview is read.
        footprints: Edges of the ground that images show.
        conditions: How poor labels and cameras are taken to be.
        seed: With the same one, everything is the same.
        correlation: Whether map correlation is tried on images without a fix.
    """

    database: str
    has_overview: bool
    footprints: tuple[float, ...]
    conditions: Conditions
    seed: int
    correlation: bool = False

    def assessment(self, database: ReferenceDatabase, localizer: Localizer, footprint: float) -> Assessment:
        """The assessment of one footprint.

        Args:
            database: That is assessed, with its overview where it has one.
            footprint: One of ``footprints``.

        Raises:
            ParameterError: For a footprint that is none.
            DatabaseError: For a database without landmarks.
        """
        return Assessment(database, localizer, footprint, self.conditions, self.seed, self.correlation)


def job_of(assessments: Sequence[Assessment]) -> AssessmentJob:
    """What is the same for all images of some assessments of one database, which lies in a file.

    Args:
        assessments: Made alike but for their footprints.
    """
    first = assessments[0]
    return AssessmentJob(
        first.database.source or "",
        first.database.overview is not None,
        tuple(assessment.footprint for assessment in assessments),
        first.conditions,
        first.seed,
        first.correlation,
    )


def conditions_of(numbers: Mapping[str, float]) -> Conditions:
    """How poor labels and cameras are taken to be.

    Args:
        numbers: By name: missed, invented, misnamed, ragged, background, displaced, shifted, leaning, lens and tilt;
            percent, map units, degrees.

    Raises:
        ParameterError: For what can't be.
    """
    noise = LabelNoise(
        numbers["missed"] / 100,
        numbers["invented"] / 100,
        numbers["misnamed"] / 100,
        numbers["ragged"],
        background=numbers["background"] / 100,
        displaced=numbers["displaced"],
        leaning=numbers["leaning"] / 100,
    )
    return Conditions(noise, numbers["shifted"], numbers["lens"] / 100, numbers["tilt"])
