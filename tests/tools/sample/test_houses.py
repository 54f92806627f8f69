"""Buildings have plausible sizes and do not stand in each other."""

import numpy as np
import pytest
from shapely.geometry import LineString, Point

from sample import houses
from sample.roads import Road, Settlement
from sample.scatter import Ground


@pytest.mark.parametrize("mix", houses.MIX)
def test_every_kind_of_settlement_has_buildings_of_plausible_size(mix):
    rng = np.random.default_rng(1)
    assert sum(houses.MIX[mix]) == pytest.approx(1)
    assert all(60 < houses.footprint(rng, mix).area < 2000 for _ in range(50))


def test_a_footprint_is_turned_and_moved():
    put = houses.put(Point(5, 0).buffer(1), (100, 200), np.pi / 2)
    assert put.centroid.coords[0] == pytest.approx((100, 205), abs=1e-6)


def test_buildings_along_a_street_stand_free_on_both_sides():
    street, place = Road(LineString([(100, 200), (300, 200)]), 6.0), Settlement("village", (200.0, 200.0), 150.0)
    ground = Ground((400.0, 400.0), street.surface)
    built = houses.along_street(np.random.default_rng(1), street, place, ground)
    assert len(built) > 6
    assert {b.centroid.y > 200 for b in built} == {True, False}
    assert all(b.disjoint(street.surface) for b in built)
    assert all(a.distance(b) > 1 for n, a in enumerate(built) for b in built[:n])


def test_a_farmyard_is_four_to_eight_buildings_apart():
    built = houses.farmyard(np.random.default_rng(2), (0, 0), 0.3)
    assert 3 <= len(built) <= 8
    assert all(a.distance(b) > houses.CLEARANCE_M for n, a in enumerate(built) for b in built[:n])


@pytest.mark.parametrize(("at", "mix"), [((0, 0), "core"), ((300, 0), "town")])
def test_the_middle_of_a_town_is_its_core(at, mix):
    assert houses.mix_at(Settlement("town", (0.0, 0.0), 400.0), at) == mix
