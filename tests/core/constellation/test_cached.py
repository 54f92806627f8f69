from dataclasses import fields, replace

import numpy as np
import pytest

from semref.core.constellation import cached
from semref.core.constellation.cached import cached_index
from semref.core.constellation.index import build_index
from semref.core.constellation.settings import CONSTELLATION
from semref.core.database.model import MapLandmarks

COUNT = 900


def landmarks(seed=0):
    rng = np.random.default_rng(seed)
    positions = rng.uniform(0, 3000, (COUNT, 2)) + (600000, 5200000)
    areas, edge = np.exp(rng.normal(5, 1, COUNT)), rng.random(COUNT) < 0.02
    return MapLandmarks(positions, rng.choice([1, 4], COUNT, p=[0.9, 0.1]).astype(np.uint8), areas, edge)


@pytest.fixture(autouse=True)
def own_cache(monkeypatch, tmp_path):
    monkeypatch.setenv("SEMREF_CACHE", str(tmp_path))
    monkeypatch.setattr(cached, "FEWEST", 10)


def loaded(references, settings=CONSTELLATION):
    return cached_index(references, 1.0, settings)


def files(tmp_path):
    return sorted(tmp_path.glob("index-*"))


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


def test_an_index_is_built_once_and_then_loaded_to_the_last_bit(monkeypatch):
    references = landmarks()
    assert_same(loaded(references), references)
    monkeypatch.setattr(cached, "index_parts", lambda *_: pytest.fail("it was built"))
    index = loaded(references)
    assert_same(index, references)
    assert not index.keys.flags.owndata and not index.keys.flags.writeable


@pytest.mark.parametrize("what", ["landmarks", "settings", "pixel", "version"])
def test_an_index_of_something_else_is_built_again(tmp_path, monkeypatch, what):
    loaded(landmarks())
    before = files(tmp_path)
    references, settings, pixel = landmarks(), CONSTELLATION, 1.0
    if what == "landmarks":
        references.areas_m2[7] *= 1.0000001
    elif what == "settings":
        longer = replace(CONSTELLATION.limits, minimum_side_in_sizes=CONSTELLATION.limits.minimum_side_in_sizes * 1.1)
        settings = replace(CONSTELLATION, limits=longer)
    elif what == "pixel":
        pixel = 2.0
    else:
        monkeypatch.setattr(cached, "VERSION", cached.VERSION + 1)
    found = cached_index(references, pixel, settings)
    np.testing.assert_array_equal(found.keys, build_index(references, pixel, settings).keys)
    assert len(before) == 1 and len(files(tmp_path)) == 2
