"""Rivers cross the map, the stream joins the river, ponds lie on free ground."""

import numpy as np
import pytest
from shapely.geometry import Point, Polygon

from sample import water
from sample.scatter import Ground

SIZE = (4000.0, 3000.0)


def rng():
    return np.random.default_rng(2)


def test_the_river_crosses_the_map_and_the_stream_joins_it():
    rivers = water.make_rivers(rng(), SIZE)
    x0, _, x1, _ = rivers.river_line.bounds
    assert x0 < 0 and x1 > SIZE[0]
    assert rivers.stream.intersects(rivers.river)
    assert rivers.surface.area < rivers.river.area + rivers.stream.area


def test_an_island_is_a_hole_in_its_lake():
    assert len(water.lake(rng(), (0, 0), 100, island=True).interiors) == 1
    assert len(water.lake(rng(), (0, 0), 100, island=False).interiors) == 0


def test_fishponds_lie_side_by_side():
    ponds = water.fishponds(rng(), (0, 0), 0.4)
    assert 3 <= len(ponds) <= 5
    assert all(a.disjoint(b) for n, a in enumerate(ponds) for b in ponds[:n])


def test_still_waters_keep_off_what_is_blocked():
    blocked = Point(2000, 1500).buffer(700)
    waters = water.still_waters(rng(), Ground(SIZE, blocked))
    assert len(waters) >= water.POND_COUNT
    assert all(isinstance(w, Polygon) and w.disjoint(blocked) for w in waters)
    assert max(w.area for w in waters) == pytest.approx(np.pi * 135**2, rel=0.5)
