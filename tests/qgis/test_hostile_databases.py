"""A database is read completely or refused: journals, other writers, foreign triggers, impossible values."""

import contextlib
import json
import shutil
import sqlite3
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from edited_database import edit
from made_inputs import NAMES, scattered_objects, write_raster
from qgis.core import QgsProject

from semref.core.errors import DatabaseError, SemRefError
from semref.processing.layers.database_layers import add_database_to_map
from semref.storage.database.reader import read_database, read_overview, stored_style

LABELS = scattered_objects(500, 600, 200, seed=3)

HOT_WRITER = """
import os, sqlite3, sys
connection = sqlite3.connect(sys.argv[1], isolation_level=None)
# A cache this small makes SQLite write changed pages into the file before the commit.
connection.execute("PRAGMA cache_size=2")
connection.execute("PRAGMA journal_mode=DELETE")
for function in ("ST_IsEmpty", "ST_MinX", "ST_MinY", "ST_MaxX", "ST_MaxY"):
    connection.create_function(function, 1, lambda blob: 0)
connection.execute("BEGIN IMMEDIATE")
connection.execute('DELETE FROM "references" WHERE fid % 3 = 0')
connection.execute("UPDATE windows SET center_x = center_x + 100000, vector = zeroblob(length(vector))")
connection.execute("UPDATE parameters SET value = value || ' '")
print("written", flush=True)
sys.stdin.readline()
os._exit(9)
"""
LATER = ("windows rows", "references rows", "reference_bounds rows")


@pytest.fixture(scope="module")
def built(build_area):
    return build_area(LABELS, NAMES, 200, 50)


@pytest.fixture
def database(built, tmp_path):
    return Path(shutil.copy(built, tmp_path / "area.gpkg"))


@pytest.fixture
def read(qgis_app):
    return lambda path: read_database(str(path))


def spoil(path, *statements) -> None:
    """Change a database like its maker, without the checksums that would show it."""
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        connection.execute("DELETE FROM parameters WHERE key = 'checksums'")
        # GDAL's triggers need its functions.
        for function in ("ST_IsEmpty", "ST_MinX", "ST_MinY", "ST_MaxX", "ST_MaxY"):
            connection.create_function(function, 1, lambda blob: 0)
        for statement in statements:
            connection.execute(statement)


def refusal(read, path) -> str:
    with pytest.raises(SemRefError) as refused:
        read(path)
    text = str(refused.value)
    assert "\n" not in text and text.endswith("."), text
    assert len(text) < 600, text
    return text


@contextlib.contextmanager
def writing(path):
    """Start another process with an open transaction; it dies without ending the transaction."""
    process = subprocess.Popen(
        [sys.executable, "-c", HOT_WRITER, str(path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    try:
        assert process.stdout.readline() == "written\n"
        yield
    finally:
        process.stdin.close()
        process.wait()
        process.stdout.close()


def test_what_a_killed_writer_left_is_rolled_back_if_it_may_be_and_else_refused(read, built, database, monkeypatch):
    with writing(database):
        pass
    assert Path(f"{database}-journal").stat().st_size
    with monkeypatch.context() as patch:
        patch.setattr("os.access", lambda path, mode: False)
        assert "another program" in refusal(read, database)
    found, whole = read(database), read(built)
    assert len(found.references) == len(whole.references)
    np.testing.assert_array_equal(found.windows.centers, whole.windows.centers)


def test_a_database_that_another_program_writes_is_refused(read, database, short_wait):
    with writing(database):
        assert "is being written by another program" in refusal(read, database)


def test_changes_that_wait_in_a_wal_are_read(read, database):
    with contextlib.closing(sqlite3.connect(database)) as writer:
        writer.execute("PRAGMA journal_mode=WAL")
        writer.execute("UPDATE parameters SET value = '\"9.9.9\"' WHERE key = 'plugin_version'")
        writer.execute("DELETE FROM parameters WHERE key = 'checksums'")
        writer.commit()
        assert read(database).parameters.plugin_version == "9.9.9"


def test_reading_leaves_nothing_beside_the_file(read, database):
    with contextlib.closing(sqlite3.connect(database)) as writer:
        writer.execute("PRAGMA journal_mode=WAL")
    before = database.read_bytes()
    read(database)
    assert [path.name for path in database.parent.iterdir()] == [database.name]
    assert database.read_bytes() == before


@pytest.fixture
def update(run_algorithm, tmp_path):
    def run(database):
        labels = LABELS.copy()
        labels[200:260, 200:260] = 4
        labels[210:240, 210:230] = 1
        new = write_raster(tmp_path / "new.tif", labels, names=NAMES)
        asked = {"DATABASE": str(database), "LABELS": str(new), "OUTPUT": str(tmp_path / "updated.gpkg")}
        return run_algorithm("semref:updatedatabase", asked)["OUTPUT"]

    return run


def schema_of(path) -> set:
    with contextlib.closing(sqlite3.connect(path)) as connection:
        return set(connection.execute("SELECT type, name, sql FROM sqlite_master").fetchall())


@pytest.mark.slow
@pytest.mark.parametrize("name", ["harmless", "rtree_windows_geom_delete", "trigger_insert_feature_count_references"])
def test_a_foreign_trigger_is_neither_run_nor_carried_into_an_update(read, update, built, database, name):
    whole = read(update(built))
    spoil(
        database,
        f'DROP TRIGGER IF EXISTS "{name}"',
        f'CREATE TRIGGER "{name}" AFTER UPDATE ON windows BEGIN UPDATE "references" SET class = 2, area = 7; END',
        'CREATE TRIGGER "more" AFTER INSERT ON "references" BEGIN UPDATE "references" SET area = 7; END',
        'CREATE VIEW seen AS SELECT * FROM "references"',
        "CREATE TABLE foreign_table (secret TEXT)",
    )
    updated = update(database)
    found = read(updated)
    np.testing.assert_array_equal(found.references.areas_m2, whole.references.areas_m2)
    np.testing.assert_array_equal(found.references.classes, whole.references.classes)
    assert schema_of(updated) == schema_of(built)


@pytest.mark.parametrize(
    "statements",
    [
        "DROP TABLE windows; CREATE VIEW windows AS SELECT 1 AS fid",
        "ALTER TABLE windows RENAME TO w; CREATE VIEW windows AS SELECT * FROM w",
        "ALTER TABLE windows DROP COLUMN vector; "
        "ALTER TABLE windows ADD COLUMN vector GENERATED ALWAYS AS (zeroblob(1000000000)) VIRTUAL",
    ],
)
def test_a_table_that_is_no_table_is_refused(read, database, statements):
    spoil(database, *statements.split("; "))
    refusal(read, database)


BAD_WINDOWS = (
    *("center_x = 1e308", "center_x = NULL", "size = 1e308", "level = 1e300", "reference_count = 9e18"),
    *("vector = zeroblob(3)", "vector = replace(hex(zeroblob(60)), '00', 'a')"),
    "vector = CAST(replace(hex(zeroblob(30)), '00', x'ffff') AS BLOB)",
)
BAD_LANDMARKS = (
    *("area = NULL", "class = 77", "class = 300", "class = 'x'", "geom = NULL", "geom = x'47'", "geom = 3"),
    "geom = CAST(substr(geom, 1, 13) || zeroblob(16) AS BLOB)",
)
BAD_VALUES = [
    *(f"UPDATE windows SET {change}" for change in BAD_WINDOWS),
    *(f'UPDATE "references" SET {change}' for change in BAD_LANDMARKS),
    "UPDATE classes SET value = 1e300",
    "UPDATE classes SET draw_order = 'NaN'",
    "UPDATE classes SET name = hex(zeroblob(4000000))",
    "UPDATE parameters SET value = hex(zeroblob(4000000)) WHERE key = 'crs'",
    "UPDATE parameters SET value = replace(hex(zeroblob(50000)), '00', '[') WHERE key = 'levels'",
    "UPDATE parameters SET value = '[1, 0]' WHERE key = 'levels'",
    "UPDATE parameters SET value = '[-1]' WHERE key = 'levels'",
    "UPDATE parameters SET value = '1e308' WHERE key = 'pixel_size'",
    "UPDATE parameters SET value = '[NaN, 1, 0, 0, 0, -1]' WHERE key = 'geotransform'",
    "UPDATE parameters SET value = '[550000, 0, 0, 5220000, 0, 0]' WHERE key = 'geotransform'",
    "UPDATE parameters SET value = '1e400' WHERE key = 'minimum_area'",
    "UPDATE parameters SET value = replace(hex(zeroblob(5000)), '0', '1') WHERE key = 'map_width_px'",
    "UPDATE parameters SET value = '11' WHERE key = 'references_per_vector'",
    "UPDATE parameters SET key = x'ff'",
]


@pytest.mark.slow
@pytest.mark.parametrize("statement", BAD_VALUES)
def test_an_impossible_value_is_refused_in_one_sentence(read, database, statement):
    spoil(database, statement)
    refusal(read, database)


@pytest.mark.parametrize("name", ['a"b', "a:b", "a'b ? #%41"])
def test_an_odd_path_has_its_overview_comes_onto_the_map_and_can_be_updated(update, built, tmp_path, name):
    (tmp_path / name).mkdir()
    path = str(shutil.copy(built, tmp_path / name / f"{name}.gpkg"))
    np.testing.assert_array_equal(read_overview(path), read_overview(built))
    if "?" in name:
        return
    project = QgsProject()
    add_database_to_map(path, project)
    assert sorted(layer.name() for layer in project.mapLayers().values()) == ["Landmarks", "Overview", "Windows"]
    assert Path(update(path)).is_file()


def test_a_flipped_bit_in_a_stored_number_is_refused(read, built, database):
    data, whole = database.read_bytes(), read(built)
    with contextlib.closing(sqlite3.connect(database)) as connection:
        tile = connection.execute("SELECT tile_data FROM overview").fetchone()[0]
    targets = [
        whole.windows.vectors[whole.windows.described][5].astype("<f4").tobytes()[:8],
        whole.references.positions[4].astype("<f8").tobytes(),
        whole.parameters.map_hash.encode(),
        tile[60:80],
    ]
    for target in targets:
        place = data.index(target) + len(target) - 1
        database.write_bytes(data[:place] + bytes([data[place] ^ 1]) + data[place + 1 :])
        with pytest.raises(DatabaseError):
            read(database)
            read_overview(str(database))


CHANGED_CELLS = [
    "UPDATE windows SET name = '1_1' WHERE fid = 3",
    "UPDATE windows SET longitude = longitude + 1e-12 WHERE fid = 3",
    "UPDATE windows SET latitude = NULL WHERE fid = 3",
    "UPDATE windows SET geom = (SELECT geom FROM windows WHERE fid = 4) WHERE fid = 3",
    "UPDATE windows SET level = 1.25 WHERE fid = 3",
    "UPDATE \"references\" SET class_name = 'Water' WHERE fid = 3",
    'UPDATE "references" SET class = class + 0.25 WHERE fid = 3',
]


@pytest.mark.parametrize("statement", CHANGED_CELLS)
def test_what_only_the_map_shows_is_under_the_checksums_too(read, database, statement):
    edit(database, statement)
    assert "is not what its checksum says" in refusal(read, database)


def test_a_database_with_the_checksums_of_the_version_before_opens(qgis_app, read, database):
    with contextlib.closing(sqlite3.connect(database)) as connection, connection:
        (text,) = connection.execute("SELECT value FROM parameters WHERE key = 'checksums'").fetchone()
        kept = {name: checksum for name, checksum in json.loads(text).items() if name not in LATER}
        connection.execute("UPDATE parameters SET value = ? WHERE key = 'checksums'", (json.dumps(kept),))
    assert len(read(database).references) and stored_style(str(database), "windows")
    edit(database, "UPDATE windows SET name = '1_1' WHERE fid = 3")
    assert len(read(database).references)


@pytest.mark.parametrize("name", LATER)
def test_a_checksum_that_is_missing_among_the_others_is_no_way_around_it(read, database, name):
    edit(database, f"UPDATE parameters SET value = replace(value, '{name}', 'other') WHERE key = 'checksums'")
    refusal(read, database)
