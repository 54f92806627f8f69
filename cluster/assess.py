"""``assess``: where a database will localize, by many workers, as ``semref:assessdatabase`` tells it."""

from __future__ import annotations

import sqlite3
from argparse import Namespace
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from ..core.assessment.assessment import Estimates
from ..core.assessment.cells import Cells, ground_cells
from ..core.assessment.job import AssessmentJob, conditions_of
from ..core.assessment.offered import OFFERED
from ..core.assessment.squares import FIELDS, footprint_sizes, square_rows
from ..core.database.model import ReferenceDatabase
from ..core.errors import DatabaseError, ParameterError
from ..core.localizer.localizer import Localizer
from ..storage.database.connection import DatabaseChangedError
from ..storage.database.reader import read_database, read_overview
from ..storage.file_states import fingerprint
from ..storage.files import written_beside
from ..storage.metadata import plugin_metadata
from ..storage.notes import database_sources, history, write_notes
from ..storage.squares_file import ABOUT_SQUARES, write_squares
from ..storage.squares_style import squares_qml
from .engine import DaskRunner, connected
from .inputs import Teller, moment_of, plain, require_apart, require_unchanged, seen_by_workers, state
from .order import answered


def assess(options: Namespace, teller: Teller) -> dict[str, Any]:
    """Assesses the database that the command line asks for.

    Args:
        options: Of the command line.
        teller: Takes what is being done.

    Returns:
        What came of it, by name; of the first footprint.

    Raises:
        SemRefError: Anything that the user can mend.
    """
    path = seen_by_workers(options.database)
    read = [path]
    require_apart(path, options.output)
    footprints = footprint_sizes(options.footprints, 1.0)
    before = {file: state(file) for file in read}
    database = _read(path, teller)
    footprints = footprint_sizes(options.footprints, database.parameters.window_size)
    cells = ground_cells(database, min(footprints) / 2 if options.spacing is None else options.spacing)
    if not len(cells):
        raise ParameterError("assessment.nothing", path=path)
    given = {name: usual if getattr(options, name) is None else getattr(options, name) for name, usual in _usual()}
    correlation = not options.without_map_correlation and database.overview is not None
    job = AssessmentJob(
        path, database.overview is not None, tuple(footprints), conditions_of(given), options.seed, correlation
    )
    localizer, threshold = Localizer(database), options.threshold / 100
    assessments = [job.assessment(database, localizer, footprint) for footprint in footprints]
    planned = [assessment.plan(cells.centers, cells.size, options.trials) for assessment in assessments]
    with written_beside(str(Path(options.output).absolute())) as temporary:
        with connected(options.scheduler, options.local, options.worker_memory, teller.say) as client:
            tried = answered(job, planned, DaskRunner(client, ""), teller, fingerprint(database))
        require_unchanged(before)
        estimates = [
            assessment.estimate(cells.centers, trials, correlated, cells.size)
            for assessment, (trials, correlated) in zip(assessments, tried)
        ]
        moment = moment_of(max(before.values(), key=lambda found: found[1]))
        write_squares(
            temporary,
            FIELDS,
            _squares(database, cells, footprints, estimates, threshold),
            database.parameters.crs,
            moment,
            squares_qml(threshold, footprints[0], len(footprints) == 1),
        )
        made = history(moment, plugin_metadata()["version"], _command(options, footprints, given, correlation))
        _tell(temporary, database, made, moment)
    success = estimates[0].success
    return {
        "output": options.output,
        "squares": len(cells),
        "localizable_fraction": float((success >= threshold).mean()),
        "mean_success": float(success.mean()),
    }


def _command(
    options: Namespace, footprints: Sequence[float], given: Mapping[str, float], correlation: bool
) -> list[str]:
    """What makes the same squares again, wherever they go to and whoever does it."""
    command = ["assess", options.database, "--footprints", ";".join(map(plain, footprints))]
    command += [] if options.spacing is None else ["--spacing", plain(options.spacing)]
    command += ["--trials", str(options.trials), "--threshold", plain(options.threshold), "--seed", str(options.seed)]
    command += [part for name, value in given.items() for part in (f"--{name}", plain(value))]
    return command if correlation else [*command, "--without-map-correlation"]


def _tell(path: str, database: ReferenceDatabase, made: str, moment: str) -> None:
    """Writes what the squares are, what made them, and the licenses of the databases they are of."""
    texts, sources = {Path(path).stem: ABOUT_SQUARES}, database_sources(database.source or "")
    try:
        write_notes(path, texts, sources, database.parameters.crs, made, moment)
    except sqlite3.Error as error:
        raise ParameterError("storage.file_unwritable", path=path, reason=str(error).rstrip(".")) from None


def _usual() -> Iterator[tuple[str, float]]:
    return ((name, usual) for name, (usual, _) in OFFERED.items())


def _read(path: str, teller: Teller) -> ReferenceDatabase:
    """The database with bounds and, if it has one, overview."""
    database = read_database(path, with_bounds=True)
    try:
        return replace(database, overview=read_overview(path, database.parameters))
    except DatabaseChangedError:
        raise
    except DatabaseError:
        # Landmarks can be assessed all the same.
        teller.say(
            "The database has no overview: the constellation alone is assessed, and where the ground ends is taken "
            "from the extent."
        )
        return database


def _squares(
    database: ReferenceDatabase, cells: Cells, footprints: list[float], estimates: list[Estimates], threshold: float
) -> Iterator[tuple[tuple[float, float], float, dict[str, Any]]]:
    """Center, edge and values of each square of each footprint."""
    centers = [(x, y) for x, y in cells.centers.tolist()]
    for footprint, found in zip(footprints, estimates):
        for center, row in zip(centers, square_rows(cells, database.windows, footprint, found, threshold)):
            yield center, cells.size, row
