"""Work in a forked child that may be killed at a chosen moment: a warm QGIS costs nothing to start again."""

from __future__ import annotations

import contextlib
import json
import os
import resource
import signal
import sys
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

LONGEST_S = 120.0
"""Who takes longer hangs."""

_LOOK_EVERY_S, _LOOK_CLOSELY_EVERY_S = 0.004, 0.0005
"""How often it is looked whether a child has ended, and whether the moment of its kill has come."""

_EVENTS = ("open", "os.rename", "os.link", "os.remove", "os.rmdir", "os.mkdir", "os.truncate", "sqlite3.connect")
"""Python's audit events of what is done to files."""


@dataclass(frozen=True)
class Kill:
    """The moment of a kill.

    Attributes:
        touch: Before the how manieth thing that Python does to a file of the folder.
        byte: Where a file grows past that size: in the midst of a write, GDAL's and SQLite's as well.
        after_s: So long after the first unfinished output appears.
    """

    touch: int | None = None
    byte: int | None = None
    after_s: float | None = None


@dataclass(frozen=True)
class Ending:
    """How a child ended.

    Attributes:
        how: “done”, “refused” (an error that a user is told), “fault” (any other error), “killed” or “hangs”.
        text: What was said.
        told: What the work returned.
        touches: Things done to files.
        seconds: From the start, and from the first unfinished output, to the end.
    """

    how: str
    text: str = ""
    told: Any = None
    touches: int = 0
    seconds: tuple[float, float] = field(default=(0.0, 0.0))


def run(work: Callable[[], Any], folder: Path, kill: Kill | None = None, largest: int | None = None) -> Ending:
    """Runs ``work`` in a child and waits for it.

    Args:
        work: What it does; what it returns must be JSON.
        folder: Where it writes.
        kill: When it is killed.
        largest: Bytes after which the system refuses to let a file grow.
    """
    return wait(*start(work, folder, kill, largest), folder, kill)


def start(
    work: Callable[[], Any], folder: Path, kill: Kill | None = None, largest: int | None = None
) -> tuple[int, int]:
    """Starts a child; gives its id and the pipe that it answers through."""
    answer, send = os.pipe()
    sys.stdout.flush()
    child = os.fork()
    if child:
        os.close(send)
        return child, answer
    os.close(answer)
    with contextlib.suppress(BaseException):
        _work(work, folder, kill, largest, send)
    os._exit(0)


def wait(child: int, answer: int, folder: Path, kill: Kill | None = None) -> Ending:
    """Waits for a child, killing it when it is time."""
    started, appeared, text = time.monotonic(), None, b""
    os.set_blocking(answer, False)
    hangs = False
    while True:
        with contextlib.suppress(BlockingIOError):
            text += os.read(answer, 1 << 20)
        done, status = os.waitpid(child, os.WNOHANG)
        now = time.monotonic()
        if done:
            break
        if appeared is None and _has_unfinished(folder):
            appeared = now
        if kill and kill.after_s is not None and appeared is not None and now - appeared >= kill.after_s:
            os.kill(child, signal.SIGKILL)
        if now - started > LONGEST_S:
            hangs = True
            os.kill(child, signal.SIGKILL)
        time.sleep(_LOOK_CLOSELY_EVERY_S if kill and kill.after_s is not None else _LOOK_EVERY_S)
    with contextlib.suppress(BlockingIOError):
        text += os.read(answer, 1 << 24)
    os.close(answer)
    seconds = now - started, now - (appeared or now)
    if os.WIFSIGNALED(status):
        number = os.WTERMSIG(status)
        wanted = number in (signal.SIGKILL, signal.SIGXFSZ)
        return Ending("hangs" if hangs else "killed" if wanted else "fault", f"signal {number}", seconds=seconds)
    said = json.loads(text or b'{"how": "fault", "text": "no answer"}')
    return Ending(said["how"], said["text"], said.get("told"), said.get("touches", 0), seconds)


def _has_unfinished(folder: Path) -> bool:
    try:
        return any(name.endswith((".part", ".lines")) for name in os.listdir(folder))
    except OSError:
        return False


def _work(work: Callable[[], Any], folder: Path, kill: Kill | None, largest: int | None, send: int) -> None:
    _silence()
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if kill and kill.byte is not None:
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
        resource.setrlimit(resource.RLIMIT_FSIZE, (kill.byte, kill.byte))
    if largest is not None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (largest, largest))
    touches = _Touches(str(folder), kill.touch if kill else None)
    sys.addaudithook(touches)
    try:
        said = {"how": "done", "text": "", "told": work()}
    except BaseException as error:
        refused = any(kind.__name__ in ("QgsProcessingException", "SemRefError") for kind in type(error).__mro__)
        said = {"how": "refused" if refused else "fault", "text": str(error) if refused else traceback.format_exc()}
    os.write(send, json.dumps({**said, "touches": touches.count}).encode())


def _silence() -> None:
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    os.dup2(nowhere, 2)


class _Touches:
    """Counts what is done to files of a folder, and dies at one of these moments."""

    def __init__(self, folder: str, last: int | None) -> None:
        self.count, self._folder, self._last = 0, folder, last

    def __call__(self, event: str, arguments: tuple) -> None:
        if event in _EVENTS and self._folder in str(arguments[0]):
            if self.count == self._last:
                os.kill(os.getpid(), signal.SIGKILL)
            self.count += 1
