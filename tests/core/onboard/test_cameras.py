import os

import pytest

from semref.core.errors import ParameterError
from semref.core.flight.cameras import read_cameras
from semref.core.flight.motion import LinkSource
from semref.core.onboard import cameras as module
from semref.core.onboard.cameras import open_cameras

SRT = """1
00:00:0{0},000 --> 00:00:0{0},900
[rel_alt: {1} abs_alt: 500.0] [gb_yaw: {2} gb_pitch: -85.0 gb_roll: 0.0]

"""

pytestmark = pytest.mark.usefixtures("never_late")


@pytest.fixture
def table(tmp_path):
    path = tmp_path / "cameras.csv"
    path.write_text("image,roll,pitch,field_of_view,height,heading\na.png,3,-4,60,120,30\n", encoding="utf-8")
    return path


@pytest.fixture
def srt(tmp_path):
    path = tmp_path / "flight.srt"
    path.write_text("".join(SRT.format(n, 100 + n, 10 * n) for n in range(5)), encoding="utf-8")
    return path


def put(tmp_path, name, seconds):
    path = tmp_path / name
    path.write_bytes(b"")
    os.utime(path, ns=(seconds * 10**9, seconds * 10**9))
    return str(path)


def test_a_growing_camera_table_gives_what_qgis_reads(tmp_path, table):
    cameras = open_cameras(str(table), None, is_ended=False, is_strict=True)
    with open(table, "a", encoding="utf-8") as file:
        file.write("b.png,1,2,60,90,400\n")
    images = [put(tmp_path, name, 5) for name in ("a.png", "b.png", "c.png")]
    assert [cameras.of(image) for image in images] == read_cameras(images, str(table))
    assert cameras.of(images[1]).heading_deg == 40


def test_a_log_fills_gaps_of_the_camera_table_and_what_it_does_not_cover_is_unknown(tmp_path, table, srt):
    cameras = open_cameras(str(table), str(srt), is_ended=True, is_strict=True)
    known, logged = (cameras.of(put(tmp_path, name, 2)) for name in ("a.png", "b.png"))
    assert (known.attitude.roll_deg, known.height.meters, known.heading_deg) == (3, 120, 30)
    assert (logged.attitude.pitch_deg, logged.height.meters, logged.heading_deg) == pytest.approx((5, 102, 20))
    cameras = open_cameras(None, str(srt), is_ended=True, is_strict=True)
    assert cameras.of(put(tmp_path, "a.png", 50)).height is None


def test_bad_tables_and_logs_are_refused_at_the_start_and_done_without_in_the_air(tmp_path, table):
    table.write_text("image,roll,pitch\na.png,3,\n", encoding="utf-8")
    with pytest.raises(ParameterError, match="line 2"):
        open_cameras(str(table), None, is_ended=True, is_strict=True)
    with pytest.raises(ParameterError, match="not a supported flight log"):
        open_cameras(None, str(table), is_ended=True, is_strict=True)
    lenient = open_cameras(str(table), str(table), is_ended=True, is_strict=False)
    assert lenient.log is None and lenient.of(put(tmp_path, "a.png", 1)).attitude is None


def test_the_log_links_images_by_its_speeds_and_its_zone_is_that_of_the_first_image(monkeypatch):
    asked = []
    monkeypatch.setattr(module, "log_links", lambda log, names, times: asked.append((names, times)) or [])
    cameras = module.Cameras(log=object())
    assert cameras.link(("a", 5.0), ("b", 7.0)) is None and cameras.link(("b", 7.0), ("c", 9.0)) is None
    assert asked == [(["", "a", "b"], [5.0, 5.0, 7.0]), (["", "b", "c"], [5.0, 7.0, 9.0])]


def test_motion_between_two_images_is_that_of_the_log():
    from semref.core.flight.telemetry import FIELDS, telemetry

    log = telemetry([0.0, 1.0, 2.0], [[0.0, 0.0, 0.0, 100.0, 0.0, 20.0]] * 3)
    assert FIELDS[4:] == ("east", "north")
    link = module.Cameras(log=log).link(("a", 0.5), ("b", 1.5))
    assert link.source == LinkSource.LOG and link.translation == pytest.approx((0, -20))
