"""Compute and check the checksums of a database's tables, so that a damaged database is refused."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterator, Mapping
from itertools import chain

import numpy as np

from ...core.cache import digest
from ...core.database.model import MapLandmarks, Windows
from ...core.values import read_json
from . import schema

CHECKSUMS = "checksums"
"""Parameter with the JSON of SHA-256 by table. Databases of older versions have no checksums."""


def checksums_of(connection: sqlite3.Connection, windows: Windows, landmarks: MapLandmarks) -> dict[str, str]:
    """Return SHA-256 by table of the columns that localization reads (docs/reference/file_formats.md)."""
    distinct = windows.distinctiveness
    numbers = (
        windows.levels,
        windows.sizes,
        windows.centers,
        windows.counts,
        windows.vectors,
        windows.described,
        # All NaN get the same bits.
        np.where(np.isnan(distinct), np.nan, distinct),
    )
    return {
        schema.WINDOWS: digest(_little_endian(column) for column in numbers),
        schema.REFERENCES: digest(
            _little_endian(column)
            for column in (landmarks.positions, landmarks.classes, landmarks.areas_m2, landmarks.touches_edge)
        ),
        schema.CLASSES: _text_digest(
            connection, "SELECT value, name, color, role, draw_order, hsv_min, hsv_max FROM classes ORDER BY fid"
        ),
        schema.PARAMETERS: _text_digest(
            connection, "SELECT key, value FROM parameters WHERE key <> 'checksums' ORDER BY key, value"
        ),
    }


def overview_checksum(connection: sqlite3.Connection) -> str:
    """Return SHA-256 of the overview's stored tiles and their matrix."""
    tiles = connection.execute(
        "SELECT zoom_level, tile_column, tile_row, tile_data FROM overview ORDER BY zoom_level, tile_column, tile_row"
    )
    # Lazily: the tiles of a continent don't fit into memory.
    columns = (
        part
        for zoom, column, row, data in tiles
        for part in (np.array([zoom, column, row], "<i8"), data if isinstance(data, bytes) else repr(data).encode())
    )
    matrix = connection.execute(
        "SELECT zoom_level, matrix_width, matrix_height, tile_width, tile_height, pixel_x_size, pixel_y_size "
        "FROM gpkg_tile_matrix WHERE table_name = 'overview' ORDER BY zoom_level"
    )
    return digest(chain(columns, [repr(matrix.fetchall()).encode()]))


_SHOWN_ROWS = {
    # Column by column: all columns of ten million windows are gigabytes.
    "windows rows": (
        "SELECT fid FROM windows ORDER BY fid",
        "SELECT level FROM windows ORDER BY fid",
        "SELECT reference_count FROM windows ORDER BY fid",
        "SELECT longitude FROM windows ORDER BY fid",
        "SELECT latitude FROM windows ORDER BY fid",
        "SELECT name FROM windows ORDER BY fid",
        "SELECT geom FROM windows ORDER BY fid",
    ),
    "references rows": (
        'SELECT class, touches_edge, class_name, count(*), min(fid), max(fid), total(fid) FROM "references" '
        "GROUP BY 1, 2, 3 ORDER BY 1, 2, 3",
        "SELECT min(substr(geom, 1, 13)), max(substr(geom, 1, 13)), min(length(geom)), max(length(geom)) "
        'FROM "references"',
    ),
    "reference_bounds rows": ("SELECT count(*), min(fid), max(fid), total(fid) FROM reference_bounds",),
}
"""Queries for the data that ``checksums_of`` omits. Landmarks are many, so they are summarized by class.

Databases have these checksums from version 1.4 on: all or none of them.
"""

_NUMBERS = {int, float, type(None)}


def shown_checksums(connection: sqlite3.Connection) -> dict[str, str]:
    """Return SHA-256 by name of the data that only QGIS shows.

    GeoPackage's own tables, spatial indexes and styles have no checksums: versions of QGIS and GDAL write them
    differently for the same map, and users change them in QGIS.
    """
    tables = {name for (name,) in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
    found = {}
    for name, queries in _SHOWN_ROWS.items():
        # The first versions had no bounds.
        if name.split()[0] in tables:
            # Column by column takes a tenth of the time of row by row.
            columns = (column for query in queries for column in _columns(connection, query))
            found[name] = digest(part for column in columns for part in _column(column))
    return found


def _columns(connection: sqlite3.Connection, query: str) -> list[list]:
    """Return the columns of all rows; none without rows."""
    cursor = connection.execute(query)
    values, width = list(chain.from_iterable(cursor)), len(cursor.description)
    return [values[column::width] for column in range(width)] if values else []


def _column(values: list) -> Iterator[np.ndarray | bytes]:
    """Yield a column as bytes: numbers as float64 with NaN for NULL; other types as lengths and values."""
    kinds = set(map(type, values))
    if kinds <= _NUMBERS:
        yield np.array(values, "<f8")
        return
    parts = values if kinds == {bytes} else [str(value).encode("utf-8") for value in values]
    yield np.fromiter(map(len, parts), "<i8", len(parts))
    yield b"".join(parts)


def has_checksums(connection: sqlite3.Connection) -> bool:
    """Whether a database has checksums."""
    return bool(_stored_checksums(connection))


def keeps_shown(connection: sqlite3.Connection) -> bool:
    """Whether a database has checksums of the data that only QGIS reads."""
    return any(name in stated for stated in _stored_checksums(connection) for name in _SHOWN_ROWS)


def _stored_checksums(connection: sqlite3.Connection) -> list[dict]:
    rows = connection.execute("SELECT value FROM parameters WHERE key = ?", (CHECKSUMS,)).fetchall()
    found = [read_json(value) for (value,) in rows]
    if len(found) > 1 or not all(isinstance(stated, dict) for stated in found):
        raise ValueError("its checksums can't be read")
    return found


def require_checksums(connection: sqlite3.Connection, found: Mapping[str, str]) -> None:
    """Raise ValueError if a table differs from its stored checksum; old databases have no checksums."""
    for stated in _stored_checksums(connection):
        for name, checksum in found.items():
            if stated.get(name) != checksum:
                raise ValueError(f"its table {name.split()[0]} is not what its checksum says")


def _little_endian(column: np.ndarray) -> np.ndarray:
    return column.astype(column.dtype.newbyteorder("<"), copy=False)


def _text_digest(connection: sqlite3.Connection, query: str) -> str:
    return digest(repr(row).encode("utf-8") for row in connection.execute(query))
