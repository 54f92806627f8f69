"""Copy, compare and check the vector files of outputs."""

from __future__ import annotations

import contextlib
import hashlib
import sqlite3
import time
from pathlib import Path

from osgeo import gdal

from ..core.errors import ParameterError
from .gdal_errors import gdal_failures, unwritten_database

STYLE_OF_SEMREF = "Style of SemRef"
"""Description of a style in a file. Without one QGIS writes the time, and two runs would differ."""

WAIT_S = 3.0
"""How long to wait for another writer before a file counts as in use."""

_BUSY = (5, 6)
"""SQLITE_BUSY and SQLITE_LOCKED, which Python names from 3.11 on."""


def copy_whole(source: sqlite3.Connection, target: sqlite3.Connection) -> None:
    """Copy all committed content of a file into an empty one.

    Python's own copy never gives up on a file that another program keeps locked.

    Raises:
        sqlite3.OperationalError: Another program keeps the file locked.
        sqlite3.DatabaseError: The file can't be read.
        UnwritableError: The copy can't be written: the disk is full.
    """
    until = time.monotonic() + WAIT_S

    def give_up_late(status: int, _remaining: int, _total: int) -> None:
        if status in _BUSY and time.monotonic() > until:
            raise sqlite3.OperationalError("database is locked")

    try:
        source.backup(target, progress=give_up_late, sleep=0.05)
    except sqlite3.OperationalError as error:
        if "locked" in str(error):
            raise
        raise unwritten_database(error) from None


def no_place(path: str | Path, reason: str) -> ParameterError:
    """Return the error of a file or folder that can't be made."""
    return ParameterError("{path} can't be written: {reason}; choose another place.", path=path, reason=reason)


def copy_geopackage(path: str, target: str) -> None:
    """Copy a GeoPackage with all committed changes. Raises ParameterError: it can't be read."""
    try:
        closing = contextlib.closing
        with closing(sqlite3.connect(path, timeout=5)) as source, closing(sqlite3.connect(target)) as copy:
            copy_whole(source, copy)
    except sqlite3.Error as error:
        raise no_place(path, str(error)) from None


def content_digest(path: str) -> bytes:
    """Return the digest of a closed SQLite file. Opening and closing the file does not change it."""
    sha = hashlib.blake2b(digest_size=16)
    with open(path, "rb") as file:
        head = bytearray(file.read(100))
        # Skip journal mode, change counter and library version.
        for first, end in ((18, 20), (24, 28), (92, 100)):
            head[first:end] = bytes(len(head[first:end]))
        sha.update(head)
        while piece := file.read(1 << 20):
            sha.update(piece)
    return sha.digest()


def feature_count(path: str, layer: str = "") -> int:
    """Read and count all features of a layer, or of the first layer without a name; -1 if it can't be read.

    GDAL reads the file, not QGIS: QGIS keeps a file open for a minute, and Windows can't rename an open file.
    """
    dataset = None
    with gdal_failures() as failures:
        dataset = gdal.OpenEx(path, gdal.OF_VECTOR | gdal.OF_READONLY)
        found = None if dataset is None else dataset.GetLayerByName(layer) if layer else dataset.GetLayer(0)
        count = -1 if found is None else sum(1 for _ in found)
    return -1 if dataset is None or failures else count


def lacks_spatial_index(path: str) -> bool:
    """Whether a layer of a GeoPackage lacks its spatial index. On a full disk GDAL omits it without an error."""
    query = (
        "SELECT count(*) FROM gpkg_geometry_columns WHERE 'rtree_' || table_name || '_' || column_name "
        "NOT IN (SELECT name FROM sqlite_master)"
    )
    try:
        with contextlib.closing(sqlite3.connect(path)) as connection:
            return connection.execute(query).fetchone()[0] > 0
    except sqlite3.Error:
        # The file is damaged or has no geometries.
        return False


def leave_wal(path: str) -> None:
    """End WAL mode, so that no -wal and -shm files remain beside a finished file."""
    with contextlib.closing(sqlite3.connect(path)) as connection:
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        connection.execute("PRAGMA journal_mode=DELETE")
