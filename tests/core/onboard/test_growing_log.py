import json
import logging
import math
import os
import struct
import threading
import time
from datetime import datetime

import pytest
from made_models import NAMES, write_model

from semref.core.flight.logs.mavlink import checksum
from semref.core.labels.class_table import class_table_from_csv
from semref.core.onboard import growing_log
from semref.core.onboard.cameras import open_cameras
from semref.core.onboard.growing_log import GrowingLog
from semref.core.onboard.image_records import label_reader
from semref.core.onboard.log import json_line, log_event, start_log

LONG_S = 30.0
pytestmark = pytest.mark.usefixtures("never_late")


def attitude(time_s, heading_deg):
    """Return a packet of a .tlog."""
    content = struct.pack("<I6f", 1, 0.0, 0.0, math.radians(heading_deg), 1, 1, 1)
    head = bytes([len(content), 0, 0, 7, 1, 1]) + (30).to_bytes(3, "little")
    total = checksum(head + content + bytes([39]))
    return struct.pack(">Q", int(time_s * 1e6)) + b"\xfd" + head + content + struct.pack("<H", total)


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
    monkeypatch.setattr(growing_log, "ROW_WITHIN_S", LONG_S)
    log = GrowingLog(str(path))
    looks = []
    monkeypatch.setattr(growing_log, "LOOK_EVERY_S", 0.001)
    look = log._look
    monkeypatch.setattr(log, "_look", lambda: (looks.append(1), look()))

    def write():
        while len(looks) < 5:
            time.sleep(0.001)
        append(path, attitude(start_s + 2, 30))

    writer = threading.Thread(target=write)
    writer.start()
    # Closer to the present, where later entries may still arrive.
    monkeypatch.setattr(growing_log.time, "time", lambda: start_s + 2.0)
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


@pytest.fixture
def lines(capsys):
    """`lines(level)` starts the log and returns a function that reads the new lines."""
    logger = logging.getLogger("semref")
    before = logger.handlers, logger.level

    def started(level):
        start_log(level)
        return lambda: [json.loads(line) for line in capsys.readouterr().err.splitlines()]

    yield started
    logger.handlers, logger.level = before


def test_a_line_has_time_level_event_and_details(lines):
    written = lines("info")
    log_event(logging.WARNING, "image failed", path="a.png", tries=2)
    (line,) = written()
    assert datetime.fromisoformat(line.pop("time")).utcoffset().total_seconds() == 0
    assert line == {"level": "warning", "event": "image failed", "path": "a.png", "tries": 2}


def test_a_name_that_is_no_utf8_comes_back_as_the_system_has_it():
    text = json_line({"path": "a\udcff.png", "class": "forêt"})
    assert text.encode("utf-8") and "forêt" in text
    assert json.loads(text)["path"] == "a\udcff.png"


@pytest.fixture
def logged(lines, tmp_path, monkeypatch):
    """`logged(device)` returns the lines of the log where only the CPU exists."""
    import onnxruntime

    monkeypatch.setattr(onnxruntime, "get_available_providers", lambda: ["CPUExecutionProvider"])
    model = write_model(tmp_path / "m.onnx")
    table = class_table_from_csv("value,name\n" + "".join(f"{n},{name}\n" for n, name in enumerate(NAMES, start=1)))

    def run(device):
        written = lines("info")
        label_reader(str(model), 1, table, device)
        return written()

    return run


@pytest.mark.parametrize("device", ["auto", "cpu"])
def test_the_log_names_the_device(logged, device):
    (line,) = logged(device)
    assert (line["event"], line["device"]) == ("model", "CPU")


def test_a_device_that_is_not_there_is_a_warning(logged):
    warning, line = logged("cuda")
    assert (warning["level"], warning["event"]) == ("warning", "device")
    assert "CUDA is selected" in warning["reason"] and line["device"] == "CPU"
