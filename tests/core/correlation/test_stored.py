"""A kept pyramid is the one that was made, to the last bit, or it is not used."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from semref.core.correlation import stored
from semref.core.correlation.class_pyramid import MapPyramid, part_shapes, pyramid_parts
from semref.core.correlation.settings import CORRELATION
from semref.core.correlation.solver import localize
from semref.core.correlation.stored import pyramid_path, stored_pyramid
from semref.core.geometry.frame import MapFrame
from semref.core.localization import Prior

FRAME = MapFrame.at((500_000.0, 5_200_000.0), 4.0)


def overview(seed=0, shape_hw=(203, 310)):
    small = np.random.default_rng(seed).integers(0, 4, (shape_hw[0] // 9 + 1, shape_hw[1] // 9 + 1)).astype(np.uint8)
    return np.ascontiguousarray(np.kron(small, np.ones((9, 9), np.uint8))[: shape_hw[0], : shape_hw[1]])


@pytest.fixture(autouse=True)
def own_cache(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr(stored, "FEWEST_PIXELS", 100)


@pytest.fixture
def database(tmp_path):
    folder = tmp_path / "maps"
    folder.mkdir()
    return str(folder / "area.gpkg")


def opened(database, labels_hw, settings=CORRELATION):
    return stored_pyramid(labels_hw, FRAME, settings, database)


def never_made(monkeypatch):
    monkeypatch.setattr(stored, "pyramid_parts", lambda *_: pytest.fail("it was made"))


def assert_same(pyramid, expected):
    assert pyramid.energy == expected.energy and pyramid.bytes == expected.bytes
    for name in ("values", "usual", "projection"):
        np.testing.assert_array_equal(getattr(pyramid.space, name), getattr(expected.space, name))
    assert pyramid.level_of(1e9) == expected.level_of(1e9)
    for number in range(expected.level_of(1e9) + 1):
        level, wanted = pyramid.stored(number), expected.stored(number)
        assert (level is None) == (wanted is None)
        if level is not None:
            assert level.pixel == wanted.pixel
            np.testing.assert_array_equal(level.evidence, wanted.evidence)
            np.testing.assert_array_equal(level.known, wanted.known)


def test_it_is_made_once_and_then_opened_to_the_last_bit(database, monkeypatch):
    labels = overview()
    assert_same(opened(database, labels), MapPyramid(labels, FRAME))
    assert [path.name for path in pyramid_path(database).parent.iterdir()] == ["area.gpkg.semref-pyramid"]
    never_made(monkeypatch)
    pyramid = opened(database, labels)
    assert_same(pyramid, MapPyramid(labels, FRAME))
    assert not pyramid.stored(3).evidence.flags.writeable


def test_an_image_is_found_in_an_opened_one_as_in_one_that_was_made(database):
    labels = overview(7, (400, 400))
    image = labels[100:260, 150:310]
    prior = Prior(pixel_size_range=(3.8, 4.2))
    opened(database, labels)
    found, expected = (localize(image, one, prior) for one in (opened(database, labels), MapPyramid(labels, FRAME)))
    assert expected.best is not None and found.best == expected.best and found.risk == expected.risk


@pytest.mark.parametrize("what", ["labels", "shape", "settings", "version"])
def test_a_pyramid_of_something_else_is_made_anew(database, monkeypatch, what):
    labels, settings = overview(), CORRELATION
    opened(database, labels)
    before = pyramid_path(database).read_bytes()
    if what == "labels":
        labels = labels.copy()
        labels[17, 5] = 3 - labels[17, 5]
    elif what == "shape":
        labels = np.ascontiguousarray(labels.reshape(310, 203))
    elif what == "settings":
        settings = replace(CORRELATION, rarity_exponent=0.25)
    else:
        monkeypatch.setattr(stored, "VERSION", stored.VERSION + 1)
    assert_same(opened(database, labels, settings), MapPyramid(labels, FRAME, settings))
    assert pyramid_path(database).read_bytes() != before


def test_settings_that_only_tell_how_it_is_searched_leave_it_as_it_is(database, monkeypatch):
    opened(database, overview())
    never_made(monkeypatch)
    assert opened(database, overview(), replace(CORRELATION, candidates=7)).settings.candidates == 7


def test_small_maps_and_those_of_no_file_are_not_kept(database, monkeypatch):
    opened(None, overview())
    monkeypatch.setattr(stored, "FEWEST_PIXELS", overview().size + 1)
    opened(database, overview())
    assert not pyramid_path(database).exists()


@pytest.mark.parametrize("shape_hw", [(1, 1), (4, 4), (5, 3), (17, 64), (203, 310)])
@pytest.mark.parametrize("classes", [0, 1, 4, 7])
def test_the_kinds_of_its_parts_are_those_that_are_expected(shape_hw, classes):
    labels = np.random.default_rng(1).integers(0, classes + 1, shape_hw).astype(np.uint8)
    parts = pyramid_parts(labels, CORRELATION.rarity_exponent)
    channels, found = parts["projection"].shape
    assert {n: (a.dtype.str, a.shape) for n, a in parts.items()} == part_shapes(shape_hw, found, channels)
