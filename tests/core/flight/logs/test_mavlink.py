import math
import struct

import numpy as np
import pytest

from semref.core.flight.logs.mavlink import TlogReader, checksum, is_tlog, read_tlog

ATTITUDE = struct.pack("<I6f", 1, 0.1, -0.2, math.radians(-90), 0, 0, 0)
PLACE = struct.pack("<Iiiii3hH", 1, 0, 0, 0, 55_500, 300, 400, 0, 9_000)


def packet(time_s, kind, content, extra, version=2, system=1):
    if version == 2:
        content = content.rstrip(b"\0") or b"\0"
        head = bytes([len(content), 0, 0, 7, system, 1]) + kind.to_bytes(3, "little")
    else:
        head = bytes([len(content), 7, system, 1, kind])
    total = checksum(head + content + bytes([extra]))
    start = b"\xfd" if version == 2 else b"\xfe"
    return struct.pack(">Q", int(time_s * 1e6)) + start + head + content + struct.pack("<H", total)


def test_the_checksum_is_that_of_mavlink():
    assert checksum(b"123456789") == 0x6F91


@pytest.mark.parametrize("version", [1, 2])
def test_attitude_height_and_velocity_are_read(version):
    data = packet(1e9, 30, ATTITUDE, 39, version) + packet(1e9 + 1, 33, PLACE, 104, version)
    assert is_tlog(data)
    log = read_tlog(data)
    assert (log.is_clock, log.is_gimbal, log.times_s.tolist()) == (True, False, [1e9, 1e9 + 1])
    assert log.values[0, :3] == pytest.approx([-90, math.degrees(0.1), math.degrees(-0.2)], abs=1e-4)
    assert log.values[1, 3:].tolist() == [55.5, 4.0, 3.0]


def test_other_systems_and_other_messages_are_ignored():
    data = packet(1, 30, ATTITUDE, 39) + packet(2, 30, ATTITUDE, 39, system=255) + packet(3, 0, b"\1\2\3", 50)
    assert read_tlog(data).times_s.tolist() == [1.0]


def test_packets_with_a_wrong_checksum_are_skipped():
    bad = bytearray(packet(1, 30, ATTITUDE, 39))
    bad[20] ^= 1
    assert read_tlog(bytes(bad) + packet(2, 30, ATTITUDE, 39)).times_s.tolist() == [2.0]


def test_a_text_is_no_log():
    assert not is_tlog(b"image,dx_m,dy_m,dheading_deg\na,,,\nb,1,2,3\n")


@pytest.mark.parametrize("step", [1, 7, 40, 200])
def test_a_log_in_pieces_gives_the_same_as_the_whole(step):
    kinds = ((30, ATTITUDE, 39), (33, PLACE, 104), (0, b"\1\2\3\xfe\xfd", 50))
    data = b"".join(packet(n, *kinds[n % 3], version=1 + n % 2) for n in range(12))
    reader, begin = TlogReader(), 0
    for end in range(step, len(data) + step, step):
        begin += reader.take(data[begin:end])
    told, whole = reader.telemetry(), read_tlog(data)
    assert begin == len(data) and told.times_s.tolist() == whole.times_s.tolist()
    assert np.array_equal(told.values, whole.values, equal_nan=True)


def test_a_log_that_was_cut_anywhere_after_its_first_packet_is_one():
    first = packet(1, 30, ATTITUDE, 39)
    data = first + packet(2, 0, bytes(range(1, 40)), 50)
    assert not is_tlog(data[: len(first) - 1])
    assert all(is_tlog(data[:end]) for end in range(len(first), len(data) + 1))
    assert not is_tlog(first + b"12345678" + b"no packet")
