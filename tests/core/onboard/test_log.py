"""The log of the command line: one JSON object per line; it names the device of the network."""

from __future__ import annotations

import json
import logging
from datetime import datetime

import pytest
from made_models import NAMES, write_model

from semref.core.labels.class_table import class_table_from_csv
from semref.core.onboard.image_records import label_reader
from semref.core.onboard.log import json_line, log_event, start_log


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


def test_the_traceback_of_an_error_is_optional(lines):
    written = lines("info")
    try:
        raise ValueError("no such thing")
    except ValueError:
        log_event(logging.ERROR, "bug", traceback=True)
    (line,) = written()
    assert line["traceback"].endswith("ValueError: no such thing")


def test_a_name_that_is_no_utf8_comes_back_as_the_system_has_it():
    text = json_line({"path": "a\udcff.png", "class": "forêt"})
    assert text.encode("utf-8") and "forêt" in text
    assert json.loads(text)["path"] == "a\udcff.png"


# --- the device of the network ---


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
