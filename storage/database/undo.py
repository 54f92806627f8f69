"""Undo the last update: the database before the update is kept beside the new one as the undo copy."""

from __future__ import annotations

import contextlib
import os
import shutil
import sqlite3
from collections.abc import Iterator
from pathlib import Path

from ...core.errors import DatabaseError, ParameterError
from ..atomic_output import Batch
from ..gdal_errors import unwritten_database
from ..vector_files import WAIT_S, copy_whole

_BEFORE = "_before_update"


def file_before(path: str) -> str:
    """Return the path of a database's undo copy, which may not exist."""
    whole = Path(path)
    return str(whole.with_name(f"{whole.stem}{_BEFORE}{whole.suffix}"))


def can_undo(path: str) -> bool:
    """Whether a database has an undo copy."""
    return bool(Path(path).name) and os.path.isfile(file_before(path))


def replace_keeping(path: str, updated: str, of: str | None = None) -> str | None:
    """Replace a database by its updated version and keep the old one as the undo copy; both or neither.

    On file systems with hard links the old file itself becomes the undo copy. The undo copy has a table with the
    checksums of the updated database: only that database can be undone.

    Args:
        updated: The updated database in another file, which is moved.
        of: ``stated_checksums`` of the database when the update was planned; None to skip the comparison.

    Returns:
        ``stated_checksums`` of the updated database.

    Raises:
        DatabaseError: A database can't be read.
        ParameterError: A file can't be replaced; nothing is changed.
    """
    # Imported here: the dock calls can_undo and must open without loading GDAL.
    from .connection import DatabaseChangedError
    from .schema import TABLES

    made = stated_checksums(updated)
    if of is not None and stated_checksums(path) != of:
        raise DatabaseChangedError("{path} was changed by another program meanwhile; try again.", path=path)
    _require_kept_by_us(file_before(path))
    with Batch() as batch:
        kept, fresh = (batch.file(target, tables=(*TABLES, "semref_undo")) for target in (file_before(path), path))
        if not _link(path, kept, made):
            with _editable_copy(path, kept) as copy:
                _store_checksums(copy, made)
        shutil.move(updated, fresh)
        try:
            batch.commit()
        except BaseException:
            _unmark(path, kept)
            raise
    return made


def undo_update(path: str) -> None:
    """Replace a database by its undo copy after checking the copy.

    Raises:
        DatabaseError: There is no undo copy, it is damaged, or the database was changed after that update.
        ParameterError: The database can't be replaced; nothing is changed.
    """
    # Imported here: the dock calls can_undo and must open without loading GDAL.
    from .reader import read_overview, read_stored_database
    from .schema import TABLES

    before = file_before(path)
    stored = read_stored_database(before)
    read_overview(before)
    with Batch() as batch:
        with _editable_copy(before, batch.file(path, tables=TABLES)) as copy:
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


def _store_checksums(kept: sqlite3.Connection, made: str | None) -> None:
    kept.execute("DROP TABLE IF EXISTS semref_undo")
    kept.execute("CREATE TABLE semref_undo (checksums TEXT)")
    kept.execute("INSERT INTO semref_undo VALUES (?)", (made,))


def _link(path: str, kept: str, made: str | None) -> bool:
    """Make the undo copy a hard link of the old database. Returns False if a copy is needed.

    A copy is needed if the database is a link, has other names, is in use or read-only, or without hard links.
    """
    if os.path.islink(path) or os.stat(path).st_nlink > 1:
        return False
    try:
        with _writable(path) as own:
            if own.execute("PRAGMA journal_mode=DELETE").fetchone() != ("delete",):
                return False
            own.execute("BEGIN IMMEDIATE")
            _store_checksums(own, made)
            own.execute("COMMIT")
        os.link(path, kept)
    except (OSError, sqlite3.Error):
        return False
    return True


def _unmark(path: str, kept: str) -> None:
    """Remove the table of ``_link`` from the old database, which was not replaced."""
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
    """Raise ParameterError if a file with the name of the undo copy is not an undo copy."""
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
    """Return the stored checksums of a database as text; None for a database of an older version."""
    from .connection import snapshot

    with snapshot(path) as connection:
        row = connection.execute("SELECT value FROM parameters WHERE key = 'checksums'").fetchone()
    return row[0] if row else None


@contextlib.contextmanager
def _editable_copy(path: str, target: str) -> Iterator[sqlite3.Connection]:
    """Copy a database and yield a connection to the copy. Raises UnwritableError."""
    from .connection import snapshot

    with contextlib.closing(sqlite3.connect(target, isolation_level=None)) as copy:
        with snapshot(path) as source:
            source.rollback()
            copy_whole(source, copy)
        try:
            copy.execute("PRAGMA journal_mode=DELETE")
            yield copy
        except sqlite3.Error as error:
            raise unwritten_database(error) from None
