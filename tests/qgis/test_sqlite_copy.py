"""Copies of SQLite files while other programs use them."""

import sqlite3
import threading
from contextlib import closing

import pytest

from semref.storage.vector_files import copy_whole

LIMIT_S = 60


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
    thread.join(LIMIT_S)
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
