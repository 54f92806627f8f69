"""Run one algorithm in the background and report by signals."""

from __future__ import annotations

from functools import partial
from typing import Callable
from weakref import ref

from qgis.core import (
    QgsApplication,
    QgsProcessingAlgRunnerTask,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProject,
    QgsTask,
)
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject, QTimer, pyqtSignal

from ...processing.translation import tr
from ..widgets.messages import bug_sentence

UNLOAD_WAIT_MS = 2000
"""Longest wait when the plugin is unloaded. A cancel takes effect within a second."""

BEGINS_WITHIN_MS = 3000
"""QGIS never starts a task that is still queued after this time while no task runs."""

_BUG_REPORT_BEGINS = "Traceback"
"""Start of the text by which QGIS reports an unexpected Python exception."""


def begin(task: QgsTask, restart: Callable[[], None]) -> None:
    """Start a task in the background. Call ``restart`` if QGIS loses it.

    QGIS removes ended tasks from its queue by their address. A new task at the same address is removed as well and
    never starts (seen in 3.44, once in some hundred runs).
    """
    watched = ref(task)
    QgsApplication.taskManager().addTask(task)

    def look() -> None:
        left = watched()
        if left is None or sip.isdeleted(left) or left.status() != QgsTask.TaskStatus.Queued:
            return
        tasks = QgsApplication.taskManager().activeTasks()
        if any(other.status() == QgsTask.TaskStatus.Running for other in tasks):
            # The task waits for a running one.
            QTimer.singleShot(BEGINS_WITHIN_MS, look)
        else:
            restart()

    QTimer.singleShot(BEGINS_WITHIN_MS, look)


class AlgorithmRun(QObject):
    """One run. If it starts, it ends with exactly one of ``done``, ``failed`` and ``canceled``.

    textChanged: current step; logged: line for the log panel; done: results (dict), and the context with layers in
    memory; failed: a sentence for the user.
    """

    progressed = pyqtSignal(float)
    textChanged = pyqtSignal(str)
    logged = pyqtSignal(str)
    done = pyqtSignal(object, object)
    failed = pyqtSignal(str)
    canceled = pyqtSignal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._task: QgsProcessingAlgRunnerTask | None = None
        self._feedback: _Feedback | None = None
        self._context: QgsProcessingContext | None = None
        self._cancel_asked = False

    @property
    def running(self) -> bool:
        return self._task is not None

    def start_algorithm(self, algorithm_id: str, parameters: dict, title: str) -> bool:
        """Start a run. Returns False after emitting ``failed`` if it can't start."""
        algorithm = QgsApplication.processingRegistry().algorithmById(algorithm_id)
        if algorithm is None:
            self.failed.emit(
                tr(
                    "The Processing provider SemRef is not active. Activate it under Settings ▸ Options ▸ Processing "
                    "▸ Providers."
                )
            )
            return False
        able, reason = algorithm.canExecute()
        if not able:
            self.failed.emit(reason)
            return False
        self._cancel_asked = False
        self._context = QgsProcessingContext()
        self._context.setProject(QgsProject.instance())
        self._feedback = _Feedback()
        self._feedback.textChanged.connect(self.textChanged)
        self._feedback.logged.connect(self.logged)
        self._feedback.progressChanged.connect(self.progressed)
        self._task = QgsProcessingAlgRunnerTask(algorithm, parameters, self._context, self._feedback, *_flags())
        # Layers are found here, where the task is prepared. Its thread must not search a project that may change.
        self._context.setProject(None)
        self._task.setDescription(title)
        # The task uses both until it ends, possibly after this object is deleted.
        self._feedback.setParent(self._task)
        self._feedback.context = self._context
        if self._task.isCanceled():
            # Preparation failed. Such a task never starts and emits no signal.
            QTimer.singleShot(0, self._end_unprepared)
        else:
            self._task.executed.connect(self._finish)
            begin(self._task, partial(self._restart, algorithm_id, parameters, title))
        return True

    def _restart(self, *asked) -> None:
        """Start the run again, because QGIS lost its task."""
        self._task.executed.disconnect(self._finish)
        self._task.cancel()
        self.start_algorithm(*asked)

    def cancel(self) -> None:
        if self._task is not None:
            self._cancel_asked = True
            self._task.cancel()

    def shut_down(self) -> None:
        """Cancel without signals, and wait until the background thread has ended."""
        if self._task is None:
            return
        self.blockSignals(True)
        task = self._task
        self.cancel()
        task.waitForFinished(UNLOAD_WAIT_MS)

    def _end_unprepared(self) -> None:
        if self._task is not None:
            self._finish(False, {})

    def _finish(self, succeeded: bool, results: dict) -> None:
        context, error = self._context, self._feedback.last_error
        self._task = self._feedback = self._context = None
        if self._cancel_asked:
            # Also if the run has just succeeded: after a cancel its results are not wanted.
            self.canceled.emit()
        elif succeeded:
            self.done.emit(results, context)
        elif not error:
            # Canceled in QGIS's task manager.
            self.canceled.emit()
        elif error.startswith(_BUG_REPORT_BEGINS):
            self.failed.emit(bug_sentence(error))
        else:
            self.failed.emit(error)


def _flags() -> tuple:
    """Return flags that suppress QGIS's message about canceled tasks, which exist from QGIS 3.26 on."""
    silent = getattr(QgsTask.Flag, "Silent", None)
    return () if silent is None else (QgsTask.Flag.CanCancel | silent,)


class _Feedback(QgsProcessingFeedback):
    """Forwards messages. QGIS calls it in the worker thread, so it only emits signals and stores texts."""

    textChanged = pyqtSignal(str)
    logged = pyqtSignal(str)

    def __init__(self) -> None:
        super().__init__(False)
        self.last_error = ""
        self.context = None

    def setProgressText(self, text):
        self.textChanged.emit(text)

    def pushInfo(self, info):
        self.logged.emit(info)

    def pushWarning(self, warning):
        self.logged.emit(warning)

    def reportError(self, error, fatalError=False):
        # Bug reports are logged when the run ends.
        if not fatalError and not error.startswith(_BUG_REPORT_BEGINS):
            self.logged.emit(error)
        # The last reported error is the one that ended the run.
        self.last_error = error
