"""Read the rows of large tables as columns: ten million rows as Python objects would need gigabytes."""

from __future__ import annotations

import sqlite3
import struct
from collections.abc import Callable, Sequence
from itertools import chain, islice

import numpy as np

from ...core.database.model import MapLandmarks, Windows, first_pixels_of
from ...core.database.parameters import BuildParameters
from ...core.errors import DatabaseError
from ...core.labels.class_table import MAXIMUM_VALUE

BATCH = 50_000
"""Rows per batch."""

_POINT = np.dtype([("header", "V8"), ("order", "u1"), ("type", "<u4"), ("xy", "<f8", (2,))])
"""A GeoPackage point without envelope, little-endian, as SemRef and GDAL write it: 8 bytes, then WKB."""

_LITTLE_ENDIAN = 1


def columns_of(
    connection: sqlite3.Connection, query: str, arrays: Callable[[list[list]], Sequence[np.ndarray]]
) -> list[np.ndarray]:
    """Convert the rows of a query to arrays in batches, at least one, and concatenate these.

    The tuples of the rows are not kept: Python's search for garbage visits each of them again and again.

    Args:
        arrays: Converts the columns of some rows to arrays; also for an empty batch.
    """
    cursor, made = connection.execute(query), []
    width, values = len(cursor.description), chain.from_iterable(cursor)
    while (flat := list(islice(values, BATCH * width))) or not made:
        made.append(arrays([flat[column::width] for column in range(width)]))
    return [np.concatenate(column) for column in zip(*made)]


def points_of(blobs: Sequence[bytes]) -> np.ndarray:
    """Return (N, 2) float64 of GeoPackage point blobs: 8-byte header without envelope, then WKB."""
    if blobs and {*map(type, blobs)} == {bytes} and {*map(len, blobs)} == {_POINT.itemsize}:
        found = np.frombuffer(b"".join(blobs), _POINT)
        if (found["order"] == _LITTLE_ENDIAN).all():
            return found["xy"].astype(np.float64)
    points: list[tuple[float, float]] = []
    for blob in blobs:
        order = "<" if blob[8] else ">"
        points.append(struct.unpack_from(f"{order}dd", blob, 13))
    return np.array(points, np.float64).reshape(-1, 2)


def read_windows(connection: sqlite3.Connection, parameters: BuildParameters, path: str) -> Windows:
    """Return all windows of a database in the order of their fids.

    Raises:
        DatabaseError: A vector has a wrong length.
        ValueError: A window has no position, or one between the label map's pixels.
    """
    length = 3 * parameters.references_per_vector

    def arrays(columns: list[list]) -> tuple[np.ndarray, ...]:
        levels, sizes, xs, ys, counts, blobs, distinctiveness = columns
        if any(blob is not None and len(blob) != 4 * length for blob in blobs):
            raise DatabaseError(
                "{path} has vectors that are not {length} numbers long; build it again.", path=path, length=length
            )
        described = np.array([blob is not None for blob in blobs], bool)
        vectors = np.zeros((len(blobs), length), np.float32)
        vectors[described] = np.frombuffer(b"".join(filter(None, blobs)), "<f4").reshape(-1, length)
        places = np.array([sizes, xs, ys], np.float64).reshape(3, -1).T
        # NULL becomes NaN.
        distinct = np.array(distinctiveness, np.float64)
        return np.array(levels, np.int64), places, np.array(counts, np.int64), vectors, described, distinct

    levels, places, counts, vectors, described, distinctiveness = columns_of(connection, _WINDOWS, arrays)
    if not np.isfinite(places).all():
        raise ValueError("a window has no place or size")
    sizes, centers = np.ascontiguousarray(places[:, 0]), np.ascontiguousarray(places[:, 1:])
    first = first_pixels_of(centers, sizes, parameters.frame)
    return Windows(first, levels, sizes, centers, counts, vectors, described, distinctiveness)


_WINDOWS = "SELECT level, size, center_x, center_y, reference_count, vector, distinctiveness FROM windows ORDER BY fid"


def read_references(connection: sqlite3.Connection) -> MapLandmarks:
    """Return all landmarks of a database in the order of their fids, without bounds.

    Raises:
        ValueError: A landmark has an impossible class value.
    """

    def arrays(columns: list[list]) -> tuple[np.ndarray, ...]:
        blobs, classes, areas, touches = columns
        values = np.array(classes, np.int64)
        if not ((values >= 0) & (values <= MAXIMUM_VALUE)).all():
            raise ValueError("a landmark has a class that is not a reference class")
        return points_of(blobs), values.astype(np.uint8), np.array(areas, np.float64), np.array(touches, bool)

    query = 'SELECT geom, class, area, touches_edge FROM "references" ORDER BY fid'
    return MapLandmarks(*columns_of(connection, query, arrays))
