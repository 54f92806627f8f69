"""The log of ``semref``: one JSON object in each line, on stderr."""

from __future__ import annotations

import json
import logging
import sys
from datetime import datetime, timezone
from typing import Any

_LOG = logging.getLogger("semref")


def start_log(level: str) -> None:
    """Send the log to stderr, from a level on: debug, info, warning or error."""
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(_JsonLines())
    _LOG.handlers = [handler]
    _LOG.setLevel(level.upper())


def log_event(level: int, event: str, traceback: bool = False, **details: object) -> None:
    """Write one line.

    Args:
        level: Of the module ``logging``.
        traceback: Whether to add the traceback of the current error.
        **details: Further values of the line.
    """
    _LOG.log(level, event, extra={"details": details}, exc_info=traceback)


def json_line(found: dict[str, Any]) -> str:
    r"""Return one JSON object in UTF-8, without line end.

    Bytes of a file name that are not UTF-8 become JSON escapes of lone surrogates (``\udcff``): Python's ``json``
    restores the name as ``os`` has it.
    """
    return json.dumps(found, ensure_ascii=False).encode("utf-8", "backslashreplace").decode("utf-8")


class _JsonLines(logging.Formatter):
    def format(self, entry: logging.LogRecord) -> str:
        """Return one JSON object: time, level, event and its details."""
        moment = datetime.fromtimestamp(entry.created, timezone.utc).isoformat(timespec="milliseconds")
        found = {"time": moment, "level": entry.levelname.lower(), "event": entry.getMessage()}
        if entry.exc_info and entry.exc_info[0]:
            found["traceback"] = self.formatException(entry.exc_info)
        return json_line({**found, **getattr(entry, "details", {})})
