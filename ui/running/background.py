"""Reading in the background: the main thread only starts it and takes the answer."""

from __future__ import annotations

import os
import traceback
from typing import TYPE_CHECKING, Callable

from qgis.core import QgsApplication, QgsTask
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...core.errors import SemRefError
from ...processing.messages.sentences import worded
from .algorithm_run import UNLOAD_WAIT_MS, BeginWatch

if TYPE_CHECKING:
    from ...core.database.model import ReferenceDatabase


class Reader(QObject):
    """One reading at a time; a new one makes the answer of the one before unwanted, and waits until that has ended.

    So whoever goes through hundreds of images with a key held down has two of them read, not hundreds at a time.
    ``shut_down`` before it is deleted.

    answered: what the function returned; failed: a sentence for the user; broke: a bug's traceback.
    """

    answered = pyqtSignal(object)
    failed = pyqtSignal(str)
    broke = pyqtSignal(str)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._task: _Task | None = None
        self._asked: tuple | None = None
        self._next: tuple | None = None
        self._is_wanted = False
        self._watch = BeginWatch(self)
        self._watch.lost.connect(self._begin_anew)

    @property
    def reading(self) -> bool:
        """Whether an answer is to come."""
        return self._is_wanted or self._next is not None

    def read(self, title: str, function: Callable, *arguments) -> None:
        self._next = title, function, arguments
        self._is_wanted = False
        if self._task is None:
            self._start()

    def forget(self) -> None:
        """The answer of what runs is not wanted any more."""
        self._next = None
        self._is_wanted = False

    def shut_down(self) -> None:
        """Forgets, and waits until no code of the plugin runs in the background any more."""
        self.forget()
        task = self._given_up()
        if task is not None:
            task.waitForFinished(UNLOAD_WAIT_MS)

    def _start(self) -> None:
        self._asked, self._next = self._next, None
        self._is_wanted = True
        self._task = _Task(*self._asked)
        self._task.done.connect(self._take)
        QgsApplication.taskManager().addTask(self._task)
        self._watch.watch(self._task)

    def _given_up(self) -> _Task | None:
        """The task, which says nothing any more."""
        self._watch.stop()
        task, self._task = self._task, None
        if task is not None:
            task.done.disconnect(self._take)
            task.cancel()
        return task

    def _begin_anew(self) -> None:
        """QGIS has lost the task; what is wanted by now is read instead."""
        self._given_up()
        if self._next is None and self._is_wanted:
            self._next = self._asked
        if self._next is not None:
            self._start()

    def _take(self) -> None:
        self._watch.stop()
        task, self._task = self._task, None
        if self._next is not None:
            self._start()
            return
        is_wanted, self._is_wanted = self._is_wanted, False
        if not is_wanted:
            return
        if task.sentence:
            self.failed.emit(task.sentence)
        elif task.report:
            self.broke.emit(task.report)
        else:
            self.answered.emit(task.answer)


class _Task(QgsTask):
    """``done`` comes in the main thread, also of one that was canceled in QGIS's own list of tasks."""

    done = pyqtSignal()

    def __init__(self, title: str, function: Callable, arguments: tuple) -> None:
        # Whoever quits QGIS is not asked about them.
        super().__init__(title, QgsTask.Flag.CanCancel | QgsTask.Flag.CancelWithoutPrompt | _hidden())
        self._function, self._arguments = function, arguments
        self.answer = None
        self.sentence = self.report = ""

    def run(self):
        try:
            self.answer = self._function(*self._arguments)
        except SemRefError as error:
            self.sentence = worded(error)
        except Exception:
            self.report = traceback.format_exc()
        return True

    def finished(self, result):
        # In the main thread.
        self.done.emit()


def _hidden():
    """Reading a picture is no task worth a line in the status bar; QGIS can hide it from 3.26."""
    return getattr(QgsTask.Flag, "Hidden", QgsTask.Flag.CanCancel)


class DatabaseShelf:
    """The database read last; read again when its file has changed. For background threads."""

    def __init__(self) -> None:
        self._held: tuple = (None, None)

    def read(self, path: str) -> ReferenceDatabase:
        """Raises DatabaseError."""
        key = path, os.path.getmtime(path) if os.path.exists(path) else None
        known, database = self._held
        if key != known:
            # Not at the top: reading brings numpy and GDAL, and QGIS shall start at once.
            from ...storage.database.reader import read_database

            database = read_database(path)
            # One assignment: another thread sees the old pair or the new one.
            self._held = key, database
        return database
