"""Tab *Correct*: go through the places that a check found, and update the database."""

from __future__ import annotations

import json
import time
from collections import Counter
from collections.abc import Iterator

from qgis.core import QgsFeature, QgsMapLayerProxyModel, QgsProject, QgsVectorLayer
from qgis.gui import QgsMapCanvas, QgsMapLayerComboBox
from qgis.PyQt.QtCore import QTimer
from qgis.PyQt.QtWidgets import QCheckBox, QProgressBar, QPushButton, QVBoxLayout, QWidget

from ....core.annotation.findings import INFORMATION
from ....processing.inspection.repair import REPAIRABLE
from ....processing.translation import tr
from ...canvas.marks import PlaceMark
from ...widgets.controls import ChoiceBox, message_label, number_text, remember, shortcut, tool_button
from ...widgets.database_box import DatabaseBox
from ...widgets.layouts import narrow, row_of
from ...widgets.messages import Messages
from .places_table import PlaceRow, PlacesTable, has_severity, is_places, place_text, places_of
from .repair_button import RepairButton
from .update_box import UpdateBox

DONE_PROPERTY = "semref/done"
"""Custom property of the layer: the project stores which places are done; the layer's table does not change."""

OPEN_SETTING, PROBLEMS_SETTING = "semref/correct/only_open", "semref/correct/only_to_mend"

_LEAST_EXTENT_SHARE = 1e-4
"""Share of the layer's extent that is added to a place, because points and lines have no extent."""

_FILL_S = 0.03
"""Longest time to fill the list without a break."""


class CorrectTab(QWidget):
    """Goes through the places of a layer, repairs them, and updates the database."""

    def __init__(self, canvas: QgsMapCanvas, database: DatabaseBox, messages: Messages) -> None:
        super().__init__()
        self._done: set[int] = set()
        self._kinds: dict[int, tuple[str, str]] = {}
        self._report = ""
        self._repaired: tuple[int, set[int]] | None = None
        self._counted: set[int] = set()
        self._rows: Iterator[PlaceRow] = iter(())
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self._fill_on)
        self._layer: QgsVectorLayer | None = None
        self._mark = PlaceMark(canvas, self)
        self.updating = UpdateBox(database, messages, lambda: self._layer)
        self.repair = RepairButton(messages, self.updating.correction)
        self._lay_out()
        self._connect()
        self._list_layers()
        self._use_layer()

    def _lay_out(self) -> None:
        self.layer = QgsMapLayerComboBox()
        self.layer.setFilters(QgsMapLayerProxyModel.Filter.PolygonLayer)
        self.layer.setAllowEmptyLayer(True, tr("Choose a layer of issues or disagreements"))
        self.layer.setToolTip(tr("The result of “Check land-cover layer” or “Compare label maps”"))
        self.layer.setAccessibleName(tr("Layer of places to check"))
        self.layer.setMinimumWidth(1)
        self.places = PlacesTable()
        self.kind = ChoiceBox()
        self.kind.setAccessibleName(tr("Kind"))
        self.kind.setToolTip(tr("Show places of one kind only"))
        self.repair.setMinimumWidth(1)
        self.text = message_label()
        self.before = tool_button("/mActionArrowLeft.svg", tr("Previous place"))
        self.after = tool_button("/mActionArrowRight.svg", tr("Next place"))
        self.done = QPushButton(tr("Done, next"))
        self.done.setToolTip(tr("Mark the place as done and go to the next open place (Ctrl+D)"))
        self.open = QCheckBox(tr("Only open places"))
        remember(self.open, OPEN_SETTING, True)
        self.problems = QCheckBox(tr("Only errors and warnings"))
        self.problems.setToolTip(tr("Hide places that are only for information"))
        remember(self.problems, PROBLEMS_SETTING, False)
        self.progress = QProgressBar()
        self.progress.setFormat(tr("%v of %m done"))
        layout = narrow(QVBoxLayout(self), 0)
        layout.addWidget(self.layer)
        layout.addLayout(row_of((self.kind, 1), (self.repair, 1)))
        layout.addWidget(self.places, 1)
        layout.addWidget(self.text)
        layout.addLayout(row_of(self.before, self.after, (self.done, 1)))
        for widget in (self.open, self.problems, self.progress, self.updating):
            layout.addWidget(widget)

    def _connect(self) -> None:
        self.layer.layerChanged.connect(self._use_layer)
        self.places.itemSelectionChanged.connect(self._show_place)
        self.kind.activated.connect(self._fill)
        self.repair.textChanged.connect(self._show_report)
        self.repair.repaired.connect(self._mark_repaired)
        self.before.clicked.connect(lambda: self._step(-1))
        self.after.clicked.connect(lambda: self._step(1))
        self.done.clicked.connect(self._mark_done)
        shortcut("Ctrl+D", self).activated.connect(self._mark_done)
        self.open.toggled.connect(self._fill)
        self.problems.toggled.connect(self._fill)
        project = QgsProject.instance()
        project.layersWillBeRemoved.connect(self._leave_removed)
        project.layersAdded.connect(self._take_added)

    def shut_down(self) -> None:
        """Ignore changes of the project, whose layers may be removed before this tab is deleted."""
        project = QgsProject.instance()
        project.layersWillBeRemoved.disconnect(self._leave_removed)
        project.layersAdded.disconnect(self._take_added)
        self.layer.layerChanged.disconnect(self._use_layer)

    # --- the layer ---

    def _use_layer(self) -> None:
        # A repair is of the places that are listed.
        self.repair.run.cancel()
        self._layer = self.layer.currentLayer()
        stored = "" if self._layer is None else self._layer.customProperty(DONE_PROPERTY, "")
        self._done = set(json.loads(stored)) if stored else set()
        self._report, self._repaired = "", None
        self.kind.clear()
        self._fill()

    def _take_added(self, layers: list) -> None:
        """List new layers as soon as they are complete, and choose new places if no layer is chosen."""
        QTimer.singleShot(0, self._list_layers)
        found = [layer for layer in layers if is_places(layer)]
        if found and self._layer is None:
            self.layer.setLayer(found[-1])

    def _list_layers(self) -> None:
        layers = list(QgsProject.instance().mapLayers().values())
        self._leave_out(layers)
        self.updating.list_layers(layers)

    def _leave_out(self, layers: list) -> None:
        self.layer.setExceptedLayerList([layer for layer in layers if not is_places(layer)])

    def _leave_removed(self, ids: list[str]) -> None:
        """Clear the box if its layer is removed; it would silently choose another one."""
        if self._layer is not None and self._layer.id() in ids:
            self.layer.setLayer(None)
        # The box compares addresses: a new layer at the address of a deleted one would be hidden.
        left = [layer for layer in QgsProject.instance().mapLayers().values() if layer.id() not in ids]
        self._leave_out(left)
        self.updating.leave_out(left)

    def _fill(self, *_) -> None:
        self.places.show_titles(self._layer)
        self._rows = iter(()) if self._layer is None else places_of(self._layer)
        self._counted, self._kinds = set(), {}
        self.problems.setEnabled(self._layer is not None and has_severity(self._layer))
        self.places.setRowCount(0)
        self.progress.setRange(0, 1 if self._layer is None else max(self._layer.featureCount(), 1))
        self._show_progress()
        self._fill_on()
        self._show_place()

    def _fill_on(self) -> None:
        """Add rows for a short time, then continue later: a check may have tens of thousands of places."""
        end = time.perf_counter() + _FILL_S
        for place in self._rows:
            self._kinds[place.id] = place.kind, place.kind_title
            if self.kind.currentData() not in (None, "", place.kind):
                continue
            if not (place.severity == INFORMATION and self.problems.isEnabled() and self.problems.isChecked()):
                self._counted.add(place.id)
                if not (self.open.isChecked() and place.id in self._done):
                    self.places.strike_out(self.places.add(place), place.id in self._done)
            if time.perf_counter() > end:
                self._soon.start(0)
                break
        else:
            self._soon.stop()
            self._done &= self._kinds.keys()
            self.progress.setRange(0, max(len(self._counted), 1))
            self.progress.setVisible(bool(self._counted))
            self._show_progress()
            self.places.fit_columns()
            self._list_kinds()
            self._show_repairable()
            self._show_place()

    def _list_kinds(self) -> None:
        chosen, counts = self.kind.currentData(), Counter(self._kinds.values())
        self.kind.clear()
        self.kind.addItem(tr("All kinds ({count})").format(count=number_text(len(self._kinds))), "")
        for (kind, title), count in counts.most_common():
            self.kind.addItem(f"{title} ({number_text(count)})", kind)
        self.kind.setCurrentIndex(max(0, self.kind.findData(chosen)))
        self.kind.setEnabled(len(counts) > 1)

    def _show_repairable(self) -> None:
        self.repair.show_kinds(Counter(kind for place, (kind, _) in self._kinds.items() if place not in self._done))

    def _selected(self) -> QgsFeature | None:
        row = self.places.selected_row()
        if row < 0 or self._layer is None:
            return None
        feature = self._layer.getFeature(self.places.id_of(row))
        return feature if feature.isValid() else None

    # --- going through the places ---

    def _step(self, step: int) -> None:
        if self.places.rowCount():
            self.places.selectRow((self.places.selected_row() + step) % self.places.rowCount())

    def _mark_done(self) -> None:
        row = self.places.selected_row()
        if row < 0:
            return
        place = self.places.id_of(row)
        self._done ^= {place}
        self._store_done()
        if place in self._done and self.open.isChecked():
            self.places.removeRow(row)
            self.places.selectRow(row if row < self.places.rowCount() else 0)
            self._show_place()
            return
        self.places.strike_out(row, place in self._done)
        if place in self._done:
            order = [*range(row + 1, self.places.rowCount()), *range(row)]
            following = next((n for n in order if self.places.id_of(n) not in self._done), None)
            if following is not None:
                self.places.selectRow(following)

    def _store_done(self) -> None:
        self._layer.setCustomProperty(DONE_PROPERTY, json.dumps(sorted(self._done)))
        QgsProject.instance().setDirty()
        self._show_progress()
        self._show_repairable()

    def _show_progress(self) -> None:
        self.progress.setValue(len(self._done & self._counted))

    def _show_place(self) -> None:
        feature = self._selected()
        for button in (self.before, self.after):
            button.setEnabled(self.places.rowCount() > 0)
        self.done.setEnabled(feature is not None)
        self._mark.clear()
        if feature is None:
            self.text.setText(self._what_is_left())
            return
        self.text.setText(place_text(feature, self._layer))
        self._report = ""
        self._mark.show(feature.geometry(), self._layer.crs())
        whole = self._layer.extent()
        self._mark.zoom(_LEAST_EXTENT_SHARE * max(whole.width(), whole.height()))

    def _show_report(self, sentence: str) -> None:
        """Show progress or result of a repair until a place is selected."""
        self._report = sentence
        self.text.setText(sentence)

    def _mark_repaired(self, annotation: QgsVectorLayer) -> None:
        """Mark repaired places as done; undoing the repair before the edits are saved unmarks them."""
        places = {place for place, (kind, _) in self._kinds.items() if kind in REPAIRABLE} - self._done
        self._repaired = annotation.undoStack().index(), places
        annotation.undoStack().indexChanged.connect(self._follow_undo)
        annotation.beforeCommitChanges.connect(self._forget_repair)
        self._follow_undo(annotation.undoStack().index())

    def _follow_undo(self, step: int) -> None:
        if self._repaired is not None:
            repaired_step, places = self._repaired
            self._done = self._done | places if step >= repaired_step else self._done - places
            self._report = self._report if step >= repaired_step else ""
            self._store_done()
            self._fill()

    def _forget_repair(self, *_) -> None:
        self._repaired = None

    def _what_is_left(self) -> str:
        if self._report:
            return self._report
        if self.places.rowCount() or self._layer is None:
            return ""
        return tr("All places are done.") if self._counted else tr("There is no place to check.")
