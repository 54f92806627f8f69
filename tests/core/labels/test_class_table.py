import re

import pytest

from semref.core import limits
from semref.core.errors import ClassTableError
from semref.core.labels.class_colors import default_color
from semref.core.labels.class_proposal import FoundClass, proposed_table
from semref.core.labels.class_table import (
    ClassTable,
    LandCoverClass,
    class_table_from_csv,
    class_table_from_names,
    class_table_from_values,
    split_list,
)
from semref.core.sentences import english

TABLE = ClassTable(
    (
        LandCoverClass(7, "water", "#0000ff", "reference", 3.0, (100, 50, 50), (130, 255, 255)),
        LandCoverClass(1, "building", "#ff0000", "reference", hsv_min=(170, 80, 0), hsv_max=(10, 255, 255)),
        LandCoverClass(3, "bare, dry “land”", "#aabbcc"),
    )
)


def refuses(sentence):
    """Require that the error has this whole sentence (or one of these endings)."""
    return pytest.raises(ClassTableError, match=re.escape(sentence) + "$")


def csv(*rows, header="value,name,color,role,draw_order,hsv_min,hsv_max"):
    return class_table_from_csv("\n".join([header, *rows]), "classes.csv")


@pytest.mark.parametrize(
    "table",
    [
        ClassTable((LandCoverClass(1, "a", "#000000"),)),
        TABLE,
        ClassTable(tuple(LandCoverClass(v, f"class {v}", default_color(v)) for v in range(256))),
        ClassTable((LandCoverClass(2, 'Weiß, Ödland; "q"', "#010203", "reference"),)),
    ],
    ids=["one class", "all columns", "256 classes", "awkward name"],
)
def test_a_table_written_as_csv_reads_back_equal(table):
    again = class_table_from_csv(table.to_csv())
    assert again == table
    assert again.digest() == table.digest()


def test_csv_text_is_plain_and_ordered_by_value():
    assert TABLE.to_csv().splitlines() == [
        "value,name,color,role,draw_order,hsv_min,hsv_max",
        "1,building,#ff0000,reference,,170 80 0,10 255 255",
        '3,"bare, dry “land”",#aabbcc,background,,,',
        "7,water,#0000ff,reference,3,100 50 50,130 255 255",
    ]


@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize("bom", ["", "\ufeff"], ids=["no BOM", "BOM"])
@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_spreadsheets_may_use_other_separators_line_ends_and_a_byte_order_mark(separator, bom, newline):
    rows = ["value,name,color,role", "1,building,#ff0000,reference", "2,forest,#00ff00,background"]
    table = class_table_from_csv(bom + newline.join(rows).replace(",", separator) + newline)
    assert [(c.value, c.name, c.color, c.role) for c in table] == [
        (1, "building", "#ff0000", "reference"),
        (2, "forest", "#00ff00", "background"),
    ]


def test_blank_lines_spaces_and_capitals_do_no_harm():
    table = class_table_from_csv(" Value , NAME,Color,role\n\n 4 , a class , #AABBCC , Reference \n\n")
    assert table.classes == (LandCoverClass(4, "a class", "#aabbcc", "reference"),)


def test_color_and_role_may_be_left_out():
    table = class_table_from_csv("name,value\nbuilding,1\nwater,2\n")
    assert [(c.name, c.color, c.role) for c in table] == [
        ("building", "#c8372d", "background"),
        ("water", "#3a87c8", "background"),
    ]


def test_a_table_without_classes_is_refused():
    with refuses("classes.csv has no classes. It needs a header value,name,color,role and one line per class."):
        class_table_from_csv("value,name,color,role\n", "classes.csv")


@pytest.mark.parametrize("header", ["name,color", "value,color", "id,label", ""])
def test_a_header_without_value_or_name_is_refused(header):
    with refuses(f"classes.csv begins with “{header}”; its header needs the columns value, name."):
        class_table_from_csv(f"\ufeff\n{header}\n", "classes.csv")


NO_NUMBER = "“{}” is not a whole number; the column value needs 0 to 255."
OUT_OF_RANGE = "Class “water” has the value {}; class values go from 0 to 255."
NO_COLOR = "Class “water” has the color “{}”; write it as #rrggbb."
ONE_LIMIT = "Class “water” has only one of hsv_min and hsv_max; fill in both, or leave both empty."
NO_HSV = "“{}” is not three numbers “h s v” in OpenCV's ranges (h 0–180, s and v 0–255)."
WRONG_HSV = "181 0 0", "0 256 0", "0 0 256", "1 2", "1 2 3 4", "a b c", "-1 2 3", "1.5 2 3", "² 2 3"


@pytest.mark.parametrize(
    ("row", "sentence"),
    [
        *((f"{text},water", NO_NUMBER.format(text)) for text in ("", "x", "1.5", "1e2")),
        *((f"{value},water", OUT_OF_RANGE.format(value)) for value in (-20, -1, 256, 1000)),
        *((row, "The class with value 1 has no name; add one.") for row in ("1,,#000000,background", "1")),
        *((f"1,water,{text}", NO_COLOR.format(text)) for text in ("red", "#12345", "#1234567", "123456", "#gggggg")),
        ("1,water,,landmark", "Class “water” has the role “landmark”; it must be “reference” or “background”."),
        ("0,other,,reference", "Class “other” has the value 0, which means unlabeled; it can't be a reference class."),
        ("1,water,,background,top", "“top” is not a number; draw_order needs a number or nothing."),
        *((f"1,water,,,,{cells}", ONE_LIMIT) for cells in ("10 20 30,", ",10 20 30")),
        *((f"1,water,,,,{text},1 2 3", NO_HSV.format(text)) for text in WRONG_HSV),
    ],
)
def test_a_line_that_is_no_class_is_refused(row, sentence):
    with refuses(f"classes.csv, line 2: {sentence}"):
        csv(row)


def test_a_line_may_end_early_or_go_on_and_a_class_may_have_the_value_zero():
    assert csv("1,building").classes[0].role == "background"
    assert csv("1,building,#000000,reference,,,,left,over").classes[0].name == "building"
    assert csv("0,other,#000000,background").by_value(0).name == "other"


@pytest.mark.parametrize(
    ("rows", "sentence"), [("1,a 1,b 2,c", "value 1"), ("1,a 2,a 3,b", "name a"), ("1,a 1,b 2,c 2,d", "value 1, 2")]
)
def test_repeated_values_and_names_are_refused(rows, sentence):
    with refuses(f"The class table has the {sentence} more than once; values and names must be unique."):
        csv(*rows.split(), header="value,name")


@pytest.mark.parametrize(
    ("text", "name"),
    [
        *((unknown, None) for unknown in ("", "forest", "8", "1000")),
        *((known, "water") for known in ("water", " Water ", "7", "007")),
        ("BUILDING", "building"),
    ],
)
def test_a_class_is_found_by_name_or_value(text, name):
    found = TABLE.find(text)
    assert (found and found.name) == name


def test_names_that_differ_only_in_case_are_distinguished():
    table = class_table_from_names(["Road", "road"])
    assert (table.find("Road").value, table.find("road").value, table.find("ROAD")) == (1, 2, None)


@pytest.mark.parametrize(
    ("chosen", "values"), [([], ()), (["3"], (3,)), (["Water", "bare, dry “land”"], (3, 7)), (["7", "water"], (7,))]
)
def test_exactly_the_named_classes_become_references(chosen, values):
    table = TABLE.with_references(chosen)
    assert table.reference_values == values and [c.name for c in table] == [c.name for c in TABLE]


def test_unknown_references_value_zero_and_a_table_without_references_are_refused():
    with refuses("There is no class “wood”; the classes are 1 building, 3 bare, dry “land”, 7 water."):
        TABLE.with_references(["wood"])
    table = ClassTable((LandCoverClass(0, "other", "#000000"), LandCoverClass(1, "a", "#000000")))
    with refuses("Class “other” has the value 0, which means unlabeled; it can't be a reference class."):
        table.with_references(["other"])
    assert TABLE.require_references() is TABLE
    classes = "1 building, 3 bare, dry “land”, 7 water"
    advice = f"Choose at least one of {classes}, or give it the role “reference” in the class table."
    with refuses(f"No class is a reference class. {advice}"):
        TABLE.with_references([]).require_references()
    with refuses("There are no classes. Choose a label map with labeled pixels, or a class table."):
        ClassTable(()).require_references()


def test_long_tables_are_described_in_short():
    assert english(class_table_from_values(range(1, 31)).describe()).endswith("12 12 and 18 more")


def test_default_colors_are_valid_distinct_and_always_the_same_and_read_as_red_green_blue():
    colors = [default_color(value) for value in range(1, 256)]
    assert all(re.fullmatch("#[0-9a-f]{6}", color) for color in [default_color(0), *colors])
    assert len(set(colors)) == 255
    assert colors[:2] == ["#cc6677", "#332288"]
    assert LandCoverClass(1, "a", "#0a80FF").rgb == (10, 128, 255)


def test_a_label_map_has_at_most_255_classes_and_a_full_table_no_room_for_other_ground():
    assert len(class_table_from_names(str(n) for n in range(255))) == 255
    with refuses(
        "There are 256 classes, but a label map can store 255. "
        "Choose another class field, or merge classes with a class table."
    ):
        class_table_from_names(str(n) for n in range(256))
    full = class_table_from_names([f"class {n}" for n in range(255)])
    with pytest.raises(ClassTableError, match="255"):
        full.with_filling()


@pytest.mark.parametrize("value", [-3, 256])
def test_a_field_value_outside_a_byte_is_refused(value):
    with refuses(f"Class “{value}” has the value {value}; class values go from 0 to 255."):
        class_table_from_values([1, value])


@pytest.mark.parametrize(
    ("text", "items"),
    [(None, []), ("", []), (" ; ", []), ("road;water", ["road", "water"]), (" 1 ; bare land;", ["1", "bare land"])],
)
def test_lists_are_text_separated_by_semicolons(text, items):
    assert split_list(text) == items


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"draw_order": float("nan")}, "a draw_order that is not a finite number"),
        ({"draw_order": float("inf")}, "a draw_order that is not a finite number"),
        ({"name": "n" * (limits.NAME_CHARACTERS + 1)}, "The name of class 1 has more than"),
    ],
)
def test_what_no_file_could_hold_is_refused(values, said):
    with pytest.raises(ClassTableError, match=said):
        LandCoverClass(**{"value": 1, "name": "house", "color": "#ff0000", **values})
    assert LandCoverClass(1, "n" * limits.NAME_CHARACTERS, "#ff0000", draw_order=1e300).draw_order == 1e300


def test_long_lines_numbers_and_tables_are_refused_before_colors_are_chosen(monkeypatch):
    with pytest.raises(ClassTableError, match="classes.csv has a line of more than"):
        class_table_from_csv("value,name\n1," + "n" * 200_000, "classes.csv")
    with pytest.raises(ClassTableError, match="not three numbers"):
        csv("1,water,,,," + "9" * 5000 + " 0 0,1 2 3")
    monkeypatch.setattr("semref.core.labels.class_table.chosen_colors", lambda *_: pytest.fail("colors were chosen"))
    with pytest.raises(ClassTableError, match="300 classes"):
        csv(*["1,water"] * 300)


def test_a_table_gets_a_class_for_ground_that_no_polygon_covers():
    made = class_table_from_names(["building", "water"]).with_filling()
    assert made.filling == made.by_value(3) and made.filling.name == "other" and not made.filling.is_reference
    assert made.with_filling() is made
    assert class_table_from_csv(made.to_csv()).filling == made.filling
    assert class_table_from_names(["building"]).filling is None


def test_a_class_other_that_is_there_is_taken_and_one_for_no_label_makes_room():
    own = class_table_from_csv("value,name\n4,Other\n9,building\n").with_filling()
    assert (own.filling.value, own.filling.name, len(own)) == (4, "Other", 2)
    none = class_table_from_csv("value,name\n0,other\n1,building\n").with_filling()
    assert (none.filling.value, len(none)) == (2, 2)


PRESET = class_table_from_csv(
    "value,name,color,role\n5,water,#000080,background\n9,Exotic Forest,#003300,reference\n"
    "23,311 Broad-leaved forest,#80ff00,background\n"
)


def rows(table) -> list[tuple]:
    return [(c.value, c.name, c.color, c.role) for c in table]


def test_classes_known_by_texts_keep_them_and_are_numbered_colored_and_given_roles_by_name():
    table = proposed_table([FoundClass("forest", "forest"), FoundClass("water", "water")])
    assert [(c.value, c.name, c.role) for c in table] == [(1, "forest", "background"), (2, "water", "reference")]
    assert (table.find("forest").color, table.find("water").color) == ("#1f7a3a", "#3a87c8")
    table = proposed_table([FoundClass("wa", "Water", "#123456")])
    assert table.find("wa").color == "#123456"


def test_the_styles_colors_come_first_and_name_classes_that_are_numbers():
    found = [FoundClass("7", "Lake", "#123456", 7), FoundClass("3", "House", "#654321", 3)]
    assert rows(proposed_table(found)) == [(3, "House", "#654321", "reference"), (7, "Lake", "#123456", "reference")]


def test_a_nomenclature_gives_values_colors_and_roles_and_others_come_behind_it():
    table = proposed_table([FoundClass(t, t) for t in ("lawn", "exotic forest", "water")], PRESET)
    assert rows(table)[:2] == [(5, "water", "#000080", "background"), (9, "exotic forest", "#003300", "reference")]
    assert table.by_value(10).name == "lawn"


@pytest.mark.parametrize("text", ["311", "311 Broad-leaved forest", "broad-leaved Forest"])
def test_codes_names_and_titles_of_a_nomenclature_are_the_same_class(text):
    table = proposed_table([FoundClass(text, text)], PRESET)
    assert (table.find(text).value, table.find(text).color) == (23, "#80ff00")


def test_every_text_of_the_layer_finds_a_class_of_its_own():
    texts = ["311", "Broad-leaved forest", "water", "Water ", "12", "0"]
    table = proposed_table([FoundClass(t.strip(), t) for t in texts], PRESET)
    assert len(table) == 6
    found = [table.find(text.strip()) for text in texts[2:5]]
    assert None not in found and len({c.value for c in found}) == 3
