"""Features become valid single polygons; unusable features are left out."""

from __future__ import annotations

import pytest
import shapely
from made_annotation import feature, numbered, square

from semref.core.annotation.findings import NOTHING
from semref.core.annotation.polygons import (
    FARTHEST_M,
    AnnotatedFeature,
    feature_geometries,
    split_parts,
    valid_polygons,
)

BOWTIE = shapely.from_wkt("POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))")


def polygons_of(*features):
    features = numbered(features)
    return valid_polygons(features, split_parts(feature_geometries(features)))


def test_parts_keep_the_place_of_their_feature():
    both = shapely.multipolygons([square(0, 0, 2), square(5, 0, 2)])
    polygons = polygons_of(feature(square(9, 9, 1), 3), feature(both, 4, 2.0))
    assert polygons.features.tolist() == polygons.feature_ids.tolist() == [0, 1, 1]
    assert polygons.classes.tolist() == [3, 4, 4]
    assert polygons.priorities.tolist() == [0.0, 2.0, 2.0]


def test_a_bowtie_becomes_its_two_triangles():
    polygons = polygons_of(feature(BOWTIE))
    assert shapely.is_valid(polygons.geometries).all()
    assert shapely.area(polygons.geometries) == pytest.approx([4, 4])


@pytest.mark.parametrize(
    "left_out",
    [
        feature(None),
        feature(shapely.from_wkt("POLYGON EMPTY")),
        feature(shapely.from_wkt("POLYGON ((0 0, 4 4, 0 0, 0 0))")),
        feature(square(0, 0, 5), NOTHING),
        feature(square(2 * FARTHEST_M, 0, 5)),
        AnnotatedFeature(0, b"no geometry", 1),
    ],
    ids=["none", "empty", "no area", "no class", "beyond every map", "unreadable"],
)
def test_what_is_no_polygon_with_a_class_is_left_out(left_out):
    assert polygons_of(left_out, feature(square(0, 0, 5))).features.tolist() == [1]


def test_in_drawing_the_later_of_equal_priority_is_on_top():
    polygons = polygons_of(feature(square(0, 0, 1), 1, 5.0), feature(square(0, 0, 2)), feature(square(0, 0, 3)))
    assert polygons.drawn_ranks().tolist() == [2, 0, 1]
