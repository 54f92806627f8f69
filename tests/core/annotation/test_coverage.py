"""Polygons get the corners of their neighbors, so that borders simplified on both sides stay the same line."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from semref.core.annotation.coverage import can_simplify, from_wkb, on_map, simplified, with_nodes

simplifies = pytest.mark.skipif(not can_simplify(), reason="this shapely or GEOS can't simplify coverages")

LEFT, UPPER, LOWER = shapely.box(0, 0, 4, 6), shapely.box(4, 0, 9, 2), shapely.box(4, 2, 9, 6)
"""Rows grow downwards: the border of UPPER and LOWER ends in the middle of LEFT's edge."""


def corners(polygon) -> set:
    return {(int(x), int(y)) for x, y in shapely.get_coordinates(polygon)}


def test_a_neighbors_corner_on_a_straight_edge_becomes_a_vertex():
    left, upper, lower = with_nodes(np.array([LEFT, UPPER, LOWER]), np.array([[2, 4]]), 10)
    assert corners(left) == corners(LEFT) | {(4, 2)}
    assert corners(upper) == corners(UPPER) and corners(lower) == corners(LOWER)
    assert shapely.equals(left, LEFT)


@pytest.mark.parametrize("reverse", [False, True])
def test_several_nodes_on_one_edge_come_in_the_edges_order(reverse):
    box = shapely.reverse(shapely.box(0, 0, 8, 8)) if reverse else shapely.box(0, 0, 8, 8)
    nodes = np.array([[0, 2], [0, 5], [3, 0], [3, 8], [6, 0], [6, 8], [8, 1], [8, 7]])
    (made,) = with_nodes(np.array([box]), nodes, 20)
    assert corners(made) == corners(box) | {(int(column), int(row)) for row, column in nodes}
    assert made.length == box.length and made.is_valid and made.equals(box)


def test_holes_and_nodes_elsewhere_are_heeded():
    ring = shapely.box(0, 0, 10, 10) - shapely.box(3, 3, 7, 7)
    (made,) = with_nodes(np.array([ring]), np.array([[3, 5], [5, 5], [7, 4]]), 12)
    assert corners(made) == corners(ring) | {(5, 3), (4, 7)}
    assert made.area == ring.area


def test_without_nodes_polygons_stay_as_they_are():
    (made,) = with_nodes(np.array([LEFT]), np.empty((0, 2), int), 10)
    assert corners(made) == corners(LEFT)


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


def test_well_known_binary_becomes_polygons():
    assert from_wkb([LEFT.wkb, UPPER.wkb])[1].equals(UPPER)
