"""A kept index is the one that was built, to the last bit, or it is not used."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest

from semref.core.constellation import stored
from semref.core.constellation.index import build_index
from semref.core.constellation.settings import CONSTELLATION
from semref.core.constellation.stored import index_path, stored_index
from semref.core.database.model import MapLandmarks

COUNT = 900


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
