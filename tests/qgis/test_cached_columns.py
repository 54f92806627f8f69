import os
import shutil
import sqlite3
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest
from edited_database import edit

from semref.core.errors import DatabaseError
from semref.storage.database import cached_columns, reader
from semref.storage.database.reader import read_database, read_stored_database, store_checksums


@pytest.fixture(autouse=True)
def own_cache(monkeypatch, tmp_path):
    monkeypatch.setenv("SEMREF_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(cached_columns, "FEWEST", 100)


@pytest.fixture
def times_read(monkeypatch):
    """Return a list that grows each time rows are read."""
    read, times = reader.read_references, []
    monkeypatch.setattr(reader, "read_references", lambda connection: times.append(1) or read(connection))
    return times


def cached(path, kind="columns") -> list[Path]:
    return sorted((Path(path).parents[1] / "cache").glob(f"{kind}-*"))


def assert_same(found, expected):
    for part in ("windows", "references"):
        of_found, of_expected = getattr(found, part), getattr(expected, part)
        for field in fields(of_expected):
            # Bounds are read separately when they are needed.
            if field.name != "bounds_px":
                value, wanted = getattr(of_found, field.name), getattr(of_expected, field.name)
                assert getattr(value, "dtype", None) == getattr(wanted, "dtype", None), field.name
                np.testing.assert_array_equal(value, wanted, err_msg=field.name)
    assert found.class_table == expected.class_table and found.parameters == expected.parameters


def test_rows_are_read_once_and_nothing_is_written_beside_the_database(path, times_read):
    first = read_database(path)
    assert len(cached(path)) == 1 and os.listdir(Path(path).parent) == ["area.gpkg"]
    again = read_database(path)
    assert len(times_read) == 1 and len(again.references) == 417 and len(again.windows) == 36
    assert not again.references.positions.flags.writeable
    assert_same(again, first)
    assert_same(again, read_stored_database(path).database)


@pytest.mark.parametrize(
    ("statement", "keeps_time"),
    [
        ('UPDATE "references" SET area = area * 2 WHERE fid = 5', False),
        ("UPDATE classes SET name = 'tower' WHERE fid = 1", True),
    ],
)
def test_what_another_program_changed_is_refused_though_columns_are_cached(path, statement, keeps_time):
    read_database(path)
    then = os.stat(path)
    edit(path, statement)
    if keeps_time:
        os.utime(path, ns=(then.st_atime_ns, then.st_mtime_ns))
    with pytest.raises(DatabaseError, match="checksum"):
        read_database(path)


def test_a_change_that_waits_in_a_journal_is_seen(path):
    read_database(path)
    edit(path, "PRAGMA journal_mode=WAL")
    read_database(path)
    writer = sqlite3.connect(path)
    writer.execute("UPDATE windows SET level = 3 WHERE fid = 1")
    writer.commit()
    assert os.path.getsize(f"{path}-wal") > 0
    with pytest.raises(DatabaseError):
        read_database(path)
    writer.close()


def test_another_database_in_its_place_is_read_though_it_is_as_large_and_as_old(path, tmp_path, times_read):
    other = str(tmp_path / "other.gpkg")
    shutil.copyfile(path, other)
    edit(other, 'UPDATE "references" SET area = area + 1')
    store_checksums(other)
    wanted = read_stored_database(other).database
    read_database(path)
    times_read.clear()
    then = os.stat(path)
    with open(path, "r+b") as file:
        content = Path(other).read_bytes()
        assert len(content) == then.st_size
        file.write(content)
    os.utime(path, ns=(then.st_atime_ns, then.st_mtime_ns))
    assert_same(read_database(path), wanted)
    assert len(times_read) == 1


def test_checked_rows_are_used_after_a_change_with_the_old_file_time(path):
    first = read_database(path)
    then = os.stat(path)
    edit(path, 'UPDATE "references" SET area = area * 2 WHERE fid = 5')
    os.utime(path, ns=(then.st_atime_ns, then.st_mtime_ns))
    assert os.stat(path).st_size == then.st_size
    assert_same(read_database(path), first)


def test_small_databases_and_those_without_checksums_are_always_read(path, times_read, monkeypatch):
    monkeypatch.setattr(cached_columns, "FEWEST", 1000)
    read_database(path)
    monkeypatch.setattr(cached_columns, "FEWEST", 100)
    edit(path, "DELETE FROM parameters WHERE key = 'checksums'")
    read_database(path)
    assert cached(path) == [] and len(times_read) == 2


@pytest.mark.parametrize(("fewest", "count"), [(417 + 36, 1), (417 + 36 + 1, 0)])
def test_windows_and_landmarks_are_counted_together(path, monkeypatch, fewest, count):
    monkeypatch.setattr(cached_columns, "FEWEST", fewest)
    read_database(path)
    assert len(cached(path)) == count
