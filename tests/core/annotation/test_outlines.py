import cv2
import numpy as np
import pytest
import shapely

from semref.core.annotation import outlines
from semref.core.annotation.outlines import areas_and_wkb, can_simplify, outline_regions, simplify, to_map
from semref.core.steps import result_of


def outlines_of(labels: np.ndarray):
    return result_of(outline_regions(lambda first, last: labels[first:last], labels.shape))


def region_numbers(labels: np.ndarray) -> np.ndarray:
    """Return (H, W) numbers of 4-connected regions; 0 is unlabeled."""
    found = np.zeros(labels.shape, np.int64)
    for value in np.unique(labels[labels > 0]):
        count, numbers = cv2.connectedComponents((labels == value).astype(np.uint8), connectivity=4)
        found[numbers > 0] = numbers[numbers > 0] + found.max()
    return found


def painted(polygons: np.ndarray, shape_hw: tuple[int, int]) -> np.ndarray:
    """Return (H, W) numbers of the polygons from 1 on; no pixel may be in two polygons."""
    rows, columns = (indices.ravel() + 0.5 for indices in np.indices(shape_hw))
    found = np.zeros(len(rows), np.int64)
    for number, polygon in enumerate(polygons, start=1):
        inside = shapely.contains_xy(polygon, columns, rows)
        assert not found[inside].any()
        found[inside] = number
    return found.reshape(shape_hw)


def assert_regions(labels: np.ndarray) -> None:
    values, polygons = outlines_of(labels)
    numbers, expected = painted(polygons, labels.shape), region_numbers(labels)
    # As many pairs as regions and as polygons: the relation is one to one.
    pairs = np.unique(np.stack([numbers, expected]).reshape(2, -1), axis=1)
    pairs = pairs[:, pairs.any(axis=0)]
    assert pairs.shape[1] == expected.max() == len(polygons)
    assert pairs.all()
    np.testing.assert_array_equal(np.append(0, values)[numbers], labels)
    assert shapely.is_valid(polygons).all()
    assert shapely.area(polygons).sum() == (labels > 0).sum()
    if hasattr(shapely, "coverage_is_valid"):
        # This fails if a border lacks a corner of a neighbor.
        assert shapely.coverage_is_valid(polygons)


@pytest.mark.parametrize("rows_at_once", [5, 2048])
@pytest.mark.parametrize("classes", [2, 3, 5])
@pytest.mark.parametrize("shape_hw", [(1, 1), (1, 9), (7, 1), (23, 31), (40, 22)])
def test_every_region_is_one_polygon(monkeypatch, shape_hw, classes, rows_at_once):
    monkeypatch.setattr(outlines, "_ROWS_AT_ONCE", rows_at_once)
    labels = np.random.default_rng(classes).integers(0, classes, shape_hw).astype(np.uint8)
    labels[0, 0] = 1
    assert_regions(labels)


def test_holes_within_holes_belong_to_the_region_around_them():
    labels = np.ones((15, 22), np.uint8)
    labels[2:13, 2:13] = 2
    labels[4:11, 4:11] = 1
    labels[6:9, 6:9] = 0
    labels[3:6, 15:18] = labels[3:6, 19:21] = 3
    assert_regions(labels)
    _, polygons = outlines_of(labels)
    assert sorted(shapely.get_num_interior_rings(polygons).tolist()) == [0, 0, 1, 1, 3]


def test_a_neighbors_corner_on_a_straight_edge_becomes_a_vertex():
    labels = np.array([[1, 2], [1, 3]], np.uint8)
    _, (left, _, _) = outlines_of(labels)
    assert (1, 1) in {(int(x), int(y)) for x, y in shapely.get_coordinates(left)}


def test_the_share_done_increases():
    labels = np.random.default_rng(3).integers(0, 4, (60, 70)).astype(np.uint8)
    shares = list(outline_regions(lambda first, last: labels[first:last], labels.shape))
    assert shares == sorted(shares) and len(shares) > 3


simplifies = pytest.mark.skipif(not can_simplify(), reason="this shapely or GEOS can't simplify coverages")


@simplifies
def test_borders_are_straightened_alike_on_both_sides():
    stairs = np.array([(n // 2 + n % 2, n // 2) for n in range(21)])
    left = shapely.Polygon([(0, 0), *stairs[1:].tolist(), (0, 10)])
    right = shapely.Polygon([(20, 0), (20, 10), *stairs[::-1].tolist()])
    made = simplify(np.array([left, right]), 1.5)
    assert shapely.coverage_is_valid(made)
    assert shapely.get_num_coordinates(made).sum() < 20
    assert shapely.area(made).sum() == pytest.approx(left.area + right.area)


def test_pixels_come_to_the_map():
    (made,) = to_map(np.array([shapely.box(0, 0, 2, 3)]), (100.0, 0.5, 0.0, 200.0, 0.0, -0.5))
    assert made.bounds == (100, 198.5, 101, 200)


def test_areas_and_well_known_binary_are_those_of_each_polygon():
    polygons = np.array([shapely.box(0, 0, 4, 6), shapely.box(4, 0, 9, 2)])
    areas, wkb = areas_and_wkb(polygons)
    assert areas.tolist() == [24, 10]
    assert [shapely.from_wkb(one).equals(polygon) for one, polygon in zip(wkb, polygons)] == [True, True]
