"""Button that repairs the land-cover layer with *Repair land-cover layer*, as one undo step."""

from __future__ import annotations

from collections import Counter
from typing import Callable

from qgis.core import QgsProcessingContext, QgsProject
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtWidgets import QMessageBox, QPushButton

from ....core.errors import ParameterError
from ....processing.inspection.repair import REPAIRABLE, apply_repair
from ....processing.messages.annotation_messages import kind_titles
from ....processing.messages.sentences import worded
from ....processing.translation import tr
from ...running.algorithm_run import AlgorithmRun
from ...running.correction_run import Correction
from ...widgets.controls import number_text
from ...widgets.messages import Messages

REPAIR = "semref:repairannotation"


class RepairButton(QPushButton):
    """Button to repair all places.

    textChanged: progress or result in words; repaired: the layer, which has one more undo step.
    """

    textChanged = pyqtSignal(str)
    repaired = pyqtSignal(object)

    def __init__(self, messages: Messages, annotation: Callable[[], Correction | None]) -> None:
        """``annotation`` returns what to repair; None if nothing is chosen."""
        super().__init__()
        self._messages, self._annotation = messages, annotation
        self._kinds: Counter = Counter()
        self._layer_id = ""
        self._is_edited = False
        self.run = AlgorithmRun(self)
        self.run.done.connect(self._apply)
        working = tr("Repairing: {percent} %")
        self.run.progressed.connect(lambda percent: self.textChanged.emit(working.format(percent=int(percent))))
        for ended in (self.run.failed, self.run.canceled):
            ended.connect(self._show)
        self.run.failed.connect(messages.error)
        self.run.canceled.connect(lambda: self.textChanged.emit(tr("Canceled.")))
        self.clicked.connect(self._press)
        self.setToolTip(tr("Repair everything that “Repair land-cover layer” can repair. You can undo this."))
        self.show_kinds(Counter())

    def show_kinds(self, kinds: Counter) -> None:
        """Show how many open places can be repaired. ``kinds``: number of open places by kind."""
        self._kinds = Counter({kind: kinds[kind] for kind in REPAIRABLE if kinds[kind]})
        self._show()

    def _show(self, *_) -> None:
        count = sum(self._kinds.values())
        if self.run.running:
            self.setText(tr("Cancel"))
        elif count:
            self.setText(tr("Repair all ({count})…").format(count=number_text(count)))
        else:
            self.setText(tr("Repair all…"))
        self.setEnabled(self.run.running or bool(count))

    def _press(self) -> None:
        if self.run.running:
            self.run.cancel()
            return
        wanted = self._annotation()
        if wanted is None:
            sentence = tr("Choose the land-cover layer and its class field below, under “Update the database”.")
            self._messages.error(sentence)
            return
        if QMessageBox.question(self.window(), tr("Repair all"), self._question(wanted)) != _YES:
            return
        self._layer_id, self._is_edited = wanted.annotation.id(), False
        wanted.annotation.layerModified.connect(self._note_edit)
        parameters = {**wanted.parameters, "OUTPUT": "memory:", "CHANGES": "memory:"}
        self.run.start_algorithm(REPAIR, parameters, tr("Repairing the land-cover layer"))
        self._show()

    def _question(self, wanted: Correction) -> str:
        titles = kind_titles()
        kinds = ", ".join(f"{titles[kind]}: {number_text(count)}" for kind, count in self._kinds.items())
        return tr(
            "Repair {count} places in “{layer}” ({kinds})? SemRef also merges touching polygons of the same "
            "class. It does not save the edits, so you can undo them."
        ).format(count=number_text(sum(self._kinds.values())), layer=wanted.annotation.name(), kinds=kinds)

    def _note_edit(self) -> None:
        self._is_edited = True

    def _apply(self, results: dict, context: QgsProcessingContext) -> None:
        self._show()
        project = QgsProject.instance()
        layer = project.mapLayer(self._layer_id)
        if layer is None:
            self.textChanged.emit(tr("Canceled."))
            return
        if self._is_edited:
            # The repaired copy lacks these edits, and would undo them.
            sentence = tr("“{layer}” was edited during the repair, so nothing was repaired. Repair it again.")
            self.textChanged.emit(sentence.format(layer=layer.name()))
            return
        repaired, changes = (context.takeResultLayer(results[key]) for key in ("OUTPUT", "CHANGES"))
        try:
            done = apply_repair(layer, repaired, changes, project.transformContext(), tr("Repair all"))
        except ParameterError as error:
            self._messages.error(worded(error))
            return
        self.repaired.emit(layer)
        self.textChanged.emit(
            tr(
                "Repaired “{layer}”: {changed} polygons changed, {added} added, {removed} removed. Save the layer’s "
                "edits to keep the repair, or undo it (Ctrl+Z). Check the layer again to find what is left."
            ).format(layer=layer.name(), **{name: number_text(count) for name, count in done._asdict().items()})
        )


_YES = QMessageBox.StandardButton.Yes
