"""Undo of the last update: the database as it was before is kept beside the new one, under a name of its own."""

from __future__ import annotations

import contextlib
import os
import shutil
import sqlite3
from collections.abc import Iterator
from pathlib import Path

from ...core.errors import DatabaseError, ParameterError
from ..atomic_output import Batch
from ..sqlite_copy import copy_whole

_BEFORE = "_before_update"


def file_before(path: str) -> str:
    """Return where a database's state before its last update is kept, whether there is one or not."""
    whole = Path(path)
    return str(whole.with_name(f"{whole.stem}{_BEFORE}{whole.suffix}"))


def can_undo(path: str) -> bool:
    """Whether a file with a database's state before its last update is there."""
    return bool(Path(path).name) and os.path.isfile(file_before(path))


def replace_keeping(path: str, updated: str) -> None:
    """Put an updated database in the place of the old one, which is kept; both or neither.

    The kept file has a table with the checksums of the updated database: only that one can be undone.

    Args:
        path: Of the database.
        updated: A file that the update wrote elsewhere; it is removed.

    Raises:
        DatabaseError: A database can't be read.
        ParameterError: A file can't be replaced; nothing is changed.
    """
    # Not at the top: it brings GDAL, and the dock, which asks whether there is an undo, shall open at once.
    from .schema import TABLES

    made = _checksums(updated)
    _require_kept_by_us(file_before(path))
    with Batch() as batch:
        kept = batch.file(file_before(path), tables=(*TABLES, "semref_undo"))
        fresh = batch.file(path, tables=TABLES)
        with _copied(path, kept) as copy:
            copy.execute("DROP TABLE IF EXISTS semref_undo")
            copy.execute("CREATE TABLE semref_undo (checksums TEXT)")
            copy.execute("INSERT INTO semref_undo VALUES (?)", (made,))
        shutil.copyfile(updated, fresh)
        batch.commit()
    os.remove(updated)


def undo_update(path: str) -> None:
    """Put the state before the last update back in its place, once it is read and checked whole.

    Raises:
        DatabaseError: There is none, it is damaged, or the database was changed after that update.
        ParameterError: The database can't be replaced; nothing is changed.
    """
    # Not at the top: it brings GDAL, and the dock, which asks whether there is an undo, shall open at once.
    from .reader import read_overview, read_stored_database
    from .schema import TABLES

    before = file_before(path)
    stored = read_stored_database(before)
    read_overview(before)
    with Batch() as batch:
        with _copied(before, batch.file(path, tables=TABLES)) as copy:
            copy.execute("CREATE TABLE IF NOT EXISTS semref_undo (checksums TEXT)")
            if copy.execute("SELECT checksums FROM semref_undo").fetchall() != [(_checksums(path),)]:
                raise DatabaseError(
                    "{path} was changed after the update that {before} belongs to, so that update can't be undone. To "
                    "go back further, open {before} itself.",
                    path=path,
                    before=before,
                )
            copy.execute("DROP TABLE semref_undo")
        stored.require_as_read()
        batch.commit()
    with contextlib.suppress(OSError):
        os.remove(before)


def _require_kept_by_us(before: str) -> None:
    """Raise ParameterError for a file of the user under the name that the kept database will have."""
    if os.path.isfile(before):
        try:
            with contextlib.closing(sqlite3.connect(f"{Path(before).resolve().as_uri()}?mode=ro", uri=True)) as kept:
                kept.execute("SELECT checksums FROM semref_undo").fetchall()
        except sqlite3.Error:
            raise ParameterError(
                "{path} was not made by an update of SemRef, and the update would replace it. Move it elsewhere and "
                "update again.",
                path=before,
            ) from None


def _checksums(path: str) -> str | None:
    """Return the checksums of a database's tables as it states them; None for one of an older version."""
    from .connection import snapshot

    with snapshot(path) as connection:
        row = connection.execute("SELECT value FROM parameters WHERE key = 'checksums'").fetchone()
    return row[0] if row else None


@contextlib.contextmanager
def _copied(path: str, target: str) -> Iterator[sqlite3.Connection]:
    """Copy a whole database and yield a connection to edit the copy; raises DatabaseError."""
    from .connection import snapshot

    with contextlib.closing(sqlite3.connect(target, isolation_level=None)) as copy:
        with snapshot(path) as source:
            source.rollback()
            copy_whole(source, copy)
        try:
            copy.execute("PRAGMA journal_mode=DELETE")
            yield copy
        except sqlite3.Error as error:
            raise DatabaseError("The database can't be written: {reason}.", reason=str(error)) from None
