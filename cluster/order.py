"""``order``: what QGIS wrote down for workers to do, piece by piece; its answer goes into a file of the same kind."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import singledispatch
from pathlib import Path
from typing import Any

from ..core.assessment.assessment import CORRELATED_SHARE, to_correlate
from ..core.assessment.job import AssessmentJob
from ..core.evaluation.job import EvaluationJob
from ..core.localizer.search import ImagesJob
from ..storage.carried import from_text, read, to_text, write
from ..storage.files import written_beside
from .engine import DaskRunner, connected
from .inputs import Teller, require_apart, require_unchanged, seen_by_workers, state
from .jobs import ASSESS, CORRELATE, EVALUATE, IMAGES

_TRIALS_A_TASK, _SIMULATED_A_TASK = 4, 25
"""Of some hundred milliseconds each, and of some milliseconds."""

_SIMULATED_UNTIL = 0.3
"""Share of all that is done before map correlation begins."""


def order(options: Namespace, teller: Teller) -> dict[str, Any]:
    """Does what a file tells: a job and its pieces.

    Args:
        options: Of the command line.
        teller: Takes what is being done.

    Returns:
        How many pieces there were.

    Raises:
        SemRefError: Anything that the user can mend.
    """
    require_apart(options.order, options.found)
    job, pieces, known = read(options.order)
    database = seen_by_workers(job.database)
    require_apart(database, options.found)
    # What QGIS read of some files is told by the order; it may have been long ago.
    before = {database: state(database), **known["files"]}
    require_unchanged(before)
    with written_beside(str(Path(options.found).absolute())) as temporary:
        with connected(options.scheduler, options.local, options.worker_memory, teller.say) as client:
            found = answered(job, pieces, DaskRunner(client, ""), teller, known["database"])
        # Workers open it each at its time.
        require_unchanged(before)
        write(temporary, found)
    return {"pieces": len(pieces)}


@singledispatch
def answered(job: object, pieces: Sequence[Any], run: DaskRunner, teller: Teller, database: str) -> Any:
    """What workers found of the pieces of a job, in their order.

    Args:
        job: What is the same for all of them.
        pieces: What differs.
        run: Who has it done.
        teller: Takes what is being done.
        database: Fingerprint of the database that pieces were planned by; workers that find another one refuse.

    Raises:
        SemRefError: The job can't be done.
    """
    raise TypeError(type(job).__name__)


@answered.register
def _(job: ImagesJob, pieces: Sequence[Any], run: DaskRunner, teller: Teller, database: str) -> list[Any]:
    job = replace(job, database=seen_by_workers(job.database), model=job.model and seen_by_workers(job.model))
    asked = [replace(image, path=seen_by_workers(image.path)) for image in pieces]
    return list(
        _followed(_parts((job, database), IMAGES, asked, 1, run), len(asked), "Localizing images", (0, 1), teller)
    )


@answered.register
def _(job: EvaluationJob, pieces: Sequence[Any], run: DaskRunner, teller: Teller, database: str) -> list[Any]:
    """The trials of each image."""
    job = replace(job, database=seen_by_workers(job.database), labels=seen_by_workers(job.labels))
    found = _parts((job, database), EVALUATE, pieces, _TRIALS_A_TASK, run)
    return list(_followed(found, len(pieces), "Localizing", (0, 1), teller))


@answered.register
def _(
    job: AssessmentJob, pieces: Sequence[Any], run: DaskRunner, teller: Teller, database: str
) -> list[tuple[list, dict]]:
    """Of each footprint, whose planned images are a piece: trials, and by their numbers those of map correlation."""
    job = replace(job, database=seen_by_workers(job.database))
    asked = [(footprint, query) for footprint, queries in zip(job.footprints, pieces) for query in queries]
    until = _SIMULATED_UNTIL if job.correlation else 1.0
    what = "Localizing simulated images"
    parts = _parts((job, database), ASSESS, asked, _SIMULATED_A_TASK, run)
    trials = list(_followed(parts, len(asked), what, (0, until), teller))
    firsts = [sum(map(len, pieces[:n])) for n in range(len(pieces))]
    tried = [trials[first : first + len(queries)] for first, queries in zip(firsts, pieces)]
    chosen: list[tuple[int, int]] = []
    if job.correlation:
        for n, of_footprint in enumerate(tried):
            most = max(len(of_footprint) // CORRELATED_SHARE, 1)
            chosen += [(n, number) for number in to_correlate(job.seed, of_footprint, most)]
    again = [(job.footprints[n], pieces[n][number]) for n, number in chosen]
    found = _followed(_parts((job, database), CORRELATE, again, 1, run), len(again), what, (until, 1), teller)
    correlated: list[dict[int, Any]] = [{} for _ in pieces]
    for (n, number), trial in zip(chosen, found):
        correlated[n][number] = trial
    return list(zip(tried, correlated))


def _parts(job: tuple[object, str], task: str, pieces: Sequence[Any], at_once: int, run: DaskRunner) -> Iterator[Any]:
    """What was found of each piece, in their order."""
    calls = ((to_text(list(pieces[n : n + at_once])),) for n in range(0, len(pieces), at_once))
    for text in run.in_order(task, calls, (to_text(job),)):
        yield from from_text(text)


def _followed(
    found: Iterator[Any], count: int, text: str, shares: tuple[float, float], teller: Teller
) -> Iterator[Any]:
    """The same, told as it comes."""
    first, last = shares
    teller.step(text, first)
    for n, one in enumerate(found, start=1):
        teller.step(text, first + (last - first) * n / count)
        yield one
