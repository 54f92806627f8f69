"""Classes of features from a table or a class field, and unknown classes."""

import pytest

from semref.core.annotation.classes import ClassLookup, distinct, lookup_of, raw_text, require_known_classes
from semref.core.errors import AnnotationError
from semref.core.labels.class_table import ClassTable, LandCoverClass

TABLE = ClassTable(
    (
        LandCoverClass(1, "building", "#ff0000", "reference", 3.0),
        LandCoverClass(4, "field", "#00ff00"),
    )
)


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
