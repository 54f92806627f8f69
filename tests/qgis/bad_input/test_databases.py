"""Files that are no database, and truncated or edited databases, are refused."""

from __future__ import annotations

import contextlib
import shutil
import sqlite3
from pathlib import Path

import pytest
from bad_input import DESCRIBE, LOCALIZE


@pytest.fixture
def copied(good, tmp_path):
    return Path(shutil.copy(good / "area.gpkg", tmp_path / "copy.gpkg"))


@contextlib.contextmanager
def edited(path):
    with contextlib.closing(sqlite3.connect(path)) as connection:
        # GeoPackage triggers call functions that plain SQLite does not have.
        for (name,) in connection.execute("SELECT name FROM sqlite_master WHERE type = 'trigger'").fetchall():
            connection.execute(f'DROP TRIGGER "{name}"')
        # As a deliberate change to a database would.
        connection.execute("DELETE FROM parameters WHERE key = 'checksums'")
        yield connection
        connection.commit()


@pytest.mark.parametrize("algorithm", [LOCALIZE, DESCRIBE])
def test_a_missing_database_is_named(refused, algorithm):
    assert "/nowhere/area.gpkg" in refused(algorithm, DATABASE="/nowhere/area.gpkg")


@pytest.mark.parametrize("path", ["", " "])
def test_where_no_database_is_named_the_sentence_has_no_hole_in_it(qgis_app, path):
    from qgis.core import QgsProject

    from semref.core.errors import DatabaseError
    from semref.processing.layers.database_layers import add_database_to_map
    from semref.processing.messages.sentences import worded
    from semref.storage.database.reader import read_database

    for reads in (read_database, lambda path: add_database_to_map(path, QgsProject.instance())):
        with pytest.raises(DatabaseError) as caught:
            reads(path)
        assert worded(caught.value) == "No database is named; build one or choose a file."


@pytest.mark.parametrize("content", [b"", b"hello", b"SQLite format 3\x00", b"SQLite format 3\x00" + bytes(200)])
def test_a_file_that_is_no_geopackage_is_refused(refused, tmp_path, content):
    (tmp_path / "notes.gpkg").write_bytes(content)
    assert "notes.gpkg" in refused(LOCALIZE, DATABASE=str(tmp_path / "notes.gpkg"))


def test_a_folder_is_no_database(refused, tmp_path):
    assert "DATABASE" in refused(LOCALIZE, DATABASE=str(tmp_path))


def test_a_foreign_geopackage_is_refused_with_what_it_lacks(refused, good):
    sentence = refused(LOCALIZE, DATABASE=str(good / "annotation.gpkg"))
    assert "annotation.gpkg" in sentence and "windows" in sentence and "parameters" in sentence


@pytest.mark.parametrize("share", [0.001, 0.01, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99])
def test_a_truncated_database_is_refused_at_whatever_length(refused, copied, share):
    content = copied.read_bytes()
    copied.write_bytes(content[: int(len(content) * share)])
    assert "copy.gpkg" in refused(LOCALIZE, DATABASE=str(copied))


def test_a_newer_format_version_is_refused_with_both_numbers(refused, copied):
    with edited(copied) as connection:
        connection.execute("UPDATE parameters SET value = '7' WHERE key = 'format_version'")
        connection.execute("INSERT INTO parameters (key, value) VALUES ('new_in_7', '1')")
    sentence = refused(LOCALIZE, DATABASE=str(copied))
    assert "7" in sentence and "update" in sentence


def test_vectors_of_another_length_are_refused(refused, copied):
    with edited(copied) as connection:
        connection.execute("UPDATE parameters SET value = '11' WHERE key = 'references_per_vector'")
    assert "33" in refused(LOCALIZE, DATABASE=str(copied))


@pytest.mark.parametrize("statement", ["DELETE FROM windows", "UPDATE windows SET vector = NULL"])
def test_a_database_without_vectors_is_refused_by_the_method_that_needs_them(refused, copied, statement):
    with edited(copied) as connection:
        connection.execute(statement)
    assert "topology vector" in refused(LOCALIZE, DATABASE=str(copied), METHOD=1)
