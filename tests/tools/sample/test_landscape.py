import numpy as np
import pytest
import shapely

from sample import classes, landscape

SEED = 1671
SMALL_XY = (1500.0, 1300.0)
"""Edge in meters of a small landscape."""

pytestmark = pytest.mark.slow
"""Tests that create a whole landscape."""


@pytest.fixture(scope="module")
def land():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(landscape, "SIZE_XY", SMALL_XY)
        return landscape.make_landscape(SEED)


def test_the_same_seed_gives_the_same_landscape(land, monkeypatch):
    monkeypatch.setattr(landscape, "SIZE_XY", SMALL_XY)
    again = landscape.make_landscape(SEED)
    assert [(f.class_value, f.zorder, f.geometry and f.geometry.wkb) for f in again.features] == [
        (f.class_value, f.zorder, f.geometry and f.geometry.wkb) for f in land.features
    ]


def test_the_landscape_fills_its_extent_and_nothing_leaves_it(land):
    bounds = np.array([f.geometry.bounds for f in land.features if f.geometry is not None])
    assert (*bounds[:, :2].min(axis=0), *bounds[:, 2:].max(axis=0)) == land.extent


def test_oddities_are_few_and_present(land):
    drawn = [f.geometry for f in land.features if f.geometry is not None]
    assert len(land.features) - len(drawn) == 1
    assert sum(not g.is_valid for g in drawn) == landscape.BOW_TIES
    assert 1 <= sum(g.geom_type == "MultiPolygon" for g in drawn) <= 80


def test_no_house_is_in_water(land):
    water = [f.geometry for f in land.features if f.class_value == classes.WATER]
    houses = [f.geometry for f in land.features if f.class_value == classes.BUILDING]
    assert houses
    tree = shapely.STRtree(water)
    assert tree.query(houses, predicate="intersects").size == 0


def test_the_whole_landscape_has_its_houses_and_nearly_every_window_ten_landmarks():
    whole_land = landscape.make_landscape(SEED)
    assert 1000 <= sum(f.class_value == classes.BUILDING for f in whole_land.features) <= 1600
    x0, y0, x1, y1 = whole_land.extent
    kinds = classes.BUILDING, classes.BARE_LAND, classes.WATER
    landmarks = [f.geometry for f in whole_land.features if f.class_value in kinds]
    points = np.array([landmark.representative_point().coords[0] for landmark in landmarks])
    counts = [
        np.all((points >= (x, y)) & (points <= (x + 640, y + 640)), axis=1).sum()
        for x in np.arange(x0, x1 - 639, 160)
        for y in np.arange(y0, y1 - 639, 160)
    ]
    assert np.mean(np.array(counts) >= 10) > 0.98
