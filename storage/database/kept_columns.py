"""Windows and landmarks of a large database, kept beside it as columns: opened by memory mapping, not row by row.

Told in docs/file-formats.md#kept-beside-a-database.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import partial

from ...core.database.model import MapLandmarks, Windows, first_pixels_of
from ...core.database.parameters import BuildParameters
from ...core.kept.arrays import Arrays, kept_path, opened_or_made
from ...core.kept.digests import digest
from .checksums import has_checksums
from .connection import Snapshot

SUFFIX = ".semref-columns"

VERSION = 1
"""Raised whenever the same rows give other columns."""

FEWEST = 100_000
"""Rows below which they are read in a third of a second and not kept."""

Columns = tuple[Windows, MapLandmarks]


def kept_columns(
    connection: Snapshot, path: str, parameters: BuildParameters, read: Callable[[], Columns]
) -> Columns:
    """The columns of a database: opened where they are kept, else read and, of many rows, kept.

    What is kept was read of these very files: as large, as old, with the same parameters, classes and checksums of all
    tables. A database without checksums, of an older version, is always read.

    Args:
        connection: To it.
        path: Its file.
        parameters: Of it.
        read: Reads and checks its rows; whatever that raises goes on.
    """
    if _rows(connection) < FEWEST or not has_checksums(connection):
        return read()

    def make() -> Arrays:
        windows, landmarks = read()
        return {
            **{f"windows_{name}": getattr(windows, name) for name, *_ in _WINDOWS},
            **{f"landmarks_{name}": getattr(landmarks, name) for name, *_ in _LANDMARKS},
        }

    fit = partial(_fit, vector_length=3 * parameters.references_per_vector)
    arrays = opened_or_made(kept_path(path, SUFFIX), _key(connection), make, fit, path)
    of_windows = {name: arrays[f"windows_{name}"] for name, *_ in _WINDOWS}
    first = first_pixels_of(of_windows["centers"], of_windows["sizes"], parameters.frame)
    return (
        Windows(first_pixels=first, **of_windows),
        MapLandmarks(**{name: arrays[f"landmarks_{name}"] for name, *_ in _LANDMARKS}),
    )


_VECTOR = -1
"""Stands for the length of a topology vector."""

_WINDOWS = (
    ("levels", "<i8"),
    ("sizes", "<f8"),
    ("centers", "<f8", 2),
    ("counts", "<i8"),
    ("vectors", "<f4", _VECTOR),
    ("described", "|b1"),
    ("distinctiveness", "<f8"),
)
_LANDMARKS = (("positions", "<f8", 2), ("classes", "|u1"), ("areas_m2", "<f8"), ("touches_edge", "|b1"))
"""Name, kind and, where there is one, length of a row."""


def _rows(connection: Snapshot) -> int:
    """About how many there are: counting them takes long, and fids begin at 1."""
    query = 'SELECT (SELECT max(fid) FROM windows), (SELECT max(fid) FROM "references")'
    return sum(fid or 0 for fid in connection.execute(query).fetchone())


def _key(connection: Snapshot) -> str:
    """What tells the columns from others: of all that a change of the database changes."""
    told = [
        connection.execute("SELECT key, value FROM parameters ORDER BY key, value").fetchall(),
        connection.execute("SELECT * FROM classes ORDER BY fid").fetchall(),
    ]
    return digest([json.dumps([VERSION, connection.state]).encode(), repr(told).encode("utf-8")])


def _fit(arrays: Arrays, vector_length: int) -> bool:
    """Whether the arrays have the shapes and kinds of a database's columns."""
    expected = {}
    for table, columns in (("windows", _WINDOWS), ("landmarks", _LANDMARKS)):
        first = arrays.get(f"{table}_{columns[0][0]}")
        count = 0 if first is None else len(first)
        for name, kind, *row in columns:
            lengths = [vector_length if length == _VECTOR else length for length in row]
            expected[f"{table}_{name}"] = kind, (count, *lengths)
    return {name: (array.dtype.str, array.shape) for name, array in arrays.items()} == expected
