"""A sentence: its words from the table, its values, sentences and lists among them."""

from __future__ import annotations

import pytest

from semref.core.sentences import Sentence, add, english, filled, template_of
from semref.core.sentences.sentence import _templates


def test_a_sentence_without_values_is_its_template():
    assert english(Sentence("labels.no_pixels")) == "The image has no pixels."


def test_numbers_are_shown_as_the_template_says():
    sentence = Sentence("localization.vector_too_far", distance=0.123456, threshold=0.25)
    assert str(sentence) == "The nearest window has distance 0.123, more than 0.25."


@pytest.mark.parametrize(("count", "verb"), [(0, "places fit"), (1, "place fits"), (2, "places fit")])
def test_words_follow_the_count(count, verb):
    assert str(Sentence("localization.rivals", count=count)).startswith(f"{count} other {verb} ")


def test_sentences_among_the_values_are_worded_by_the_same_hand():
    needed = Sentence("localization.more_needed", count=2)
    sentence = Sentence("localization.too_few_landmarks", shown="This", needed=needed)
    assert english(sentence) == "This; at least 2 more are needed."
    assert filled(sentence, lambda part: f"<{template_of(part)}>") == "<This; <at least 2 more are needed>.>"


def test_lists_are_joined_with_commas():
    sentence = Sentence("localization.neither_road", constellation=["a", Sentence("labels.no_pixels")], correlation=())
    assert english(sentence) == "a, The image has no pixels. Map correlation has no fix either: "


def test_equal_sentences_are_one_in_a_set_whatever_the_order_of_their_values():
    one = Sentence("room.code", a=1, b=["x", "y"])
    assert {one, Sentence("room.code", b=("x", "y"), a=1)} == {one}
    assert one != Sentence("room.code", a=2, b=["x", "y"])


def test_after_a_colon_a_sentence_begins_in_lower_case(monkeypatch):
    monkeypatch.setitem(_templates, "test.because", "No fix: {why:clause} {why}")
    said = Sentence("test.because", why=Sentence("labels.no_pixels"))
    assert english(said) == "No fix: the image has no pixels. The image has no pixels."


def test_a_missing_value_is_an_error_rather_than_a_gap():
    with pytest.raises(KeyError, match="threshold"):
        english(Sentence("localization.vector_too_far", distance=0.1))


def test_a_text_that_is_no_code_stands_for_itself_braces_included():
    assert str(Sentence("No {code}.")) == "No {code}."


def test_a_room_above_adds_its_own():
    add({"test.of_a_room_above": "{what} was added."})
    try:
        assert str(Sentence("test.of_a_room_above", what="This")) == "This was added."
    finally:
        del _templates["test.of_a_room_above"]


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ("a\nb\0c\x1b[2J", "a\\nb\\x00c\\x1b[2J"),
        ("left\u202eto right\u2028", "left\\u202eto right\\u2028"),
        ("lone \udcff", "lone \\udcff"),
        ("thin\u2009space, é, 日本", "thin\u2009space, é, 日本"),
        (10**5000, "…"),
        (-(10**5000), "…"),
        (12, "12"),
    ],
    ids=range(7),
)
def test_a_value_stands_in_one_line_whatever_it_holds(value, said):
    text = english(("x", value))
    assert text == f"x, {said}"
    text.encode("utf-8")


def test_a_long_value_is_cut_in_its_middle():
    path = "/folder/" + "x" * 100_000 + "/name.png"
    text = english(Sentence("labels.damaged", path=path))
    assert text.startswith("/folder/xxx") and "x/name.png is damaged" in text and len(text) < 600


def test_a_path_of_usual_length_is_told_whole():
    path = "/folder" * 60 + "/name.png"
    assert english(Sentence("labels.damaged", path=path)).startswith(f"{path} is damaged")


@pytest.mark.parametrize(
    ("value", "said"),
    [
        ([0] * 9000, "0, 0, 0"),
        ({"a": ["x\n"] * 9000}, "{'a': ['x\\n', "),
        ({"a": 10**5000}, "…"),
        (("name\n",) * 9000, "name\\n, name\\n, "),
    ],
    ids=["list", "dict", "number of 5,000 digits in a dict", "values with commas"],
)
def test_what_holds_many_values_is_cut_too(value, said):
    text = english(Sentence("segmentation.not_a_segmentor", source="a.onnx", kind=value))
    assert f"a.onnx is a model of type {said}" in text
    assert "…" in text and len(text) < 1700 and text.isprintable()


def test_names_of_all_classes_of_a_table_are_told_whole():
    names = tuple(f"class {n}" for n in range(1, 129))
    assert ", ".join(names) in english(Sentence("segmentation.not_a_segmentor", source="a.onnx", kind=names))
