"""An evaluation that is tried elsewhere, piece by piece: what each piece needs."""

from __future__ import annotations

from dataclasses import dataclass

from ..database.model import ReferenceDatabase
from ..geometry.frame import MapFrame
from ..labels.sources import LabelSource
from .evaluation import Evaluation, TrialRanges


@dataclass(frozen=True)
class EvaluationJob:
    """What is the same for all trials; as of ``Evaluation``.

    Attributes:
        database: Path of the reference database.
        labels: Path of the label map that images are cut from.
        frame: Where that lies.
        ranges: What images draw their values from.
        seed: With the same one, everything is the same.
        minimum_references: Landmarks that a window has to have for trials to lie around it.
        right_within: Map units that a right position may be off; None for a share of the footprint.
    """

    database: str
    labels: str
    frame: MapFrame
    ranges: TrialRanges
    seed: int
    minimum_references: int = 3
    right_within: float | None = None

    def evaluation(self, database: ReferenceDatabase, source: LabelSource) -> Evaluation:
        """The evaluation that is asked for.

        Args:
            database: With its overview.
            source: The label map.

        Raises:
            ParameterError: No window will do.
        """
        return Evaluation(
            database, source, self.frame, self.ranges, self.seed, self.minimum_references, self.right_within
        )
