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
from ..vector_files import WAIT_S, copy_whole

_BEFORE = "_before_update"


def file_before(path: str) -> str:
    """Return where a database's state before its last update is kept, whether there is one or not."""
    whole = Path(path)
    return str(whole.with_name(f"{whole.stem}{_BEFORE}{whole.suffix}"))


def can_undo(path: str) -> bool:
    """Whether a file with a database's state before its last update is there."""
    return bool(Path(path).name) and os.path.isfile(file_before(path))


def replace_keeping(path: str, updated: str, of: str | None = None) -> str | None:
    """Put an updated database in the place of the old one, which is kept; both or neither.

    The old file itself becomes the kept one where the file system has hard links, and a copy of it elsewhere. The kept
    file has a table with the checksums of the updated database: only that one can be undone.

    Args:
        updated: A file that the update wrote elsewhere, best in a folder beside the database; it is moved.
        of: ``stated_checksums`` of the database when the update was planned; None not to compare them.

    Returns:
        ``stated_checksums`` of the updated database.

    Raises:
        DatabaseError: A database can't be read.
        ParameterError: A file can't be replaced; nothing is changed.
    """
    # Not at the top: it brings GDAL, and the dock, which asks whether there is an undo, shall open at once.
    from .connection import DatabaseChangedError
    from .schema import TABLES

    made = stated_checksums(updated)
    if of is not None and stated_checksums(path) != of:
        raise DatabaseChangedError("{path} was changed by another program meanwhile; try again.", path=path)
    _require_kept_by_us(file_before(path))
    with Batch() as batch:
        kept, fresh = (batch.file(target, tables=(*TABLES, "semref_undo")) for target in (file_before(path), path))
        if not _linked(path, kept, made):
            with _copied(path, kept) as copy:
                _state(copy, made)
        shutil.move(updated, fresh)
        try:
            batch.commit()
        except BaseException:
            _forget_linked(path, kept)
            raise
    return made


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
            if copy.execute("SELECT checksums FROM semref_undo").fetchall() != [(stated_checksums(path),)]:
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


def _state(kept: sqlite3.Connection, made: str | None) -> None:
    """Write into the database of before which one followed it."""
    kept.execute("DROP TABLE IF EXISTS semref_undo")
    kept.execute("CREATE TABLE semref_undo (checksums TEXT)")
    kept.execute("INSERT INTO semref_undo VALUES (?)", (made,))


def _linked(path: str, kept: str, made: str | None) -> bool:
    """Give the old database its second name; False where a copy is needed.

    That is where it is a link itself, has other names already, is in use, can't be written or has no hard links.
    """
    if os.path.islink(path) or os.stat(path).st_nlink > 1:
        return False
    try:
        with _writable(path) as own:
            if own.execute("PRAGMA journal_mode=DELETE").fetchone() != ("delete",):
                return False
            own.execute("BEGIN IMMEDIATE")
            _state(own, made)
            own.execute("COMMIT")
        os.link(path, kept)
    except (OSError, sqlite3.Error):
        return False
    return True


def _forget_linked(path: str, kept: str) -> None:
    """Take out of the old database what ``_linked`` wrote, as it is not replaced."""
    with contextlib.suppress(OSError, sqlite3.Error):
        if os.path.samefile(path, kept):
            with _writable(path) as own:
                own.execute("DROP TABLE IF EXISTS semref_undo")


def _writable(path: str) -> contextlib.closing[sqlite3.Connection]:
    uri = f"{Path(path).resolve().as_uri()}?mode=rw"
    own = sqlite3.connect(uri, uri=True, timeout=WAIT_S, isolation_level=None)
    own.execute("PRAGMA trusted_schema=OFF")
    return contextlib.closing(own)


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


def stated_checksums(path: str) -> str | None:
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
