"""Box to update the database from the corrected land-cover layer, and to undo that."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import Callable

from qgis.core import QgsMapLayer, QgsMapLayerProxyModel, QgsProject, QgsVectorLayer
from qgis.gui import QgsFieldComboBox, QgsMapLayerComboBox
from qgis.PyQt.QtWidgets import QFormLayout, QPushButton, QWidget

from ....processing.layers.database_layers import database_file, reload_database
from ....processing.layers.guess_fields import class_field_of, class_of_all, priority_field_of
from ....processing.translation import tr
from ....storage.database.undo import can_undo, file_before, undo_update
from ...layer_files import label_maps_of, layer_file
from ...running.background import Reader
from ...running.correction_run import RASTERIZE, Correction, CorrectionRun
from ...widgets.controls import ClassNameBox, open_algorithm, plain_tip
from ...widgets.database_box import DatabaseBox
from ...widgets.layouts import FoldingBox, narrow
from ...widgets.messages import Messages
from ...widgets.progress import RemainingBar, StatusLine
from .places_table import is_places

SCOPE = "SemRef"
_ANNOTATION_ENTRY = "/annotation"
_VALUE_ENTRIES = ("/class_field", "/priority_field", "/class")


class UpdateBox(FoldingBox):
    """Updates the chosen database from a land-cover layer."""

    def __init__(self, database: DatabaseBox, messages: Messages, places: Callable[[], QgsVectorLayer | None]) -> None:
        """``places`` returns the layer of corrected places; None without one."""
        super().__init__(tr("Update the database"), "SemRefUpdate")
        self._database, self._messages, self._places = database, messages, places
        self._undone = ""
        self.run = CorrectionRun(self)
        self._undoing = Reader(self)
        self.rasterizing: QWidget | None = None
        self.annotation = QgsMapLayerComboBox()
        self.annotation.setFilters(QgsMapLayerProxyModel.Filter.PolygonLayer)
        self.annotation.setAllowEmptyLayer(True, tr("Choose the corrected layer"))
        self.class_field, self.priority_field = QgsFieldComboBox(), QgsFieldComboBox()
        self.class_of_all = ClassNameBox()
        for box in (self.class_field, self.priority_field):
            box.setAllowEmptyFieldName(True)
        self.button = QPushButton()
        self.progress = RemainingBar()
        self.state = StatusLine()
        self.undo = QPushButton(tr("Undo the last update"))
        layout = narrow(QFormLayout(self.content), 0)
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
        self._connect()
        self.list_layers(QgsProject.instance().mapLayers().values())
        self._show_running()

    def _connect(self) -> None:
        self.annotation.layerChanged.connect(self._use_annotation)
        self.class_field.fieldChanged.connect(self._show_ready)
        self.class_of_all.currentTextChanged.connect(self._show_ready)
        self.button.clicked.connect(self._press)
        self.undo.clicked.connect(self._undo_update)
        self._database.changed.connect(self._show_ready)
        self.run.textChanged.connect(self.state.show_text)
        self.run.progressed.connect(self.progress.show_percent)
        self.run.done.connect(self._show_updated)
        self.run.canceled.connect(lambda: self._show_end(tr("Canceled.")))
        self._undoing.answered.connect(lambda _: self._show_undone())
        for part in (self.run, self._undoing):
            part.failed.connect(lambda _: self._show_end(""))
            part.failed.connect(self._messages.error)

    def correction(self) -> Correction | None:
        """Return the choices; None without a layer, or without its class field or class."""
        layer, of_all = self.annotation.currentLayer(), self.class_of_all.class_name()
        fields = self.class_field.currentField(), self.priority_field.currentField()
        if layer is None or not (of_all or fields[0]):
            return None
        return Correction(self._database.path(), layer, *fields, of_all, self._places())

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

    def _show_running(self) -> None:
        running = self.run.running
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
        self._show_ready()

    def _show_end(self, text: str) -> None:
        self.state.show_text(text)
        self._show_running()

    def _show_ready(self, *_) -> None:
        running, database = self.run.running, self._database.path()
        self.class_field.setEnabled(not running and not self.class_of_all.class_name())
        self.button.setEnabled(running or bool(database and self.correction()))
        if not running and not database:
            self.state.show_text(tr("Choose a database."))
        elif self.state.text_shown == tr("Choose a database."):
            self.state.show_text("")
        possible = not running and can_undo(database)
        self.undo.setVisible(possible)
        if possible:
            self.undo.setToolTip(plain_tip(tr("Restore the database from {file}").format(file=file_before(database))))

    def _press(self) -> None:
        if self.run.running:
            self.button.setEnabled(False)
            self.state.show_text(tr("Canceling…"))
            self.run.cancel()
            return
        wanted, project = self.correction(), QgsProject.instance()
        values = wanted.class_field, wanted.priority_field, wanted.class_of_all
        for entry, value in zip((_ANNOTATION_ENTRY, *_VALUE_ENTRIES), (wanted.annotation.id(), *values)):
            project.writeEntry(SCOPE, entry, value)
        self.run.start(wanted)
        self._show_running()

    # --- after an update ---

    def _show_updated(self, path: str) -> None:
        self._show_end(tr("The database is up to date. The previous file is kept next to it."))
        self._reload(path)
        grid = self.run.rasterizing
        if QgsProject.instance().mapLayer(grid["INPUT"]) is None:
            return
        for layer in label_maps_of(QgsProject.instance(), grid["EXTENT"], grid["PIXEL_SIZE"])[:1]:
            # The file belongs to the user, so only the user replaces it.
            again = {**grid, "OUTPUT": layer_file(layer)}
            sentence = tr("The label map “{layer}” is now older than the database.").format(layer=layer.name())
            self._messages.success_with(sentence, tr("Rasterize it again…"), partial(self._rasterize, again))

    def _reload(self, path: str) -> None:
        reload_database(path, QgsProject.instance())
        if path == self._database.path():
            self._database.choose(path)

    def _rasterize(self, parameters: dict) -> None:
        self.rasterizing = open_algorithm(RASTERIZE, parameters)

    def _undo_update(self) -> None:
        self._undone = self._database.path()
        self._undoing.read(tr("Undoing the update"), undo_update, self._undone)

    def _show_undone(self) -> None:
        self._show_end(tr("The last update of the database is undone."))
        self._reload(self._undone)

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
