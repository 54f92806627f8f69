from pathlib import Path

import pytest

from semref.core.errors import ParameterError
from semref.core.labels.openstreetmap import line_width_m, rules_from_csv, tags_of

SHIPPED = Path(__file__).resolve().parents[3] / "resources" / "openstreetmap" / "rules.csv"
HEADER = "key,value,class,priority\n"
WIDE_HEADER = "key,value,class,priority,width\n"


@pytest.fixture(scope="module")
def shipped():
    return rules_from_csv(SHIPPED.read_text("utf-8"), "rules.csv")


@pytest.mark.parametrize(
    ("tags", "expected"),
    [
        *((tags, "building") for tags in ({"building": "house"}, {"fclass": "building", "type": "house"})),
        ({"building": "yes", "landuse": "residential"}, "building"),
        ({"building": "no", "landuse": "residential"}, "built_up"),
        ({"building": "yes", "location": "underground"}, ""),
        ({"natural": "water", "name": "Lake"}, "water"),
        *((tags, "forest") for tags in ({"natural": "wood"}, {"fclass": "forest"})),
        *((tags, "cultivated") for tags in ({"landuse": "farmland"}, {"type": "vineyard"})),
        ({"landuse": "meadow", "leisure": "pitch"}, "grass_scrub"),
        ({"natural": "scree"}, "bare_land"),
    ],
)
def test_the_shipped_rules_know_common_tags(shipped, tags, expected):
    assert shipped.of(tags).class_name == expected


@pytest.mark.parametrize("tags", [{}, {"boundary": "administrative", "type": "multipolygon"}, {"landuse": "military"}])
def test_what_no_rule_fits_has_no_class(shipped, tags):
    assert shipped.of(tags) is None


def test_classes_are_listed_from_the_top_down(shipped):
    assert shipped.classes[0] == "building"
    land = {"building", "water", "bare_land", "forest", "cultivated", "grass_scrub", "built_up"}
    assert set(shipped.classes) == {*land, "road"}


def test_own_rules_may_use_semicolons_and_any_value():
    rules = rules_from_csv("key;value;class;priority\nsurface;*;hard;5\nsurface;grass;soft;1\n", "own.csv")
    assert rules.of({"surface": "asphalt"}).class_name == "hard"
    assert rules.of({"surface": "grass"}).class_name == "soft"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "its header needs the columns key, value, class, priority"),
        (HEADER, "not a table of rules"),
        ("key,value,class\na,b,c\n", "needs the columns key, value, class, priority"),
        (HEADER + "building,,house,1\n", "line 2: a rule needs a key and a value"),
        (HEADER + "building,*,house,high\n", "“high” is not a whole number"),
        (HEADER + f"building,*,{'h' * 500},1\n", "characters"),
        (HEADER + f"building,*,house,1{'0' * 9}\n", "is not a whole number"),
        *((f"{WIDE_HEADER}highway,*,road,1,{w}\n", f"“{w}” is not a width of lines") for w in ("wide", "0", "500")),
        (HEADER + "x" * 200_000, "has a line of more than"),
    ],
)
def test_an_invalid_table_is_refused_with_its_line(text, said):
    with pytest.raises(ParameterError) as refused:
        rules_from_csv(text, "own.csv")
    assert said in str(refused.value) and "own.csv" in str(refused.value)


def test_tags_packed_into_one_column_are_taken_apart():
    packed = r'"landuse"=>"forest","name"=>"a \"b\" \\ c","empty"=>NULL'
    assert tags_of({"other_tags": packed}) == {"landuse": "forest", "name": r'a "b" \ c'}
    assert tags_of({"tags": '{"building": "yes", "levels": 3, "odd": [1]}'}) == {"building": "yes", "levels": "3"}


@pytest.mark.parametrize("text", ["{", "[1]", "{" * 100_000, "no tags", '"a"=>"b', 7, None])
def test_invalid_packed_tags_are_ignored(text):
    assert tags_of({"other_tags": text}) == {}


def test_a_column_of_its_own_counts_before_packed_tags():
    assert tags_of({"building": "house", "other_tags": '"building"=>"no"', "landuse": " "}) == {"building": "house"}


@pytest.mark.parametrize(
    ("tags", "expected"),
    [
        ({}, 8),
        *(({"width": text}, 3.5) for text in ("3.5", "3.5 m", "3,5")),
        ({"width": "12'"}, 12 * 0.3048),
        ({"width": "12'6\""}, pytest.approx(12.5 * 0.3048)),
        ({"width": "20 ft"}, 20 * 0.3048),
        ({"width": "4.0000000000001"}, pytest.approx(4)),
        *(({"width": text}, 8) for text in ("0", "3-4", "~5", "wide", "5000", "9" * 10_000)),
        ({"lanes": "2"}, 7),
        *(({"lanes": text}, 8) for text in ("2;3", "0")),
        ({"lanes": "2", "width": "5"}, 5),
        ({"lanes": "2", "width": "narrow"}, 7),
    ],
)
def test_a_line_has_the_width_of_a_clear_tag_or_of_its_rule(shipped, tags, expected):
    line = {"highway": "primary", **tags}
    assert line_width_m(line, shipped.for_lines.of(line)) == expected


def test_rules_without_a_width_do_not_apply_to_lines(shipped):
    assert shipped.for_lines.of({"natural": "wood"}) is None
    assert shipped.for_lines.of({"fclass": "residential"}).class_name == "road"
    assert shipped.for_lines.of({"highway": "primary", "tunnel": "yes"}).class_name == ""
