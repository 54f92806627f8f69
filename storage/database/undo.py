"""An update that can be undone: the database as it was stays beside the new one, under a name of its own."""

from __future__ import annotations

import contextlib
import os
import shutil
import sqlite3
from pathlib import Path

from ...core.errors import DatabaseError
from ..files import Batch
from ..sqlite_copy import copy_whole

_BEFORE = "_before_update"


def file_before(path: str) -> str:
    """Where a database's state before its last update lies; whether it is there is another question."""
    whole = Path(path)
    return str(whole.with_name(f"{whole.stem}{_BEFORE}{whole.suffix}"))


def can_undo(path: str) -> bool:
    """Whether a database has its state before the last update beside it."""
    return bool(Path(path).name) and os.path.isfile(file_before(path))


def replace_keeping(path: str, updated: str) -> None:
    """Puts an updated database in the place of the old one, which is kept; both or neither.

    Args:
        path: Of the database.
        updated: A file that the update wrote elsewhere; it is removed.

    Raises:
        DatabaseError: The database can't be read.
        ParameterError: A file can't be replaced; nothing is changed.
    """
    # Not at the top: it brings GDAL, and the dock, which asks for an undo, shall open at once.
    from .connection import snapshot

    with Batch() as batch:
        kept, fresh = batch.file(file_before(path)), batch.file(path)
        with snapshot(path) as source, contextlib.closing(sqlite3.connect(kept)) as copy:
            source.rollback()
            copy_whole(source, copy)
        shutil.copyfile(updated, fresh)
        batch.commit()
    os.remove(updated)


def undo_update(path: str) -> None:
    """Puts the state before the last update back in its place.

    Raises:
        DatabaseError: There is none.
        ParameterError: The database can't be replaced; nothing is changed.
    """
    if not can_undo(path):
        raise DatabaseError("storage.no_database", path=file_before(path))
    with Batch() as batch:
        shutil.copyfile(file_before(path), batch.file(path))
        batch.commit()
    os.remove(file_before(path))
