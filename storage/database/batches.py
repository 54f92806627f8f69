"""Rows of large tables, some thousands at a time: ten million at once are gigabytes of Python's objects."""

from __future__ import annotations

import sqlite3
import struct
from collections.abc import Callable, Iterator, Sequence

import numpy as np

BATCH = 50_000

_POINT = np.dtype([("header", "V8"), ("order", "u1"), ("type", "<u4"), ("xy", "<f8", (2,))])
"""A GeoPackage point without envelope, little-endian, as SemRef and GDAL write it: 8 bytes, then WKB."""

_LITTLE_ENDIAN = 1


def batches(connection: sqlite3.Connection, query: str) -> Iterator[list[tuple]]:
    """The rows of a query, up to BATCH at a time; at least one batch, which may be empty."""
    cursor = connection.execute(query)
    yield cursor.fetchmany(BATCH)
    while rows := cursor.fetchmany(BATCH):
        yield rows


def columns_of(
    connection: sqlite3.Connection, query: str, arrays: Callable[[list[tuple]], Sequence[np.ndarray]]
) -> list[np.ndarray]:
    """What a function makes of each batch of rows, as one array each; of an empty one it gives empty arrays."""
    made = [arrays(rows) for rows in batches(connection, query)]
    return [np.concatenate(column) for column in zip(*made)]


def points_of(blobs: Sequence[bytes]) -> np.ndarray:
    """(N, 2) float64 of GeoPackage point blobs (8-byte header without envelope, then WKB of either byte order)."""
    if blobs and {*map(type, blobs)} == {bytes} and {*map(len, blobs)} == {_POINT.itemsize}:
        found = np.frombuffer(b"".join(blobs), _POINT)
        if (found["order"] == _LITTLE_ENDIAN).all():
            return found["xy"].astype(np.float64)
    points: list[tuple[float, float]] = []
    for blob in blobs:
        order = "<" if blob[8] else ">"
        points.append(struct.unpack_from(f"{order}dd", blob, 13))
    return np.array(points, np.float64).reshape(-1, 2)
