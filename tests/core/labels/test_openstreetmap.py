"""Rules turn tags of OpenStreetMap into classes: the highest priority counts, invalid tables are refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from semref.core.errors import ParameterError
from semref.core.labels.openstreetmap import rules_from_csv, tags_of

SHIPPED = Path(__file__).resolve().parents[3] / "resources" / "openstreetmap" / "rules.csv"
HEADER = "key,value,class,priority\n"


@pytest.fixture(scope="module")
def shipped():
    return rules_from_csv(SHIPPED.read_text("utf-8"), "rules.csv")


@pytest.mark.parametrize(
    ("tags", "expected"),
    [
        ({"building": "house"}, "building"),
        ({"building": "yes", "landuse": "residential"}, "building"),
        ({"building": "no", "landuse": "residential"}, "built_up"),
        ({"building": "yes", "location": "underground"}, ""),
        ({"natural": "water", "name": "Lake"}, "water"),
        ({"natural": "wood"}, "forest"),
        ({"landuse": "farmland"}, "cultivated"),
        ({"landuse": "meadow", "leisure": "pitch"}, "grass_scrub"),
        ({"natural": "scree"}, "bare_land"),
        ({"fclass": "forest"}, "forest"),
        ({"fclass": "building", "type": "house"}, "building"),
        ({"type": "vineyard"}, "cultivated"),
    ],
)
def test_the_shipped_rules_know_common_tags(shipped, tags, expected):
    assert shipped.of(tags).class_name == expected


@pytest.mark.parametrize("tags", [{}, {"boundary": "administrative", "type": "multipolygon"}, {"landuse": "military"}])
def test_what_no_rule_fits_has_no_class(shipped, tags):
    assert shipped.of(tags) is None


def test_classes_are_listed_from_the_top_down(shipped):
    assert shipped.classes[0] == "building"
    assert set(shipped.classes) == {"building", "water", "bare_land", "forest", "cultivated", "grass_scrub", "built_up"}


def test_own_rules_may_use_semicolons_and_any_value():
    rules = rules_from_csv("key;value;class;priority\nsurface;*;hard;5\nsurface;grass;soft;1\n", "own.csv")
    assert rules.of({"surface": "asphalt"}).class_name == "hard"
    assert rules.of({"surface": "grass"}).class_name == "soft"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "not a table of rules"),
        (HEADER, "not a table of rules"),
        ("key,value,class\na,b,c\n", "has no column priority"),
        (HEADER + "building,,house,1\n", "line 2: a rule needs a key and a value"),
        (HEADER + "building,*,house,high\n", "“high” is not a whole number"),
        (HEADER + f"building,*,{'h' * 500},1\n", "characters"),
        (HEADER + f"building,*,house,1{'0' * 9}\n", "is not a whole number"),
        (HEADER + "x" * 20_000, "not a table of rules"),
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
