"""Logs are recognized by their content, and their messages become telemetry."""

import numpy as np
import pytest

from semref.core.errors import ParameterError
from semref.core.flight.logs.entries import Entries
from semref.core.flight.logs.files import read_log


def write(tmp_path, name, data):
    path = tmp_path / name
    path.write_bytes(data)
    return str(path)


def test_the_name_does_not_matter(tmp_path):
    text = b"1\r\n00:00:00,000 --> 00:00:01,000\r\n[rel_alt: 5.0 abs_alt: 6.0]\r\n"
    assert read_log(write(tmp_path, "a.log", text)).values[0, 3] == 5
    assert read_log(write(tmp_path, "b.log", b"EPSG:4326\na.jpg 1 2 3 44\n")).images == ("a",)


@pytest.mark.parametrize(
    ("data", "said"),
    [
        *((data, "is not a supported flight log") for data in (b"", b"image,roll\n")),
        *(
            (data, "contains no heading")
            for data in (b"EPSG:4326\na.jpg 1 2\n", b"\xa3\x95\x80", b"ULog\x01\x12\x35\x01")
        ),
    ],
)
def test_a_file_without_telemetry_is_refused(tmp_path, data, said):
    with pytest.raises(ParameterError, match=said):
        read_log(write(tmp_path, "x", data))


def test_entries_are_in_order_of_time_and_in_utc_if_known():
    entries = Entries()
    entries.add(2.0, heading=20)
    entries.add(1.0, height=5)
    log = entries.telemetry()
    assert (log.times_s.tolist(), log.is_clock) == ([1.0, 2.0], False)
    assert log.values[1, 0] == 20 and np.isnan(log.values[0, 0])
    entries.start_s = 1e9
    assert (entries.telemetry().times_s.tolist(), entries.telemetry().is_clock) == ([1e9 + 1, 1e9 + 2], True)


def test_no_entries_are_no_error():
    assert len(Entries().telemetry().times_s) == 0


def test_what_is_kept_of_a_log_does_not_grow_and_spans_all_of_it(monkeypatch):
    monkeypatch.setattr("semref.core.limits.LOG_ENTRIES", 100)
    entries = Entries()
    for n in range(5_000):
        entries.add(n / 50, heading=float(n % 360))
        entries.add(n / 50, height=n / 10)
    found = entries.telemetry()
    assert 100 <= len(found.times_s) <= 202
    for column in (0, 3):
        told = np.isfinite(found.values[:, column])
        assert 50 <= told.sum() <= 101 and found.times_s[told][0] == 0.0 and found.times_s[told][-1] > 98.0
        assert np.isfinite(found.at([50.0])[0, column])


def test_a_height_stays_with_the_velocity_of_its_entry():
    entries = Entries()
    entries.add(1.0, height=4.0, north=2.0, east=3.0)
    assert entries.telemetry().values[0, 3:].tolist() == [4.0, 3.0, 2.0]
