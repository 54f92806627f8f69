import pytest
import shapely
from made_annotation import feature, numbered, square

from semref.core.annotation.classes import ClassLookup, distinct, lookup_of, raw_text, require_known_classes
from semref.core.annotation.findings import NOTHING
from semref.core.annotation.polygons import (
    FARTHEST_M,
    AnnotatedFeature,
    feature_geometries,
    valid_polygons,
)
from semref.core.errors import AnnotationError
from semref.core.labels.class_table import ClassTable, LandCoverClass

TABLE = ClassTable((LandCoverClass(1, "building", "#ff0000", "reference", 3.0), LandCoverClass(4, "field", "#00ff00")))
BOWTIE = shapely.from_wkt("POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))")


def test_a_table_finds_names_in_any_case_and_values():
    lookup = ClassLookup(TABLE)
    assert [lookup.value(raw) for raw in ("Building", " field ", 4, 4.0, "4", "lava")] == [1, 4, 4, 4, 4, None]
    assert lookup.draw_orders == {1: 3.0}
    assert lookup.raw_values(1, as_numbers=False) == ["building", "1"]


def test_texts_are_numbered_in_their_order_and_numbers_keep_theirs():
    texts = lookup_of([((raw,), str(raw), "") for raw in distinct(["water", "", "field", "water"])], False)
    assert [(c.value, c.name) for c in texts.table] == [(1, "field"), (2, "water")]
    assert texts.value("field") == 1 and texts.value("Field") is None
    numbers = lookup_of([((raw,), str(raw), "") for raw in distinct([30, 7.0, 7])], True)
    assert sorted(c.value for c in numbers.table) == [7, 30]
    assert numbers.value(7) == 7 and numbers.raw_values(7, as_numbers=True) == [7]


@pytest.mark.parametrize("odd", ["²", "--5", "9" * 5000])
def test_texts_that_look_like_numbers_are_texts(odd):
    assert set(distinct([odd, "7"])) == {odd, "7"}


def test_classes_of_a_style_may_share_a_label_or_have_several_values():
    lookup = lookup_of([(("a", "b"), "Wood", "#112233"), (("c",), "Wood", "")], False)
    assert [c.name for c in lookup.table] == ["a", "c"]
    assert (lookup.value("b"), lookup.value("c")) == (1, 2) and lookup.table.classes[0].color == "#112233"


def test_whole_numbers_have_no_point_and_texts_no_blanks_around():
    assert [raw_text(raw) for raw in (3.0, 3.5, " a b ", 7)] == ["3", "3.5", "a b", "7"]


def test_unknown_classes_are_named_the_commonest_first():
    require_known_classes({}, "a layer", TABLE)
    with pytest.raises(AnnotationError, match=r"“a layer” has classes .*“lava” \(3\).*“ice” \(1\)"):
        require_known_classes({"ice": 1, "lava": 3}, "a layer", TABLE)


def polygons_of(*features):
    features = numbered(features)
    return valid_polygons(features, shapely.get_parts(feature_geometries(features), return_index=True))


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
