"""What is kept beside a database is what was made, to the last bit, or it is not used."""

from __future__ import annotations

import os
import time

import numpy as np
import pytest

from semref.core.kept import arrays as kept_arrays
from semref.core.kept.arrays import kept_path, opened_or_made, read_arrays, user_secret, write_arrays

SECRET = bytes(range(32))
KEY = "ab" * 32
SUFFIX = ".semref-index"


def arrays(seed=0):
    rng = np.random.default_rng(seed)
    return {
        "keys": rng.integers(0, 1 << 32, 700, np.uint32),
        "planes": rng.random((7, 9, 3), np.float32)[:, ::-1],
        "none": np.zeros((0, 3), np.float32),
        "flags": rng.integers(0, 255, (50, 2), np.uint8),
    }


@pytest.fixture(autouse=True)
def own_cache(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


@pytest.fixture
def path(tmp_path):
    folder = tmp_path / "maps"
    folder.mkdir()
    return kept_path(str(folder / "area.gpkg"), SUFFIX)


def assert_same(found, expected):
    assert list(found) == list(expected)
    for name, array in expected.items():
        assert found[name].dtype == array.dtype and found[name].shape == array.shape
        np.testing.assert_array_equal(found[name], array)


def opened(path, seed=0, key=KEY, fit=lambda _: True):
    return opened_or_made(path, key, lambda: arrays(seed), fit, "area.gpkg")


def test_they_are_made_once_and_then_opened_to_the_last_bit(path):
    assert_same(opened(path), arrays())
    assert [one.name for one in path.parent.iterdir()] == ["area.gpkg.semref-index"]
    found = opened(path, seed=1)
    assert_same(found, arrays())
    assert not found["keys"].flags.owndata and not found["keys"].flags.writeable


@pytest.mark.parametrize("what", ["key", "shape"])
def test_those_of_something_else_are_made_anew_and_replace_the_older_ones(path, what):
    opened(path)
    key, fit = ("cd" * 32, lambda _: True) if what == "key" else (KEY, lambda found: found["keys"][0] == -1)
    assert_same(opened(path, 1, key, fit), arrays(1))
    assert_same(opened(path, 2, key), arrays(1))


def test_those_that_another_user_or_a_stranger_wrote_are_not_read(path):
    assert write_arrays(path, KEY, SECRET, arrays())
    assert read_arrays(path, KEY, SECRET) is not None
    assert read_arrays(path, KEY, SECRET[::-1]) is None


def test_a_damaged_file_is_not_read_wherever_it_is_damaged(path):
    assert write_arrays(path, KEY, SECRET, arrays())
    rng = np.random.default_rng(3)
    whole = path.read_bytes()
    header = int.from_bytes(whole[16:20], "little") + 52
    places = {*range(0, header, 7), *rng.integers(header, len(whole), 60).tolist()}
    padding = {n for n in places if whole[n] == 0 and n >= header}
    for place in sorted(places - padding):
        path.write_bytes(whole[:place] + bytes([whole[place] ^ 4]) + whole[place + 1 :])
        assert read_arrays(path, KEY, SECRET) is None, place
    for length in (0, 1, 15, 16, 51, 52, 300, header, len(whole) // 2, len(whole) - 1):
        path.write_bytes(whole[:length])
        assert read_arrays(path, KEY, SECRET) is None, length
    path.write_bytes(whole + b"x")
    assert read_arrays(path, KEY, SECRET) is None


def test_a_damaged_file_is_replaced(path):
    opened(path)
    path.write_bytes(path.read_bytes()[:-200])
    assert_same(opened(path, 1), arrays(1))
    assert_same(opened(path, 2), arrays(1))


def test_where_nothing_can_be_kept_they_are_made_and_it_is_said(path, monkeypatch, caplog):
    monkeypatch.setattr(os, "replace", lambda *_: (_ for _ in ()).throw(PermissionError()))
    assert_same(opened(path), arrays())
    assert list(path.parent.iterdir()) == []
    assert [record.details for record in caplog.records] == [{"database": "area.gpkg", "file": path.name}]


def test_without_a_place_for_the_secret_nothing_is_read_or_kept(path, monkeypatch, tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("no folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(blocked))
    assert_same(opened(path), arrays())
    assert not path.exists()


def test_a_user_without_a_home_has_no_secret_and_still_arrays(path, monkeypatch):
    for name in ("XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(kept_arrays.Path, "home", lambda: (_ for _ in ()).throw(RuntimeError("no home directory")))
    assert_same(opened(path), arrays())
    assert not path.exists()


def test_a_secret_that_was_half_written_is_made_anew(path, tmp_path):
    kept = tmp_path / "cache" / "semref" / "index.secret"
    kept.parent.mkdir(parents=True)
    kept.write_bytes(b"half")
    opened(path)
    assert len(kept.read_bytes()) == len(SECRET) and list(kept.parent.iterdir()) == [kept]
    assert_same(opened(path, 1), arrays())
    assert user_secret() == kept.read_bytes()


@pytest.mark.skipif(os.name == "nt", reason="Windows keeps a user's cache by access lists")
def test_only_the_user_may_read_the_secret_and_what_is_kept(path, tmp_path):
    opened(path)
    for file in (tmp_path / "cache" / "semref" / "index.secret", path):
        assert file.stat().st_mode & 0o077 == 0, file


def test_what_a_killed_writer_left_goes_with_the_next_write(path):
    """And nothing that is still written, or is another database's."""
    names = ".area.gpkg.a1.semref-index.new", ".area.gpkg.b2.semref-index.new", ".b.c3.semref-index.new"
    left, written, others = (path.parent / name for name in names)
    for file in (left, written, others):
        file.write_bytes(b"half")
    for file in (left, others):
        os.utime(file, (0, 0))
    os.utime(written, (time.time(),) * 2)
    opened(path)
    assert path.exists()
    assert sorted(file.name for file in path.parent.glob(".*.new")) == sorted([written.name, others.name])
