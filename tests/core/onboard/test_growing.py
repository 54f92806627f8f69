import os

import pytest

from semref.core import limits
from semref.core.errors import ParameterError
from semref.core.flight.odometry import check_odometry
from semref.core.onboard.tables import GrowingTable

HEADER = "image,dx_m,dy_m,dheading_deg\n"


@pytest.fixture
def path(tmp_path):
    return tmp_path / "odometry.csv"


def append(path, text):
    with open(path, "ab") as file:
        file.write(text if isinstance(text, bytes) else text.encode())


def table(path):
    return GrowingTable(str(path), check_odometry)


def images(growing, **how):
    return [row.texts["image"] if not isinstance(row, ParameterError) else str(row) for row in growing.new_rows(**how)]


def test_each_row_comes_once_when_it_is_there(path):
    append(path, HEADER + "a,,,\n")
    growing = table(path)
    assert images(growing) == ["a"] and images(growing) == []
    append(path, "b,1,2,3\n\nc,1,2,3\n")
    assert images(growing) == ["b", "c"]


def test_half_a_line_waits_for_its_end(path):
    append(path, HEADER + "a,,,\nb,1,2,3")
    growing = table(path)
    assert images(growing) == ["a"]
    append(path, "4\n")
    (row,) = growing.new_rows()
    assert row.texts["dheading_deg"] == "34"


def test_a_last_line_without_its_end_counts_when_nobody_writes_any_more(path):
    append(path, HEADER + "a,,,\nb,1,2,3")
    assert images(table(path), is_ended=True) == ["a", "b"]


def test_an_empty_file_waits_for_its_header(path):
    append(path, "")
    growing = table(path)
    assert images(growing) == []
    append(path, "\ufeffimage;dx_m;dy_m;dheading_deg\r\na;;;\r\n")
    assert images(growing) == ["a"]


def test_a_rewritten_table_is_read_from_its_first_line(path):
    append(path, HEADER + "a,,,\nb,1,2,3\n")
    growing = table(path)
    images(growing)
    path.write_text("image,dy_m,dx_m,dheading_deg\nc,1,,\n", encoding="utf-8")
    (row,) = growing.new_rows()
    assert (row.texts["dy_m"], growing.restarts) == ("1", 1)
    assert "line 2" in str(row.place) or row.place.values["line"] == 2


def test_an_invalid_line_is_reported_in_its_place_and_others_are_read(path):
    append(path, HEADER.encode() + b"a,,,\n\xff\xfe,1,2,3\n" + b"x" * (3 * limits.LINE_BYTES) + b"\nb,1,2,3\n")
    found = images(table(path))
    assert (found[0], found[3]) == ("a", "b") and len(found) == 4
    assert "not text in UTF-8" in found[1] and "more than" in found[2]


@pytest.mark.parametrize("kind", ["missing", "folder", "null"])
def test_what_can_not_be_read_is_one_sentence(path, kind):
    where = {"missing": path, "folder": path.parent, "null": "a\0b"}[kind]
    with pytest.raises(ParameterError):
        list(GrowingTable(str(where), check_odometry).new_rows())


def test_another_header_is_one_sentence(path):
    append(path, "time,x,y\n1,2,3\n")
    with pytest.raises(ParameterError, match="dheading_deg"):
        list(table(path).new_rows())


def test_only_what_is_new_is_read(path, monkeypatch):
    append(path, HEADER + "".join(f"{number},,,\n" for number in range(2000)))
    growing = table(path)
    assert len(images(growing)) == 2000
    append(path, "z,,,\n")
    taken = []
    monkeypatch.setattr(growing, "_rows_of_line", lambda line: taken.append(line) or iter(()))
    list(growing.new_rows())
    assert taken == [b"z,,,\n"] and os.path.getsize(path) > 10_000
