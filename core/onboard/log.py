"""The log of ``semref``: one JSON object a line, on stderr."""

from __future__ import annotations

import json
import logging
import sys
from datetime import datetime, timezone
from typing import Any

_LOG = logging.getLogger("semref")


def start_log(level: str) -> None:
    """Sends the log to stderr, from a level on: debug, info, warning or error."""
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(_JsonLines())
    _LOG.handlers = [handler]
    _LOG.setLevel(level.upper())


def log_event(level: int, event: str, traceback: bool = False, **details: object) -> None:
    """Writes one line.

    Args:
        level: Of the module ``logging``.
        event: What happened, in a word.
        traceback: Whether that of the error being handled is told.
        **details: What the line tells beside.
    """
    _LOG.log(level, event, extra={"details": details}, exc_info=traceback)


def json_line(found: dict[str, Any]) -> str:
    r"""One JSON object in UTF-8, without the end of the line.

    Bytes of a file's name that are no UTF-8 are told as JSON's escapes of lone surrogates (``\udcff``): Python's
    ``json`` gives the name back as ``os`` has it.
    """
    return json.dumps(found, ensure_ascii=False).encode("utf-8", "backslashreplace").decode("utf-8")


class _JsonLines(logging.Formatter):
    def format(self, entry: logging.LogRecord) -> str:
        """One JSON object: time, level, event and its details."""
        moment = datetime.fromtimestamp(entry.created, timezone.utc).isoformat(timespec="milliseconds")
        found = {"time": moment, "level": entry.levelname.lower(), "event": entry.getMessage()}
        if entry.exc_info and entry.exc_info[0]:
            found["traceback"] = self.formatException(entry.exc_info)
        return json_line({**found, **getattr(entry, "details", {})})
