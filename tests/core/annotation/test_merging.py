"""Gaps and slivers go to the neighbor they share the longest border with."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from made_annotation import feature, numbered, square

from semref.core.annotation.findings import GAP, NOTHING, SLIVER, WARNING
from semref.core.annotation.merging import THIN_M, MergeSettings, merge_finding, merge_gaps_and_slivers
from semref.core.annotation.polygons import AnnotatedPolygons
from semref.core.annotation.surface import laid_polygons


def surface_of(*features):
    steps = laid_polygons(numbered(features), AnnotatedPolygons.repair_ranks, [])
    while True:
        try:
            next(steps)
        except StopIteration as stopped:
            return stopped.value


def merged(surface, settings):
    """(area, from, to) of each merge, and the area of each class afterwards."""
    classes, merges = merge_gaps_and_slivers(surface.partition, surface.classes, settings)
    areas = {int(value): float(surface.partition.areas[classes == value].sum()) for value in np.unique(classes)}
    told = [(float(surface.partition.areas[m.faces].sum()), m.from_class, m.to_class) for m in merges]
    return told, areas


def with_hole(size: float):
    return feature(shapely.difference(square(0, 0, 10), square(4, 4, size)))


def test_clean_neighbors_stay_as_they_are():
    surface = surface_of(feature(square(0, 0, 5)), feature(square(5, 0, 5), 2))
    told, areas = merged(surface, MergeSettings())
    assert told == []
    assert areas == pytest.approx({1: 25.0, 2: 25.0})


@pytest.mark.parametrize(("size", "limit", "is_filled"), [(1.0, 1.0, True), (1.0, 0.9, False), (2.0, 4.0, True)])
def test_a_gap_up_to_the_limit_is_filled(size, limit, is_filled):
    told, areas = merged(surface_of(with_hole(size)), MergeSettings(maximum_gap=limit))
    assert bool(told) == is_filled
    assert (NOTHING in areas) != is_filled
    if is_filled:
        assert told[0] == (pytest.approx(size**2), NOTHING, 1)


def test_a_thin_gap_is_filled_however_large_it_is():
    crack = shapely.difference(square(0, 0, 100), shapely.box(1, 50, 99, 50 + THIN_M / 2))
    told, _ = merged(surface_of(feature(crack)), MergeSettings(maximum_gap=0.0))
    assert [(before, after) for _, before, after in told] == [(NOTHING, 1)]


def test_a_sliver_goes_to_the_longest_border():
    strip = feature(shapely.box(0, 10, 30, 10.1), 9)
    surface = surface_of(feature(square(0, 0, 10), 1), feature(shapely.box(0, 10.1, 30, 20), 2), strip)
    told, areas = merged(surface, MergeSettings())
    assert told == [(pytest.approx(3.0), 9, 2)]
    assert areas == pytest.approx({1: 100.0, 2: 300.0})


@pytest.mark.parametrize(("limit", "is_merged"), [(4.0, False), (4.1, True)])
def test_a_piece_as_large_as_the_limit_stays(limit, is_merged):
    surface = surface_of(feature(square(0, 0, 10)), feature(square(10, 0, 2), 2))
    assert bool(merged(surface, MergeSettings(minimum_area=limit))[0]) == is_merged


def test_slivers_that_have_only_each_other_become_one():
    strips = [feature(shapely.box(0, 0.1 * n, 20, 0.1 * n + 0.1), n + 1) for n in range(3)]
    _, areas = merged(surface_of(*strips), MergeSettings())
    assert len(areas) == 1
    assert sum(areas.values()) == pytest.approx(6.0)


@pytest.mark.parametrize(
    ("features", "kind", "feature_id"),
    [
        ([with_hole(0.5)], GAP, None),
        ([feature(square(0, 0, 10)), feature(shapely.box(0, 10, 10, 10.1), 2)], SLIVER, 1),
    ],
    ids=["gap", "sliver"],
)
def test_a_merge_is_told_with_the_feature_seen_there(features, kind, feature_id):
    surface = surface_of(*features)
    (merge,) = merge_gaps_and_slivers(surface.partition, surface.classes, MergeSettings())[1]
    finding = merge_finding(merge, WARNING, surface.polygons, surface.partition, surface.top)
    assert (finding.kind, finding.severity, finding.feature_id, finding.other_class) == (kind, WARNING, feature_id, 1)
    assert shapely.from_wkb(finding.wkb).area == pytest.approx(finding.area)
