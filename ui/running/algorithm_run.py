"""One algorithm in the background, as signals."""

from __future__ import annotations

from qgis.core import (
    QgsApplication,
    QgsProcessingAlgRunnerTask,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProject,
    QgsTask,
)
from qgis.PyQt.QtCore import QObject, QTimer, pyqtSignal

from ...processing.translation import tr

UNLOAD_WAIT_MS = 2000
"""A cancel takes effect within a second; unloading waits no longer than this."""

BEGINS_WITHIN_MS = 3000
"""A task that QGIS has not begun by then, while none runs, will never begin."""

_BUG_REPORT_BEGINS = "Traceback"
"""How QGIS passes on a Python exception that is not meant for the user."""


class BeginWatch(QObject):
    """Watches over one task that was given to QGIS.

    QGIS takes a task that has ended out of its threads' queue by an address, at which a new one may wait by then: that
    one never begins (seen in 3.44, once in some hundred walks).

    lost: the task will never begin. Whoever hears it gives up the task and starts another.
    """

    lost = pyqtSignal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._task: QgsTask | None = None
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._look)

    def watch(self, task: QgsTask) -> None:
        """Watches over this task instead of the one before."""
        self._task = task
        self._timer.start(BEGINS_WITHIN_MS)

    def stop(self) -> None:
        """To be called before the task is deleted, that is when it ends."""
        self._task = None
        self._timer.stop()

    def _look(self) -> None:
        if self._task is None or self._task.status() != QgsTask.TaskStatus.Queued:
            return
        tasks = QgsApplication.taskManager().activeTasks()
        if any(task.status() == QgsTask.TaskStatus.Running for task in tasks):
            # It waits for its turn.
            self._timer.start(BEGINS_WITHIN_MS)
            return
        self.lost.emit()


class AlgorithmRun(QObject):
    """One run. After ``start`` returned True exactly one of ``done``, ``failed``, ``broke`` and ``canceled`` comes.

    said: what is being done; logged: detail for the log panel; done: the results (dict) and the context that holds
    layers in memory; failed: a sentence for the user; broke: a bug's traceback.
    """

    progressed = pyqtSignal(float)
    said = pyqtSignal(str)
    logged = pyqtSignal(str)
    done = pyqtSignal(object, object)
    failed = pyqtSignal(str)
    broke = pyqtSignal(str)
    canceled = pyqtSignal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._task: QgsProcessingAlgRunnerTask | None = None
        self._feedback: _Feedback | None = None
        self._context: QgsProcessingContext | None = None
        self._cancel_asked = False
        self._asked: tuple[str, dict, str] = ("", {}, "")
        self._watch = BeginWatch(self)
        self._watch.lost.connect(self._begin_anew)

    @property
    def running(self) -> bool:
        return self._task is not None

    @property
    def title(self) -> str:
        """What QGIS calls the task that was started last."""
        return self._asked[2]

    def start_algorithm(self, algorithm_id: str, parameters: dict, title: str) -> bool:
        """False when it can't even begin; then ``failed`` has said why."""
        algorithm = QgsApplication.processingRegistry().algorithmById(algorithm_id)
        if algorithm is None:
            self.failed.emit(tr("The Processing provider SemRef is switched off; switch it on in the options."))
            return False
        able, reason = algorithm.canExecute()
        if not able:
            self.failed.emit(reason)
            return False
        self._cancel_asked = False
        self._context = QgsProcessingContext()
        self._context.setTransformContext(QgsProject.instance().transformContext())
        self._feedback = _Feedback()
        self._feedback.said.connect(self.said)
        self._feedback.logged.connect(self.logged)
        self._feedback.progressChanged.connect(self.progressed)
        self._task = QgsProcessingAlgRunnerTask(algorithm, parameters, self._context, self._feedback, *_flags())
        self._task.setDescription(title)
        # The task uses both to its end, which may come after this object's.
        self._feedback.setParent(self._task)
        self._feedback.context = self._context
        if self._task.isCanceled():
            # It could not be prepared. Such a task never starts, and never says so.
            QTimer.singleShot(0, self._end_unprepared)
        else:
            self._task.executed.connect(self._finish)
            QgsApplication.taskManager().addTask(self._task)
            self._asked = algorithm_id, parameters, title
            self._watch.watch(self._task)
        return True

    def _begin_anew(self) -> None:
        """QGIS has lost the task."""
        if self._task is None or self._cancel_asked:
            return
        task, self._task = self._task, None
        task.executed.disconnect(self._finish)
        task.cancel()
        self.start_algorithm(*self._asked)

    def cancel(self) -> None:
        if self._task is not None:
            self._cancel_asked = True
            self._task.cancel()

    def abandon(self) -> None:
        """Cancels, says nothing more, and waits until no code of the plugin runs in the background any more."""
        if self._task is None:
            return
        self.blockSignals(True)
        self._watch.stop()
        task = self._task
        self.cancel()
        task.waitForFinished(UNLOAD_WAIT_MS)

    def _end_unprepared(self) -> None:
        if self._task is not None:
            self._finish(False, {})

    def _finish(self, succeeded: bool, results: dict) -> None:
        self._watch.stop()
        context, error = self._context, self._feedback.last_error
        self._task = self._feedback = self._context = None
        if self._cancel_asked:
            # Also where it had ended already: what follows a cancel, another project say, wants none of its results.
            self.canceled.emit()
        elif succeeded:
            self.done.emit(results, context)
        elif not error:
            # Canceled in QGIS's own list of tasks.
            self.canceled.emit()
        elif error.startswith(_BUG_REPORT_BEGINS):
            self.broke.emit(error)
        else:
            self.failed.emit(error)


def _flags() -> tuple:
    """QGIS reports canceled tasks as failed; from 3.26 a task can be silent."""
    silent = getattr(QgsTask.Flag, "Silent", None)
    return () if silent is None else (QgsTask.Flag.CanCancel | silent,)


class _Feedback(QgsProcessingFeedback):
    """Passes on what is being done; called in the worker thread, so it only emits and stores."""

    said = pyqtSignal(str)
    logged = pyqtSignal(str)
    shows_time_left = True  # The dock's bar does.

    def __init__(self) -> None:
        super().__init__(False)
        self.last_error = ""
        self.context = None

    def setProgressText(self, text):
        self.said.emit(text)

    def pushInfo(self, info):
        self.logged.emit(info)

    def pushWarning(self, warning):
        self.logged.emit(warning)

    def reportError(self, error, fatalError=False):
        # A bug's report is logged when the run ends.
        if not fatalError and not error.startswith(_BUG_REPORT_BEGINS):
            self.logged.emit(error)
        # What ends a run is reported last.
        self.last_error = error
