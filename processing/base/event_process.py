"""A process beside QGIS that reports what it does as lines of JSON on its output."""

from __future__ import annotations

import contextlib
import json
import os
import signal
from collections.abc import Iterator, Mapping
from pathlib import Path

from qgis.core import QgsProcessingFeedback
from qgis.PyQt.QtCore import QProcess, QProcessEnvironment

from ...core.sentences import Sentence
from .algorithm import check_canceled

FAILED = {"template": str, "values": dict}
"""Values of the event “failed” of any process."""

_LOOKED_EVERY_MS, _KILLED_WITHIN_MS = 200, 5000
_LAST_LINES = 20
"""Other lines that are kept; the last ones show why the process ended."""

_LONGEST_LINE = 1 << 20
_LARGEST_NUMBER = 1e15


def python_environment() -> QProcessEnvironment:
    """QGIS's own environment for a Python that writes UTF-8 and leaves no compiled files."""
    environment = QProcessEnvironment.systemEnvironment()
    environment.insert("PYTHONIOENCODING", "utf-8")
    environment.insert("PYTHONDONTWRITEBYTECODE", "1")
    if os.name == "nt":
        environment.insert("PYTHONUTF8", "1")
    return environment


class EventProcess:
    """Read the events of a process, and keep its other last lines."""

    def __init__(self, process: QProcess, events: Mapping[str, Mapping[str, type]]) -> None:
        """Nothing is read yet.

        Args:
            process: Was started.
            events: Names of its events, with the types of the values that are used; ``float`` is any finite number.
        """
        self._process, self._known = process, events
        self._rest = b""
        self._said: list[str] = []

    @property
    def reason(self) -> str:
        """Its last line that is no event, as part of a sentence."""
        return self._said[-1].rstrip(".") if self._said else ""

    def read(self, feedback: QgsProcessingFeedback) -> Iterator[dict]:
        """Every event until the process ends; raises Canceled when the user canceled.

        Lines that are no such events are ignored: libraries print, too.
        """
        running = True
        while running:
            check_canceled(feedback)
            running = self._process.state() != QProcess.ProcessState.NotRunning
            if running:
                self._process.waitForReadyRead(_LOOKED_EVERY_MS)
            yield from self._events()

    def end(self, asked_ms: int = 0) -> None:
        """Ends the process, if it runs, and all processes that it and they started.

        Args:
            asked_ms: How long it may take to end by itself and clear up; systems that can't ask it give it no time.
        """
        if self._process.state() == QProcess.ProcessState.NotRunning:
            return
        if asked_ms and os.name != "nt":
            self._process.terminate()
            if self._process.waitForFinished(asked_ms):
                return
        if os.name == "nt":
            # By its whole path: a program of that name in the current folder would come first.
            taskkill = os.path.join(os.environ.get("SYSTEMROOT", "C:\\Windows"), "System32", "taskkill.exe")
            QProcess.execute(taskkill, ["/F", "/T", "/PID", str(self._process.processId())])
        else:
            _kill(self._process.processId())
        self._process.kill()
        self._process.waitForFinished(_KILLED_WITHIN_MS)

    def _events(self) -> Iterator[dict]:
        errors = bytes(self._process.readAllStandardError()).decode("utf-8", "replace")
        self._said = [*self._said, *filter(None, map(str.strip, errors.splitlines()))][-_LAST_LINES:]
        *lines, rest = (self._rest + bytes(self._process.readAllStandardOutput())).split(b"\n")
        self._rest = rest[-_LONGEST_LINE:]
        for line in lines:
            event = self._event(line)
            if event is not None:
                yield event

    def _event(self, line: bytes) -> dict | None:
        try:
            found = json.loads(line.decode("utf-8", "replace"))
        except (ValueError, RecursionError):
            return None
        name = found.get("event") if isinstance(found, dict) else None
        if not isinstance(name, str) or name not in self._known:
            return None
        is_whole = all(_is(found.get(key), kind) for key, kind in self._known[name].items())
        return found if is_whole else None


def failure(event: dict) -> Sentence:
    """What an event “failed” says."""
    said = Sentence(event["template"], **event["values"])
    try:
        str(said)
    except (KeyError, IndexError, AttributeError, ValueError, TypeError):
        # A library that prints such an event, too.
        return Sentence("{reason}", reason=event["template"])
    return said


def _is(value: object, kind: type) -> bool:
    if kind is float:
        # Neither infinite nor NaN.
        return isinstance(value, (int, float)) and abs(value) <= _LARGEST_NUMBER
    return isinstance(value, kind)


def _kill(root: int) -> None:
    """Kills a process and its descendants: stopped first, so that none starts others meanwhile."""
    stopped: set[int] = set()
    while new := _descendants(root) - stopped:
        _send(new, signal.SIGSTOP)
        stopped |= new
    _send(stopped, signal.SIGKILL)


def _send(processes: set[int], number: signal.Signals) -> None:
    for process in processes:
        # Those that have ended since, or run as another user.
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.kill(process, number)


def _descendants(root: int) -> set[int]:
    """A process and all those that it and they started."""
    parents, found = _parents(), [root]
    for process in found:
        found += [child for child, parent in parents.items() if parent == process]
    return set(found)


def _parents() -> dict[int, int]:
    """The parent of each process of the machine: of Linux's /proc, elsewhere as ``ps`` lists them."""
    if os.path.isdir("/proc/self"):
        parents = {}
        for file in Path("/proc").glob("[0-9]*/stat"):
            with contextlib.suppress(OSError):
                # The name before may have spaces and brackets.
                parents[int(file.parent.name)] = int(file.read_bytes().rpartition(b")")[2].split()[1])
        return parents
    listing = QProcess()
    listing.start("ps", ["-A", "-o", "pid=,ppid="])
    listing.waitForFinished(_KILLED_WITHIN_MS)
    rows = (line.split() for line in bytes(listing.readAllStandardOutput()).splitlines())
    return {int(row[0]): int(row[1]) for row in rows if len(row) == 2}
