"""Polygons that share borders: straightened alike on both sides, laid on the map, and as binary."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from semref.core.annotation.coverage import areas_and_wkb, can_simplify, on_map, simplified

simplifies = pytest.mark.skipif(not can_simplify(), reason="this shapely or GEOS can't simplify coverages")


@simplifies
def test_borders_are_straightened_alike_on_both_sides():
    stairs = np.array([(n // 2 + n % 2, n // 2) for n in range(21)])
    left = shapely.Polygon([(0, 0), *stairs[1:].tolist(), (0, 10)])
    right = shapely.Polygon([(20, 0), (20, 10), *stairs[::-1].tolist()])
    made = simplified(np.array([left, right]), 1.5)
    assert shapely.coverage_is_valid(made)
    assert shapely.get_num_coordinates(made).sum() < 20
    assert shapely.area(made).sum() == pytest.approx(left.area + right.area)


def test_pixels_come_to_the_map():
    (made,) = on_map(np.array([shapely.box(0, 0, 2, 3)]), (100.0, 0.5, 0.0, 200.0, 0.0, -0.5))
    assert made.bounds == (100, 198.5, 101, 200)


def test_areas_and_well_known_binary_are_those_of_each_polygon():
    polygons = np.array([shapely.box(0, 0, 4, 6), shapely.box(4, 0, 9, 2)])
    areas, wkb = areas_and_wkb(polygons)
    assert areas.tolist() == [24, 10]
    assert [shapely.from_wkb(one).equals(polygon) for one, polygon in zip(wkb, polygons)] == [True, True]
