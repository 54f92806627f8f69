import contextlib
import os
import shutil
import sqlite3
import sys
from pathlib import Path

import numpy as np
import pytest
from full_disks import files_of_at_most
from made_inputs import NAMES, NORTH, WEST, read_pixels, scattered_objects, square, write_layer, write_raster
from osgeo import ogr
from qgis.core import QgsProcessingException, QgsVectorLayer

from semref.storage.database import editor
from semref.storage.database.connection import DatabaseChangedError
from semref.storage.database.reader import read_database, read_overview

BUILD, UPDATE = "semref:builddatabase", "semref:updatedatabase"
HEIGHT, WIDTH = 1100, 1300
EDIT = (660, 560, 60)
"""Column, row and size of the corrected square."""


def map_labels():
    labels = scattered_objects(HEIGHT, WIDTH, 900, seed=8)
    labels[:, 700:703] = 2
    return labels


def edited_labels():
    labels = map_labels()
    column, row, size = EDIT
    labels[row : row + size, column : column + size] = 4
    labels[row + 3 : row + 30, column + 5 : column + 17] = 1
    labels[row + 3 : row + 20, column + 25 : column + 38] = 3
    return labels


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Return old and new label map, the changed areas, and databases built from both maps."""
    folder = tmp_path_factory.mktemp("update")
    write_raster(folder / "old.tif", map_labels(), names=NAMES)
    write_raster(folder / "new.tif", edited_labels(), names=NAMES)
    write_layer(folder / "changed.gpkg", [(square(*EDIT),)], [], geometry=ogr.wkbPolygon)
    return folder


@pytest.fixture(scope="module")
def build(run_algorithm, folder):
    sizes = {"WINDOW_SIZE": 240, "STRIDE": 100, "LEVELS": "1;2", "MINIMUM_AREA": 40}

    def run(name):
        asked = {"LABELS": str(folder / f"{name}.tif"), "REFERENCE_CLASSES": "building;water;bare_land", **sizes}
        return run_algorithm(BUILD, {**asked, "DATABASE": str(folder / f"{name}.gpkg")})["DATABASE"]

    return run


@pytest.fixture(scope="module")
def old(build):
    return build("old")


@pytest.fixture(scope="module")
def rebuilt(build):
    return build("new")


@pytest.fixture
def update(run_algorithm, folder, old, tmp_path):
    def run(feedback=None, **parameters):
        settings = {"DATABASE": old, "LABELS": str(folder / "new.tif"), "OUTPUT": str(tmp_path / "updated.gpkg")}
        return run_algorithm(UPDATE, {**settings, **parameters}, feedback)["OUTPUT"]

    return run


def rows(database, sql):
    with contextlib.closing(sqlite3.connect(f"file:{database}?mode=ro", uri=True)) as connection:
        return connection.execute(sql).fetchall()


def references(database):
    """Return {(all but the fid)} of the references with their bounds."""
    sql = (
        'SELECT r.*, b.first_column, b.first_row, b.end_column, b.end_row FROM "references" r '
        "JOIN reference_bounds b ON b.fid = r.fid"
    )
    return {row[0]: row[1:] for row in rows(database, sql)}


def assert_same_content(database, expected):
    # Of styles only the owners: Qt writes their attributes in any order.
    for table in ("windows", "classes", "parameters", "layer_styles"):
        key, columns = ("id", "f_table_name") if table == "layer_styles" else ("fid", "*")
        # Checksums are of rows and tiles in the order of the file, which may differ after a rebuild.
        where = "WHERE key <> 'checksums'" if table == "parameters" else ""
        sql = f"SELECT {columns} FROM {table} {where} ORDER BY {key}"
        assert rows(database, sql) == rows(expected, sql), table
    assert sorted(references(database).values()) == sorted(references(expected).values())
    overviews = [read_pixels(f"GPKG:{path}:overview") for path in (database, expected)]
    np.testing.assert_array_equal(*overviews)


@pytest.mark.slow
@pytest.mark.parametrize("areas", [True, False], ids=["with the changed areas", "to compare the whole map"])
def test_the_result_is_the_rebuilds(update, folder, old, rebuilt, areas):
    before = Path(old).read_bytes()
    output = update(CHANGED=str(folder / "changed.gpkg")) if areas else update()
    assert_same_content(output, rebuilt)
    vectors = [rows(path, "SELECT vector FROM windows ORDER BY fid") for path in (old, output)]
    assert vectors[0] != vectors[1]
    assert Path(old).read_bytes() == before
    assert sorted(p.name for p in Path(output).parent.iterdir()) == ["updated.gpkg"]


def test_what_did_not_change_keeps_its_fid_and_the_log_counts_the_changes(update, folder, old, feedback):
    output = update(feedback, CHANGED=str(folder / "changed.gpkg"))
    before, after = references(old), references(output)
    gone, new = set(before) - set(after), set(after) - set(before)
    assert gone and new and min(new) > max(before)
    assert all(before[fid] == after[fid] for fid in set(before) & set(after))
    assert len(set(before.values()) & set(after.values())) == len(set(before) & set(after))
    assert f"{len(gone)} removed, {len(new)} added." in feedback.textLog()


def test_the_database_itself_can_be_replaced(update, folder, old, rebuilt, tmp_path):
    place = str(shutil.copy(old, tmp_path / "area.gpkg"))
    assert update(DATABASE=place, OUTPUT=place) == place
    assert_same_content(place, rebuilt)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["area.gpkg"]


def test_index_extent_and_counts_are_right_afterwards(update, folder, rebuilt):
    output = update(CHANGED=str(folder / "changed.gpkg"))
    for name in ("windows", "references"):
        sources = [ogr.Open(path) for path in (output, rebuilt)]
        layers = [source.GetLayerByName(name) for source in sources]
        assert layers[0].GetFeatureCount() == layers[1].GetFeatureCount()
        assert layers[0].GetExtent() == layers[1].GetExtent()
        column, row, size = EDIT
        for layer in layers:
            layer.SetSpatialFilterRect(WEST + column, NORTH - row - size, WEST + column + size, NORTH - row)
        assert layers[0].GetFeatureCount() == layers[1].GetFeatureCount() > 0
    sql = "SELECT min_x, min_y, max_x, max_y FROM gpkg_contents WHERE table_name IN ('windows', 'references')"
    assert rows(output, sql) == rows(rebuilt, sql)
    assert rows(output, "PRAGMA integrity_check") == [("ok",)]
    assert rows(output, "SELECT count(*) FROM rtree_references_geom") == [(len(references(output)),)]
    layer = QgsVectorLayer(f"{output}|layername=references", "references", "ogr")
    assert layer.isValid() and layer.featureCount() == len(references(rebuilt))


def test_changes_waiting_in_a_wal_file_are_kept(update, old, tmp_path):
    place = str(shutil.copy(old, tmp_path / "edited.gpkg"))
    with contextlib.closing(sqlite3.connect(place)) as connection:
        connection.execute("PRAGMA journal_mode=WAL")
        connection.execute("UPDATE layer_styles SET description = 'mine'")
        connection.commit()
        assert os.path.getsize(place + "-wal")
        output = update(DATABASE=place)
    assert set(rows(output, "SELECT description FROM layer_styles")) == {("mine",)}


def refused(sentence):
    return pytest.raises(QgsProcessingException, match=sentence)


def test_a_database_of_an_older_version_is_refused_in_one_sentence(update, old, tmp_path):
    place = shutil.copy(old, tmp_path / "older.gpkg")
    with contextlib.closing(sqlite3.connect(place)) as connection:
        connection.execute("DROP TABLE reference_bounds")
        connection.execute("DELETE FROM parameters WHERE key IN ('block_hashes', 'checksums')")
        connection.commit()
    with refused("built the database without block hashes and bounds of landmarks"):
        update(DATABASE=str(place))


def test_what_others_wrote_meanwhile_is_not_undone(update, old, tmp_path, monkeypatch):
    area = tmp_path / "area.gpkg"
    shutil.copy(old, area)
    real = editor.write_changes

    def write_changes(*arguments):
        yield from real(*arguments)
        with contextlib.closing(sqlite3.connect(area)) as connection, connection:
            connection.execute("UPDATE classes SET color = '#123456'")

    monkeypatch.setattr(editor, "write_changes", write_changes)
    with refused("changed by another program"):
        update(DATABASE=str(area), OUTPUT=str(area))
    assert rows(area, "SELECT DISTINCT color FROM classes") == [("#123456",)]


def test_an_overview_of_another_state_is_refused(old, rebuilt):
    was = read_database(str(old)).parameters
    assert read_overview(str(old), was).size > 0
    with pytest.raises(DatabaseChangedError, match="changed by another program"):
        read_overview(str(rebuilt), was)


@pytest.mark.skipif(sys.platform == "win32", reason="limits on files as Unix has them")
@pytest.mark.parametrize("share", [0.05, 0.5, 0.9, 0.97, 0.995, 1.0])
def test_a_full_disk_is_not_reported_as_a_damaged_database(update, old, rebuilt, tmp_path, share):
    size = (os.path.getsize(old) * share) // 4096 * 4096
    with files_of_at_most(int(size)), pytest.raises(QgsProcessingException) as caught:
        update()
    assert "written" in str(caught.value) and "damaged" not in str(caught.value)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("begin", ["BEGIN IMMEDIATE", pytest.param("BEGIN EXCLUSIVE", marks=pytest.mark.slow)])
def test_a_database_that_is_locked_before_the_end_is_not_replaced(
    update, old, tmp_path, monkeypatch, short_wait, begin
):
    """Otherwise the other program would commit into a file that is no longer in use."""
    place = str(shutil.copy(old, tmp_path / "area.gpkg"))
    write_changes = editor.write_changes
    with contextlib.closing(sqlite3.connect(place, isolation_level=None)) as other:

        def lock_at_the_end(*arguments):
            yield from write_changes(*arguments)
            other.execute(begin)
            other.execute("UPDATE classes SET name = 'tower' WHERE fid = 2")

        monkeypatch.setattr(editor, "write_changes", lock_at_the_end)
        with pytest.raises(QgsProcessingException, match="another program"):
            update(DATABASE=place, OUTPUT=place)
        other.execute("COMMIT")
    assert rows(place, "SELECT name FROM classes WHERE fid = 2") == [("tower",)]
