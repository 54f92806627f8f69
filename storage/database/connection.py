"""THE way a database is opened for reading: with a lock, its journals seen, its own code never run."""

from __future__ import annotations

import contextlib
import os
import sqlite3
import struct
from collections.abc import Iterator, Sequence
from pathlib import Path

from osgeo import gdal

from ...core.errors import DatabaseError, DatabaseInUseError, reason_of
from ..vector_files import WAIT_S
from . import schema

_WAL_VERSION = 2
"""Read and write version in the header of a database whose changes wait in a -wal."""

_COLUMNS = {
    schema.WINDOWS: schema.WINDOW_FIELDS,
    schema.REFERENCES: schema.REFERENCE_FIELDS,
    schema.CLASSES: schema.CLASS_FIELDS,
    schema.PARAMETERS: schema.PARAMETER_FIELDS,
}


class DatabaseChangedError(DatabaseError):
    """A database was replaced or written to between two looks at it."""


class Snapshot(sqlite3.Connection):
    """A connection to one state of a database.

    Attributes:
        state: ``state`` of the database before it was opened.
    """

    state: tuple = ()


@contextlib.contextmanager
def snapshot(path: str) -> Iterator[Snapshot]:
    """One state of a reference database, whatever others write to it while the block runs.

    What a killed writer left half done is rolled back first, as SQLite does it; where that can't be, or where another
    program is writing, the file is refused. Functions in the schema of the file are not trusted, and tables that are
    views, virtual or have generated columns are none of ours.

    Raises:
        DatabaseError: The file is missing, foreign, in use, or damaged, whatever the block stumbles over in it.
    """
    if not os.path.isfile(path):
        raise no_database(path)
    try:
        with contextlib.closing(_connected(path)) as connection:
            connection.execute("PRAGMA trusted_schema=OFF")
            connection.execute("PRAGMA cell_size_check=ON")
            connection.execute("BEGIN")
            _require_our_tables(connection, path)
            yield connection
            connection.rollback()
    except sqlite3.OperationalError as error:
        # Python tells SQLite's codes from 3.11 on only.
        if "locked" in str(error):
            raise DatabaseInUseError("{path} is being written by another program; try again.", path=path) from None
        if "readonly" in str(error) or "unable to open" in str(error):
            raise DatabaseError(
                "{path} was left half written by another program and can't be mended where it lies; copy it with the "
                "file {path}-journal or {path}-wal to a place where you may write.",
                path=path,
            ) from None
        raise damaged(path, error) from None
    except OSError as error:
        raise damaged(path, reason_of(error)) from None
    except _DAMAGES as error:
        raise damaged(path, error) from None


_DAMAGES = (
    sqlite3.Error,
    sqlite3.Warning,
    TypeError,
    ValueError,
    LookupError,
    AttributeError,
    OverflowError,
    MemoryError,
    RecursionError,
    struct.error,
)
"""What reading stumbles over where a file holds something else than it should."""

_LONGEST_REASON = 200


def no_database(path: str) -> DatabaseError:
    """The error for a path without a file, or for none."""
    if not path.strip():
        return DatabaseError("No database is named; build one or choose a file.")
    return DatabaseError("There is no database {path}; build one or choose another file.", path=path)


def damaged(path: str, reason: object) -> DatabaseError:
    """The error for a database whose content can't be what SemRef wrote."""
    text = " ".join(str(reason).split()).rstrip(".") or type(reason).__name__
    return DatabaseError(
        "{path} is damaged or cut short ({reason}); build it again or fetch another copy.",
        path=path,
        reason=text[:_LONGEST_REASON],
    )


def state(path: str) -> tuple:
    """What is another after every change of a database's files."""
    stats = [os.stat(name) for name in (path, f"{path}-wal") if os.path.exists(name)]
    return tuple((found.st_mtime_ns, found.st_size, found.st_ino) for found in stats)


def require_unchanged_since(path: str, then: tuple) -> None:
    """Raises DatabaseChangedError where a database's files are others than when ``state`` was ``then``."""
    try:
        is_same = state(path) == then
    except OSError:
        is_same = False
    if not is_same:
        raise DatabaseChangedError("{path} was changed by another program meanwhile; try again.", path=path)


def open_table(path: str, table: str, kind: int, options: Sequence[str] = ()) -> gdal.Dataset | None:
    """One table of a GeoPackage by GDAL, whatever characters its path has; None or RuntimeError where it can't."""
    return gdal.OpenEx(path, kind, ["GPKG"], [f"TABLE={table}", *options])


def _connected(path: str) -> Snapshot:
    # Before, as it may be replaced at any moment.
    found = state(path)
    with open(path, "rb") as file:
        header = file.read(100).ljust(100, b"\0")
    if not header.startswith(b"SQLite format 3\0"):
        raise DatabaseError(
            "{path} is not a GeoPackage; choose a database made by “Build reference database”.", path=path
        )
    # SQLite notices missing pages only when it comes to them.
    page_size, read_version, pages = struct.unpack_from(">16xHxB8xI", header)
    if os.path.getsize(path) < pages * (page_size if page_size > 1 else 65536):
        raise ValueError("its end is missing")
    journals = [name for name in (f"{path}-journal", f"{path}-wal") if os.path.exists(name) and os.path.getsize(name)]
    may_write = os.access(path, os.W_OK) and os.access(os.path.dirname(os.path.abspath(path)), os.W_OK)
    if may_write and (journals or read_version == _WAL_VERSION):
        # Rolls a hot journal back, and leaves no -wal and -shm behind that a reader who may not write has to leave.
        mode = "rw"
    elif read_version == _WAL_VERSION and not journals and not may_write:
        # Nobody can write here and nothing waits: SQLite would ask for a -shm that it can't make.
        mode = "ro&immutable=1"
    else:
        mode = "ro"
    uri = f"{Path(path).resolve().as_uri()}?mode={mode}"
    connection = sqlite3.connect(uri, uri=True, timeout=WAIT_S, isolation_level=None, factory=Snapshot)
    connection.state = found
    return connection


def _require_our_tables(connection: sqlite3.Connection, path: str) -> None:
    """Raises DatabaseError unless the tables that are read are plain ones with the columns that they should have."""
    rows = connection.execute("SELECT name, sql FROM sqlite_master WHERE type = 'table'").fetchall()
    plain = {name for name, sql in rows if sql and not sql.lstrip().upper().startswith("CREATE VIRTUAL")}
    missing = [name for name in _COLUMNS if name not in plain]
    if missing:
        raise DatabaseError(
            "{path} is not a SemRef reference database (it lacks {missing}); choose one made by “Build reference "
            "database”.",
            path=path,
            missing=missing,
        )
    for table in (*_COLUMNS, schema.BOUNDS, schema.OVERVIEW):
        columns = connection.execute("SELECT name, hidden FROM pragma_table_xinfo(?)", (table,)).fetchall()
        if any(hidden for _, hidden in columns):
            raise ValueError(f"{table} has columns that are computed")
        lacking = {name for name, _ in _COLUMNS.get(table, ())} - {name for name, _ in columns}
        if lacking:
            raise ValueError(f"{table} lacks {', '.join(sorted(lacking))}")
