"""Proposed class tables for land-cover layers."""

from __future__ import annotations

import pytest

from semref.core.labels.class_proposal import FoundClass, proposed_table
from semref.core.labels.class_table import class_table_from_csv

PRESET = class_table_from_csv(
    "value,name,color,role\n5,water,#000080,background\n9,Exotic Forest,#003300,reference\n"
    "23,311 Broad-leaved forest,#80ff00,background\n"
)


def rows(table) -> list[tuple]:
    return [(c.value, c.name, c.color, c.role) for c in table]


def test_classes_known_by_texts_are_numbered_in_order_colored_and_given_roles_by_name():
    table = proposed_table([FoundClass("forest", "forest"), FoundClass("water", "water")])
    assert [(c.value, c.name, c.role) for c in table] == [(1, "forest", "background"), (2, "water", "reference")]
    assert (table.find("forest").color, table.find("water").color) == ("#1f7a3a", "#3a87c8")


def test_the_styles_colors_come_first_and_name_classes_that_are_numbers():
    found = [FoundClass("7", "Lake", "#123456", 7), FoundClass("3", "House", "#654321", 3)]
    assert rows(proposed_table(found)) == [(3, "House", "#654321", "reference"), (7, "Lake", "#123456", "reference")]


def test_texts_keep_their_names_whatever_the_style_calls_them():
    table = proposed_table([FoundClass("wa", "Water", "#123456")])
    assert table.find("wa").color == "#123456"


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
