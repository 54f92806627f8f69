import shutil

import numpy as np
import pytest
from bad_input import BUILD, DESCRIBE, LABELS, LOCALIZE
from edited_database import edit
from made_inputs import NORTH, WEST, write_raster
from osgeo import gdal
from qgis.core import QgsProject

from semref.core.errors import DatabaseError
from semref.processing.layers.database_layers import add_database_to_map
from semref.processing.messages.sentences import worded
from semref.storage.database.reader import read_database


@pytest.mark.parametrize("path", ["", " "])
def test_where_no_database_is_named_the_sentence_has_no_hole_in_it(qgis_app, path):
    for reads in (read_database, lambda path: add_database_to_map(path, QgsProject.instance())):
        with pytest.raises(DatabaseError) as caught:
            reads(path)
        assert worded(caught.value) == "No database is named; build one or choose a file."


@pytest.mark.parametrize("algorithm", [LOCALIZE, DESCRIBE])
def test_a_missing_database_is_named(refused, tmp_path, algorithm):
    assert "/nowhere/area.gpkg" in refused(algorithm, DATABASE="/nowhere/area.gpkg")
    assert f"There is no database {tmp_path};" in refused(algorithm, DATABASE=str(tmp_path))


@pytest.mark.parametrize("content", [b"", b"hello", b"SQLite format 3\x00", b"SQLite format 3\x00" + bytes(200)])
def test_a_file_that_is_no_geopackage_is_refused(refused, tmp_path, content):
    (tmp_path / "notes.gpkg").write_bytes(content)
    assert "notes.gpkg" in refused(LOCALIZE, DATABASE=str(tmp_path / "notes.gpkg"))


def test_a_foreign_geopackage_is_refused_with_what_it_lacks(refused, good):
    sentence = refused(LOCALIZE, DATABASE=str(good / "annotation.gpkg"))
    assert "annotation.gpkg" in sentence and "windows" in sentence and "parameters" in sentence


@pytest.mark.parametrize("share", [0.001, 0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99])
def test_a_truncated_database_is_refused_at_whatever_length(refused, good, tmp_path, share):
    content = (good / "area.gpkg").read_bytes()
    (tmp_path / "copy.gpkg").write_bytes(content[: int(len(content) * share)])
    assert "copy.gpkg" in refused(LOCALIZE, DATABASE=str(tmp_path / "copy.gpkg"))


@pytest.mark.parametrize("statement", ["DELETE FROM windows", "UPDATE windows SET vector = NULL"])
def test_a_database_without_vectors_is_refused_by_the_method_that_needs_them(refused, good, tmp_path, statement):
    path = str(shutil.copy(good / "area.gpkg", tmp_path / "copy.gpkg"))
    edit(path, statement, "DELETE FROM parameters WHERE key = 'checksums'")
    assert "topology vector" in refused(LOCALIZE, DATABASE=path, METHOD=1)


def with_value(value: int) -> np.ndarray:
    labels = LABELS.astype(np.int32)
    labels[100, 100] = value
    return labels


@pytest.mark.parametrize(
    ("pixels", "options", "words"),
    [
        (LABELS, {"crs": 4326, "transform": (9.5, 0.00001, 0, 47.2, 0, -0.00001)}, ["EPSG:4326"]),
        (LABELS, {"crs": 2263, "transform": (985000, 1, 0, 200000, 0, -1)}, ["EPSG:2263"]),
        (LABELS, {"crs": None}, ["coordinate reference system"]),
        (LABELS, {"transform": (WEST, 1, 0.2, NORTH, 0.2, -1)}, ["rotated"]),
        (LABELS, {"transform": (WEST, 1, 0, NORTH, 0, 1)}, ["mirrored"]),
        (LABELS, {"transform": (WEST, 1, 0, NORTH, 0, -2)}, ["1 × 2"]),
        *((LABELS, {"kind": getattr(gdal, f"GDT_{name}")}, [name]) for name in ("Float32", "Float64", "CInt16")),
        (np.stack([LABELS] * 3), {}, ["3 bands"]),
        (with_value(256), {"kind": gdal.GDT_UInt16}, [" 256", "255"]),
        (with_value(70000), {"kind": gdal.GDT_Int32}, [" 70000", "255"]),
        (with_value(-1), {"kind": gdal.GDT_Int16}, [" -1", "255"]),
    ],
)
def test_a_label_map_is_metric_north_up_square_and_of_class_values(refused, tmp_path, pixels, options, words):
    sentence = refused(BUILD, LABELS=str(write_raster(tmp_path / "labels.tif", pixels, **options)))
    assert [word for word in ["labels.tif", *words] if word not in sentence] == []


def test_missing_and_unknown_reference_classes_are_refused_with_those_of_the_map(refused, tmp_path):
    sentence = refused(BUILD, REFERENCE_CLASSES="building;lighthouse")
    assert "“lighthouse”" in sentence and "1 building" in sentence
    unnamed = str(write_raster(tmp_path / "labels.tif", LABELS))
    assert "Reference classes" in refused(BUILD, LABELS=unnamed, REFERENCE_CLASSES="")
