"""Open land is cut into parcels that lose nothing but tracks and margins."""

import numpy as np
import pytest
from shapely.geometry import LineString, box
from shapely.ops import unary_union

from sample import fields


def rng():
    return np.random.default_rng(6)


def test_parcels_cover_the_land_but_for_tracks_and_do_not_overlap():
    land = box(0, 0, 800, 500)
    parcels = fields.parcels(rng(), land)
    assert len(parcels) > 5
    assert unary_union(parcels).area == pytest.approx(sum(p.area for p in parcels))
    assert 0.9 * land.area < sum(p.area for p in parcels) < land.area


def test_a_piece_as_small_as_a_parcel_stays_whole():
    piece = box(0, 0, 60, 60)
    assert fields.cut(rng(), piece, 0.0) == [piece]


def test_trees_stand_along_the_river():
    river = LineString([(0, 0), (2000, 0)])
    trees = fields.riverside_trees(rng(), river)
    assert trees
    assert all(tree.distance(river) < 50 for tree in trees)


def test_gardens_lie_around_houses_and_leave_the_roads():
    road = box(-100, -4, 100, 4)
    (garden,) = fields.gardens([box(0, 10, 12, 20), box(20, 10, 32, 20)], road)
    assert garden.area > 500
    assert garden.intersection(road).area == pytest.approx(0, abs=1e-6)
