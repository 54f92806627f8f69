"""Values from files: valid ones pass, hostile and impossible ones are refused."""

from __future__ import annotations

import pytest

from semref.core import limits
from semref.core.values import checked, number, read_json, short_text, shown


def test_json_is_read_up_to_its_longest_and_deepest():
    assert read_json('{"a": [1, 2.5, "]]"]}') == {"a": [1, 2.5, "]]"]}
    assert read_json("[1, 2]", longest=6) == [1, 2]
    deepest = "[" * limits.JSON_DEPTH + "]" * limits.JSON_DEPTH
    read_json(deepest)
    with pytest.raises(ValueError, match="7 characters, more than 6"):
        read_json("[1, 22]", longest=6)
    with pytest.raises(ValueError, match="more than 32 lists"):
        read_json(f"[{deepest}]")


def test_brackets_within_texts_are_no_depth():
    text = '["' + "[" * 100 + r"\"{{" + '"]'
    assert read_json(text) == ["[" * 100 + '"{{']


def test_a_whole_number_of_too_many_digits_is_refused():
    assert read_json("9" * 64) == 10**64 - 1
    with pytest.raises(ValueError, match="65 digits"):
        read_json("9" * 65)


@pytest.mark.parametrize("value", [True, "1", None, 0, -1, 11, float("nan"), float("inf"), 10**400])
def test_a_number_is_finite_and_in_range(value):
    assert number(10, "size", above=0, most=10) == 10.0
    with pytest.raises(ValueError, match="^size is "):
        number(value, "size", above=0, most=10)


def test_kinds_and_lengths_are_checked_and_what_is_shown_is_short():
    assert (checked(3, int, "n"), short_text("ab", "name", 2)) == (3, "ab")
    for refused in (lambda: checked(True, int, "n"), lambda: checked("3", int, "n"), lambda: short_text("abc", "n", 2)):
        with pytest.raises(ValueError, match="^n "):
            refused()
    assert shown("x" * 500) == "'" + "x" * 63 + "…"
    assert shown(10**65) == "a number of too many digits"
