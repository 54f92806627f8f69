"""Overlapping polygons: reported pairs, their order and the area of each overlap."""

from __future__ import annotations

import numpy as np
import pytest
from made_annotation import feature, numbered, square

from semref.core.annotation.findings import DUPLICATE, ERROR, HIDDEN, INFORMATION, OVERLAP, WARNING
from semref.core.annotation.overlaps import (
    find_duplicates,
    find_hidden,
    find_overlaps,
    find_same_class_neighbors,
)
from semref.core.annotation.partition import partition_polygons
from semref.core.annotation.polygons import feature_geometries, split_parts, valid_polygons


def laid(*features):
    features = numbered(features)
    polygons = valid_polygons(features, split_parts(feature_geometries(features)))
    return polygons, partition_polygons(polygons.geometries)


def nobody(polygons):
    return np.zeros(len(polygons), bool)


def told(findings):
    return [(f.kind, f.severity, f.feature_id, f.other_id) for f in findings]


def test_a_polygon_drawn_twice_is_a_duplicate_of_the_first():
    polygons, partition = laid(feature(square(0, 0, 5)), feature(square(9, 0, 5)), feature(square(0, 0, 5)))
    findings, repeated = find_duplicates(polygons, partition)
    assert told(findings) == [(DUPLICATE, WARNING, 2, 0)]
    assert repeated.tolist() == [False, False, True]


@pytest.mark.parametrize(("priority", "severity"), [(0.0, ERROR), (1.0, WARNING)])
def test_a_duplicate_of_another_class_is_an_error_unless_a_priority_decides(priority, severity):
    findings, _ = find_duplicates(*laid(feature(square(0, 0, 5)), feature(square(0, 0, 5), 2, priority)))
    assert [(f.severity, f.decided) for f in findings] == [(severity, priority > 0)]


@pytest.mark.parametrize(("priority", "severity"), [(0.0, ERROR), (1.0, INFORMATION)])
def test_an_overlap_has_its_upper_polygon_first_and_its_area(priority, severity):
    polygons, partition = laid(feature(square(0, 0, 5), 1, priority), feature(square(3, 0, 5), 2))
    (finding,) = find_overlaps(polygons, partition, np.array([1, 0]), nobody(polygons))
    assert told([finding]) == [(OVERLAP, severity, 0, 1)]
    assert finding.area == pytest.approx(10)
    assert finding.decided == (priority > 0)


def test_a_hidden_polygon_is_reported_with_what_covers_most_of_it():
    polygons, partition = laid(feature(square(0, 0, 6)), feature(square(-1, -1, 6), 2), feature(square(0, 0, 9), 3))
    (finding,) = find_hidden(polygons, partition, np.array([0, 2, 1]), [])
    assert told([finding]) == [(HIDDEN, WARNING, 0, 1)]


def test_what_a_duplicate_hides_is_not_reported_again():
    polygons, partition = laid(feature(square(0, 0, 5)), feature(square(0, 0, 5)))
    duplicates, _ = find_duplicates(polygons, partition)
    assert find_hidden(polygons, partition, np.array([0, 1]), duplicates) == []
    assert len(find_hidden(polygons, partition, np.array([0, 1]), [])) == 1


def test_neighbors_of_one_class_are_listed_smaller_first_with_their_border():
    polygons, partition = laid(feature(square(0, 0, 5)), feature(square(5, 1, 3)), feature(square(0, 5, 5), 2))
    (finding,) = find_same_class_neighbors(polygons, partition, np.arange(3), [1])
    assert (finding.feature_id, finding.other_id, finding.is_landmark) == (1, 0, True)
    assert finding.number == pytest.approx(3)


@pytest.mark.parametrize(("landmark_classes", "count"), [([1], 1), ([2], 0)])
def test_touching_in_a_point_counts_only_for_landmarks(landmark_classes, count):
    polygons, partition = laid(feature(square(0, 0, 5)), feature(square(5, 5, 3)))
    assert len(find_same_class_neighbors(polygons, partition, np.arange(2), landmark_classes)) == count
