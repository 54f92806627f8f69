"""Open databases for reading: with a lock, with their journals, and without running code in the file."""

from __future__ import annotations

import contextlib
import os
import sqlite3
import struct
from collections.abc import Iterator
from pathlib import Path

from ...core.errors import DatabaseError, DatabaseInUseError, reason_of
from ..vector_files import WAIT_S
from . import schema

_WAL_VERSION = 2
"""Read and write version in the header of a database in WAL mode."""

_COLUMNS = {
    schema.WINDOWS: schema.WINDOW_FIELDS,
    schema.REFERENCES: schema.REFERENCE_FIELDS,
    schema.CLASSES: schema.CLASS_FIELDS,
    schema.PARAMETERS: schema.PARAMETER_FIELDS,
}


class DatabaseChangedError(DatabaseError):
    """A database was replaced or written to between two reads."""


class Snapshot(sqlite3.Connection):
    """A connection to one state of a database.

    Attributes:
        state: Result of ``state()`` before the database was opened.
    """

    state: tuple = ()


@contextlib.contextmanager
def snapshot(path: str) -> Iterator[Snapshot]:
    """Open one state of a reference database; changes by other programs do not appear in the block.

    SQLite first rolls back the changes of a killed writer. If this fails, or another program is writing, the file is
    refused. Functions in its schema are not trusted. Views, virtual tables and generated columns are refused.

    Raises:
        DatabaseError: The file is missing, foreign, in use or damaged, including errors of reading in the block.
    """
    if not os.path.isfile(path):
        raise no_database(path)
    try:
        with contextlib.closing(_connect(path)) as connection:
            connection.execute("PRAGMA trusted_schema=OFF")
            connection.execute("PRAGMA cell_size_check=ON")
            connection.execute("BEGIN")
            _require_our_tables(connection, path)
            yield connection
            connection.rollback()
    except sqlite3.OperationalError as error:
        # Python has SQLite's error codes only from 3.11 on.
        if "locked" in str(error):
            raise DatabaseInUseError("{path} is being written by another program; try again.", path=path) from None
        if "readonly" in str(error) or "unable to open" in str(error):
            raise DatabaseError(
                "{path} was not completely written by another program, and its folder is read-only. Copy it together "
                "with {path}-journal or {path}-wal to a folder with write permission.",
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
"""Errors of reading a file with unexpected content."""

_LONGEST_REASON = 200


def no_database(path: str) -> DatabaseError:
    """Return the error for a path without a file, or for an empty path."""
    if not path.strip():
        return DatabaseError("No database is named; build one or choose a file.")
    return DatabaseError("There is no database {path}; build one or choose another file.", path=path)


def damaged(path: str, reason: object) -> DatabaseError:
    """Return the error for a database with damaged content."""
    text = " ".join(str(reason).split()).rstrip(".") or type(reason).__name__
    return DatabaseError(
        "{path} is damaged or cut short ({reason}); build it again or fetch another copy.",
        path=path,
        reason=text[:_LONGEST_REASON],
    )


def state(path: str) -> tuple:
    """Return a value that differs after every change of a database's files."""
    stats = [os.stat(name) for name in (path, f"{path}-wal") if os.path.exists(name)]
    return tuple((found.st_mtime_ns, found.st_size, found.st_ino) for found in stats)


def require_unchanged_since(path: str, then: tuple) -> None:
    """Raise DatabaseChangedError if a database's files changed since ``state`` returned ``then``."""
    try:
        is_same = state(path) == then
    except OSError:
        is_same = False
    if not is_same:
        raise DatabaseChangedError("{path} was changed by another program meanwhile; try again.", path=path)


def _connect(path: str) -> Snapshot:
    # Before opening: the file may be replaced at any moment.
    found = state(path)
    with open(path, "rb") as file:
        header = file.read(100).ljust(100, b"\0")
    if not header.startswith(b"SQLite format 3\0"):
        raise DatabaseError(
            "{path} is not a GeoPackage; choose a database made by “Build reference database”.", path=path
        )
    # SQLite notices missing pages only when it reads them.
    page_size, read_version, pages = struct.unpack_from(">16xHxB8xI", header)
    if os.path.getsize(path) < pages * (page_size if page_size > 1 else 65536):
        raise ValueError("its end is missing")
    journals = [name for name in (f"{path}-journal", f"{path}-wal") if os.path.exists(name) and os.path.getsize(name)]
    may_write = os.access(path, os.W_OK) and os.access(os.path.dirname(os.path.abspath(path)), os.W_OK)
    if may_write and (journals or read_version == _WAL_VERSION):
        # Rolls back a hot journal. A read-only connection would leave -wal and -shm files.
        mode = "rw"
    elif read_version == _WAL_VERSION and not journals and not may_write:
        # A read-only folder without pending changes: SQLite could not create its -shm file.
        mode = "ro&immutable=1"
    else:
        mode = "ro"
    uri = f"{Path(path).resolve().as_uri()}?mode={mode}"
    connection = sqlite3.connect(uri, uri=True, timeout=WAIT_S, isolation_level=None, factory=Snapshot)
    connection.state = found
    return connection


def _require_our_tables(connection: sqlite3.Connection, path: str) -> None:
    """Raise DatabaseError unless all tables are plain and have their columns."""
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
