"""Reference databases: their tables changed row by row in SQL, their bytes, and bits behind their checksums."""

from __future__ import annotations

import contextlib
import gzip
import json
import sqlite3
from dataclasses import replace
from pathlib import Path
from random import Random
from typing import Any

import numpy as np

from ..contract import Broken, World, require
from ..door import Door, Placed, Tools
from ..mutations import JSON_VALUES, NUMBERS, TEXTS, mutated_bytes, mutated_json

_ROOT = Path(__file__).resolve().parents[3]
KEPT = _ROOT / "tests" / "data" / "kept" / "v1" / "database.gpkg.gz"

_READ = ("windows", "references", "reference_bounds", "classes", "parameters", "layer_styles", "overview")
_OTHERS = ("gpkg_contents", "gpkg_geometry_columns", "gpkg_spatial_ref_sys", "gpkg_tile_matrix", "gpkg_tile_matrix_set")


def made_database(folder: Path) -> bytes:
    """A small database as this version writes it: a corner of the map of tests/data/onboard_blobs.py."""
    from onboard_blobs import FRAME, MAP, TABLE
    from osgeo import osr

    from semref.core.database.build import BuildSettings, DatabaseBuilder
    from semref.core.labels.sources import ArrayLabels
    from semref.storage.database.writer import DatabaseWriter

    labels = ArrayLabels(np.ascontiguousarray(MAP[:70, :90]))
    crs = osr.SpatialReference()
    crs.ImportFromEPSG(32632)
    # The blobs' own CRS has a name only, which newer PROJ refuses to write.
    frame = replace(FRAME, shape_hw=(70, 90), crs=crs.ExportToWkt())
    builder = DatabaseBuilder(labels, frame, TABLE, BuildSettings(80.0, 40.0, minimum_area=28.0), "1.2.3")
    for _ in builder.steps():
        pass
    database = replace(builder.database, overview=builder.overview)
    windows = replace(database.windows, distinctiveness=np.full(len(database.windows), 1.5))
    database = replace(database, windows=windows)
    path = folder / "made.gpkg"
    ones = np.linspace(9, 9.1, len(database.windows))
    styles = {"windows": "<qgis a='1'/>", "references": "<qgis/>", "overview": "<qgis/>"}
    for _ in DatabaseWriter(str(path), database, ones, ones + 38, database.overview, styles).steps():
        pass
    data = path.read_bytes()
    path.unlink()
    return data


def require_sound(database: Any) -> None:
    """What localization relies on."""
    windows, landmarks, parameters = database.windows, database.references, database.parameters
    numbers = (windows.centers, windows.sizes, windows.vectors, landmarks.positions, landmarks.areas_m2)
    require(all(np.isfinite(column).all() for column in numbers), "a number that is none")
    x_min, y_min, x_max, y_max = parameters.extent
    for places in (windows.centers, landmarks.positions):
        slack = parameters.pixel_size
        inside = (places >= (x_min - slack, y_min - slack)) & (places <= (x_max + slack, y_max + slack))
        require(inside.all(), "a place off the map")
    if database.overview is not None:
        require(database.overview.shape == parameters.overview_frame.shape_hw, "an overview of another map")


def _columns(connection: sqlite3.Connection) -> dict[str, list[str]]:
    return {
        table: [row[1] for row in connection.execute(f'PRAGMA table_info("{table}")')] for table in (*_READ, *_OTHERS)
    }


def _value(random: Random, now: Any) -> Any:
    kind = random.randrange(9)
    if kind == 0:
        return None
    if kind == 1:
        return random.choice((0, -1, 1, 2, 255, 300, 2**31, 2**62, -(2**62), float("inf"), 1e308, -1e308, 1e-320))
    if kind == 2:
        return random.choice(TEXTS + NUMBERS)
    if isinstance(now, bytes) and kind < 7:
        return mutated_bytes(random, now, [b"\xff\xff\xff\x7f", b"\0\0\xc0\x7f", b"GP\0\x01"])
    if isinstance(now, str) and kind < 7:
        try:
            return json.dumps(mutated_json(random, json.loads(now), JSON_VALUES[:20]))
        except (ValueError, RecursionError, TypeError):
            return mutated_bytes(random, now.encode("utf-8", "replace"), most=2).decode("utf-8", "replace")
    if isinstance(now, (int, float)) and kind < 8:
        return now * random.choice((-1, 2, 1e9, 1e-9, 1.001)) if abs(now) < 1e300 else -now
    return random.choice((b"", b"\0", "", 0, random.randbytes(20)))


_STATEMENTS = (
    'DELETE FROM "{table}"',
    'DELETE FROM "{table}" WHERE rowid % 2',
    'DROP TABLE "{table}"',
    'ALTER TABLE "{table}" RENAME COLUMN "{column}" TO other',
    'CREATE TABLE seen AS SELECT * FROM "{table}"; DROP TABLE "{table}"; ALTER TABLE seen RENAME TO "{table}"',
    'ALTER TABLE "{table}" RENAME TO seen; CREATE VIEW "{table}" AS SELECT * FROM seen',
    'INSERT INTO "{table}" SELECT * FROM "{table}" WHERE 0',
    'UPDATE "{table}" SET rowid = rowid + 1000',
    'UPDATE "{table}" SET rowid = -rowid',
    'CREATE TABLE seen AS SELECT * FROM "{table}"; DELETE FROM "{table}"; INSERT INTO "{table}" SELECT * FROM seen',
)


class _Changer:
    """Changes databases in memory, as their maker could: without GDAL's triggers, with or without checksums."""

    def __init__(self, samples: list[bytes]) -> None:
        self._samples = []
        for data in samples:
            with contextlib.closing(sqlite3.connect(":memory:")) as connection:
                connection.deserialize(data)
                connection.execute("DELETE FROM parameters WHERE key = 'checksums'")
                # Fewer rows are read faster.
                names = connection.execute("SELECT name FROM sqlite_master WHERE type = 'trigger'").fetchall()
                for (name,) in names:
                    connection.execute(f'DROP TRIGGER "{name}"')
                connection.commit()
                connection.execute("VACUUM")
                self._samples.append((connection.serialize(), _columns(connection)))

    def __call__(self, random: Random) -> bytes:
        data, columns = self._samples[random.random() < 0.1]
        if random.random() < 0.15:
            return mutated_bytes(random, data)
        with contextlib.closing(sqlite3.connect(":memory:")) as connection:
            connection.deserialize(data)
            for _ in range(random.choice((1, 1, 1, 2, 3))):
                with contextlib.suppress(sqlite3.Error, OverflowError):
                    self._change(random, connection, columns)
            connection.commit()
            return connection.serialize()

    def _change(self, random: Random, connection: sqlite3.Connection, columns: dict[str, list[str]]) -> None:
        table = random.choice(_READ if random.random() < 0.85 else _OTHERS)
        column = random.choice(columns[table])
        if random.random() < 0.12:
            connection.executescript(random.choice(_STATEMENTS).format(table=table, column=column))
            return
        rows = [row for (row,) in connection.execute(f'SELECT rowid FROM "{table}"')]
        if rows:
            row = random.choice(rows)
            (now,) = connection.execute(f'SELECT "{column}" FROM "{table}" WHERE rowid = ?', (row,)).fetchone()
            where = "" if random.random() < 0.1 else " WHERE rowid = ?"
            values = (_value(random, now), row)[: 2 if where else 1]
            connection.execute(f'UPDATE "{table}" SET "{column}" = ?{where}', values)


def changed(world: World) -> Tools:
    from semref.storage.database.reader import read_database, read_stored_database, stored_style

    placed = Placed(world.folder, "area.gpkg")
    change = _Changer([made_database(world.folder), gzip.decompress(KEPT.read_bytes())])
    world.forget()

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            stored_style(path, "windows")
            require_sound(read_database(path, with_overview=True))
            stored = read_stored_database(path)
            require(len(stored.window_fids) == len(stored.database.windows), "windows without rows")

    return change, attempt


def flipped(world: World) -> Tools:
    """One bit of a file of this version: refused, or nothing that anything reads is another."""
    from semref.storage.database.reader import read_database, read_stored_database, stored_style

    placed = Placed(world.folder, "area.gpkg")
    whole = made_database(world.folder)
    world.forget()
    right = content(whole)

    def attempt(data: bytes) -> None:
        with placed(data) as path:
            require_sound(read_database(path, with_overview=True))
            read_stored_database(path)
            for table in ("windows", "references", "overview"):
                stored_style(path, table)
        found = content(data)
        for table in found:
            if found[table] != right[table]:
                raise Broken(f"a flipped bit in {table} was not seen")

    def make(random: Random) -> bytes:
        data = bytearray(whole)
        data[random.randrange(len(data))] ^= 1 << random.randrange(8)
        return bytes(data)

    return make, attempt


_SEEN = {
    **{table: f'SELECT rowid, * FROM "{table}" ORDER BY 1' for table in ("windows", "references", "reference_bounds")},
    **{table: f'SELECT * FROM "{table}" ORDER BY fid' for table in ("classes",)},
    "parameters": "SELECT key, value FROM parameters WHERE key <> 'checksums' ORDER BY 1",
    "overview": "SELECT zoom_level, tile_column, tile_row, tile_data FROM overview ORDER BY 1, 2, 3",
}
"""What is under a checksum of each table."""


def content(data: bytes) -> dict[str, list]:
    """All that SemRef or QGIS reads, by table; a table that can't be read is not there."""
    found = {}
    with contextlib.closing(sqlite3.connect(":memory:")) as connection:
        connection.deserialize(data)
        connection.text_factory = bytes
        for table, query in _SEEN.items():
            # QGIS says by itself what it can't read.
            with contextlib.suppress(sqlite3.Error):
                found[table] = connection.execute(query).fetchall()
    return found


DOORS = (
    Door("databases", "reference databases: schema, parameters, vectors, geometry, overview", changed, 4_000, 5000),
    Door("flipped_bits", "reference databases with a flipped bit", flipped, 3_000, 5000),
)
