"""The log of the command line: one JSON object per line."""

from __future__ import annotations

import json
import logging
from datetime import datetime

import pytest

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
