"""Files that are no database, and truncated or edited databases, are refused."""

import shutil

import pytest
from bad_input import DESCRIBE, LOCALIZE
from edited_database import edit
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
    assert "DATABASE" in refused(algorithm, DATABASE=str(tmp_path))


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
