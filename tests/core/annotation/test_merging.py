"""Merge gaps and slivers into the neighbor with the longest shared border."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from made_annotation import feature, numbered, square

from semref.core.annotation.findings import GAP, SLIVER, WARNING
from semref.core.annotation.merging import MergeSettings, merge_finding, merge_gaps_and_slivers
from semref.core.annotation.polygons import AnnotatedPolygons
from semref.core.annotation.surface import overlay_polygons


def surface_of(*features):
    steps = overlay_polygons(numbered(features), AnnotatedPolygons.repair_ranks, [])
    while True:
        try:
            next(steps)
        except StopIteration as stopped:
            return stopped.value


def merged(surface, settings):
    """Return (area, from, to) of each merge, and the area of each class afterwards."""
    classes, merges = merge_gaps_and_slivers(surface.partition, surface.classes, settings)
    areas = {int(value): float(surface.partition.areas[classes == value].sum()) for value in np.unique(classes)}
    told = [(float(surface.partition.areas[m.faces].sum()), m.from_class, m.to_class) for m in merges]
    return told, areas


def with_hole(size: float):
    return feature(shapely.difference(square(0, 0, 10), square(4, 4, size)))


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
def test_a_merge_is_reported_with_the_visible_feature(features, kind, feature_id):
    surface = surface_of(*features)
    (merge,) = merge_gaps_and_slivers(surface.partition, surface.classes, MergeSettings())[1]
    finding = merge_finding(merge, WARNING, surface.polygons, surface.partition, surface.top)
    assert (finding.kind, finding.severity, finding.feature_id, finding.other_class) == (kind, WARNING, feature_id, 1)
    assert shapely.from_wkb(finding.wkb).area == pytest.approx(finding.area)
