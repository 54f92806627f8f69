import struct

import pytest

from semref.core.flight.logs.dataflash import read_dataflash

KINDS = {
    "ATT": (60, "QccccCCCCB", "TimeUS,DesRoll,Roll,DesPitch,Pitch,DesYaw,Yaw,ErrRP,ErrYaw,AEKF", "<QhhhhHHHHB"),
    "XKF1": (61, "QBccCfff", "TimeUS,C,Roll,Pitch,Yaw,VN,VE,VD", "<QBhhHfff"),
    "POS": (62, "QLLfff", "TimeUS,Lat,Lng,Alt,RelHomeAlt,RelOriginAlt", "<Qiifff"),
    "GPS": (63, "QBIH", "TimeUS,Status,GMS,GWk", "<QBIH"),
}


def described(name):
    kind, letters, labels, packed = KINDS[name]
    texts = name.encode(), letters.encode(), labels.encode()
    return b"\xa3\x95\x80" + struct.pack("<BB4s16s64s", kind, 3 + struct.calcsize(packed), *texts)


def message(name, *values):
    kind, _, _, packed = KINDS[name]
    return b"\xa3\x95" + bytes([kind]) + struct.pack(packed, *values)


def log_of(*messages):
    own = b"\xa3\x95\x80" + struct.pack("<BB4s16s64s", 128, 89, b"FMT", b"BBnNZ", b"Type,Length,Name,Format,Columns")
    return own + b"".join(described(name) for name in KINDS) + b"".join(messages)


ATT = message("ATT", 1_000_000, 0, 150, 0, -250, 0, 27_050, 0, 0, 3)
VELOCITY = message("XKF1", 1_500_000, 0, 0, 0, 0, 3.0, 4.0, 0.0)
HEIGHT = message("POS", 2_000_000, 1, 2, 400.0, 55.5, 55.5)


def test_attitude_velocity_and_height_are_read():
    log = read_dataflash(log_of(ATT, VELOCITY, HEIGHT))
    assert (log.is_clock, log.is_gimbal) == (False, False)
    assert log.times_s.tolist() == [1.0, 1.5, 2.0]
    assert log.values[0, :3].tolist() == [270.5, 1.5, -2.5]
    assert log.values[1, 4:].tolist() == [4.0, 3.0]
    assert log.values[2, 3] == 55.5


def test_only_the_first_filter_counts():
    assert not len(read_dataflash(log_of(message("XKF1", 1, 1, 0, 0, 0, 3.0, 4.0, 0.0))).times_s)


def test_the_clock_is_that_of_satellites_where_there_is_one():
    log = read_dataflash(log_of(message("GPS", 500_000, 3, 1000, 2000), ATT))
    assert log.is_clock
    assert log.times_s[0] == pytest.approx(315_964_800 + 2000 * 604_800 + 1 - 18 - 0.5 + 1.0, abs=1e-3)


def test_damage_is_skipped():
    whole = log_of(ATT, VELOCITY)
    assert len(read_dataflash(whole[:-5]).times_s) == 1
    assert len(read_dataflash(log_of(ATT, b"\xa3\x95\xfejunk\x00\xa3", VELOCITY)).times_s) == 2
    assert len(read_dataflash(b"\xa3\x95").times_s) == 0
