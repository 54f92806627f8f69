import json

import pytest

from semref.core import limits
from semref.core.errors import ParameterError
from semref.core.flight.motion import LinkSource
from semref.core.flight.odometry import odometry_links, read_odometry
from semref.core.onboard import tables
from semref.core.onboard.log import start_log
from semref.core.onboard.tables import OdometryTable

HEADER = "image,dx_m,dy_m,dheading_deg,sigma_m\n"
pytestmark = pytest.mark.usefixtures("never_late")


@pytest.fixture
def path(tmp_path):
    return tmp_path / "odometry.csv"


def append(path, *lines):
    with open(path, "a", encoding="utf-8") as file:
        file.writelines(f"{line}\n" for line in lines)


def begun(path, *lines):
    path.write_text(HEADER, encoding="utf-8")
    append(path, *lines)
    return OdometryTable(str(path), is_ended=False)


def told(capsys):
    return [json.loads(line) for line in capsys.readouterr().err.splitlines()]


def test_a_growing_table_gives_the_same_as_a_whole_one(path):
    rows = ["a,,,,", "b,0,60,2,1", "c,5,60,-3,1", "d,0,61,1,2"]
    table, links = begun(path), []
    for before, row in zip([None, *"abc"], rows):
        append(path, row)
        links.append(None if before is None else table.link(before, row[0]))
    whole = odometry_links(read_odometry(str(path)), ["a.png", "b.png", "c.png", "d.png"])
    for one, other in zip(links[1:], whole):
        assert (one.translation, one.turn, one.covariance) == (other.translation, other.turn, other.covariance)
        assert one.source == LinkSource.ODOMETRY and one.in_meters


def test_empty_and_missing_rows_give_no_link(path):
    table = begun(path, "a,,,,", "b,,,,", "c,0,50,0,1")
    assert table.link("a", "b") is None and table.link("a", "c") is None and table.link("x", "b") is None
    assert table.link("b", "c") is not None and table.link("c", "b") is None and table.link("c", "x") is None


def test_a_row_that_comes_after_its_image_serves_the_next_one(path):
    table = begun(path, "a,,,,")
    assert table.link("a", "b") is None
    append(path, "b,0,60,0,1", "c,0,60,0,1")
    assert table.link("b", "c") is not None


def test_a_row_is_waited_for_while_the_table_keeps_up(path, monkeypatch):
    monkeypatch.setattr(tables, "ROW_WITHIN_S", 1e9)
    table = begun(path, "a,,,,")
    monkeypatch.setattr(tables.time, "sleep", lambda seconds: append(path, "b,0,60,0,1"))
    assert table.link("a", "b") is not None


def test_a_table_that_stopped_is_waited_for_once(path, monkeypatch):
    monkeypatch.setattr(tables, "ROW_WITHIN_S", 1.0)
    clock, table = [0.0], begun(path, "a,,,,")
    monkeypatch.setattr(tables.time, "monotonic", lambda: clock[0])
    monkeypatch.setattr(tables.time, "sleep", lambda seconds: clock.__setitem__(0, clock[0] + seconds))
    assert table.link("a", "b") is None and clock[0] >= 1.0
    waited = clock[0]
    assert table.link("b", "c") is None and clock[0] == waited


def test_a_bad_line_is_reported_and_breaks_the_chain_of_links(path, capsys):
    start_log("warning")
    table = begun(path, "a,,,,", "b,far,60,0,1", "c,0,60,0,1", "d,0,60,0,1")
    assert table.link("a", "c") is None and table.link("c", "d") is not None
    (line,) = told(capsys)
    assert line["event"] == "table_line_left_out" and "line 3" in line["reason"] and "far" in line["reason"]


def test_a_bad_table_is_refused_before_the_start_and_reported_after_a_restart(path):
    begun(path, "a,,,,", "b,x,1,1,1")
    with pytest.raises(ParameterError, match="line 3"):
        OdometryTable(str(path), is_ended=False).check()
    assert OdometryTable(str(path), is_ended=False).link("a", "b") is None


def test_a_missing_table_is_reported_once_and_read_again_later(path, capsys):
    start_log("warning")
    table = OdometryTable(str(path), is_ended=False)
    assert table.link("a", "b") is None and table.link("b", "c") is None
    assert [line["event"] for line in told(capsys)] == ["table_fails"]
    path.write_text(HEADER + "a,,,,\nb,0,60,0,1\n", encoding="utf-8")
    assert table.link("a", "b") is not None


def test_memory_does_not_grow_with_the_table(path, monkeypatch):
    monkeypatch.setattr(limits, "HELD_ROWS", 50)
    table = begun(path, "0,,,,")
    for number in range(1, 400):
        append(path, f"{number},0,60,0,1")
        assert table.link(str(number - 1), str(number)).translation == pytest.approx((0, -60))
        assert len(table._rows) <= 50 and len(table._numbers) <= 50


def test_a_rewritten_table_replaces_the_earlier_rows(path):
    table = begun(path, "a,,,,", "b,0,60,0,1", "c,0,60,0,1")
    assert table.link("b", "c") is not None
    path.write_text(HEADER + "c,9,9,9,9\nd,0,30,0,1\n", encoding="utf-8")
    assert table.link("c", "d").translation == pytest.approx((0, -30)) and table.link("b", "c") is None
