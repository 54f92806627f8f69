import os
import shutil
import sqlite3
import threading
from contextlib import closing
from pathlib import Path
from unittest.mock import Mock

import numpy as np
import pytest
from edited_database import edit
from full_disks import files_of_at_most
from qgis.core import QgsRectangle

from semref.core.errors import SemRefError
from semref.processing.inspection.correction import DrawnFeature, changed_bounds
from semref.storage.database import undo
from semref.storage.database.reader import read_database, store_checksums
from semref.storage.database.undo import can_undo, file_before, replace_keeping, stated_checksums, undo_update
from semref.storage.vector_files import copy_whole


def larger(path, tmp_path, square_meters):
    """Write an updated database elsewhere: all landmarks are larger."""
    updated = str(shutil.copy(path, tmp_path / "updated.gpkg"))
    edit(updated, f'UPDATE "references" SET area = area + {square_meters}')
    store_checksums(updated)
    return updated


def areas(path):
    return read_database(path).references.areas_m2


def content(path):
    return {file.name: file.read_bytes() for file in Path(path).parent.iterdir()}


def dump(path):
    with closing(sqlite3.connect(path)) as connection:
        return list(connection.iterdump())


@pytest.fixture
def updated_path(path, tmp_path):
    """Return the path of a database after an update that can be undone."""
    replace_keeping(path, larger(path, tmp_path, 5))
    return path


def assert_not_undone(path, message=None):
    """Require that the undo is refused and leaves all files as they are."""
    before = content(path)
    with pytest.raises(SemRefError, match=message):
        undo_update(path)
    assert content(path) == before


def test_undo_gives_back_what_was_there_before_the_update(path, tmp_path):
    before, was = dump(path), areas(path)
    replace_keeping(path, larger(path, tmp_path, 5))
    np.testing.assert_allclose(areas(path), was + 5)
    np.testing.assert_array_equal(areas(file_before(path)), was)
    undo_update(path)
    assert dump(path) == before
    assert os.listdir(tmp_path / "maps") == ["area.gpkg"] and not can_undo(path)


def test_the_old_file_itself_is_kept_and_the_new_one_moved(path, tmp_path):
    updated = larger(path, tmp_path, 5)
    old, new = os.stat(path).st_ino, os.stat(updated).st_ino
    replace_keeping(path, updated)
    assert (os.stat(file_before(path)).st_ino, os.stat(path).st_ino) == (old, new)
    assert not os.path.exists(updated)


def test_a_database_that_is_another_one_than_was_updated_is_not_replaced(path, tmp_path):
    planned, updated = stated_checksums(path), larger(path, tmp_path, 5)
    os.replace(larger(path, tmp_path / "maps", 7), path)
    before = content(path)
    with pytest.raises(SemRefError, match="was changed by another program"):
        replace_keeping(path, updated, planned)
    assert content(path) == before
    replace_keeping(path, updated, stated_checksums(path))


def no_links(monkeypatch, path):
    monkeypatch.setattr(os, "link", Mock(side_effect=OSError(95, "Operation not supported")))


def in_wal(monkeypatch, path):
    monkeypatch.setattr(undo, "_link", lambda *_: False)
    with closing(sqlite3.connect(path)) as connection:
        connection.execute("PRAGMA journal_mode=WAL")


@pytest.mark.parametrize("case", [no_links, lambda _, path: os.link(path, f"{path}.mine"), in_wal])
def test_a_copy_is_kept_where_the_old_file_can_t_be(path, tmp_path, monkeypatch, case):
    case(monkeypatch, path)
    was, inode = areas(path), os.stat(path).st_ino
    replace_keeping(path, larger(path, tmp_path, 5))
    assert os.stat(file_before(path)).st_ino != inode
    undo_update(path)
    np.testing.assert_array_equal(areas(path), was)


@pytest.fixture
def break_replacing(monkeypatch):
    """`break_replacing(name)` refuses to replace the file of that name."""
    replace = os.replace

    def broken(name):
        def run(source, target):
            if os.path.basename(target) == name:
                raise PermissionError(13, "Permission denied")
            replace(source, target)

        monkeypatch.setattr(os, "replace", run)

    return broken


def test_an_update_that_can_t_be_put_in_place_leaves_the_database_and_no_trace_in_it(path, tmp_path, break_replacing):
    updated, was = larger(path, tmp_path, 5), areas(path)
    break_replacing("area_before_update.gpkg")
    with pytest.raises(SemRefError, match="can't be replaced"):
        replace_keeping(path, updated)
    np.testing.assert_array_equal(areas(path), was)
    assert os.listdir(tmp_path / "maps") == ["area.gpkg"]
    assert not any("semref_undo" in line for line in dump(path))


def test_an_undo_that_ends_before_the_last_step_leaves_both_files(updated_path, break_replacing):
    break_replacing("area.gpkg")
    assert_not_undone(updated_path)


def test_a_copy_of_the_user_s_own_under_the_name_of_the_kept_file_is_not_replaced(path, tmp_path):
    own = Path(shutil.copy(path, file_before(path)))
    before = own.read_bytes(), content(path)
    with pytest.raises(SemRefError, match="was not made by an update"):
        replace_keeping(path, larger(path, tmp_path, 5))
    assert (own.read_bytes(), content(path)) == before


def test_two_updates_are_undone_by_one_though_somebody_styled_the_layers_since(path, tmp_path):
    was = areas(path)
    for _ in range(2):
        replace_keeping(path, larger(path, tmp_path, 5))
    edit(path, "UPDATE layer_styles SET description = 'mine'")
    undo_update(path)
    np.testing.assert_allclose(areas(path), was + 5)
    assert not can_undo(path)


def test_an_update_by_processing_after_the_last_one_is_not_undone_with_it(updated_path, tmp_path):
    os.replace(larger(updated_path, tmp_path, 7), updated_path)
    assert_not_undone(updated_path, "can't be undone")


def flip_overview(before):
    edit(before, "UPDATE overview SET tile_data = substr(tile_data, 1, 200) || zeroblob(length(tile_data) - 200)")


DAMAGES = {
    "empty": lambda before: Path(before).write_bytes(b""),
    "no database": lambda before: Path(before).write_bytes(b"SQLite format 3\0" + bytes(5000)),
    "truncated": lambda before: os.truncate(before, os.path.getsize(before) // 2),
    "changed row": lambda before: edit(before, 'UPDATE "references" SET area = 3 WHERE fid = 7'),
    "changed bounds": lambda before: edit(before, "UPDATE reference_bounds SET end_row = end_row + 1 WHERE fid = 7"),
    "changed overview": flip_overview,
    "missing table": lambda before: edit(before, "DROP TABLE windows"),
    "no record": lambda before: edit(before, "DROP TABLE semref_undo"),
    "foreign": lambda before: edit(before, "UPDATE semref_undo SET checksums = '{}'"),
}


@pytest.mark.parametrize("damage", DAMAGES.values(), ids=DAMAGES)
def test_a_damaged_or_foreign_file_is_not_restored_and_both_files_stay(updated_path, damage):
    damage(file_before(updated_path))
    assert_not_undone(updated_path)


@pytest.mark.skipif(os.name == "nt", reason="limits on files as Unix has them")
def test_a_full_disk_leaves_both_files(updated_path):
    with files_of_at_most(os.path.getsize(updated_path) // 2):
        assert_not_undone(updated_path, "can't be written")


def test_a_file_that_another_program_locks_is_not_replaced(updated_path, short_wait):
    with closing(sqlite3.connect(updated_path, isolation_level=None)) as other:
        other.execute("BEGIN IMMEDIATE")
        assert_not_undone(updated_path)


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "some.gpkg"
    with closing(sqlite3.connect(path)) as made:
        made.execute("CREATE TABLE numbers AS SELECT 7 AS number")
        made.commit()
    return path


def copied(file, target):
    """Copy in a thread, so that an endless copy fails; return the error or None."""
    raised = []

    def work():
        with closing(sqlite3.connect(file)) as source, closing(sqlite3.connect(target)) as copy:
            try:
                copy_whole(source, copy)
            except Exception as error:
                raised.append(error)

    thread = threading.Thread(target=work, daemon=True)
    thread.start()
    thread.join(60)
    assert not thread.is_alive(), "the copy waits for good"
    return raised[0] if raised else None


@pytest.mark.parametrize("is_written", [False, True])
def test_a_copy_waits_for_a_writer_that_ends_soon_and_contains_what_was_committed(file, tmp_path, is_written):
    with closing(sqlite3.connect(file, isolation_level=None, check_same_thread=False)) as other:
        timer = threading.Timer(0.3, other.rollback)
        if is_written:
            other.execute("BEGIN EXCLUSIVE")
            timer.start()
        assert copied(file, tmp_path / "copy.gpkg") is None
        if is_written:
            timer.join()
    with closing(sqlite3.connect(tmp_path / "copy.gpkg")) as copy:
        assert copy.execute("SELECT number FROM numbers").fetchall() == [(7,)]


@pytest.mark.slow
def test_a_file_that_another_program_keeps_locked_is_reported(file, tmp_path):
    with closing(sqlite3.connect(file, isolation_level=None)) as other:
        other.execute("BEGIN EXCLUSIVE")
        error = copied(file, tmp_path / "copy.gpkg")
    assert isinstance(error, sqlite3.OperationalError) and "locked" in str(error)


def drawn(**digests):
    """Return features with these digests, each at its own place."""
    return {
        ord(name): DrawnFeature(digest, QgsRectangle(ord(name), digest, ord(name) + 1, digest + 1))
        for name, digest in digests.items()
    }


@pytest.mark.parametrize(
    ("now", "changed"),
    [
        ({"a": 1, "b": 1, "c": 1}, set()),
        ({"a": 1, "b": 2, "c": 1}, {("b", 1), ("b", 2)}),
        ({"a": 1, "c": 1}, {("b", 1)}),
        ({"a": 1, "b": 1, "c": 1, "d": 4}, {("d", 4)}),
        ({"c": 1, "a": 1, "b": 1}, {("a", 1), ("b", 1), ("c", 1)}),
        ({"d": 1, "b": 3, "c": 1}, {("a", 1), ("b", 1), ("b", 3), ("d", 1)}),
    ],
    ids=["nothing", "changed", "removed", "added", "moved to the bottom", "several"],
)
def test_old_and_new_places_of_all_that_differs_are_found(qgis_app, now, changed):
    found = changed_bounds(drawn(a=1, b=1, c=1), drawn(**now))
    assert {(chr(int(place.xMinimum())), int(place.yMinimum())) for place in found} == changed
