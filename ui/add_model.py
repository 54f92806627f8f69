"""Dialog *Add a model*: asks what the maker of a network states, shows a test picture, and adds the model."""

from __future__ import annotations

import os
import tempfile
from typing import TYPE_CHECKING

from qgis.core import QgsProcessingContext, QgsProject
from qgis.gui import QgsFileWidget, QgsProcessingMapLayerComboBox
from qgis.PyQt.QtCore import QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor, QIcon, QImage, QPixmap
from qgis.PyQt.QtWidgets import (
    QComboBox,
    QDialog,
    QDoubleSpinBox,
    QFormLayout,
    QHeaderView,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QSpinBox,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from ..core.segmentation.network_facts import BUILDINGS, FLAIR, NetworkFacts
from ..processing.algorithms.add_model import (
    BUILDINGS_PRESET,
    CHECKPOINTS,
    FLAIR_PRESET,
    FROM_0_TO_1,
    NO_PRESET,
    SEPARATOR,
    AddModel,
)
from ..processing.algorithms.segment_image import SegmentImage
from ..processing.inspection.model_test import ModelTest, labels_of_picture, look_at_network
from ..processing.inspection.models import new_model_file
from ..processing.reports.page import percent
from ..processing.translation import tr
from .layer_files import photo_layer
from .running.algorithm_run import AlgorithmRun
from .running.background import Reader, shut_down
from .sample_project import ORTHOPHOTO_FILE, SAMPLE
from .widgets.controls import message_label
from .widgets.layouts import row_of

if TYPE_CHECKING:
    import numpy as np

ALGORITHM = "semref:addmodel"
_MOST_OUTPUTS = 255
_SIZE_PX = QSize(1100, 680)
_PICTURE_PX, _SWATCH_PX, _LEGEND_ROWS = 260, 12, 7


class AddModelDialog(QDialog):
    """added: path of the new model."""

    added = pyqtSignal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("SemRefAddModel")
        self.setWindowTitle(tr("Add a model"))
        # They own the definitions that the widgets use.
        self._asked, self._segmenting = AddModel(), SegmentImage()
        for algorithm in (self._asked, self._segmenting):
            algorithm.initAlgorithm()
        self.file = QgsFileWidget()
        self.file.setFilter(self._asked.parameterDefinition(AddModel.INPUT).fileFilter())
        self.preset, self.pixel_values = self._choice(AddModel.PRESET), self._choice(AddModel.PIXEL_VALUES)
        self.name, self.mean, self.deviation, self.license = (QLineEdit() for _ in range(4))
        self.architecture, self.encoder = QLineEdit("unet"), QLineEdit("resnet34")
        self.outputs = QSpinBox()
        self.outputs.setRange(1, _MOST_OUTPUTS)
        self.classes = QTableWidget(1, 1)
        self.resolution_cm, self.threshold = QDoubleSpinBox(), QDoubleSpinBox()
        self.picture = QgsProcessingMapLayerComboBox(self._segmenting.parameterDefinition(SegmentImage.INPUT))
        self.test, self.add, self.close_button = map(QPushButton, (tr("Test"), tr("Add"), tr("Close")))
        self.image, self.labels, self.legend = _empty_picture(), _empty_picture(), QListWidget()
        self.state = message_label()
        self._run, self._looking, self._labeling = AlgorithmRun(self), Reader(self), Reader(self)
        self._folder = tempfile.TemporaryDirectory(prefix="semref")
        self._lay_out()
        self._connect()
        self._fill(NetworkFacts(("",), 0.0))
        self._show_kind()

    def _choice(self, key: str) -> QComboBox:
        made = QComboBox()
        made.addItems(self._asked.parameterDefinition(key).options())
        return made

    # --- layout ---

    def _lay_out(self) -> None:
        self.resolution_cm.setRange(0, 100_000)
        self.resolution_cm.setSpecialValueText(tr("not stated"))
        self.threshold.setRange(0, 1)
        self.threshold.setSingleStep(0.05)
        self.classes.setHorizontalHeaderLabels([tr("Class (empty: not used)")])
        self.classes.horizontalHeader().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        self.form = QFormLayout()
        for key, widget in (
            (AddModel.INPUT, self.file),
            (AddModel.PRESET, self.preset),
            (AddModel.NAME, self.name),
            (AddModel.ARCHITECTURE, self.architecture),
            (AddModel.ENCODER, self.encoder),
            ("", self.outputs),
            (AddModel.CLASSES, self.classes),
            (AddModel.THRESHOLD, self.threshold),
            (AddModel.RESOLUTION, self.resolution_cm),
            (AddModel.PIXEL_VALUES, self.pixel_values),
            (AddModel.MEAN, self.mean),
            (AddModel.STANDARD_DEVIATION, self.deviation),
            (AddModel.LICENSE, self.license),
        ):
            definition = self._asked.parameterDefinition(key) if key else None
            title = tr("Number of outputs") if definition is None else definition.description()
            widget.setToolTip("" if definition is None else definition.help())
            widget.setAccessibleName(title)
            self.form.addRow(title, widget)
        self.state.setMinimumHeight(3 * self.fontMetrics().height())
        self.legend.setMaximumHeight(_LEGEND_ROWS * (self.fontMetrics().height() + 4))
        beside = QVBoxLayout()
        beside.addWidget(QLabel(tr("Test picture: the middle of")))
        beside.addLayout(row_of((self.picture, 1), self.test))
        beside.addLayout(row_of((self.image, 1), (self.labels, 1)), 1)
        beside.addWidget(self.legend)
        beside.addWidget(self.state)
        both = row_of()
        both.addLayout(self.form, 1)
        both.addLayout(beside, 1)
        layout = QVBoxLayout(self)
        layout.addLayout(both, 1)
        layout.addLayout(row_of((QWidget(), 1), self.add, self.close_button))
        self.add.setDefault(True)
        self.resize(_SIZE_PX)
        # QGIS selects the first raster, which may be a label map.
        photo = photo_layer(QgsProject.instance())
        if photo is not None:
            self.picture.setLayer(photo)
        else:
            sample = SAMPLE / ORTHOPHOTO_FILE
            self.picture.setValue(str(sample) if sample.is_file() else None, QgsProcessingContext())

    def _connect(self) -> None:
        self.file.fileChanged.connect(self._look)
        self.preset.currentIndexChanged.connect(self._take_preset)
        self.outputs.valueChanged.connect(self._show_outputs)
        self.test.clicked.connect(self._test)
        self.add.clicked.connect(self._add)
        self.close_button.clicked.connect(self.reject)
        self._looking.answered.connect(self._take_network)
        self._labeling.answered.connect(self._show_test)
        for reader in (self._looking, self._labeling):
            reader.failed.connect(self._show_end)
        self._run.textChanged.connect(self.state.setText)
        self._run.failed.connect(self._show_end)
        self._run.canceled.connect(lambda: self._show_end(tr("Canceled. Nothing was written.")))
        self._run.done.connect(self._take_model)

    # --- what is asked ---

    @property
    def is_checkpoint(self) -> bool:
        """Whether the file is a checkpoint of segmentation_models_pytorch."""
        return self.file.filePath().strip().lower().endswith(CHECKPOINTS)

    def parameters(self, target: str) -> dict:
        """Return the parameters of the algorithm; ``target``: its output."""
        return {
            AddModel.INPUT: self.file.filePath().strip(),
            AddModel.NAME: self.name.text(),
            AddModel.CLASSES: SEPARATOR.join(self._class_names()),
            AddModel.RESOLUTION: self.resolution_cm.value() or None,
            AddModel.PIXEL_VALUES: self.pixel_values.currentIndex(),
            AddModel.MEAN: self.mean.text(),
            AddModel.STANDARD_DEVIATION: self.deviation.text(),
            AddModel.THRESHOLD: self.threshold.value(),
            AddModel.LICENSE: self.license.text(),
            AddModel.ARCHITECTURE: self.architecture.text(),
            AddModel.ENCODER: self.encoder.text(),
            AddModel.OUTPUT: target,
        }

    def _class_names(self) -> list[str]:
        items = (self.classes.item(row, 0) for row in range(self.classes.rowCount()))
        return ["" if item is None else item.text().strip() for item in items]

    def _look(self) -> None:
        self._looking.forget()
        self._show_kind()
        self.image.clear()
        self.labels.clear()
        self.legend.clear()
        path = self.file.filePath().strip()
        able, reason = self._asked.canExecute()
        self.state.setText(reason)
        if able and path and not self.is_checkpoint:
            self.state.setText(tr("Reading the network…"))
            self._looking.read(tr("Reading the network"), look_at_network, path)

    def _take_network(self, found: tuple[int, NetworkFacts]) -> None:
        channels, facts = found
        self.state.setText(tr("The network has {count} outputs.").format(count=channels))
        if self.preset.currentIndex() == NO_PRESET:
            self._fill(facts)

    def _take_preset(self, number: int) -> None:
        preset = {FLAIR_PRESET: FLAIR, BUILDINGS_PRESET: BUILDINGS}.get(number)
        if preset is not None:
            self._fill(preset)
        else:
            self._look()

    def _fill(self, facts: NetworkFacts) -> None:
        self.outputs.setValue(len(facts.classes))
        self._show_outputs()
        for row, name in enumerate(facts.classes):
            self.classes.setItem(row, 0, QTableWidgetItem(name))
        self.name.setText(facts.name or os.path.splitext(os.path.basename(self.file.filePath()))[0])
        self.resolution_cm.setValue(100 * facts.resolution_m)
        self.pixel_values.setCurrentIndex(FROM_0_TO_1)
        for field, numbers in ((self.mean, facts.mean), (self.deviation, facts.std)):
            field.setText(f"{SEPARATOR} ".join(f"{number:g}" for number in numbers))
        self.threshold.setValue(facts.threshold)
        self.license.setText(facts.license)
        for field in (self.name, self.mean, self.deviation, self.license):
            field.setCursorPosition(0)

    def _show_outputs(self) -> None:
        count = self.outputs.value()
        self.classes.setRowCount(count)
        self.classes.setVerticalHeaderLabels([str(number) for number in range(1, count + 1)])
        self.threshold.setEnabled(count == 1)

    def _show_kind(self) -> None:
        """Show architecture and encoder for checkpoints only; the file of an ONNX network states its outputs."""
        for widget in (self.architecture, self.encoder, self.outputs):
            widget.setVisible(self.is_checkpoint)
            self.form.labelForField(widget).setVisible(self.is_checkpoint)

    # --- test picture, and the model ---

    def _test(self) -> None:
        self._start(os.path.join(self._folder.name, "test.onnx"), tr("Testing the network"))

    def _add(self) -> None:
        if self._run.running:
            self._run.cancel()
            return
        self._start(new_model_file(_file_name(self.name.text())), tr("Adding a model"))

    def _start(self, target: str, title: str) -> None:
        self._labeling.forget()
        self._show_running(self._run.start_algorithm(ALGORITHM, self.parameters(target), title))

    def _take_model(self, results: dict, _context: QgsProcessingContext) -> None:
        self._show_running(False)
        if not results[AddModel.OUTPUT].startswith(self._folder.name):
            self.added.emit(results[AddModel.OUTPUT])
            self.accept()
            return
        layer = self.picture.currentLayer()
        path = self.picture.value() if layer is None else layer.source()
        if not isinstance(path, str) or not path:
            self.state.setText(tr("Choose a raster layer or file for the test picture."))
            return
        self.state.setText(tr("Labeling the test picture…"))
        self._labeling.read(tr("Labeling the test picture"), labels_of_picture, results[AddModel.OUTPUT], path)

    def _show_test(self, test: ModelTest) -> None:
        self.state.setText(
            tr("Check that the classes are in the right places. If not, check order, resolution and mean.")
        )
        self.image.setPixmap(_pixmap(test.pixels_hw3))
        self.labels.setPixmap(_pixmap(test.labels_hw3))
        self.legend.clear()
        for name, color, share in test.classes:
            swatch = QPixmap(_SWATCH_PX, _SWATCH_PX)
            swatch.fill(QColor(color))
            self.legend.addItem(QListWidgetItem(QIcon(swatch), f"{name or tr('no class')}: {percent(share, 0)}"))

    def _show_end(self, sentence: str) -> None:
        self._show_running(False)
        self.state.setText(sentence)

    def _show_running(self, is_running: bool) -> None:
        self.add.setText(tr("Cancel") if is_running else tr("Add"))
        for widget in (self.test, self.file, self.preset):
            widget.setEnabled(not is_running)

    def done(self, result: int) -> None:
        """End what runs, and remove the model of the test picture."""
        shut_down(self)
        self._folder.cleanup()
        super().done(result)


def _empty_picture() -> QLabel:
    made = QLabel()
    made.setMinimumSize(_PICTURE_PX, _PICTURE_PX)
    made.setAlignment(Qt.AlignmentFlag.AlignCenter)
    return made


def _pixmap(pixels_hw3: np.ndarray) -> QPixmap:
    """Return (H, W, 3) uint8 pixels, red first, in the size of the dialog's pictures."""
    height, width = pixels_hw3.shape[:2]
    image = QImage(pixels_hw3.tobytes(), width, height, 3 * width, QImage.Format.Format_RGB888)
    ways = Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation
    return QPixmap.fromImage(image).scaled(_PICTURE_PX, _PICTURE_PX, *ways)


def _file_name(name: str) -> str:
    return "".join(c if c.isalnum() or c in "-_" else "_" for c in name.strip())[:100] or "model"
