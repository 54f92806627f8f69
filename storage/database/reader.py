"""Reading a reference database with SQLite alone."""

from __future__ import annotations

import contextlib
import csv
import io
import json
import os
import sqlite3
import struct
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from osgeo import gdal

from ...core.database.model import MapLandmarks, ReferenceDatabase, Windows, first_pixels_of
from ...core.database.parameters import BuildParameters, build_parameters
from ...core.errors import DatabaseError
from ...core.labels.class_table import class_table_from_csv
from ..gdal_errors import gdal_failure, gdal_failures
from . import schema


def read_database(path: str, with_overview: bool = False) -> ReferenceDatabase:
    """Reads a reference database. Raises DatabaseError for files that are missing, foreign, truncated or too new."""
    if not os.path.isfile(path):
        raise DatabaseError("storage.no_database", path=path)
    try:
        with contextlib.closing(_connect(path)) as connection:
            _check_is_ours(connection, path)
            parameters = _read_parameters(connection, path)
            table = class_table_from_csv(_class_csv(connection), f"the class table of {path}")
            windows = _read_windows(connection, parameters, path)
            references = _read_references(connection)
    except (sqlite3.Error, TypeError, ValueError, IndexError, struct.error) as error:
        raise DatabaseError("storage.database_damaged", path=path, reason=str(error)) from None
    overview = read_overview(path) if with_overview else None
    return ReferenceDatabase(windows, references, table, parameters, path, overview)


def read_overview(path: str) -> np.ndarray:
    """(h, w) uint8 class values. Raises DatabaseError for a database that has none."""
    # Left as it is where GDAL raises.
    overview = None
    with gdal_failures() as failures:
        dataset = gdal.OpenEx(f"GPKG:{path}:{schema.OVERVIEW}", gdal.OF_RASTER)
        overview = None if dataset is None else dataset.GetRasterBand(1).ReadAsArray()
    if overview is None:
        reason = gdal_failure(failures[0] if failures else None)
        raise DatabaseError("storage.no_readable_overview", path=path, reason=reason)
    return overview


def _connect(path: str) -> sqlite3.Connection:
    with open(path, "rb") as file:
        header = file.read(100)
    if not header.startswith(b"SQLite format 3\0"):
        raise DatabaseError("storage.no_geopackage", path=path)
    # SQLite notices missing pages only when it comes to them.
    page_size, pages = struct.unpack_from(">16xH10xI", header.ljust(100, b"\0"))
    if os.path.getsize(path) < pages * (page_size if page_size > 1 else 65536):
        raise ValueError("its end is missing")
    wal = Path(path + "-wal")
    # Without changes in waiting the file is read as it is, so that read-only places work and no -shm appears.
    quiet = "" if wal.exists() and wal.stat().st_size else "&immutable=1"
    return sqlite3.connect(f"{Path(path).resolve().as_uri()}?mode=ro{quiet}", uri=True)


def _check_is_ours(connection: sqlite3.Connection, path: str) -> None:
    found = {row[0] for row in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
    missing = [
        name for name in (schema.WINDOWS, schema.REFERENCES, schema.CLASSES, schema.PARAMETERS) if name not in found
    ]
    if missing:
        raise DatabaseError("storage.foreign_database", path=path, missing=missing)


def _read_parameters(connection: sqlite3.Connection, path: str) -> BuildParameters:
    stored = connection.execute("SELECT key, value FROM parameters").fetchall()
    try:
        return build_parameters({key: json.loads(value) for key, value in stored}, path)
    except (KeyError, ValueError, TypeError) as error:
        raise DatabaseError("storage.no_readable_parameter", path=path, reason=str(error)) from None


def _class_csv(connection: sqlite3.Connection) -> str:
    rows = connection.execute("SELECT value, name, color, role, draw_order, hsv_min, hsv_max FROM classes").fetchall()
    text = io.StringIO()
    writer = csv.writer(text)
    writer.writerow(schema.CLASS_COLUMNS)
    writer.writerows(["" if cell is None else cell for cell in row] for row in rows)
    return text.getvalue()


def _read_windows(connection: sqlite3.Connection, parameters: BuildParameters, path: str) -> Windows:
    rows = connection.execute(
        "SELECT level, size, center_x, center_y, reference_count, vector, distinctiveness FROM windows ORDER BY fid"
    ).fetchall()
    levels, sizes, xs, ys, counts, blobs, distinctiveness = zip(*rows) if rows else ((),) * 7
    length = 3 * parameters.references_per_vector
    if any(blob is not None and len(blob) != 4 * length for blob in blobs):
        raise DatabaseError("storage.vector_length", path=path, length=length)
    sizes, *centers = np.array([sizes, xs, ys], np.float64)
    centers = np.column_stack(centers)
    if not (np.isfinite(sizes).all() and np.isfinite(centers).all()):
        raise ValueError("a window has no place or size")
    vectors = np.zeros((len(rows), length), np.float32)
    for i, blob in enumerate(blobs):
        if blob is not None:
            vectors[i] = np.frombuffer(blob, "<f4")
    return Windows(
        first_pixels_of(centers, sizes, parameters.frame),
        np.array(levels, np.int64),
        sizes,
        centers,
        np.array(counts, np.int64),
        vectors,
        np.array([blob is not None for blob in blobs], bool),
        # NULL becomes NaN.
        np.array(distinctiveness, np.float64),
    )


def _read_references(connection: sqlite3.Connection) -> MapLandmarks:
    rows = connection.execute('SELECT geom, class, area, touches_edge FROM "references" ORDER BY fid').fetchall()
    blobs, classes, areas, touches = zip(*rows) if rows else ((),) * 4
    return MapLandmarks(
        _points(blobs), np.array(classes, np.uint8), np.array(areas, np.float64), np.array(touches, bool)
    )


def _points(blobs: Sequence[bytes]) -> np.ndarray:
    """GeoPackage point blobs (8-byte header without envelope, then WKB) → (N, 2)."""
    found: list[tuple[float, float]] = []
    for blob in blobs:
        order = "<" if blob[8] else ">"
        found.append(struct.unpack_from(f"{order}dd", blob, 13))
    return np.array(found, np.float64).reshape(-1, 2)


@dataclass(frozen=True)
class StoredDatabase:
    """A database as an update needs it.

    Attributes:
        database: With the landmarks' bounds, None when the file has none.
        window_fids, reference_fids: Of its windows and landmarks, in their order.
    """

    database: ReferenceDatabase
    window_fids: tuple[int, ...]
    reference_fids: tuple[int, ...]


def read_stored_database(path: str) -> StoredDatabase:
    """Reads what ``read_database`` reads and what an update needs besides; raises DatabaseError as that does."""
    database = read_database(path)
    try:
        with contextlib.closing(_connect(path)) as connection:
            window_fids = connection.execute("SELECT fid FROM windows ORDER BY fid").fetchall()
            fids = connection.execute('SELECT fid FROM "references" ORDER BY fid').fetchall()
            bounds = _read_bounds(connection)
    except (sqlite3.Error, ValueError) as error:
        raise DatabaseError("storage.database_damaged", path=path, reason=str(error)) from None
    if bounds is not None and len(bounds) != len(fids):
        raise DatabaseError("storage.bounds_count", path=path, count=len(fids), bounds=len(bounds))
    database = replace(database, references=replace(database.references, bounds_px=bounds))
    return StoredDatabase(database, tuple(fid for (fid,) in window_fids), tuple(fid for (fid,) in fids))


def _read_bounds(connection: sqlite3.Connection) -> np.ndarray | None:
    """(N, 4) int64 bounds of the references in the order of their fids; None in databases of older versions."""
    found = connection.execute("SELECT count(*) FROM sqlite_master WHERE name = ?", (schema.BOUNDS,)).fetchone()
    if not found[0]:
        return None
    rows = connection.execute(
        'SELECT first_column, first_row, end_column, end_row FROM reference_bounds AS b JOIN "references" AS r '
        "ON r.fid = b.fid ORDER BY b.fid"
    ).fetchall()
    return np.array(rows, np.int64).reshape(-1, 4)


def stored_style(path: str, table: str) -> str | None:
    """QML of the style of one table of a database, None when it has none."""
    try:
        with contextlib.closing(_connect(path)) as connection:
            row = connection.execute("SELECT styleQML FROM layer_styles WHERE f_table_name = ?", (table,)).fetchone()
    except (sqlite3.Error, ValueError):
        return None
    return row[0] if row else None


def copy_database(path: str, target: str) -> None:
    """Copies a database as it is, changes that still wait beside it included."""
    with contextlib.closing(_connect(path)) as source, contextlib.closing(sqlite3.connect(target)) as copy:
        source.backup(copy)


def leave_wal(path: str) -> None:
    """No -wal and -shm beside the finished file."""
    with contextlib.closing(sqlite3.connect(path)) as connection:
        connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        connection.execute("PRAGMA journal_mode=DELETE")
