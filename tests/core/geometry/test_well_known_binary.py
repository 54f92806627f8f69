"""Geometries keep their height on the way through well-known binary."""

from __future__ import annotations

import numpy as np
import shapely

from semref.core.geometry.well_known_binary import to_wkb


def test_heights_are_kept():
    point = shapely.Point(1, 2, 3)
    assert shapely.from_wkb(to_wkb(point)).equals_exact(point, 0)
    assert shapely.from_wkb(to_wkb(point)).z == 3


def test_an_array_gives_an_array():
    points = shapely.points([(0.0, 1.0), (2.0, 3.0)])
    assert shapely.equals(shapely.from_wkb(to_wkb(np.array(points))), points).all()
