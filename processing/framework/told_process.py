"""A process beside QGIS that tells by lines of JSON on its output what it does."""

from __future__ import annotations

import json
from collections.abc import Iterator

from qgis.core import QgsProcessingFeedback
from qgis.PyQt.QtCore import QProcess

from .base import check_canceled

_LOOKED_EVERY_MS = 200
_LAST_LINES = 20
"""Of what it says beside events; the last of them tell why it ended."""


class ToldProcess:
    """What a process prints: events on its output, and the last words beside them."""

    def __init__(self, process: QProcess) -> None:
        self._process = process
        self._rest = b""
        self._said: list[str] = []

    @property
    def reason(self) -> str:
        """Its last words, as part of a sentence."""
        return self._said[-1].rstrip(".") if self._said else ""

    def read(self, feedback: QgsProcessingFeedback) -> Iterator[dict]:
        """Every event until the process ends; raises Canceled when the user canceled."""
        running = True
        while running:
            check_canceled(feedback)
            running = self._process.state() != QProcess.ProcessState.NotRunning
            if running:
                self._process.waitForReadyRead(_LOOKED_EVERY_MS)
            yield from self._events()

    def _events(self) -> Iterator[dict]:
        errors = bytes(self._process.readAllStandardError()).decode("utf-8", "replace")
        self._said = [*self._said, *filter(None, map(str.strip, errors.splitlines()))][-_LAST_LINES:]
        *lines, self._rest = (self._rest + bytes(self._process.readAllStandardOutput())).split(b"\n")
        for line in lines:
            event = _event(line)
            if event is not None:
                yield event


def _event(line: bytes) -> dict | None:
    """What a line tells; None for one that is no event: libraries print, too."""
    try:
        found = json.loads(line.decode("utf-8", "replace"))
    except ValueError:
        return None
    return found if isinstance(found, dict) and isinstance(found.get("event"), str) else None
