import tracemalloc

import pytest

from semref.core import limits
from semref.core.errors import ParameterError
from semref.core.sentences import Sentence, english
from semref.core.tables import Row, bytes_of, rows_of, stem_of
from semref.core.values import checked, number, read_json, short_text, shown


def write(tmp_path, data):
    path = tmp_path / "table.csv"
    path.write_bytes(data)
    return str(path)


def need_image(columns):
    columns.need(["image"])


def test_rows_keep_the_number_of_their_line(tmp_path):
    rows = list(rows_of(write(tmp_path, b"\xef\xbb\xbfImage,B\n\na,1\n\nb\n"), need_image))
    assert [row.texts for row in rows] == [{"image": "a", "b": "1"}, {"image": "b"}]
    assert [english(row.place)[-6:] for row in rows] == ["line 3", "line 5"]


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (b"", "begins with “”; its header needs the columns image"),
        (b"other,b\n", "begins with “other,b”; its header needs the columns image"),
        (b"image\n\xff\xfe\n", "is not text in UTF-8"),
        (b"image\n" + b"x" * 20_000, "has a line of more than"),
    ],
)
def test_what_is_no_table_is_refused(tmp_path, data, said):
    with pytest.raises(ParameterError, match=said):
        list(rows_of(write(tmp_path, data), need_image))


def test_files_that_cannot_be_read_are_refused(tmp_path):
    large = write(tmp_path, b"x" * 11)
    for path, said in (
        *((unreadable, "can't be read") for unreadable in (str(tmp_path / "none.csv"), "a\0b")),
        *((str(tmp_path), "is not a file"), (large, "is larger than")),
    ):
        with pytest.raises(ParameterError, match=said):
            bytes_of(path, 10)


def test_numbers_are_finite_and_in_range():
    row = Row({"a": "2.5", "b": "inf", "c": ""}, Sentence("{source}, line {line}", source="t", line=2))
    assert row.number("a") == 2.5
    assert row.number("c", 7.0) == 7.0
    for name, said in (("b", "b is “inf”, which is not a number"), ("c", "c is “”, which is not a number")):
        with pytest.raises(ParameterError, match=f"^t, line 2: {said}"):
            row.number(name)
    with pytest.raises(ParameterError, match="a is 2.5; it must be from 0 to 1"):
        row.within("a", 0, 1)


@pytest.mark.parametrize("path", ["a.b.jpg", "/x/y/a.b.tif", "C:\\x\\a.b.png"])
def test_the_stem_is_the_name_without_folders_and_extension(path):
    assert stem_of(path) == "a.b"


def test_a_null_character_ends_nothing(tmp_path):
    # Before Python 3.11, csv refuses null characters.
    try:
        assert [row.texts["image"] for row in rows_of(write(tmp_path, b"image,b\na\0,1\n"), need_image)] == ["a\0"]
    except ParameterError as error:
        assert error.sentence.template == "{path} can't be read: {reason}."


def test_a_small_file_takes_no_room_for_the_largest(tmp_path):
    path = tmp_path / "track.csv"
    path.write_bytes(b"x,y\n1,2\n")
    tracemalloc.start()
    try:
        assert bytes_of(str(path), 500_000_000) == b"x,y\n1,2\n"
        assert tracemalloc.get_traced_memory()[1] < 1_000_000
    finally:
        tracemalloc.stop()


def test_json_is_read_up_to_its_longest_its_deepest_and_its_numbers_of_most_digits():
    assert read_json('{"a": [1, 2.5, "]]"]}') == {"a": [1, 2.5, "]]"]}
    assert read_json("[1, 2]", longest=6) == [1, 2]
    deepest = "[" * limits.JSON_DEPTH + "]" * limits.JSON_DEPTH
    read_json(deepest)
    with pytest.raises(ValueError, match="7 characters, more than 6"):
        read_json("[1, 22]", longest=6)
    with pytest.raises(ValueError, match="more than 32 lists"):
        read_json(f"[{deepest}]")
    text = '["' + "[" * 100 + r"\"{{" + '"]'
    assert read_json(text) == ["[" * 100 + '"{{']
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
