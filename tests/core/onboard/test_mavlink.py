import json
import math
import os
import select
from datetime import datetime, timezone

import cv2
import numpy as np
import pytest
from onboard_area import CENTER, HERE
from onboard_blobs import linear

from semref.core.errors import ParameterError
from semref.core.geometry.lon_lat import fit_lon_lat, local_axes, meters_from
from semref.core.onboard.command_line import ALL_FIXED, REFUSED, main
from semref.core.onboard.mavlink import UNKNOWN, MavlinkSink

EXTENT = (600000.0, 5199300.0, 600700.0, 5200000.0)
MIDDLE = 600350.0, 5199650.0
TAKEN = "2026-05-01T10:00:00.250000+00:00"


@pytest.fixture(scope="module")
def mavutil():
    os.environ["MAVLINK20"] = "1"
    return pytest.importorskip("pymavlink.mavutil", reason="pymavlink is not here")


@pytest.fixture
def autopilot(mavutil):
    """Return (address, `heard(kind, wait=3)`: the next message of that kind, or None after ``wait`` seconds)."""
    connection = mavutil.mavlink_connection("udpin:127.0.0.1:0", dialect="ardupilotmega")
    port = connection.port.getsockname()[1]
    yield f"udp:{port}", lambda kind, wait=3: connection.recv_match(type=kind, blocking=True, timeout=wait)
    connection.close()


@pytest.fixture(scope="module")
def lon_lat():
    return fit_lon_lat(linear, EXTENT)


def record(**values):
    longitude, latitude = (float(v[0]) for v in linear(np.array([CENTER])))
    place = {"x": CENTER[0], "y": CENTER[1], "longitude": longitude, "latitude": latitude, "heading": 30.0}
    errors = {"sigma_east": 3.0, "sigma_north": 2.0, "correlation": 0.5, "sigma_heading": 1.5, "confidence": 0.98}
    return {"time": TAKEN, "status": "fix", "track": 2, **place, **errors, **values}


def sent(autopilot, lon_lat, kind, message, *records, **options):
    where, heard = autopilot
    sink = MavlinkSink(where, lon_lat, message, **options)
    for one in records:
        sink.send(one)
    sink.close()
    assert sink.lost == 0
    return heard(kind)


def test_odometry_has_meters_from_the_middle_of_the_map_the_heading_and_the_record_s_covariance(autopilot, lon_lat):
    found = sent(autopilot, lon_lat, "ODOMETRY", "odometry", record())
    scale = 111_319.5 * math.cos(math.radians(46.997)) / 80_000
    x, y = MIDDLE
    assert found.y == pytest.approx((CENTER[0] - x) * scale, rel=0.005)
    assert found.x == pytest.approx((CENTER[1] - y) * 111_170 / 111_000, rel=0.005)
    assert (found.frame_id, found.child_frame_id) == (1, 12)
    yaw = 2 * math.atan2(found.q[3], found.q[0])
    assert math.degrees(yaw) == pytest.approx(30, abs=0.5)
    assert found.time_usec == round(datetime.fromisoformat(TAKEN).timestamp() * 1e6)
    assert (found.reset_counter, found.quality, found.estimator_type) == (2, 98, 2)
    assert math.isnan(found.vx) and math.isnan(found.velocity_covariance[0])
    full = np.zeros((6, 6))
    full[np.triu_indices(6)] = found.pose_covariance
    axes = local_axes(lon_lat, CENTER)
    # North first; the map's axes are scaled here, not turned.
    assert full[0, 0] == pytest.approx((2 * axes[1, 1]) ** 2, rel=1e-3)
    assert full[1, 1] == pytest.approx((3 * axes[0, 0]) ** 2, rel=1e-3)
    assert full[0, 1] == pytest.approx(0.5 * 2 * 3 * axes[0, 0] * axes[1, 1], rel=1e-3)
    assert full[2, 2] == full[3, 3] == pytest.approx(UNKNOWN**2)
    assert full[5, 5] == pytest.approx(math.radians(1.5) ** 2, rel=1e-3)


def test_an_autopilot_without_an_origin_gets_the_middle_of_the_map(autopilot, lon_lat):
    found = sent(autopilot, lon_lat, ["GPS_GLOBAL_ORIGIN", "SET_GPS_GLOBAL_ORIGIN"], "odometry", record())
    longitude, latitude = (float(v[0]) for v in linear(np.array([MIDDLE])))
    assert (found.latitude, found.longitude) == (round(latitude * 1e7), round(longitude * 1e7))


def test_an_origin_of_the_autopilot_is_used_and_not_sent(autopilot, lon_lat):
    origin = record()["latitude"], record()["longitude"]
    where, heard = autopilot
    sink = MavlinkSink(where, lon_lat, "vision", origin=origin)
    sink.send(record())
    sink.close()
    kinds = [heard(None).get_type() for _ in range(2)]
    assert kinds == ["HEARTBEAT", "VISION_POSITION_ESTIMATE"]


def test_a_vision_estimate_allows_for_the_mounting_of_the_camera(autopilot, lon_lat):
    found = sent(autopilot, lon_lat, "VISION_POSITION_ESTIMATE", "vision", record(heading=350.0), camera_yaw_deg=-90.0)
    assert math.degrees(found.yaw) == pytest.approx(80, abs=0.5)
    assert (found.z, found.roll, found.pitch, found.reset_counter) == (0, 0, 0, 2)
    assert found.covariance[0] == pytest.approx(4, rel=0.02)


def test_a_slow_fix_is_a_command_with_longitude_latitude_and_accuracy(autopilot, lon_lat):
    now = datetime.now(timezone.utc)
    found = sent(autopilot, lon_lat, "COMMAND_INT", "external", record(time=now.isoformat(), heading=None))
    assert (found.command, found.frame, found.target_system, found.target_component) == (43003, 0, 1, 1)
    assert (found.x, found.y) == (round(record()["latitude"] * 1e7), round(record()["longitude"] * 1e7))
    assert 0 <= found.param2 < 5 and math.isnan(found.z)
    # The larger semi-axis at one standard deviation.
    expected = math.sqrt(np.linalg.eigvalsh([[9, 3], [3, 4]])[-1])
    assert found.param3 == pytest.approx(expected, rel=0.06)


LACKING = [{"x": None, "longitude": None}, {"heading": None}]
OF_NO_FIX = [{"status": status} for status in ("likely", "ambiguous", "a status of a newer version")]


@pytest.mark.parametrize(
    ("message", "changed"),
    [(m, c) for m in ("odometry", "vision", "external") for c in OF_NO_FIX + (LACKING if m != "external" else [])],
)
def test_without_a_fix_and_its_pose_only_a_heartbeat_is_sent(autopilot, lon_lat, message, changed):
    found = sent(autopilot, lon_lat, None, message, record(**changed))
    assert (found.get_type(), found.get_srcSystem(), found.get_srcComponent()) == ("HEARTBEAT", 1, 197)
    assert autopilot[1](None, 0.2) is None


def test_a_turned_grid_turns_heading_and_covariance():
    """The y axis of the map points north-east."""

    def transform(points_xy):
        u, v = (points_xy - [1000.0, 1000.0]).T
        east, north = (u + v) / math.sqrt(2), (v - u) / math.sqrt(2)
        return 9 + east / (111_319.5 * math.cos(math.radians(47))), 47 + north / 111_170

    axes = local_axes(fit_lon_lat(transform, (0.0, 0.0, 2000.0, 2000.0)), (1000.0, 1000.0))
    assert math.degrees(math.atan2(axes[1, 0], axes[1, 1])) == pytest.approx(45, abs=0.2)
    assert np.hypot(*axes.T) == pytest.approx([1, 1], rel=0.004)


def test_meters_on_the_ellipsoid():
    """Lengths of a degree of latitude and longitude at 45°, from tables of WGS 84."""
    assert meters_from((44.5, 9.0), (45.5, 9.0)) == pytest.approx((111_132, 0), abs=3)
    assert meters_from((45.0, 179.5), (45.0, -179.5)) == pytest.approx((0, 78_847), abs=3)


def test_a_serial_line_hears_it_also_after_its_adapter_was_unplugged(mavutil, lon_lat, tmp_path):
    pytest.importorskip("serial", reason="pyserial is not here")
    pty = pytest.importorskip("pty")
    from pymavlink.dialects.v20 import ardupilotmega

    device = tmp_path / "tty"

    def heard(*records) -> list[str]:
        """Plug in, send the records, unplug, and return the kinds of the messages."""
        ours, theirs = pty.openpty()
        device.symlink_to(os.ttyname(theirs))
        sink = sinks[0] if sinks else MavlinkSink(f"serial:{device}:57600", lon_lat)
        sinks[:] = [sink]
        for one in records:
            sink.send(one)
        data = b""
        while select.select([ours], [], [], 0.5)[0]:
            data += os.read(ours, 4000)
        os.close(ours)
        os.close(theirs)
        device.unlink()
        return [message.get_type() for message in ardupilotmega.MAVLink(None).parse_buffer(data) or ()]

    sinks: list[MavlinkSink] = []
    assert heard(record()) == ["HEARTBEAT", "SET_GPS_GLOBAL_ORIGIN", "ODOMETRY"]
    sinks[0].send(record())
    sinks[0].send(record())
    assert heard(record())[-1:] == ["ODOMETRY"]
    assert sinks[0].lost == 2
    sinks[0].close()


@pytest.mark.parametrize("message", ["odometry", "vision", "external"])
def test_an_image_of_before_1970_is_sent_as_well(autopilot, lon_lat, message):
    kind = {"odometry": "ODOMETRY", "vision": "VISION_POSITION_ESTIMATE", "external": "COMMAND_INT"}[message]
    assert sent(autopilot, lon_lat, kind, message, record(time="1969-12-31T23:00:00+00:00")) is not None


def test_watch_sends_positions_to_an_autopilot(area, autopilot, tmp_path):
    folder = tmp_path / "incoming"
    folder.mkdir()
    cv2.imwrite(str(folder / "a.png"), HERE)
    where, heard = autopilot
    fixes = tmp_path / "fixes"
    arguments = ["watch", str(folder), "--database", area, "--once", "--fixes", str(fixes), "--mavlink", where]
    assert main([*arguments, "--mavlink-as", "external"]) == ALL_FIXED
    row, found = json.loads(fixes.read_text()), heard("COMMAND_INT")
    assert found.x == pytest.approx(row["latitude"] * 1e7, abs=1)
    assert found.y == pytest.approx(row["longitude"] * 1e7, abs=1)


def test_a_line_that_is_not_there_is_refused_by_name(mavutil, area, tmp_path, capsys):
    pytest.importorskip("serial", reason="pyserial is not here")
    arguments = ["watch", str(tmp_path), "--database", area, "--once", "--mavlink", "serial:/dev/none"]
    assert main(arguments) == REFUSED
    assert "serial:/dev/none can't be written" in capsys.readouterr().err


def test_without_pymavlink_the_message_names_the_package(monkeypatch, lon_lat):
    monkeypatch.setitem(__import__("sys").modules, "pymavlink.dialects.v20", None)
    with pytest.raises(ParameterError, match="pip install pymavlink"):
        MavlinkSink("udp:14550", lon_lat)


def test_an_unreachable_host_is_reported_and_counted(mavutil, lon_lat):
    sink = MavlinkSink("udp:256.1.1.1:14550", lon_lat)
    sink.send(record())
    sink.send({"time": None, "x": None})
    sink.close()
    assert sink.lost >= 1
