"""Read a reference database with SQLite."""

from __future__ import annotations

import contextlib
import csv
import io
import json
import sqlite3
from dataclasses import dataclass, replace
from itertools import chain

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
from .cached_columns import Columns, cached_columns
from .checksums import CHECKSUMS, checksums_of, keeps_shown, overview_checksum, require_checksums, shown_checksums
from .connection import DatabaseChangedError, Snapshot, require_unchanged_since, snapshot
from .rows import columns_of, read_references, read_windows

_LONGEST_REASON = 200


def read_database(path: str, with_overview: bool = False, with_bounds: bool = False) -> ReferenceDatabase:
    """Read a reference database.

    Args:
        with_bounds: Whether to read the bounds of its landmarks; old databases have no bounds.

    Raises:
        DatabaseError: The file is missing, foreign, damaged or too new.
    """
    with snapshot(path) as connection:
        database = _read(connection, path, is_cached=True)
        if with_bounds:
            database = _with_bounds(connection, database, path)
        return replace(database, overview=_overview(connection, path)) if with_overview else database


def read_overview(path: str, of: BuildParameters | None = None) -> np.ndarray:
    """Return (h, w) uint8 class values.

    Args:
        of: Parameters from an earlier read; None to skip the check for an update since then.

    Raises:
        DatabaseError: The database has no overview.
        DatabaseChangedError: The database was updated since then.
    """
    with snapshot(path) as connection:
        if of is not None and _read_parameters(connection, path) != of:
            raise DatabaseChangedError("{path} was changed by another program meanwhile; try again.", path=path)
        return _overview(connection, path)


def _read(connection: Snapshot, path: str, is_checked: bool = True, is_cached: bool = False) -> ReferenceDatabase:
    """Read a database without its overview. Its errors become DatabaseError in ``snapshot``.

    Args:
        is_checked: Whether to check the tables against their checksums.
        is_cached: Whether the columns of a large database may come from the cache.
    """
    parameters = _read_parameters(connection, path)
    table = _class_table(connection, path)

    def read() -> Columns:
        windows, landmarks = read_windows(connection, parameters, path), read_references(connection)
        require_sound(windows, landmarks, parameters, table)
        if is_checked:
            require_checksums(connection, checksums_of(connection, windows, landmarks))
            if keeps_shown(connection):
                require_checksums(connection, shown_checksums(connection))
        return windows, landmarks

    windows, landmarks = cached_columns(connection, read) if is_cached else read()
    return ReferenceDatabase(windows, landmarks, table, parameters, path)


def _overview(connection: Snapshot, path: str) -> np.ndarray:
    """Read the overview with GDAL, under the connection's lock; a replaced file is detected."""
    parameters = _read_parameters(connection, path)
    require_checksums(connection, {schema.OVERVIEW: overview_checksum(connection)})
    overview = None
    with gdal_failures() as failures:
        dataset = gdal.OpenEx(path, gdal.OF_RASTER, ["GPKG"], [f"TABLE={schema.OVERVIEW}"])
        overview = None if dataset is None else _labels(dataset, parameters)
    require_unchanged_since(path, connection.state)
    if overview is None:
        reason = gdal_failure(failures[0] if failures else None)
        raise DatabaseError(
            "{path} has no overview that can be read ({reason}); build it again.", path=path, reason=reason
        )
    return overview


def _labels(dataset: gdal.Dataset, parameters: BuildParameters) -> np.ndarray:
    """Return (h, w) uint8. Raises ValueError for a raster of another size."""
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
    """A database with the data for an update.

    Attributes:
        database: The database with the landmarks' bounds; old files have no bounds.
        window_fids: Fids of the windows, in their order.
        reference_fids: Fids of the landmarks, in their order.
        state: Result of ``connection.state()`` when the database was read.
    """

    database: ReferenceDatabase
    window_fids: tuple[int, ...]
    reference_fids: tuple[int, ...]
    state: tuple

    def require_as_read(self) -> None:
        """Raise DatabaseChangedError if the database was changed since it was read."""
        require_unchanged_since(self.database.source, self.state)


def read_stored_database(path: str) -> StoredDatabase:
    """Read a database with the data for an update. Raises DatabaseError as ``read_database``."""
    with snapshot(path) as connection:
        database = _with_bounds(connection, _read(connection, path), path)
        fids = ("SELECT fid FROM windows ORDER BY fid", 'SELECT fid FROM "references" ORDER BY fid')
        window_fids, reference_fids = (tuple(chain.from_iterable(connection.execute(query))) for query in fids)
    return StoredDatabase(database, window_fids, reference_fids, connection.state)


def _with_bounds(connection: sqlite3.Connection, database: ReferenceDatabase, path: str) -> ReferenceDatabase:
    """Return a database with the bounds of its landmarks, which databases of older versions do not have."""
    bounds = _read_bounds(connection)
    if bounds is None:
        return database
    require_checksums(connection, {schema.BOUNDS: digest([bounds])})
    if len(bounds) != len(database.references):
        raise DatabaseError(
            "{path} has {count} landmarks and bounds of {bounds}; build it again.",
            path=path,
            count=len(database.references),
            bounds=len(bounds),
        )
    first, end = bounds[:, :2], bounds[:, 2:]
    size = database.parameters.map_width_px, database.parameters.map_height_px
    if not ((first >= 0) & (first < end) & (end <= size)).all():
        raise ValueError("a landmark spans pixels that the map has not")
    return replace(database, references=replace(database.references, bounds_px=bounds))


def _read_bounds(connection: sqlite3.Connection) -> np.ndarray | None:
    """Return (N, 4) int64 bounds in the order of the references' fids; None for a database of an older version."""
    found = connection.execute("SELECT count(*) FROM sqlite_master WHERE name = ?", (schema.BOUNDS,)).fetchone()
    if not found[0]:
        return None
    query = (
        'SELECT first_column, first_row, end_column, end_row FROM reference_bounds AS b JOIN "references" AS r '
        "ON r.fid = b.fid ORDER BY b.fid"
    )
    return columns_of(connection, query, lambda columns: [np.array(columns, np.int64).T])[0]


def stored_style(path: str, table: str) -> str | None:
    """Return the QML style of a table; None if it has no style or the database is damaged."""
    query = "SELECT styleQML FROM layer_styles WHERE f_table_name = ? AND length(styleQML) < ?"
    try:
        with snapshot(path) as connection:
            row = connection.execute(query, (table, limits.STYLE_CHARACTERS)).fetchone()
    except DatabaseError:
        return None
    return row[0] if row else None


def store_checksums(path: str) -> None:
    """Store the checksums of a finished database in its parameters.

    Raises:
        DatabaseError: The new database can't be read.
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
