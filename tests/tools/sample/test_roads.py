"""Settlements keep their distance; roads join neighbors."""

import numpy as np
import pytest
from shapely.geometry import LineString

from sample import roads

SIZE = (4000.0, 3000.0)
RIVER = LineString([(-200, 1700), (4200, 1100)])


def settled():
    return roads.settle(np.random.default_rng(4), SIZE, RIVER)


def test_settlements_keep_their_distance_and_lie_on_the_map():
    places = settled()
    assert sum(place.kind == "town" for place in places) == 1
    for n, one in enumerate(places):
        assert (np.array(one.center_xy) > 0).all() and (np.array(one.center_xy) < SIZE).all()
        for other in places[:n]:
            assert np.hypot(*np.subtract(one.center_xy, other.center_xy)) > one.radius + other.radius


@pytest.mark.parametrize(
    ("nodes", "edges"),
    [
        ([(0, 0), (10, 0)], [(0, 1)]),
        ([(0, 0), (10, 0), (5, 0.1)], [(0, 2), (1, 2)]),
        ([(0, 0), (10, 0), (5, 9)], [(0, 1), (0, 2), (1, 2)]),
    ],
    ids=["two", "one between", "triangle"],
)
def test_neighbors_have_no_other_in_the_circle_over_them(nodes, edges):
    assert roads.gabriel_edges(np.array(nodes, float)) == edges


def test_a_road_covers_its_width():
    road = roads.Road(LineString([(0, 0), (1000, 0)]), 8.0)
    assert road.surface.area == pytest.approx(8000, rel=0.01)


def test_few_roads_cross_the_river():
    network = roads.connect(np.random.default_rng(4), settled(), SIZE, RIVER)
    assert network
    assert sum(road.line.intersects(RIVER) for road in network) <= roads.KEPT_BRIDGES
