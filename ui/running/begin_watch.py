"""Tasks that QGIS never begins."""

from __future__ import annotations

from qgis.core import QgsApplication, QgsTask
from qgis.PyQt.QtCore import QObject, QTimer, pyqtSignal

BEGINS_WITHIN_MS = 3000
"""A task that QGIS has not begun by then, while none runs, will never begin."""


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
