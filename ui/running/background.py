"""Run functions in the background; the main thread only starts them and takes the results."""

from __future__ import annotations

import os
import traceback
from functools import lru_cache
from typing import TYPE_CHECKING, Callable

from qgis.core import QgsApplication, QgsTask
from qgis.PyQt.QtCore import QObject, QThreadPool, QTimer, pyqtSignal

from ...core.errors import SemRefError
from ...processing.messages.sentences import worded
from ..widgets.messages import bug_sentence
from .algorithm_run import UNLOAD_WAIT_MS, begin

if TYPE_CHECKING:
    from ...core.database.model import ReferenceDatabase


def shut_down(whole: QObject) -> None:
    """End what the parts of an object do outside of it. Call it before the object is deleted.

    Timers stop. Background work, map tools and marks on the canvas have a method ``shut_down``.
    """
    for timer in whole.findChildren(QTimer):
        timer.stop()
    for part in whole.findChildren(QObject):
        if hasattr(part, "shut_down"):
            part.shut_down()


def keep_threads() -> None:
    """Let QGIS's threads wait for a task without end, instead of 30 s.

    When a thread ends, QGIS loses the definitions of all CRS that this thread used first, also for the main thread: a
    CRS stays valid, but its WKT is empty, and transforms return the coordinates unchanged (seen in 3.22).
    """
    task_threads().setExpiryTimeout(-1)


def task_threads() -> QThreadPool:
    """Return the threads that run QGIS's tasks."""
    manager = QgsApplication.taskManager()
    return manager.threadPool() if hasattr(manager, "threadPool") else QThreadPool.globalInstance()


def end_idle_threads() -> None:
    """End QGIS's threads that wait for a task; has no effect while a task runs.

    QGIS 3.40.6 dies when it quits if a thread opened the authentication database, as QGIS's news do, ended after 30 s
    without a task, and was started again for one, possibly ours (fixed in github.com/qgis/QGIS/pull/62429).
    """
    manager = QgsApplication.taskManager()
    if hasattr(manager, "threadPool"):  # not in QGIS 3.22
        manager.threadPool().waitForDone(0)


class Reader(QObject):
    """Runs one function at a time. A new one discards the result of the previous one and waits until that has ended.

    Thus, stepping through hundreds of images with a key held down reads two of them.

    answered: result of the function; failed: a sentence for the user.
    """

    answered = pyqtSignal(object)
    failed = pyqtSignal(str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._task: _Task | None = None
        self._asked: tuple | None = None
        """Request of the running task; None if its result is not wanted anymore."""
        self._next: tuple | None = None

    def read(self, title: str, function: Callable, *arguments) -> None:
        self._asked, self._next = None, (title, function, arguments)
        if self._task is None:
            self._start()

    def forget(self) -> None:
        """Discard the result of the running function."""
        self._asked = self._next = None

    def shut_down(self) -> None:
        """Discard the result, and wait until the background thread has ended."""
        self.forget()
        task = self._give_up()
        if task is not None:
            task.waitForFinished(UNLOAD_WAIT_MS)

    def _start(self) -> None:
        self._asked, self._next = self._next, None
        self._task = _Task(*self._asked)
        self._task.done.connect(self._take)
        begin(self._task, self._restart)

    def _give_up(self) -> _Task | None:
        task, self._task = self._task, None
        if task is not None:
            task.done.disconnect(self._take)
            task.cancel()
        return task

    def _restart(self) -> None:
        """Start again with the latest request, because QGIS lost the task."""
        self._give_up()
        self._next = self._next or self._asked
        if self._next is not None:
            self._start()

    def _take(self) -> None:
        task, self._task = self._task, None
        # Its arguments may keep files open.
        is_wanted, self._asked = self._asked is not None, None
        if self._next is not None:
            self._start()
        elif is_wanted and task.sentence:
            self.failed.emit(task.sentence)
        elif is_wanted:
            self.answered.emit(task.answer)


class _Task(QgsTask):
    """Emits ``done`` in the main thread, also after a cancel in QGIS's task manager."""

    done = pyqtSignal()

    def __init__(self, title: str, function: Callable, arguments: tuple) -> None:
        # QGIS does not ask about these tasks when it quits.
        super().__init__(title, QgsTask.Flag.CanCancel | QgsTask.Flag.CancelWithoutPrompt | _hidden())
        self._function, self._arguments = function, arguments
        self.answer = None
        self.sentence = ""

    def run(self):
        try:
            self.answer = self._function(*self._arguments)
        except SemRefError as error:
            self.sentence = worded(error)
        except Exception:
            self.sentence = bug_sentence(traceback.format_exc())
        return True

    def finished(self, result):
        # QGIS calls this in the main thread.
        self.done.emit()


def _hidden():
    """Return the flag that hides short tasks from the status bar, which exists from QGIS 3.26 on."""
    return getattr(QgsTask.Flag, "Hidden", QgsTask.Flag.CanCancel)


def latest_database(path: str) -> ReferenceDatabase:
    """Return a database, which is read again only if its file has changed. For background threads.

    Raises DatabaseError.
    """
    return _read(path, changed_at(path))


@lru_cache(maxsize=1)
def _read(path: str, _changed: float | None) -> ReferenceDatabase:
    # Imported here because it loads NumPy and GDAL, which would delay the start of QGIS.
    from ...storage.database.reader import read_database

    return read_database(path)


def changed_at(path: str) -> float | None:
    """Return the time of the last change of a file; None if it does not exist."""
    return os.path.getmtime(path) if os.path.exists(path) else None
