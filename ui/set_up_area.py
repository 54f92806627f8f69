"""Dialog *Set up an area*: asks for photos, map, imagery and folder, shows the derived sizes, and runs everything."""

from __future__ import annotations

import os
from collections.abc import Sequence

from qgis.core import (
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProject,
    QgsProviderRegistry,
    QgsSettings,
    QgsVectorLayer,
)
from qgis.gui import QgsFileWidget, QgsProcessingMapLayerComboBox
from qgis.PyQt.QtCore import QEvent, QSize, Qt, QTimer, pyqtSignal
from qgis.PyQt.QtWidgets import (
    QCheckBox,
    QDialog,
    QDoubleSpinBox,
    QFileDialog,
    QFormLayout,
    QFrame,
    QProgressBar,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from ..core.errors import SemRefError
from ..processing.algorithms.classify_openstreetmap import POLYGONS_OF_OSM
from ..processing.algorithms.set_up_area import SetUpArea, layer_of_extract
from ..processing.base.values import Values
from ..processing.layers.database_layers import add_database_to_map, database_layers, place_on_top
from ..processing.messages.sentences import worded
from ..processing.translation import tr
from .layer_files import photo_layer
from .proposals import annotation_at_hand
from .running.algorithm_run import AlgorithmRun
from .running.background import Reader, shut_down
from .running.localization_run import named_results
from .widgets.controls import message_label
from .widgets.layouts import row_of
from .widgets.messages import open_guide
from .widgets.progress import StatusLine

ALGORITHM = "semref:setuparea"
GUIDE = "tutorials/own_area_and_photos.md"
_FOLDER_SETTING = "semref/area_folder"
_WAIT_MS = 400
"""Pause after a change before the map is read again."""

_WIDTH_PX = 560


class SetUpAreaDialog(QDialog):
    """Not modal; a run continues when it is closed. ``shut_down`` deletes it.

    finished_with: results of the algorithm, and the parameters of the run.
    """

    finished_with = pyqtSignal(dict, dict)

    def __init__(self, model: str, parent: QWidget | None = None) -> None:
        """Make the dialog; ``model``: path of the dock's model, empty for the one of SemRef."""
        super().__init__(parent)
        self.setObjectName("SemRefSetUpArea")
        self.setWindowTitle(tr("Set up an area"))
        # It owns the definitions that the widgets use.
        self._asked = _algorithm()
        self._definition = self._asked.parameterDefinition
        self.photos = _files(QgsFileWidget.StorageMode.GetDirectory)
        self.add_files = QPushButton(tr("Add files…"))
        self.width_m = _number(tr("from the camera or the imagery"), 1, 10)
        self.flight = QCheckBox(self._definition(SetUpArea.FLIGHT).description())
        self.map = QgsProcessingMapLayerComboBox(self._definition(SetUpArea.ANNOTATION))
        self.lines = QgsProcessingMapLayerComboBox(self._definition(SetUpArea.LINES))
        self.imagery = QgsProcessingMapLayerComboBox(self._definition(SetUpArea.IMAGERY))
        # QGIS selects the first layer, also of an optional parameter.
        self.lines.setValue(None, QgsProcessingContext())
        self.minutes = _number(tr("0, use the model as it is"), 0, 5)
        self.model = _files(QgsFileWidget.StorageMode.GetFile)
        self.model.setFilter(tr("ONNX models (*.onnx)"))
        self.model.lineEdit().setPlaceholderText(tr("the model of SemRef"))
        self.model.setFilePath(model if os.path.isfile(model) else "")
        self.folder = _files(QgsFileWidget.StorageMode.GetDirectory)
        self._inputs, self.summary = QWidget(), message_label()
        # Without the remaining time: the steps take very different times.
        self.progress, self.state = QProgressBar(), StatusLine()
        self.start, self.close_button = QPushButton(tr("Run")), QPushButton(tr("Close"))
        self.help = QPushButton(tr("Help"))
        self._run, self._reader, self._soon = AlgorithmRun(self), Reader(self), QTimer(self)
        self._feedback, self._context = QgsProcessingFeedback(False), QgsProcessingContext()
        self._used: dict = {}
        self._seen: Sequence[str] = ()
        self._is_other_project = True
        self._lay_out()
        self.resize(self.sizeHint().expandedTo(QSize(_WIDTH_PX, 0)))
        self._connect()
        self._read_soon()

    def _lay_out(self) -> None:
        form = QFormLayout(self._inputs)
        form.setContentsMargins(0, 0, 0, 0)
        for key, widget in (
            (SetUpArea.PHOTOS, self.photos),
            (SetUpArea.PHOTO_WIDTH, self.width_m),
            (SetUpArea.FLIGHT, self.flight),
            (SetUpArea.ANNOTATION, self.map),
            (SetUpArea.LINES, self.lines),
            (SetUpArea.IMAGERY, self.imagery),
            (SetUpArea.MINUTES, self.minutes),
            (SetUpArea.MODEL, self.model),
            (SetUpArea.FOLDER, self.folder),
        ):
            definition = self._definition(key)
            widget.setToolTip(definition.help())
            widget.setAccessibleName(definition.description())
            row = row_of((widget, 1), self.add_files) if widget is self.photos else widget
            form.addRow("" if widget is self.flight else definition.description(), row)
        self.summary.setAlignment(Qt.AlignmentFlag.AlignTop)
        # Without it, a long summary would squeeze the fields on a small screen.
        scrolled = QScrollArea()
        scrolled.setAccessibleName(tr("What SemRef will do"))
        scrolled.setFrameShape(QFrame.Shape.NoFrame)
        scrolled.setWidgetResizable(True)
        scrolled.setMinimumHeight(5 * self.fontMetrics().height())
        scrolled.setWidget(self.summary)
        self._inputs.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self.progress.setVisible(False)
        self.start.setDefault(True)
        layout = QVBoxLayout(self)
        layout.addWidget(self._inputs)
        layout.addWidget(scrolled, 1)
        for widget in (self.progress, self.state):
            layout.addWidget(widget)
        layout.addLayout(row_of(self.help, (QWidget(), 1), self.start, self.close_button))

    def _connect(self) -> None:
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self._read)
        for widget in (self.photos, self.model, self.folder):
            widget.fileChanged.connect(self._read_soon)
        for widget in (self.map, self.lines, self.imagery, self.width_m, self.minutes):
            widget.valueChanged.connect(self._read_soon)
        self._reader.answered.connect(self._show_area)
        self._reader.failed.connect(self.summary.setText)
        self._run.failed.connect(self._show_fault)
        self._run.progressed.connect(lambda percent: self.progress.setValue(round(percent)))
        self._run.textChanged.connect(self.state.show_text)
        self._run.done.connect(self._finish)
        self._run.canceled.connect(lambda: self._show_fault(tr("Canceled. Press “Run” to continue.")))
        self.add_files.clicked.connect(self._choose_photos)
        self.start.clicked.connect(self._start_or_cancel)
        self.close_button.clicked.connect(self.hide)
        self.help.clicked.connect(lambda: open_guide(page=GUIDE))
        QgsProject.instance().cleared.connect(self._leave_project)

    def shut_down(self) -> None:
        """Cancel what runs, and delete the dialog."""
        self._feedback.cancel()
        shut_down(self)
        self.deleteLater()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        # The user may have installed or selected elsewhere what was missing.
        if event.type() == QEvent.Type.ActivationChange and self.isActiveWindow() and not self.start.isEnabled():
            self._read_soon()

    def choose_layers(self) -> None:
        """Choose map and imagery of a project in which the dialog is new."""
        if self._run.running or not self._is_other_project:
            return
        self._is_other_project = False
        self.imagery.setLayer(photo_layer(QgsProject.instance()))
        annotation = annotation_at_hand(QgsProject.instance()).get("INPUT")
        if annotation is not None:
            self.map.setLayer(QgsProject.instance().mapLayer(annotation))

    def parameters(self) -> dict:
        photos = QgsFileWidget.splitFilePaths(self.photos.filePath().strip())
        return {
            SetUpArea.PHOTOS: [path for path in photos if path],
            SetUpArea.PHOTO_WIDTH: self.width_m.value() or None,
            SetUpArea.FLIGHT: self.flight.isChecked(),
            SetUpArea.ANNOTATION: self.map.value(),
            SetUpArea.LINES: self.lines.value(),
            SetUpArea.IMAGERY: self.imagery.value(),
            SetUpArea.MINUTES: self.minutes.value(),
            SetUpArea.MODEL: self.model.filePath().strip(),
            SetUpArea.FOLDER: self.folder.filePath().strip(),
        }

    def _choose_photos(self) -> None:
        filters = QgsProviderRegistry.instance().fileRasterFilters()
        paths, _ = QFileDialog.getOpenFileNames(self, tr("Add images"), self.photos.defaultRoot(), filters)
        if paths:
            self.photos.setFilePath(" ".join(f'"{path}"' for path in paths))

    def _read_soon(self, *_: object) -> None:
        if not self._run.running:
            self._feedback.cancel()
            self._reader.forget()
            self.start.setEnabled(False)
            self._soon.start(_WAIT_MS)

    def _read(self) -> None:
        given = self.parameters()
        if not given[SetUpArea.ANNOTATION]:
            self.summary.setText(tr("Choose a folder with photos, and a map of their place."))
            return
        self._feedback, self._context = QgsProcessingFeedback(False), QgsProcessingContext()
        self._context.setProject(QgsProject.instance())
        # A new one: a reading that was given up may still use the layers of the last one.
        algorithm = _algorithm()
        values = Values(algorithm, given, self._context)
        self.summary.setText(tr("Reading the photos and the map…"))
        try:
            algorithm.check(values)
            algorithm.read_layers(values)
        except SemRefError as error:
            self.summary.setText(worded(error))
            return
        self._reader.read(tr("Reading the photos and the map"), algorithm.read, values, self._feedback)

    def _show_area(self, area) -> None:
        if self._seen != area.photos.files:
            # Only once for the same photos: the user may know better.
            self._seen = area.photos.files
            self.flight.setChecked(area.photos.is_flight)
        lines = [area.summary(self.minutes.value()), *area.warnings]
        can_start = bool(self.folder.filePath().strip())
        if not can_start:
            # First, because the end may need scrolling.
            lines.insert(0, tr("Choose a folder for the results."))
        self.summary.setText("\n\n".join(lines))
        self.start.setEnabled(can_start)

    def _show_fault(self, sentence: str) -> None:
        self._show_running(False)
        self.summary.setText(sentence)

    def _start_or_cancel(self) -> None:
        if self._run.running:
            self.start.setEnabled(False)
            self.state.show_text(tr("Canceling…"))
            self._run.cancel()
            return
        self._used = self.parameters()
        self._is_other_project = False
        if self._run.start_algorithm(ALGORITHM, self._used, tr("Setting up an area")):
            self._show_running(True)

    def _leave_project(self) -> None:
        self._is_other_project = True

    def _show_running(self, is_running: bool) -> None:
        self.progress.setVisible(is_running)
        self.progress.setValue(0)
        self.state.show_text("")
        self.start.setText(tr("Cancel") if is_running else tr("Run"))
        self.start.setEnabled(True)
        self._inputs.setEnabled(not is_running)

    def _finish(self, results: dict, _context: QgsProcessingContext) -> None:
        self._show_running(False)
        QgsSettings().setValue(_FOLDER_SETTING, os.path.dirname(self._used[SetUpArea.FOLDER]))
        if self._is_other_project:
            self.summary.setText(
                tr(
                    "The area is set up, but another project was opened meanwhile. The files are in {folder}; nothing "
                    "was added to this project."
                ).format(folder=self._used[SetUpArea.FOLDER])
            )
            self.show()
            return
        self.hide()
        self.finished_with.emit(results, self._used)


def _algorithm() -> SetUpArea:
    made = SetUpArea()
    made.initAlgorithm()
    return made


def add_area(results: dict, given: dict, project: QgsProject) -> str:
    """Add map, database and positions of a run to the project, from bottom to top.

    Returns:
        The file with the photos' positions; empty without photos.
    """
    area = given[SetUpArea.ANNOTATION]
    if isinstance(area, str) and os.path.exists(area.partition("|")[0]):
        name = os.path.splitext(os.path.basename(area))[0]
        project.addMapLayer(layer_of_extract(area, POLYGONS_OF_OSM) or QgsVectorLayer(area, name, "ogr"))
    if not database_layers(results[SetUpArea.DATABASE], project):
        add_database_to_map(results[SetUpArea.DATABASE], project)
    positions = results.get(SetUpArea.POSITIONS, "").partition("|")[0]
    if positions:
        layers = named_results(positions)
        shown = [layer for layer in (*layers[:2], layers[-1]) if layer is not None]
        for layer in reversed(shown):
            place_on_top(layer, project)
    return positions


def _files(mode: QgsFileWidget.StorageMode) -> QgsFileWidget:
    made = QgsFileWidget()
    made.setStorageMode(mode)
    made.setDefaultRoot(QgsSettings().value(_FOLDER_SETTING, "", type=str))
    return made


def _number(none: str, decimals: int, step: float) -> QDoubleSpinBox:
    """Return a field for a number; 0 is shown as ``none``."""
    made = QDoubleSpinBox()
    made.setRange(0, 100_000)
    made.setDecimals(decimals)
    made.setSingleStep(step)
    made.setSpecialValueText(none)
    return made
