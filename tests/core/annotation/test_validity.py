"""Broken geometries are reported once, with place and reason."""

from __future__ import annotations

import numpy as np
import pytest
import shapely
from made_annotation import SOUTH, WEST, feature, numbered, square

from semref.core.annotation.findings import ERROR, INVALID, NO_AREA, NO_GEOMETRY, NOTHING, WARNING
from semref.core.annotation.polygons import AnnotatedFeature, feature_geometries, split_parts, valid_polygons
from semref.core.annotation.validity import UNREADABLE, find_invalid, find_unusable

BOWTIE = shapely.from_wkt("POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))")
LINE = shapely.from_wkt("POLYGON ((0 0, 4 4, 0 0, 0 0))")


def invalid(*features):
    features = numbered(features)
    geometries = feature_geometries(features)
    return find_invalid(features, geometries, split_parts(geometries))


def unusable(*features):
    features = numbered(features)
    geometries = feature_geometries(features)
    return find_unusable(features, geometries, valid_polygons(features, split_parts(geometries)))


def test_a_crossing_is_reported_with_its_place_and_reason():
    (finding,) = invalid(feature(square(9, 9, 1)), feature(BOWTIE, 3))
    assert (finding.kind, finding.severity, finding.feature_id, finding.class_value) == (INVALID, ERROR, 1, 3)
    assert finding.reason == f"Self-intersection ({WEST + 2:.2f}, {SOUTH + 2:.2f})"
    assert shapely.from_wkb(finding.wkb).centroid.coords[0] == pytest.approx((WEST + 2, SOUTH + 2))


def test_each_broken_part_is_reported_once():
    other = shapely.transform(BOWTIE, lambda xy: xy + (20, 0))
    assert [f.feature_id for f in invalid(feature(shapely.multipolygons([BOWTIE, other, square(50, 0, 2)])))] == [0, 0]


@pytest.mark.parametrize(
    ("broken", "kind", "severity"),
    [
        (feature(None), NO_GEOMETRY, WARNING),
        (feature(shapely.from_wkt("POLYGON EMPTY")), NO_GEOMETRY, WARNING),
        (AnnotatedFeature(0, b"no geometry", 1), INVALID, ERROR),
        (feature(LINE), NO_AREA, WARNING),
        (feature(LINE, NOTHING), NO_AREA, WARNING),
    ],
    ids=["none", "empty", "unreadable", "no area", "neither area nor class"],
)
def test_unusable_geometries_are_reported(broken, kind, severity):
    (finding,) = unusable(broken, feature(square(0, 0, 5)))
    assert (finding.kind, finding.severity, finding.feature_id) == (kind, severity, 0)


def test_an_unreadable_geometry_is_reported():
    with np.errstate(invalid="ignore"):
        broken = shapely.to_wkb(shapely.polygons([[0, 0], [np.nan, 5], [5, 5]]))
    assert [f.reason for f in unusable(AnnotatedFeature(7, broken, 1))] == [UNREADABLE]
