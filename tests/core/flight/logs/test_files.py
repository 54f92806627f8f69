import numpy as np
import pytest

from semref.core.errors import ParameterError
from semref.core.flight.logs.entries import Entries
from semref.core.flight.logs.files import read_log
from semref.core.flight.logs.texts import is_geo, is_srt, read_geo, read_srt


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
        is_known = np.isfinite(found.values[:, column])
        assert 50 <= is_known.sum() <= 101 and found.times_s[is_known][0] == 0.0 and found.times_s[is_known][-1] > 98.0
        assert np.isfinite(found.at([50.0])[0, column])


def test_a_height_stays_with_the_velocity_of_its_entry():
    entries = Entries()
    entries.add(1.0, height=4.0, north=2.0, east=3.0)
    assert entries.telemetry().values[0, 3:].tolist() == [4.0, 3.0, 2.0]


NEW = """1
00:00:00,000 --> 00:00:00,033
<font size="28">SrtCnt : 1, DiffTime : 33ms
2021-06-15 13:51:24,812,345
[iso : 100] [fnum : 280] [focal_len : 240] [latitude: 46.1] [longitude: 7.2] [rel_alt: 33.400 abs_alt: 1234.5]
[gb_yaw: -12.5 gb_pitch: -90.0 gb_roll: 0.0] </font>

2
00:01:00,033 --> 00:01:00,066
<font size="28">[rel_alt: 34.000 abs_alt: 1235.1] [gb_yaw: -13.5 gb_pitch: -89.0 gb_roll: 0.5] </font>
"""
PHANTOM = """1
00:00:01,000 --> 00:00:02,000
HOME(149.0251,-20.2532) 2017.08.05 14:11:51
GPS(149.0251,-20.2533,16) BAROMETER:1.9
"""
MAVIC = """1
00:00:01,000 --> 00:00:02,000
F/2.8, SS 206.14, ISO 150, EV 0, GPS (-122.3699, 37.5929, 19), D 2.74m, H 60.50m, H.S 1.00m/s, V.S 0.00m/s
"""


def test_height_and_gimbal_of_the_newer_kind():
    log = read_srt(NEW)
    assert (log.is_gimbal, log.is_clock) == (True, False)
    assert log.times_s.tolist() == [0.0, 60.033]
    assert log.values[:, :4].tolist() == [[-12.5, 0.0, -90.0, 33.4], [-13.5, 0.5, -89.0, 34.0]]
    assert np.isnan(log.values[:, 4:]).all()


def test_height_of_older_kinds():
    assert read_srt(PHANTOM).values[0, 3] == 1.9
    assert read_srt(MAVIC).values[0, 3] == 60.5


def test_a_damaged_entry_is_skipped():
    assert np.isnan(read_srt("1\n00:00:00,000 --> x\n[rel_alt: ]").values).all()


GEO = "EPSG:4326\na.jpg 7.1 46.2 400 35.5 0 0 1 1\nb.jpg 7.2 46.3 401\n# no\nc.jpg 7.2 46.3 401 x\n"


def test_yaw_in_geo_txt_is_the_heading_of_the_image():
    log = read_geo(GEO)
    assert log.images == ("a", "c")
    assert log.values[0, 0] == 35.5
    assert np.isnan(log.values[0, 1:]).all() and np.isnan(log.values[1]).all()


def test_subtitles_are_recognized_by_their_times_and_geo_txt_by_its_reference_system():
    assert is_geo(GEO) and is_geo("\n+proj=utm +zone=32\n") and not is_geo("image,a\n")
    assert is_srt(NEW) and not is_srt("EPSG:4326\na 1 2")
