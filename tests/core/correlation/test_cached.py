from dataclasses import replace

import numpy as np
import pytest

from semref.core.correlation import cached
from semref.core.correlation.cached import cached_pyramid
from semref.core.correlation.class_pyramid import MapPyramid
from semref.core.correlation.settings import CORRELATION
from semref.core.geometry.frame import MapFrame

FRAME = MapFrame.at((500_000.0, 5_200_000.0), 4.0)
FEWEST_PIXELS = cached.FEWEST_PIXELS


def overview(seed=0, shape_hw=(203, 310)):
    small = np.random.default_rng(seed).integers(0, 4, (shape_hw[0] // 9 + 1, shape_hw[1] // 9 + 1)).astype(np.uint8)
    return np.ascontiguousarray(np.kron(small, np.ones((9, 9), np.uint8))[: shape_hw[0], : shape_hw[1]])


@pytest.fixture(autouse=True)
def own_cache(monkeypatch, tmp_path):
    monkeypatch.setenv("SEMREF_CACHE", str(tmp_path))
    monkeypatch.setattr(cached, "FEWEST_PIXELS", 100)


def loaded(labels_hw, settings=CORRELATION):
    return cached_pyramid(labels_hw, FRAME, settings)


def files(tmp_path):
    return sorted(tmp_path.glob("pyramid-*"))


def never_made(monkeypatch):
    monkeypatch.setattr(cached, "pyramid_parts", lambda *_: pytest.fail("it was made"))


def assert_same(pyramid, expected):
    assert pyramid.energy == expected.energy
    for name in ("values", "usual", "projection"):
        np.testing.assert_array_equal(getattr(pyramid.space, name), getattr(expected.space, name))
    assert pyramid.level_of(1e9) == expected.level_of(1e9)
    for number in range(expected.level_of(1e9) + 1):
        level, wanted = pyramid.whole(number), expected.whole(number)
        assert (level is None) == (wanted is None)
        if level is not None:
            assert level.pixel == wanted.pixel
            np.testing.assert_array_equal(level.evidence, wanted.evidence)
            np.testing.assert_array_equal(level.known, wanted.known)


def test_a_pyramid_is_made_once_and_then_loaded_to_the_last_bit(monkeypatch):
    labels = overview()
    assert_same(loaded(labels), MapPyramid(labels, FRAME))
    never_made(monkeypatch)
    pyramid = loaded(labels)
    assert_same(pyramid, MapPyramid(labels, FRAME))
    assert not pyramid.whole(3).evidence.flags.writeable


@pytest.mark.parametrize(("columns", "is_kept"), [(2500, True), (2400, False)])
def test_the_pyramid_of_80_square_kilometers_at_4_meters_is_kept(monkeypatch, tmp_path, columns, is_kept):
    monkeypatch.setattr(cached, "FEWEST_PIXELS", FEWEST_PIXELS)
    loaded(overview(shape_hw=(2000, columns)))
    assert len(files(tmp_path)) == is_kept


@pytest.mark.parametrize("what", ["labels", "shape", "settings", "version"])
def test_a_pyramid_of_something_else_is_made_again(tmp_path, monkeypatch, what):
    labels, settings = overview(), CORRELATION
    loaded(labels)
    before = files(tmp_path)
    if what == "labels":
        labels = labels.copy()
        labels[17, 5] = 3 - labels[17, 5]
    elif what == "shape":
        labels = np.ascontiguousarray(labels.reshape(310, 203))
    elif what == "settings":
        settings = replace(CORRELATION, rarity_exponent=0.25)
    else:
        monkeypatch.setattr(cached, "VERSION", cached.VERSION + 1)
    assert_same(loaded(labels, settings), MapPyramid(labels, FRAME, settings))
    assert len(before) == 1 and len(files(tmp_path)) == 2


def test_search_settings_do_not_change_the_pyramid(monkeypatch):
    loaded(overview())
    never_made(monkeypatch)
    assert loaded(overview(), replace(CORRELATION, candidates=7)).settings.candidates == 7
