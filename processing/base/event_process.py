"""A process beside QGIS that reports its progress as lines of JSON, see ``core/events.py``."""

from __future__ import annotations

import contextlib
import json
import os
import signal
from collections.abc import Iterator
from pathlib import Path

from qgis.core import QgsProcessingFeedback
from qgis.PyQt.QtCore import QProcess, QProcessEnvironment

from ...core.sentences import Sentence
from .algorithm import check_canceled

PROGRAM = Path(__file__).resolve().parents[2] / "program.py"

_LOOKED_EVERY_MS, _KILLED_WITHIN_MS = 200, 5000
_LAST_LINES = 20
"""Number of other lines that are stored; the last ones show why the process ended."""

_LONGEST_LINE = 1 << 20


def python_environment() -> QProcessEnvironment:
    """Return QGIS's environment for a Python that writes UTF-8 and no compiled files."""
    environment = QProcessEnvironment.systemEnvironment()
    environment.insert("PYTHONIOENCODING", "utf-8")
    environment.insert("PYTHONDONTWRITEBYTECODE", "1")
    if os.name == "nt":
        environment.insert("PYTHONUTF8", "1")
    return environment


class EventProcess:
    """Read the events of a process, and store its other last lines."""

    def __init__(self, process: QProcess) -> None:
        self._process = process
        self._rest = b""
        self._said: list[str] = []

    @property
    def reason(self) -> str:
        """Last line that is not an event, as part of a sentence."""
        return self._said[-1].rstrip(".") if self._said else ""

    def read(self, feedback: QgsProcessingFeedback) -> Iterator[dict]:
        """Yield each event until the process ends. Raises Canceled.

        Other lines are ignored, because libraries print, too.
        """
        running = True
        while running:
            check_canceled(feedback)
            running = self._process.state() != QProcess.ProcessState.NotRunning
            if running:
                self._process.waitForReadyRead(_LOOKED_EVERY_MS)
            yield from self._events()

    def end(self, asked_ms: int = 0) -> None:
        """End the process, if it runs, and all processes that it and they started: on Unix, those of its group.

        Args:
            asked_ms: Time to end by itself and clean up; not on Windows.
        """
        if self._process.state() == QProcess.ProcessState.NotRunning:
            return
        if asked_ms and os.name != "nt":
            self._process.terminate()
            if self._process.waitForFinished(asked_ms):
                return
        if os.name == "nt":
            # Full path, because a program of that name in the current folder would be found first.
            taskkill = os.path.join(os.environ.get("SYSTEMROOT", "C:\\Windows"), "System32", "taskkill.exe")
            QProcess.execute(taskkill, ["/F", "/T", "/PID", str(self._process.processId())])
        elif group := self._process.processId():
            # 0, which would be QGIS's own group, if it ended meanwhile; no group yet if it has just been started.
            with contextlib.suppress(ProcessLookupError):
                os.killpg(group, signal.SIGKILL)
        self._process.kill()
        self._process.waitForFinished(_KILLED_WITHIN_MS)

    def _events(self) -> Iterator[dict]:
        errors = bytes(self._process.readAllStandardError()).decode("utf-8", "replace")
        self._said = [*self._said, *filter(None, map(str.strip, errors.splitlines()))][-_LAST_LINES:]
        *lines, rest = (self._rest + bytes(self._process.readAllStandardOutput())).split(b"\n")
        self._rest = rest[-_LONGEST_LINE:]
        yield from filter(None, map(_event, lines))


def _event(line: bytes) -> dict | None:
    """Return the event in a line; None for another line."""
    try:
        found = json.loads(line.decode("utf-8", "replace"))
    except (ValueError, RecursionError):
        return None
    return found if isinstance(found, dict) and "event" in found else None


def failure(event: dict) -> Sentence:
    return Sentence(event["template"], **event["values"])
