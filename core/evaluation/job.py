"""An evaluation piece by piece: which images are tried with which methods, and what a worker needs to try one."""

from __future__ import annotations

from dataclasses import dataclass

from ..database.model import ReferenceDatabase
from ..geometry.frame import MapFrame
from ..labels.sources import LabelSource
from ..localization import Method
from .evaluation import Evaluation, TrialRanges, WindowQuery

GRID_CELLS = 16
MOST_IN_A_CELL = 20
"""A cell of the grid of noise has count / GRID_CELLS images, but 2 at least and so many at most; so has a step of the
offset."""

Job = tuple[WindowQuery, list[Method]]


@dataclass(frozen=True)
class EvaluationJob:
    """What is the same for all trials; as of ``Evaluation``.

    Attributes:
        database: Path of the reference database.
        labels: Path of the label map that images are cut from.
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


def plan_trials(
    evaluation: Evaluation, methods: list[Method], count: int, mirrored_share: float, is_reported: bool
) -> list[Job]:
    """What is tried with which methods.

    Args:
        methods: The first is that of the grid of noise.
        count: Images of the map and mirrored ones.
        mirrored_share: Of them, 0…1; one at least is of the map.
        is_reported: Whether tables and charts are made of it, which need more.
    """
    mirrored = min(round(count * mirrored_share), count - 1)
    jobs = [(query, methods) for query in evaluation.trials(count - mirrored, mirrored)]
    if is_reported:
        a_cell = min(max(count // GRID_CELLS, 2), MOST_IN_A_CELL)
        jobs += [(query, methods[:1]) for query in evaluation.noise_grid(a_cell)]
        jobs += [(query, methods) for query in evaluation.moves(a_cell)]
        jobs += [(query, methods) for query in evaluation.tables()]
    return jobs
