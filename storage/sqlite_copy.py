"""A copy of a whole SQLite file, as SQLite sees it."""

from __future__ import annotations

import sqlite3
import time

from ..core.errors import DatabaseError

WAIT_S = 3.0
"""How long a writer may take to finish before a file is said to be in use."""

_BUSY = (5, 6)
"""SQLITE_BUSY and SQLITE_LOCKED; Python names them from 3.11 on."""


def copy_whole(source: sqlite3.Connection, target: sqlite3.Connection) -> None:
    """Copies all that is committed to a file into an empty one.

    Python's own copy asks a file that another program keeps locked again and again, for good.

    Raises:
        sqlite3.OperationalError: Another program keeps the file locked.
        sqlite3.DatabaseError: The file can't be read.
        DatabaseError: The copy can't be written: the disk is full.
    """
    until = time.monotonic() + WAIT_S

    def give_up_late(status: int, _remaining: int, _total: int) -> None:
        if status in _BUSY and time.monotonic() > until:
            # As Python words it elsewhere.
            raise sqlite3.OperationalError("database is locked")

    try:
        source.backup(target, progress=give_up_late, sleep=0.05)
    except sqlite3.OperationalError as error:
        if "locked" in str(error):
            raise
        raise DatabaseError("The database can't be written: {reason}.", reason=str(error)) from None
