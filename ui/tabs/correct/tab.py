"""The dock's third tab: an annotator goes through the findings of a check, place by place, and marks what is done."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator

from qgis.core import (
    QgsFeature,
    QgsFeatureRequest,
    QgsMapLayerProxyModel,
    QgsProject,
    QgsVectorLayer,
)
from qgis.gui import QgsMapCanvas, QgsMapLayerComboBox
from qgis.PyQt.QtCore import Qt, QTimer, pyqtSignal
from qgis.PyQt.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QHeaderView,
    QLabel,
    QProgressBar,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ....core.annotation.findings import INFORMATION
from ....processing.compat import is_null
from ....processing.translation import tr
from ...canvas.place_mark import PlaceMark
from ...widgets.buttons import shortcut, tool_button
from ...widgets.layouts import narrow, row_of

DONE_PROPERTY = "semref/done"
"""Custom property of the layer, so that the project remembers what is done and the layer's own table stays as it is."""

_COLUMNS = (("kind", "annotated_class"), ("message", "predicted_class"), ("area",))
"""Fields that the list shows: of *Check annotation*'s issues, else of *Compare label maps*' disagreements."""

_SEVERITY = "severity"
"""Field of *Check annotation*'s issues."""

_LEAST_EXTENT_SHARE = 1e-4
"""Points and lines have no extent: this share of the layer's is added."""

_FILL_S = 0.03
"""The list is filled for so long at a time."""


class CorrectTab(QWidget):
    """``updateAsked`` comes with a layer of the places marked as done. ``shut_down`` before it is deleted."""

    updateAsked = pyqtSignal(object)

    def __init__(self, canvas: QgsMapCanvas, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._canvas = canvas
        self._done: set[int] = set()
        self._ids: set[int] = set()
        self._counted: set[int] = set()
        self._rows: Iterator[dict] = iter(())
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self._fill_on)
        self._layer: QgsVectorLayer | None = None
        self._mark = PlaceMark(canvas)
        self._lay_out()
        self._connect()
        self._use_layer()

    def _lay_out(self) -> None:
        self.layer = QgsMapLayerComboBox()
        self.layer.setFilters(QgsMapLayerProxyModel.Filter.PolygonLayer)
        self.layer.setAllowEmptyLayer(True, tr("Choose a layer of issues or disagreements"))
        self.layer.setToolTip(tr("The result of “Check annotation” or “Compare label maps”"))
        self.places = QTableWidget(0, len(_COLUMNS))
        self.places.setObjectName("SemRefPlaces")
        self.places.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.places.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.places.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.places.verticalHeader().hide()
        self.places.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 8)
        self.places.horizontalHeader().setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)
        self.places.setTabKeyNavigation(False)
        self.text = QLabel()
        self.text.setWordWrap(True)
        self.text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.before = tool_button("/mActionArrowLeft.svg", tr("Place before"))
        self.after = tool_button("/mActionArrowRight.svg", tr("Next place"))
        self.done = QPushButton(tr("Done, next"))
        self.done.setToolTip(tr("Marks the place as done and goes to the next one that is not (Ctrl+D)"))
        self.open = QCheckBox(tr("Only what is open"))
        self.mend = QCheckBox(tr("Without information"))
        self.mend.setToolTip(tr("Lists errors and warnings only: what has to be mended"))
        self.progress = QProgressBar()
        self.progress.setFormat(tr("%v of %m done"))
        self.update_button = QPushButton(tr("Update the database…"))
        self.update_button.setToolTip(tr("Opens “Update reference database” with the places that are done"))
        chosen = row_of(self.open, self.mend)
        chosen.addStretch()
        layout = narrow(QVBoxLayout(self), 0)
        layout.addWidget(self.layer)
        layout.addWidget(self.places, 1)
        layout.addWidget(self.text)
        layout.addLayout(row_of(self.before, self.after, (self.done, 1)))
        layout.addLayout(chosen)
        layout.addWidget(self.progress)
        layout.addWidget(self.update_button)

    def _connect(self) -> None:
        self.layer.layerChanged.connect(self._use_layer)
        self.places.itemSelectionChanged.connect(self._show_place)
        self.before.clicked.connect(lambda: self._step(-1))
        self.after.clicked.connect(lambda: self._step(1))
        self.done.clicked.connect(self._mark_done)
        shortcut("Ctrl+D", self).activated.connect(self._mark_done)
        self.open.toggled.connect(self._fill)
        self.mend.toggled.connect(self._fill)
        self.update_button.clicked.connect(self._ask_update)
        QgsProject.instance().layersWillBeRemoved.connect(self._leave_removed)

    def shut_down(self) -> None:
        """Stops filling the list and takes the mark off the canvas."""
        self._soon.stop()
        self._rows = iter(())
        QgsProject.instance().layersWillBeRemoved.disconnect(self._leave_removed)
        self.layer.layerChanged.disconnect(self._use_layer)
        self._mark.remove()

    # --- the layer ---

    def _use_layer(self) -> None:
        self._layer = self.layer.currentLayer()
        stored = "" if self._layer is None else self._layer.customProperty(DONE_PROPERTY, "")
        self._done = set(json.loads(stored)) if stored else set()
        self._fill()

    def _leave_removed(self, ids: list[str]) -> None:
        """Else the box would go on to some other layer, without telling."""
        if self._layer is not None and self._layer.id() in ids:
            self.layer.setLayer(None)

    def _fill(self) -> None:
        fields = [None] * len(_COLUMNS) if self._layer is None else _fields(self._layer)
        self.places.setHorizontalHeaderLabels([_title(name) for name in fields])
        self._rows = iter(()) if self._layer is None else _rows(self._layer, fields)
        self._ids, self._counted = set(), set()
        self.mend.setEnabled(self._layer is not None and _SEVERITY in self._layer.fields().names())
        self.places.setRowCount(0)
        self.progress.setRange(0, 1 if self._layer is None else max(self._layer.featureCount(), 1))
        self._show_progress()
        self._fill_on()
        self._show_place()

    def _fill_on(self) -> None:
        """A check of a large annotation has tens of thousands of findings: their rows come a few at a time, so that
        QGIS is never held up."""
        end = time.perf_counter() + _FILL_S
        for row in self._rows:
            self._ids.add(row["id"])
            if not (row["is_information"] and self.mend.isEnabled() and self.mend.isChecked()):
                self._counted.add(row["id"])
                if not (self.open.isChecked() and row["id"] in self._done):
                    self._add_row(row)
            if time.perf_counter() > end:
                self._soon.start(0)
                break
        else:
            self._soon.stop()
            self._done &= self._ids
            self.progress.setRange(0, max(len(self._counted), 1))
            self.progress.setTextVisible(bool(self._counted))
            self._show_progress()
            self.places.resizeColumnToContents(0)
            self.places.resizeColumnToContents(2)
            self._enable()

    def _add_row(self, row: dict) -> None:
        number = self.places.rowCount()
        self.places.setRowCount(number + 1)
        for column, text in enumerate(row["texts"]):
            item = QTableWidgetItem(text)
            item.setData(Qt.ItemDataRole.UserRole, row["id"])
            self.places.setItem(number, column, item)
        if row["id"] in self._done:
            self._show_done(number)

    def _id_of(self, row: int) -> int:
        return self.places.item(row, 0).data(Qt.ItemDataRole.UserRole)

    def _selected_row(self) -> int:
        rows = self.places.selectionModel().selectedRows()
        return rows[0].row() if rows else -1

    def _selected(self) -> QgsFeature | None:
        row = self._selected_row()
        if row < 0 or self._layer is None:
            return None
        feature = self._layer.getFeature(self._id_of(row))
        return feature if feature.isValid() else None

    # --- going through it ---

    def _step(self, step: int) -> None:
        if self.places.rowCount():
            self.places.selectRow((self._selected_row() + step) % self.places.rowCount())

    def _mark_done(self) -> None:
        row = self._selected_row()
        if row < 0:
            return
        self._done ^= {self._id_of(row)}
        self._layer.setCustomProperty(DONE_PROPERTY, json.dumps(sorted(self._done)))
        QgsProject.instance().setDirty()
        self._show_done(row)
        self._show_progress()
        if self._id_of(row) not in self._done:
            return
        order = [*range(row + 1, self.places.rowCount()), *range(row)]
        following = next((n for n in order if self._id_of(n) not in self._done), None)
        if following is not None:
            self.places.selectRow(following)

    def _show_done(self, row: int) -> None:
        done = self._id_of(row) in self._done
        for column in range(self.places.columnCount()):
            item = self.places.item(row, column)
            font = item.font()
            font.setStrikeOut(done)
            item.setFont(font)

    def _show_progress(self) -> None:
        self.progress.setValue(len(self._done & self._counted))
        self.update_button.setEnabled(bool(self._done))

    def _enable(self) -> None:
        for button in (self.before, self.after, self.done):
            button.setEnabled(self.places.rowCount() > 0)

    def _show_place(self) -> None:
        feature = self._selected()
        self._enable()
        self._mark.clear()
        if feature is None:
            self.text.setText("" if self.places.rowCount() else tr("No place to look at."))
            return
        self.text.setText(" · ".join(filter(None, _texts(feature, _fields(self._layer)))))
        self._mark.show(feature.geometry(), self._layer.crs())
        whole = self._layer.extent()
        self._mark.zoom(_LEAST_EXTENT_SHARE * max(whole.width(), whole.height()))

    def _ask_update(self) -> None:
        request = QgsFeatureRequest().setFilterFids(sorted(self._done))
        places = self._layer.materialize(request)
        places.setName(tr("Corrected places"))
        self.updateAsked.emit(places)


def _fields(layer: QgsVectorLayer) -> list[str | None]:
    """The field shown in each column; None where the layer has none of those."""
    names = set(layer.fields().names())
    return [next((name for name in choices if name in names), None) for choices in _COLUMNS]


def _title(field: str | None) -> str:
    titles = {
        "kind": tr("Kind"),
        "message": tr("Message"),
        "annotated_class": tr("Annotated"),
        "predicted_class": tr("Predicted"),
        "area": tr("Area"),
    }
    return titles.get(field, "")


def _texts(feature: QgsFeature, fields: list[str | None]) -> list[str]:
    values = [None if name is None else feature[name] for name in fields]
    return ["" if is_null(v) else f"{v:.1f}" if isinstance(v, float) else str(v) for v in values]


def _rows(layer: QgsVectorLayer, fields: list[str | None]) -> Iterator[dict]:
    has_severity = _SEVERITY in layer.fields().names()
    for feature in layer.getFeatures(QgsFeatureRequest().setFlags(QgsFeatureRequest.NoGeometry)):
        is_information = has_severity and feature[_SEVERITY] == INFORMATION
        yield {"id": feature.id(), "texts": _texts(feature, fields), "is_information": is_information}
