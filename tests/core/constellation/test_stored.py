"""A kept index is the one that was built, to the last bit, or it is not used."""

from __future__ import annotations

import os
from dataclasses import fields, replace

import numpy as np
import pytest

from semref.core.constellation import stored
from semref.core.constellation.index import build_index, index_parts
from semref.core.constellation.settings import CONSTELLATION
from semref.core.constellation.stored import index_path, key_of, read_parts, stored_index, write_parts
from semref.core.database.model import MapLandmarks

COUNT = 900
SECRET = bytes(range(32))


def landmarks(seed=0):
    rng = np.random.default_rng(seed)
    positions = rng.uniform(0, 3000, (COUNT, 2)) + (600000, 5200000)
    areas, edge = np.exp(rng.normal(5, 1, COUNT)), rng.random(COUNT) < 0.02
    return MapLandmarks(positions, rng.choice([1, 4], COUNT, p=[0.9, 0.1]).astype(np.uint8), areas, edge)


@pytest.fixture(autouse=True)
def own_cache(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr(stored, "FEWEST", 10)


@pytest.fixture
def database(tmp_path):
    folder = tmp_path / "maps"
    folder.mkdir()
    return str(folder / "area.gpkg")


def opened(database, references, settings=CONSTELLATION):
    return stored_index(references, 1.0, settings, database)


def assert_same(index, references):
    expected = build_index(references, 1.0)
    for field in fields(expected):
        value, wanted = getattr(index, field.name), getattr(expected, field.name)
        if isinstance(wanted, np.ndarray):
            assert value.dtype == wanted.dtype, field.name
            np.testing.assert_array_equal(value, wanted, err_msg=field.name)
        elif field.name != "matcher":
            assert value == wanted, field.name
    places = np.array([[600100 + 5200100j - expected.origin, 0j]])
    for found, wanted in zip(
        index.matcher.match(places, np.array([0, 1])), expected.matcher.match(places, np.array([0, 1]))
    ):
        np.testing.assert_array_equal(found, wanted)


def never_built(monkeypatch):
    monkeypatch.setattr(stored, "index_parts", lambda *_: pytest.fail("it was built"))


def test_it_is_built_once_and_then_opened_to_the_last_bit(database, monkeypatch):
    references = landmarks()
    assert_same(opened(database, references), references)
    assert [path.name for path in index_path(database).parent.iterdir()] == ["area.gpkg.semref-index"]
    never_built(monkeypatch)
    index = opened(database, references)
    assert_same(index, references)
    assert not index.keys.flags.owndata and not index.keys.flags.writeable


@pytest.mark.parametrize("what", ["landmarks", "settings", "pixel", "version"])
def test_an_index_of_something_else_is_built_anew(database, monkeypatch, what):
    opened(database, landmarks())
    before = index_path(database).read_bytes()
    references, settings, pixel = landmarks(), CONSTELLATION, 1.0
    if what == "landmarks":
        references.areas_m2[7] *= 1.0000001
    elif what == "settings":
        settings = replace(CONSTELLATION, minimum_side_in_sizes=CONSTELLATION.minimum_side_in_sizes * 1.1)
    elif what == "pixel":
        pixel = 2.0
    else:
        monkeypatch.setattr(stored, "VERSION", stored.VERSION + 1)
    found = stored_index(references, pixel, settings, database)
    np.testing.assert_array_equal(found.keys, build_index(references, pixel, settings).keys)
    assert index_path(database).read_bytes() != before


def test_few_landmarks_and_those_of_no_file_are_not_kept(database, monkeypatch):
    opened(None, landmarks())
    monkeypatch.setattr(stored, "FEWEST", COUNT + 1)
    opened(database, landmarks())
    assert not index_path(database).exists()


def written(path, references=None):
    references = references or landmarks()
    key = key_of(references, 1.0, CONSTELLATION)
    assert write_parts(path, key, SECRET, index_parts(references, 1.0, CONSTELLATION))
    return key


def test_one_that_another_user_or_a_stranger_made_is_not_read(tmp_path):
    key = written(tmp_path / "a.semref-index")
    assert read_parts(tmp_path / "a.semref-index", key, SECRET) is not None
    assert read_parts(tmp_path / "a.semref-index", key, SECRET[::-1]) is None


def test_a_damaged_one_is_not_read_wherever_it_is_damaged(tmp_path):
    path = tmp_path / "a.semref-index"
    key, rng = written(path), np.random.default_rng(3)
    whole = path.read_bytes()
    header = int.from_bytes(whole[16:20], "little") + 52
    places = {*range(0, header, 7), *rng.integers(header, len(whole), 60).tolist()}
    padding = {n for n in places if whole[n] == 0 and n >= header}
    for place in sorted(places - padding):
        path.write_bytes(whole[:place] + bytes([whole[place] ^ 4]) + whole[place + 1 :])
        assert read_parts(path, key, SECRET) is None, place
    for length in (0, 1, 15, 16, 51, 52, 300, header, len(whole) // 2, len(whole) - 1):
        path.write_bytes(whole[:length])
        assert read_parts(path, key, SECRET) is None, length
    path.write_bytes(whole + b"x")
    assert read_parts(path, key, SECRET) is None


def test_a_damaged_one_is_replaced(database, monkeypatch):
    references = landmarks()
    opened(database, references)
    path = index_path(database)
    path.write_bytes(path.read_bytes()[:-200])
    assert_same(opened(database, references), references)
    never_built(monkeypatch)
    assert_same(opened(database, references), references)


def test_where_nothing_can_be_kept_it_is_built_and_said(database, monkeypatch, caplog):
    monkeypatch.setattr(os, "replace", lambda *_: (_ for _ in ()).throw(PermissionError()))
    references = landmarks()
    assert_same(opened(database, references), references)
    assert list(index_path(database).parent.iterdir()) == []
    assert len(caplog.records) == 1 and caplog.records[0].details == {"database": database}


def test_without_a_place_for_the_secret_nothing_is_read_or_kept(database, monkeypatch, tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("no folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(blocked))
    references = landmarks()
    assert_same(opened(database, references), references)
    assert not index_path(database).exists()


def test_a_user_without_a_home_has_no_secret_and_still_an_index(database, monkeypatch):
    for name in ("XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(stored.Path, "home", lambda: (_ for _ in ()).throw(RuntimeError("no home directory")))
    references = landmarks()
    assert_same(opened(database, references), references)
    assert not index_path(database).exists()


def test_a_secret_that_was_half_written_is_made_anew(database, monkeypatch, tmp_path):
    kept = tmp_path / "cache" / "semref" / "index.secret"
    kept.parent.mkdir(parents=True)
    kept.write_bytes(b"half")
    opened(database, landmarks())
    assert len(kept.read_bytes()) == len(SECRET) and list(kept.parent.iterdir()) == [kept]
    never_built(monkeypatch)
    opened(database, landmarks())


@pytest.mark.skipif(os.name == "nt", reason="Windows keeps a user's cache by access lists")
def test_only_the_user_may_read_the_secret_and_the_index(database, tmp_path):
    opened(database, landmarks())
    for path in (tmp_path / "cache" / "semref" / "index.secret", index_path(database)):
        assert path.stat().st_mode & 0o077 == 0, path


def test_what_a_killed_writer_left_goes_with_the_next_write(database):
    """And nothing that is still written, or is another database's."""
    folder = index_path(database).parent
    left, written, others = (folder / f".{name}.semref-index.new" for name in ("area.gpkg.a1", "area.gpkg.b2", "b.c3"))
    for path in (left, written, others):
        path.write_bytes(b"half")
    for path in (left, others):
        os.utime(path, (0, 0))
    opened(database, landmarks())
    assert index_path(database).exists()
    assert sorted(path.name for path in folder.glob(".*.new")) == sorted([written.name, others.name])
