"""Vector files that outputs are written to: what they hold, and copies of them."""

from __future__ import annotations

import contextlib
import hashlib
import sqlite3
import time

from osgeo import gdal

from ..core.errors import DatabaseError, ParameterError
from .gdal_errors import gdal_failures

STYLE_OF_SEMREF = "Style of SemRef"
"""Description of a style in a file; QGIS writes the time for none, and two runs would differ."""

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


def copy_database(path: str, target: str) -> None:
    """Copies a GeoPackage whole, with what others have committed to it, as SQLite sees it.

    Raises:
        ParameterError: When it can't be read.
    """
    try:
        closing = contextlib.closing
        with closing(sqlite3.connect(path, timeout=5)) as source, closing(sqlite3.connect(target)) as copy:
            copy_whole(source, copy)
    except sqlite3.Error as error:
        raise ParameterError(
            "{path} can't be written: {reason}; choose another place.", path=path, reason=str(error)
        ) from None


def content_digest(path: str) -> bytes:
    """Return the digest of what a closed SQLite file holds, whatever was opened and closed since: see its header."""
    sha = hashlib.blake2b(digest_size=16)
    with open(path, "rb") as file:
        head = bytearray(file.read(100))
        # Journal mode, change counter, version of the library.
        for first, end in ((18, 20), (24, 28), (92, 100)):
            head[first:end] = bytes(len(head[first:end]))
        sha.update(head)
        while piece := file.read(1 << 20):
            sha.update(piece)
    return sha.digest()


def feature_count(path: str, layer: str = "") -> int:
    """Reads all features of a layer, the file's only one without a name, and counts them; -1 where it can't be read.

    By GDAL and not by QGIS, which keeps a file open for a minute after it was read: Windows moves no open file.
    """
    dataset = None
    # It may raise or return None, as the user has set it.
    with gdal_failures() as failures:
        dataset = gdal.OpenEx(path, gdal.OF_VECTOR | gdal.OF_READONLY)
        found = None if dataset is None else dataset.GetLayerByName(layer) if layer else dataset.GetLayer(0)
        count = -1 if found is None else sum(1 for _ in found)
    return -1 if dataset is None or failures else count


def lacks_spatial_index(path: str) -> bool:
    """Whether a layer of a GeoPackage has none: on a full disk GDAL leaves it out without a word."""
    query = (
        "SELECT count(*) FROM gpkg_geometry_columns WHERE 'rtree_' || table_name || '_' || column_name "
        "NOT IN (SELECT name FROM sqlite_master)"
    )
    try:
        with contextlib.closing(sqlite3.connect(path)) as connection:
            return connection.execute(query).fetchone()[0] > 0
    except sqlite3.Error:
        # Damaged, or one of no geometry at all.
        return False


def leave_wal(path: str) -> None:
    """No -wal and -shm beside the finished file."""
    with contextlib.closing(sqlite3.connect(path)) as connection:
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        connection.execute("PRAGMA journal_mode=DELETE")
