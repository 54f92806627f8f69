"""The rows of a database's windows and landmarks, as columns."""

from __future__ import annotations

import sqlite3

import numpy as np

from ...core.database.model import MapLandmarks, Windows, first_pixels_of
from ...core.database.parameters import BuildParameters
from ...core.errors import DatabaseError
from ...core.labels.class_table import MAXIMUM_VALUE
from .batches import columns_of, points_of


def read_windows(connection: sqlite3.Connection, parameters: BuildParameters, path: str) -> Windows:
    """All windows of a database, in the order of their fids.

    Raises:
        DatabaseError: A vector has another length than its parameters say.
        ValueError: A window has no place, or one between the label map's pixels.
    """
    length = 3 * parameters.references_per_vector

    def arrays(rows: list[tuple]) -> tuple[np.ndarray, ...]:
        levels, sizes, xs, ys, counts, blobs, distinctiveness = zip(*rows) if rows else ((),) * 7
        if any(blob is not None and len(blob) != 4 * length for blob in blobs):
            raise DatabaseError(
                "{path} has vectors that are not {length} numbers long; build it again.", path=path, length=length
            )
        described = np.array([blob is not None for blob in blobs], bool)
        vectors = np.zeros((len(rows), length), np.float32)
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
    """All landmarks of a database, in the order of their fids, without bounds.

    Raises:
        ValueError: A landmark has an impossible class.
    """

    def arrays(rows: list[tuple]) -> tuple[np.ndarray, ...]:
        blobs, classes, areas, touches = zip(*rows) if rows else ((),) * 4
        values = np.array(classes, np.int64)
        if not ((values >= 0) & (values <= MAXIMUM_VALUE)).all():
            raise ValueError("a landmark has a class that is no reference class")
        return points_of(blobs), values.astype(np.uint8), np.array(areas, np.float64), np.array(touches, bool)

    query = 'SELECT geom, class, area, touches_edge FROM "references" ORDER BY fid'
    return MapLandmarks(*columns_of(connection, query, arrays))
