"""Cache the windows and landmarks of a large database as columns (docs/reference/file_formats.md#cache)."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import fields

from ...core.cache import Arrays, digest, load_or_build
from ...core.database.model import MapLandmarks, Windows
from .checksums import has_checksums
from .connection import Snapshot

VERSION = 1
"""Increased when the same rows give different columns."""

FEWEST = 100_000
"""Smallest number of rows to cache; fewer rows are read in a third of a second."""

Columns = tuple[Windows, MapLandmarks]


def cached_columns(connection: Snapshot, read: Callable[[], Columns]) -> Columns:
    """Return windows and landmarks, of a large database from the cache.

    Args:
        read: Reads and checks the rows. Its errors are passed on.
    """
    key = _key(connection)
    if key is None:
        return read()

    def make() -> Arrays:
        return {
            f"{table}_{item.name}": column
            for table, rows in zip(("windows", "landmarks"), read())
            for item in fields(rows)
            if (column := getattr(rows, item.name)) is not None
        }

    arrays = load_or_build("columns", key, make)
    windows, landmarks = (
        kind(**{item.name: arrays.get(f"{table}_{item.name}") for item in fields(kind)})
        for table, kind in (("windows", Windows), ("landmarks", MapLandmarks))
    )
    return windows, landmarks


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
