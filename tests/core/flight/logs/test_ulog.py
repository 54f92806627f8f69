import math
import struct

import pytest

from semref.core.flight.logs.ulog import angles_of, read_ulog

FORMATS = (
    b"vehicle_attitude:uint64_t timestamp;float[4] q;uint8_t[3] flags;uint8_t[5] _padding0;",
    b"vehicle_local_position:uint64_t timestamp;float x;float z;float vx;float vy;",
    b"sensor_gps:uint64_t timestamp;uint64_t time_utc_usec;",
    b"other:uint64_t timestamp;nested n;",
)
NAMES = ("vehicle_attitude", "vehicle_local_position", "sensor_gps", "other")


def message(kind, content):
    return struct.pack("<HB", len(content), ord(kind)) + content


def log_of(*messages):
    added = (message("A", b"\0" + struct.pack("<H", n) + name.encode()) for n, name in enumerate(NAMES))
    head = b"ULog\x01\x12\x35\x01" + bytes(8)
    return head + b"".join(message("F", text) for text in FORMATS) + b"".join(added) + b"".join(messages)


def data_of(number, packed, *values):
    return message("D", struct.pack("<H", number) + struct.pack(packed, *values))


HALF = math.sqrt(0.5)
ATTITUDE = data_of(0, "<Q4f3B", 1_000_000, HALF, 0, 0, HALF, 1, 2, 3)
PLACE = data_of(1, "<Q4f", 2_000_000, 9, -55.5, 3, 4)


def test_attitude_height_and_velocity_are_read():
    log = read_ulog(log_of(ATTITUDE, PLACE, data_of(3, "<Q", 5)))
    assert (log.is_clock, log.times_s.tolist()) == (False, [1.0, 2.0])
    assert log.values[0, :3] == pytest.approx([90, 0, 0], abs=1e-4)
    assert log.values[1, 3:].tolist() == [55.5, 4.0, 3.0]


def test_the_clock_is_that_of_satellites_where_there_is_one():
    log = read_ulog(log_of(data_of(2, "<QQ", 500_000, 1_600_000_000_000_000), ATTITUDE))
    assert log.is_clock and log.times_s[0] == pytest.approx(1.6e9 + 0.5, abs=1e-3)


@pytest.mark.parametrize(
    ("quaternion", "angles"),
    [((1, 0, 0, 0), (0, 0, 0)), ((HALF, HALF, 0, 0), (90, 0, 0)), ((math.sqrt(0.75), 0, 0.5, 0), (0, 60, 0))],
)
def test_angles_of_a_quaternion(quaternion, angles):
    assert angles_of(*quaternion) == pytest.approx(angles, abs=1e-6)


def test_damage_is_skipped():
    assert len(read_ulog(log_of(ATTITUDE, PLACE)[:-5]).times_s) == 1
    assert len(read_ulog(b"ULog\x01\x12\x35\x01").times_s) == 0
