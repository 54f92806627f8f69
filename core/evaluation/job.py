"""An evaluation in pieces: the images with their methods, and the data that a worker needs for one."""

from __future__ import annotations

from dataclasses import dataclass

from ..database.model import ReferenceDatabase
from ..geometry.frame import MapFrame
from ..labels.sources import LabelSource
from ..localization import Method
from .evaluation import Evaluation, TrialRanges, WindowQuery

GRID_CELLS = 16
MOST_IN_A_CELL = 20
"""Images of a cell of the noise grid: count / GRID_CELLS, at least 2 and at most this number. So has a step of the
offset."""

Job = tuple[WindowQuery, list[Method]]


@dataclass(frozen=True)
class EvaluationJob:
    """Values that all trials share, as in ``Evaluation``.

    Attributes:
        database: Path of the reference database.
        labels: Path of the label map that images are cut from.
        ranges: Of the images' values.
        seed: The same one repeats everything.
        minimum_references: Least landmarks of a window for trials.
        right_within: Largest error of a right position, m; None for a share of the footprint.
    """

    database: str
    labels: str
    frame: MapFrame
    ranges: TrialRanges
    seed: int
    minimum_references: int = 3
    right_within: float | None = None

    def evaluation(self, database: ReferenceDatabase, source: LabelSource) -> Evaluation:
        """Return the requested evaluation.

        Args:
            database: With its overview.
            source: The label map.

        Raises:
            ParameterError: No window can be used.
        """
        return Evaluation(
            database, source, self.frame, self.ranges, self.seed, self.minimum_references, self.right_within
        )


def plan_trials(
    evaluation: Evaluation, methods: list[Method], count: int, mirrored_share: float, is_reported: bool
) -> list[Job]:
    """Return the queries with their methods.

    Args:
        methods: The first one is that of the grid of noise.
        count: Images of the map and mirrored ones together.
        mirrored_share: Share of mirrored images, 0…1; at least one image is of the map.
        is_reported: Whether to add the queries of tables and charts.
    """
    mirrored = min(round(count * mirrored_share), count - 1)
    jobs = [(query, methods) for query in evaluation.trials(count - mirrored, mirrored)]
    if is_reported:
        a_cell = min(max(count // GRID_CELLS, 2), MOST_IN_A_CELL)
        jobs += [(query, methods[:1]) for query in evaluation.noise_grid(a_cell)]
        jobs += [(query, methods) for query in evaluation.moves(a_cell)]
        jobs += [(query, methods) for query in evaluation.tables()]
    return jobs
