"""Cache the windows and landmarks of a large database as columns (docs/reference/file_formats.md#cache)."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import partial

from ...core.cache import Arrays, digest, load_or_build
from ...core.database.model import MapLandmarks, Windows
from .checksums import has_checksums
from .connection import Snapshot

VERSION = 1
"""Increased when the same rows give different columns."""

FEWEST = 100_000
"""Smallest number of rows to cache; fewer rows are read in a third of a second."""

Columns = tuple[Windows, MapLandmarks]


def cached_columns(connection: Snapshot, vector_length: int, read: Callable[[], Columns]) -> Columns:
    """Return windows and landmarks, of a large database from the cache.

    Args:
        connection: The database.
        vector_length: Length of a topology vector.
        read: Reads and checks the rows. Its errors are passed on.
    """
    key = _key(connection)
    if key is None:
        return read()

    def make() -> Arrays:
        return {
            f"{table}_{name}": getattr(of_table, name)
            for (table, columns), of_table in zip(_COLUMNS.items(), read())
            for name in columns
            if getattr(of_table, name) is not None
        }

    arrays = load_or_build("columns", key, make, partial(_fit, vector_length=vector_length))
    windows, landmarks = (
        {name: arrays.get(f"{table}_{name}") for name in columns} for table, columns in _COLUMNS.items()
    )
    return Windows(**windows), MapLandmarks(**landmarks)


def _key(connection: Snapshot) -> str | None:
    """Return a hash that differs after every change of the database; None for few rows or without checksums."""
    # Counting rows takes long; fids begin at 1.
    query = 'SELECT (SELECT max(fid) FROM windows), (SELECT max(fid) FROM "references")'
    rows = sum(fid or 0 for fid in connection.execute(query).fetchone())
    if rows < FEWEST or not has_checksums(connection):
        return None
    content = [
        connection.execute("SELECT key, value FROM parameters ORDER BY key, value").fetchall(),
        connection.execute("SELECT * FROM classes ORDER BY fid").fetchall(),
    ]
    return digest([json.dumps([VERSION, connection.state]).encode(), repr(content).encode("utf-8")])


_VECTOR = -1
"""Placeholder for the length of a topology vector."""

_COLUMNS = {
    "windows": {
        "first_pixels": ("<i8", 2),
        "levels": ("<i8",),
        "sizes": ("<f8",),
        "centers": ("<f8", 2),
        "counts": ("<i8",),
        "vectors": ("<f4", _VECTOR),
        "described": ("|b1",),
        "distinctiveness": ("<f8",),
    },
    "landmarks": {
        "positions": ("<f8", 2),
        "classes": ("|u1",),
        "areas_m2": ("<f8",),
        "touches_edge": ("|b1",),
    },
}
"""Data type and, for two dimensions, row length of each column."""


def _fit(arrays: Arrays, vector_length: int) -> bool:
    """Whether the arrays have the names, shapes and data types of columns."""
    expected = {}
    for table, columns in _COLUMNS.items():
        first = arrays.get(f"{table}_{next(iter(columns))}")
        count = 0 if first is None else len(first)
        for name, (kind, *row) in columns.items():
            lengths = [vector_length if length == _VECTOR else length for length in row]
            expected[f"{table}_{name}"] = kind, (count, *lengths)
    if set(arrays) != set(expected):
        return False
    return all((array.dtype.str, array.shape) == expected[name] for name, array in arrays.items())
