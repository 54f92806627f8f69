"""Read a reference database with SQLite."""

from __future__ import annotations

import contextlib
import csv
import io
import json
import sqlite3
from dataclasses import dataclass, replace

import numpy as np
from osgeo import gdal

from ...core import limits
from ...core.cache import digest
from ...core.database.checks import require_sound
from ...core.database.model import ReferenceDatabase
from ...core.database.parameters import BuildParameters, build_parameters
from ...core.errors import DatabaseError
from ...core.labels.class_table import ClassTable, class_table_from_csv
from ...core.values import read_json
from ..gdal_errors import gdal_failure, gdal_failures
from . import schema
from .batches import columns_of
from .cached_columns import Columns, cached_columns
from .checksums import (
    CHECKSUMS,
    checksums_of,
    keeps_shown,
    overview_checksum,
    require_unchanged,
    shown_checksums,
)
from .connection import DatabaseChangedError, Snapshot, damaged, open_table, require_unchanged_since, snapshot
from .rows import read_references, read_windows

_LONGEST_REASON = 200


def read_database(path: str, with_overview: bool = False, with_bounds: bool = False) -> ReferenceDatabase:
    """Read a reference database.

    Args:
        with_overview: Whether to read its overview, too.
        with_bounds: Whether to read the bounds of its landmarks, too; old databases have none.

    Raises:
        DatabaseError: The file is missing, foreign, truncated or too new.
    """
    with snapshot(path) as connection:
        database = _read(connection, path, is_cached=True)
        if with_bounds:
            bounds = _checked_bounds(connection, database, path)
            database = replace(database, references=replace(database.references, bounds_px=bounds))
        return replace(database, overview=_overview(connection, path)) if with_overview else database


def read_overview(path: str, of: BuildParameters | None = None) -> np.ndarray:
    """(h, w) uint8 class values.

    Args:
        of: What was read from it before, if anything: what was updated since is refused.

    Raises:
        DatabaseError: It has no overview.
        DatabaseChangedError: It was updated since.
    """
    with snapshot(path) as connection:
        if of is not None and _read_parameters(connection, path) != of:
            raise DatabaseChangedError("{path} was changed by another program meanwhile; try again.", path=path)
        return _overview(connection, path)


def _read(connection: Snapshot, path: str, is_checked: bool = True, is_cached: bool = False) -> ReferenceDatabase:
    """What a database holds, without the overview; raises what ``snapshot`` makes a DatabaseError of.

    Args:
        is_checked: Whether its tables have to be what its checksums say.
        is_cached: Whether the columns of a large one may come from the cache; otherwise the rows are read.
    """
    parameters = _read_parameters(connection, path)
    table = _class_table(connection, path)

    def read() -> Columns:
        windows, landmarks = read_windows(connection, parameters, path), read_references(connection)
        require_sound(windows, landmarks, parameters, table)
        if is_checked:
            require_unchanged(connection, checksums_of(connection, windows, landmarks))
            if keeps_shown(connection):
                require_unchanged(connection, shown_checksums(connection))
        return windows, landmarks

    length = 3 * parameters.references_per_vector
    windows, landmarks = cached_columns(connection, length, read) if is_cached else read()
    return ReferenceDatabase(windows, landmarks, table, parameters, path)


def _overview(connection: Snapshot, path: str) -> np.ndarray:
    """Read by GDAL while the connection's lock keeps writers out; one that replaces the file is noticed."""
    parameters = _read_parameters(connection, path)
    require_unchanged(connection, {schema.OVERVIEW: overview_checksum(connection)})
    # Left as it is where GDAL raises.
    overview = None
    with gdal_failures() as failures:
        dataset = open_table(path, schema.OVERVIEW, gdal.OF_RASTER)
        overview = None if dataset is None else _labels(dataset, parameters)
    require_unchanged_since(path, connection.state)
    if overview is None:
        reason = gdal_failure(failures[0] if failures else None)
        raise DatabaseError(
            "{path} has no overview that can be read ({reason}); build it again.", path=path, reason=reason
        )
    return overview


def _labels(dataset: gdal.Dataset, parameters: BuildParameters) -> np.ndarray:
    """(h, w) uint8; raises ValueError for a raster of another size or kind."""
    shape, expected = (dataset.RasterYSize, dataset.RasterXSize), parameters.overview_frame.shape_hw
    if shape != expected:
        raise ValueError(f"its overview has {shape[1]} × {shape[0]} pixels instead of {expected[1]} × {expected[0]}")
    return dataset.GetRasterBand(1).ReadAsArray()


def _read_parameters(connection: sqlite3.Connection, path: str) -> BuildParameters:
    stored = connection.execute("SELECT key, value FROM parameters").fetchall()
    try:
        return build_parameters({key: read_json(value) for key, value in stored if key != CHECKSUMS}, path)
    except (KeyError, ValueError, TypeError) as error:
        reason = str(error)[:_LONGEST_REASON]
        raise DatabaseError(
            "{path} has no readable parameter {reason}; build it again.", path=path, reason=reason
        ) from None


def _class_table(connection: sqlite3.Connection, path: str) -> ClassTable:
    rows = connection.execute("SELECT value, name, color, role, draw_order, hsv_min, hsv_max FROM classes").fetchall()
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow(schema.CLASS_COLUMNS)
    writer.writerows(["" if cell is None else cell for cell in row] for row in rows)
    return class_table_from_csv(text.getvalue(), f"the class table of {path}")


@dataclass(frozen=True)
class StoredDatabase:
    """A database as an update needs it.

    Attributes:
        database: With the landmarks' bounds, None when the file has none.
        window_fids, reference_fids: Of its windows and landmarks, in their order.
        state: Of its files when it was read; another one tells that it was changed.
    """

    database: ReferenceDatabase
    window_fids: tuple[int, ...]
    reference_fids: tuple[int, ...]
    state: tuple

    def require_as_read(self) -> None:
        """Raises DatabaseChangedError where the database was changed since it was read."""
        require_unchanged_since(self.database.source, self.state)


def read_stored_database(path: str) -> StoredDatabase:
    """Reads what ``read_database`` reads and what an update needs besides; raises DatabaseError as that does."""
    with snapshot(path) as connection:
        database = _read(connection, path)
        window_fids = connection.execute("SELECT fid FROM windows ORDER BY fid").fetchall()
        fids = connection.execute('SELECT fid FROM "references" ORDER BY fid').fetchall()
        bounds = _checked_bounds(connection, database, path)
    database = replace(database, references=replace(database.references, bounds_px=bounds))
    return StoredDatabase(
        database, tuple(fid for (fid,) in window_fids), tuple(fid for (fid,) in fids), connection.state
    )


def _checked_bounds(connection: sqlite3.Connection, database: ReferenceDatabase, path: str) -> np.ndarray | None:
    """Bounds of all landmarks; None in databases of older versions."""
    bounds = _read_bounds(connection)
    if bounds is None:
        return None
    require_unchanged(connection, {schema.BOUNDS: digest([bounds])})
    if len(bounds) != len(database.references):
        raise DatabaseError(
            "{path} has {count} landmarks and bounds of {bounds}; build it again.",
            path=path,
            count=len(database.references),
            bounds=len(bounds),
        )
    if not _on_map(bounds, database.parameters):
        raise damaged(path, ValueError("a landmark spans pixels that the map has not"))
    return bounds


def _on_map(bounds_px: np.ndarray, parameters: BuildParameters) -> bool:
    first, end = bounds_px[:, :2], bounds_px[:, 2:]
    size = parameters.map_width_px, parameters.map_height_px
    return bool(((first >= 0) & (first < end) & (end <= size)).all())


def _read_bounds(connection: sqlite3.Connection) -> np.ndarray | None:
    """(N, 4) int64 bounds of the references in the order of their fids; None in databases of older versions."""
    found = connection.execute("SELECT count(*) FROM sqlite_master WHERE name = ?", (schema.BOUNDS,)).fetchone()
    if not found[0]:
        return None
    query = (
        'SELECT first_column, first_row, end_column, end_row FROM reference_bounds AS b JOIN "references" AS r '
        "ON r.fid = b.fid ORDER BY b.fid"
    )
    return columns_of(connection, query, lambda rows: [np.array(rows, np.int64).reshape(-1, 4)])[0]


def stored_style(path: str, table: str) -> str | None:
    """QML of the style of one table of a database, None when it has none or a damaged one."""
    query = "SELECT styleQML FROM layer_styles WHERE f_table_name = ? AND length(styleQML) < ?"
    try:
        with snapshot(path) as connection:
            row = connection.execute(query, (table, limits.STYLE_CHARACTERS)).fetchone()
    except DatabaseError:
        return None
    return row[0] if row else None


def store_checksums(path: str) -> None:
    """Puts the checksums of a finished database's tables among its parameters, in place of older ones.

    Raises:
        DatabaseError: What was written can't be read back.
    """
    with snapshot(path) as connection:
        database = _read(connection, path, is_checked=False)
        found = checksums_of(connection, database.windows, database.references)
        found[schema.OVERVIEW] = overview_checksum(connection)
        bounds = _read_bounds(connection)
        if bounds is not None:
            found[schema.BOUNDS] = digest([bounds])
        found.update(shown_checksums(connection))
    text = json.dumps(found)
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        changed = connection.execute("UPDATE parameters SET value = ? WHERE key = ?", (text, CHECKSUMS))
        if not changed.rowcount:
            connection.execute("INSERT INTO parameters (key, value) VALUES (?, ?)", (CHECKSUMS, text))
