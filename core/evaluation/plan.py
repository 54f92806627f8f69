"""Which images an evaluation tries with which methods."""

from __future__ import annotations

from ..localization import Method
from .evaluation import Evaluation, WindowQuery

GRID_CELLS = 16
MOST_IN_A_CELL = 20
"""A cell of the grid of noise has count / GRID_CELLS images, but 2 at least and so many at most; so has a step of the
offset."""

Job = tuple[WindowQuery, list[Method]]


def planned(
    evaluation: Evaluation, methods: list[Method], count: int, mirrored_share: float, is_reported: bool
) -> list[Job]:
    """What is tried with which methods.

    Args:
        evaluation: Whose images are tried.
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
