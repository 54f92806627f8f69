"""Files of earlier versions open, and large tables are read in batches with the same result."""

import sqlite3
import struct
from dataclasses import fields

import numpy as np
import pytest
from edited_database import KEPT, edit, kept_database
from onboard_area import CENTER, HERE

from semref.core.errors import DatabaseError
from semref.core.localization import Method
from semref.core.localizer.localizer import Localizer
from semref.core.onboard.read import read_onboard
from semref.storage.database import rows
from semref.storage.database.reader import read_database, read_stored_database
from semref.storage.database.rows import columns_of, points_of

POINTS = np.array([(600000.25, 5200000.5), (-1.0, 2.0), (0.0, 1e9)])


@pytest.fixture
def path(tmp_path):
    return kept_database(tmp_path / "database.gpkg")


def assert_same(found, expected):
    for field in fields(expected):
        value, wanted = getattr(found, field.name), getattr(expected, field.name)
        if isinstance(wanted, np.ndarray):
            assert (value.dtype, value.shape) == (wanted.dtype, wanted.shape), field.name
            np.testing.assert_array_equal(value, wanted, err_msg=field.name)


@pytest.mark.parametrize("batch", [1, 7, 36])
def test_a_database_read_in_small_batches_is_the_same(path, monkeypatch, batch):
    whole = read_stored_database(path)
    monkeypatch.setattr(rows, "BATCH", batch)
    again = read_stored_database(path)
    assert_same(again.database.references, whole.database.references)
    assert_same(again.database.windows, whole.database.windows)
    assert again.database.references.bounds_px.shape == (417, 4)


def test_a_landmark_with_an_impossible_class_is_found_in_any_batch(path, monkeypatch):
    """The landmark is in the last row of the last batch."""
    edit(path, 'UPDATE "references" SET class = 900 WHERE fid = (SELECT max(fid) FROM "references")')
    monkeypatch.setattr(rows, "BATCH", 100)
    with pytest.raises(DatabaseError, match="class that is not a reference class"):
        read_database(path)


def test_a_query_without_rows_gives_empty_arrays():
    connection = sqlite3.connect(":memory:")
    connection.execute("CREATE TABLE t (a, b)")
    (found,) = columns_of(connection, "SELECT a, b FROM t", lambda columns: [np.array(columns, float).T])
    assert found.shape == (0, 2)


def blob(xy, order="<", envelope=b""):
    return b"GP\0\1" + b"\0" * 4 + envelope + struct.pack(f"{order}BIdd", order == "<", 1, *xy)


@pytest.mark.parametrize("orders", ["<<<", ">>>", "<><"])
def test_points_of_either_byte_order_are_read(orders):
    found = points_of([blob(xy, order) for xy, order in zip(POINTS, orders)])
    assert found.dtype == np.float64
    np.testing.assert_array_equal(found, POINTS)
    assert points_of([]).shape == (0, 2)


def test_a_point_that_was_cut_short_is_refused():
    with pytest.raises(struct.error):
        points_of([blob(POINTS[0]), blob(POINTS[1])[:-3]])


def check(database):
    """Require the map of tests/data/onboard_area.py and the right position of an image."""
    assert (len(database.references), len(database.windows)) == (417, 36)
    result = Localizer(database).localize(HERE, Method.AUTOMATIC)
    assert result.is_fix and np.allclose(result.position, CENTER, atol=0.5)


def test_a_database_and_an_onboard_file_of_format_1_open_and_localize(tmp_path):
    check(read_database(kept_database(tmp_path / "database.gpkg"), with_overview=True))
    check(read_onboard(str(KEPT / "onboard.npz")).database)
