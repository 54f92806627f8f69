"""A log of a ground station that grows while images arrive."""

from __future__ import annotations

import math
import os
import struct
import threading
import time

import pytest

from semref.core.flight.logs.mavlink import checksum
from semref.core.onboard import logs
from semref.core.onboard.cameras import open_cameras
from semref.core.onboard.logs import GrowingLog

LONG_S = 30.0


def attitude(time_s, heading_deg):
    """Return a packet of a .tlog."""
    content = struct.pack("<I6f", 1, 0.0, 0.0, math.radians(heading_deg), 1, 1, 1)
    head = bytes([len(content), 0, 0, 7, 1, 1]) + (30).to_bytes(3, "little")
    total = checksum(head + content + bytes([39]))
    return struct.pack(">Q", int(time_s * 1e6)) + b"\xfd" + head + content + struct.pack("<H", total)


@pytest.fixture(autouse=True)
def never_late(monkeypatch):
    monkeypatch.setattr(logs, "ROW_WITHIN_S", 0.0)


@pytest.fixture
def start_s():
    return float(int(time.time()) - 3600)


@pytest.fixture
def path(tmp_path, start_s):
    path = tmp_path / "flight.tlog"
    path.write_bytes(attitude(start_s, 10) + attitude(start_s + 1, 20))
    return path


def append(path, data):
    with open(path, "ab") as file:
        file.write(data)


def heading(log, moment_s):
    return float(log.until(moment_s).at([moment_s])[0, 0])


def test_new_entries_of_a_log_are_read(path, start_s):
    log = GrowingLog(str(path))
    assert heading(log, start_s + 0.5) == pytest.approx(15, abs=0.01)
    assert math.isnan(heading(log, start_s + 3))
    whole = attitude(start_s + 2, 30) + attitude(start_s + 3, 40)
    append(path, whole[:70])
    assert math.isnan(heading(log, start_s + 3))
    append(path, whole[70:])
    assert heading(log, start_s + 3) == pytest.approx(40, abs=0.01)


def test_a_rewritten_log_is_read_again(path, start_s):
    log = GrowingLog(str(path))
    assert heading(log, start_s) == pytest.approx(10, abs=0.01)
    path.write_bytes(attitude(start_s, 77))
    assert heading(log, start_s) == pytest.approx(77, abs=0.01)


def test_an_entry_that_is_late_is_waited_for(path, start_s, monkeypatch):
    monkeypatch.setattr(logs, "ROW_WITHIN_S", LONG_S)
    log = GrowingLog(str(path))
    looks = []
    monkeypatch.setattr(logs, "LOOK_EVERY_S", 0.001)
    look = log._look
    monkeypatch.setattr(log, "_look", lambda: (looks.append(1), look()))

    def write():
        while len(looks) < 5:
            time.sleep(0.001)
        append(path, attitude(start_s + 2, 30))

    writer = threading.Thread(target=write)
    writer.start()
    # Closer to the present, where later entries may still arrive.
    monkeypatch.setattr(logs.time, "time", lambda: start_s + 2.0)
    assert heading(log, start_s + 2) == pytest.approx(30, abs=0.01)
    writer.join()


def test_a_log_that_lags_is_not_taken_for_one_of_another_zone(tmp_path):
    now = time.time()
    path = tmp_path / "flight.tlog"
    path.write_bytes(b"".join(attitude(now - 3000 + n, n % 360) for n in range(2990)))
    log = GrowingLog(str(path))
    assert log.until(now - 2).zone([now - 2]) == 0
    assert math.isnan(heading(log, now - 2))


def test_a_log_that_vanishes_ends_nothing(path, start_s):
    log = GrowingLog(str(path))
    assert heading(log, start_s) == pytest.approx(10, abs=0.01)
    path.unlink()
    assert heading(log, start_s) == pytest.approx(10, abs=0.01)


def test_a_growing_log_gives_headings_of_images(path, start_s, tmp_path):
    cameras = open_cameras(None, str(path), is_ended=False, is_strict=True)
    image = tmp_path / "a.png"
    image.write_bytes(b"")
    append(path, attitude(start_s + 2, 30))
    os.utime(image, ns=(int(start_s + 2) * 10**9,) * 2)
    assert cameras.of(str(image)).heading_deg == pytest.approx(30, abs=0.01)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with names")
def test_a_pipe_that_takes_the_place_of_the_log_blocks_nothing(path, start_s, capsys):
    log = GrowingLog(str(path))
    before = len(log.until(start_s).times_s)
    os.remove(path)
    os.mkfifo(path)
    ended = threading.Thread(target=log.until, args=(start_s,), daemon=True)
    ended.start()
    ended.join(10)
    assert not ended.is_alive() and len(log._telemetry.times_s) == before
