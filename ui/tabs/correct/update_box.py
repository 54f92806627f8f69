"""Box to update the database from the corrected land-cover layer, and to undo that."""

from __future__ import annotations

from collections.abc import Iterable

from qgis.core import QgsMapLayer, QgsMapLayerProxyModel, QgsProject, QgsVectorLayer
from qgis.gui import QgsCollapsibleGroupBox, QgsFieldComboBox, QgsMapLayerComboBox
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtWidgets import QFormLayout, QPushButton

from ....processing.layers.database_layers import database_file
from ....processing.layers.guess_fields import class_field_of, class_of_all, priority_field_of
from ....processing.translation import tr
from ....storage.database.undo import can_undo, file_before
from ...fields.class_name_box import ClassNameBox
from ...running.correction_run import Correction
from ...widgets.layouts import content_of, name_fold, narrow
from ...widgets.progress import RemainingBar, StatusLine
from ...widgets.texts import plain_tip
from .places_table import is_places

SCOPE = "SemRef"
_ANNOTATION_ENTRY = "/annotation"
_VALUE_ENTRIES = ("/class_field", "/priority_field", "/class")


class UpdateBox(QgsCollapsibleGroupBox):
    """startAsked: a Correction without places; cancelAsked: during an update; undoAsked: path of the database."""

    startAsked = pyqtSignal(object)
    cancelAsked = pyqtSignal()
    undoAsked = pyqtSignal(str)

    def __init__(self) -> None:
        super().__init__(tr("Update the database"))
        self.setObjectName("SemRefUpdate")
        self._database = ""
        self._running = False
        self.annotation = QgsMapLayerComboBox()
        self.annotation.setFilters(QgsMapLayerProxyModel.Filter.PolygonLayer)
        self.annotation.setAllowEmptyLayer(True, tr("Choose the corrected land-cover layer"))
        self.class_field, self.priority_field = QgsFieldComboBox(), QgsFieldComboBox()
        self.class_of_all = ClassNameBox()
        for box in (self.class_field, self.priority_field):
            box.setAllowEmptyFieldName(True)
        self.button = QPushButton()
        self.progress = RemainingBar()
        self.state = StatusLine()
        self.undo = QPushButton(tr("Undo the last update"))
        layout = narrow(QFormLayout(content_of(self)), 0)
        layout.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapLongRows)
        layout.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        for title, widget in (
            (tr("Land-cover layer"), self.annotation),
            (tr("Class field"), self.class_field),
            (tr("All polygons are"), self.class_of_all),
            (tr("Priority field"), self.priority_field),
        ):
            widget.setMinimumWidth(1)
            widget.setAccessibleName(title)
            layout.addRow(title, widget)
        for widget in (self.button, self.progress, self.state, self.undo):
            layout.addRow(widget)
        name_fold(self)
        self._connect()
        self.list_layers(QgsProject.instance().mapLayers().values())
        self.show_running(False)

    def _connect(self) -> None:
        self.annotation.layerChanged.connect(self._use_annotation)
        self.class_field.fieldChanged.connect(self._show_ready)
        self.class_of_all.currentTextChanged.connect(self._show_ready)
        self.button.clicked.connect(self._press)
        self.undo.clicked.connect(lambda: self.undoAsked.emit(self._database))

    def use_database(self, path: str) -> None:
        """Set the database that is updated."""
        self._database = path
        self._show_ready()

    def correction(self) -> Correction | None:
        """Return the choices; None without a layer, or without its class field or class."""
        layer, of_all = self.annotation.currentLayer(), self.class_of_all.class_name()
        fields = self.class_field.currentField(), self.priority_field.currentField()
        has_classes = bool(of_all or fields[0])
        return Correction(self._database, layer, *fields, of_all) if layer is not None and has_classes else None

    def leave_out(self, layers: Iterable[QgsMapLayer]) -> None:
        """Hide places and database layers among ``layers``, all layers of the project."""
        self.annotation.setExceptedLayerList([layer for layer in layers if is_places(layer) or database_file(layer)])

    def list_layers(self, layers: Iterable[QgsMapLayer]) -> None:
        """List land-cover layers, and choose one."""
        self.leave_out(layers)
        if self.annotation.currentLayer() is None:
            self._choose_annotation()
        # The combo box changes its layer without a signal when the current one is hidden.
        if self.annotation.currentLayer() is not self.class_field.layer():
            self._use_annotation(self.annotation.currentLayer())

    def show_running(self, running: bool, text: str = "") -> None:
        """Show whether an update is running, and ``text`` about it."""
        self._running = running
        for part in (self.annotation, self.class_of_all, self.priority_field):
            part.setEnabled(not running)
        self.progress.setVisible(running)
        self.progress.begin()
        self.button.setText(tr("Cancel") if running else tr("Rasterize and update the database"))
        self.button.setToolTip(
            tr(
                "Rasterize the land-cover layer on the grid of the database, and update the database. The "
                "previous file is kept."
            )
        )
        self.state.show_text(text)
        self._show_ready()

    def _show_ready(self, *_) -> None:
        self.class_field.setEnabled(not self._running and not self.class_of_all.class_name())
        ready = bool(self._database and self.correction())
        self.button.setEnabled(self._running or ready)
        if not self._running and not self._database:
            self.state.show_text(tr("Choose a database."))
        elif self.state.text_shown == tr("Choose a database."):
            self.state.show_text("")
        possible = not self._running and can_undo(self._database)
        self.undo.setVisible(possible)
        if possible:
            self.undo.setToolTip(
                plain_tip(tr("Restore the database from {file}").format(file=file_before(self._database)))
            )

    def _press(self) -> None:
        if self._running:
            self.button.setEnabled(False)
            self.state.show_text(tr("Canceling…"))
            self.cancelAsked.emit()
            return
        wanted, project = self.correction(), QgsProject.instance()
        values = wanted.class_field, wanted.priority_field, wanted.class_of_all
        for entry, value in zip((_ANNOTATION_ENTRY, *_VALUE_ENTRIES), (wanted.annotation.id(), *values)):
            project.writeEntry(SCOPE, entry, value)
        self.startAsked.emit(wanted)

    # --- guesses that the user can change ---

    def _choose_annotation(self) -> None:
        project = QgsProject.instance()
        remembered = project.mapLayer(project.readEntry(SCOPE, _ANNOTATION_ENTRY)[0])
        offered = [self.annotation.layer(row) for row in range(self.annotation.count())]
        likely = [layer for layer in offered if layer is not None and (class_field_of(layer) or class_of_all(layer))]
        if remembered is not None or likely:
            self.annotation.setLayer(remembered or likely[0])

    def _use_annotation(self, layer: QgsVectorLayer | None) -> None:
        for box in (self.class_field, self.priority_field):
            box.setLayer(layer)
        if layer is not None:
            project = QgsProject.instance()
            is_remembered = project.readEntry(SCOPE, _ANNOTATION_ENTRY)[0] == layer.id()
            entries = [project.readEntry(SCOPE, entry)[0] for entry in _VALUE_ENTRIES]
            guesses = class_field_of(layer), priority_field_of(layer), class_of_all(layer)
            class_field, priority_field, of_all = entries if is_remembered else guesses
            self.class_field.setField(class_field)
            self.priority_field.setField(priority_field)
            self.class_of_all.setCurrentText(of_all)
        self._show_ready()
