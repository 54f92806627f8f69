"""Reading DJI's subtitles of several generations, and OpenDroneMap's geo.txt."""

import numpy as np

from semref.core.flight.logs.texts import is_geo, is_srt, read_geo, read_srt

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


def test_subtitles_are_recognized_by_their_times():
    assert is_srt(NEW) and not is_srt("EPSG:4326\na 1 2")


def test_a_damaged_entry_is_skipped():
    assert np.isnan(read_srt("1\n00:00:00,000 --> x\n[rel_alt: ]").values).all()


GEO = "EPSG:4326\na.jpg 7.1 46.2 400 35.5 0 0 1 1\nb.jpg 7.2 46.3 401\n# no\nc.jpg 7.2 46.3 401 x\n"


def test_yaw_in_geo_txt_is_the_heading_of_the_image():
    log = read_geo(GEO)
    assert log.images == ("a", "c")
    assert log.values[0, 0] == 35.5
    assert np.isnan(log.values[0, 1:]).all() and np.isnan(log.values[1]).all()


def test_geo_txt_begins_with_a_reference_system():
    assert is_geo(GEO) and is_geo("\n+proj=utm +zone=32\n") and not is_geo("image,a\n")
