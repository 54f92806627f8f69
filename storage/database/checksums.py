"""Checksums of a database's tables, kept among its parameters: a flipped bit is refused and not flown by."""

from __future__ import annotations

import sqlite3
from collections.abc import Mapping

import numpy as np

from ...core.database.checks import digest
from ...core.database.model import MapLandmarks, Windows
from ...core.values import read_json
from . import schema

CHECKSUMS = "checksums"
"""Key among the parameters: JSON of the SHA-256 of each table by its name. Databases of older versions have none."""


def checksums_of(connection: sqlite3.Connection, windows: Windows, landmarks: MapLandmarks) -> dict[str, str]:
    """SHA-256 by table of what is read of a database, as columns of little-endian numbers (docs/file-formats.md)."""
    distinct = windows.distinctiveness
    numbers = (
        windows.levels,
        windows.sizes,
        windows.centers,
        windows.counts,
        windows.vectors,
        windows.described,
        # Every NaN is the same one.
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
    """Of the tiles as they are stored, and of how they lie together."""
    tiles = connection.execute(
        "SELECT zoom_level, tile_column, tile_row, tile_data FROM overview ORDER BY zoom_level, tile_column, tile_row"
    )
    columns = [
        part
        for zoom, column, row, data in tiles
        for part in (np.array([zoom, column, row], "<i8"), data if isinstance(data, bytes) else repr(data).encode())
    ]
    matrix = connection.execute(
        "SELECT zoom_level, matrix_width, matrix_height, tile_width, tile_height, pixel_x_size, pixel_y_size "
        "FROM gpkg_tile_matrix WHERE table_name = 'overview' ORDER BY zoom_level"
    )
    return digest([*columns, repr(matrix.fetchall()).encode()])


def require_unchanged(connection: sqlite3.Connection, found: Mapping[str, str]) -> None:
    """Raises ValueError where a table is not what its checksum says; old databases have none."""
    rows = connection.execute("SELECT value FROM parameters WHERE key = ?", (CHECKSUMS,)).fetchall()
    if not rows:
        return
    stated = read_json(rows[0][0])
    for table, checksum in found.items():
        if len(rows) > 1 or not isinstance(stated, dict) or stated.get(table) != checksum:
            raise ValueError(f"its table {table} is not what its checksum says")


def _little_endian(column: np.ndarray) -> np.ndarray:
    return column.astype(column.dtype.newbyteorder("<"), copy=False)


def _text_digest(connection: sqlite3.Connection, query: str) -> str:
    return digest(repr(row).encode("utf-8") for row in connection.execute(query))
