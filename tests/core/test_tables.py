"""Tables of flights are checked when they are read."""

import tracemalloc

import pytest

from semref.core.errors import ParameterError
from semref.core.sentences import Sentence, english
from semref.core.tables import Row, bytes_of, rows_of, stem_of


def write(tmp_path, data):
    path = tmp_path / "table.csv"
    path.write_bytes(data)
    return str(path)


def need_image(columns):
    columns.need(["image"])


def code_of(call):
    with pytest.raises(ParameterError) as caught:
        call()
    return caught.value.sentence.template


def test_rows_keep_the_number_of_their_line(tmp_path):
    rows = list(rows_of(write(tmp_path, b"\xef\xbb\xbfImage,B\n\na,1\n\nb\n"), need_image))
    assert [row.texts for row in rows] == [{"image": "a", "b": "1"}, {"image": "b"}]
    assert [english(row.place)[-6:] for row in rows] == ["line 3", "line 5"]


@pytest.mark.parametrize(
    ("data", "code"),
    [
        (b"", "{path} begins with “{first}”; its header needs the columns {columns}."),
        (b"other,b\n", "{path} begins with “{first}”; its header needs the columns {columns}."),
        (b"image\n\xff\xfe\n", "{path} is not text in UTF-8. Save it as CSV in UTF-8."),
        (b"image\n" + b"x" * 20_000, "{path} has a line of more than {most} characters. Choose another file."),
    ],
)
def test_what_is_no_table_is_refused(tmp_path, data, code):
    assert code_of(lambda: list(rows_of(write(tmp_path, data), need_image))) == code


def test_files_that_cannot_be_read_are_refused(tmp_path):
    assert code_of(lambda: bytes_of(str(tmp_path / "none.csv"), 10)) == "{path} can't be read: {reason}."
    assert code_of(lambda: bytes_of(str(tmp_path), 10)) == "{path} is not a file. Choose a table or a log."
    assert code_of(lambda: bytes_of("a\0b", 10)) == "{path} can't be read: {reason}."
    assert (
        code_of(lambda: bytes_of(write(tmp_path, b"x" * 11), 10))
        == "{path} is larger than {most_mb} MB, the largest size of tables and logs. Choose another file."
    )


def test_numbers_are_finite_and_in_range():
    row = Row({"a": "2.5", "b": "inf", "c": ""}, Sentence("{source}, line {line}", source="t", line=2))
    assert row.number("a") == 2.5
    assert row.number("c", 7.0) == 7.0
    assert code_of(lambda: row.number("b")) == "{place}: {name} is “{text}”, which is not a number."
    assert code_of(lambda: row.number("c")) == "{place}: {name} is “{text}”, which is not a number."
    assert (
        code_of(lambda: row.within("a", 0, 1)) == "{place}: {name} is {value:g}; it must be from {least:g} to {most:g}."
    )


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
