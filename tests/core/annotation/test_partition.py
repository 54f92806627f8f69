"""Polygons cut into faces: areas add up, borders have their length, and faces of one class are one region."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from made_annotation import KINDS, random_features, square

from semref.core.annotation.partition import (
    corner_neighbors,
    dissolve,
    find_regions,
    partition_polygons,
    region_owners,
)


@pytest.mark.parametrize("kind", KINDS)
def test_faces_cover_what_polygons_cover_once(kind):
    shapes = shapely.make_valid(shapely.from_wkb([f.wkb for f in random_features(kind, 6)]))
    polygons = shapely.get_parts(shapely.get_parts(shapes))
    polygons = polygons[shapely.get_type_id(polygons) == 3]
    partition = partition_polygons(polygons)
    covered = np.unique(partition.cover_faces)
    assert partition.areas[covered].sum() == pytest.approx(shapely.area(shapely.union_all(polygons)), abs=1e-3)
    per_polygon = np.bincount(partition.cover_polygons, partition.areas[partition.cover_faces], len(polygons))
    np.testing.assert_allclose(per_polygon, shapely.area(polygons), atol=1e-3)


def overlapping():
    """Two squares of 4 m that share a square of 2 m, and one of 1 m apart."""
    return partition_polygons(np.array([square(0, 0, 4), square(2, 2, 4), square(10, 10, 1)]))


def test_borders_between_faces_have_their_length():
    partition = overlapping()
    assert partition.border_lengths.tolist() == [4.0, 4.0]


def test_the_polygon_of_the_highest_rank_is_seen():
    partition = overlapping()
    shared = int(partition.areas.argsort()[1])
    assert partition.top_polygons(np.array([0, 1, 2]))[shared] == 1
    assert partition.top_polygons(np.array([1, 0, 2]))[shared] == 0


def test_faces_of_one_class_are_one_region_owned_by_what_covers_most_of_it():
    partition = overlapping()
    top = partition.top_polygons(np.array([0, 1, 2]))
    regions = find_regions(partition, np.array([5, 5, 7])[top])
    assert sorted(zip(regions.classes.tolist(), regions.areas.tolist())) == [(5, 28.0), (7, 1.0)]
    assert regions.perimeters.max() == pytest.approx(24)
    assert region_owners(regions, top, partition.areas)[regions.areas.argmax()] == 1


def test_a_strip_is_as_wide_as_its_mean_width_says():
    partition = partition_polygons(np.array([shapely.box(0, 0, 1000, 2)]))
    assert find_regions(partition, np.array([1])).mean_widths == pytest.approx(2, rel=0.01)


@pytest.mark.parametrize(("classes", "count"), [((1, 1), 1), ((1, 2), 0), ((-1, -1), 0)])
def test_squares_that_meet_in_a_point_are_corner_neighbors_when_of_one_class(classes, count):
    partition = partition_polygons(np.array([square(0, 0, 2), square(2, 2, 2)]))
    assert len(corner_neighbors(partition, np.array(classes))) == count


def test_faces_are_joined_group_by_group():
    faces = np.array([square(0, 0, 1), square(1, 0, 1), square(5, 5, 1)])
    joined = dissolve(faces, np.array([1, 1, 0]))
    assert shapely.area(joined).tolist() == [1.0, 2.0]
    assert len(dissolve(faces[:0], np.empty(0, int))) == 0
