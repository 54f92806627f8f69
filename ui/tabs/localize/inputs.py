"""Inputs of a run: images, model for photos, method."""

from __future__ import annotations

import os
from functools import partial

from qgis.core import QgsApplication, QgsProject, QgsProviderRegistry, QgsSettings
from qgis.gui import QgsFileWidget
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtWidgets import QCheckBox, QFileDialog, QLabel, QPushButton, QVBoxLayout, QWidget

from ....core.localization import Method
from ....processing.base.algorithm import REPORTS_AS_FILES
from ....processing.inspection.chosen import ChosenImages, count_images
from ....processing.inspection.models import PHOTO_MODEL
from ....processing.jobs.image_results import is_photo
from ....processing.messages.sentences import worded
from ....processing.translation import tr
from ...model_list import ModelsDialog
from ...project_state import MODEL_SETTING
from ...proposals import training_at_hand
from ...running.background import Reader
from ...widgets.controls import ChoiceBox, ask_folder, open_algorithm, tool_button
from ...widgets.layouts import InputBox, narrow, row_of
from ...widgets.messages import Messages, open_file
from .image_list import ImageList

_METHOD_SETTING = "semref/dock/method"
_FOLDER_SETTING = "semref/dock/image_folder"

TRAIN_MODEL = "semref:trainmodel"


class ImageBox(InputBox):
    """List of images with buttons to add and remove them, and the model for photos.

    Attributes:
        chosen: Properties of the images; None while folders are being read.
        fault: Why a folder can't be used; otherwise empty.

    looked: ``chosen`` or ``fault`` changed.
    """

    changed = pyqtSignal()
    looked = pyqtSignal()

    def __init__(self, messages: Messages) -> None:
        super().__init__(tr("Images"), "SemRefImages")
        self._messages = messages
        self.list = ImageList()
        self.add_files = QPushButton(tr("Add files…"))
        self.add_folder = QPushButton(tr("Add folder…"))
        self.remove = tool_button("/mActionDeleteSelected.svg", tr("Remove the selected images (Del)"))
        self.flight = QCheckBox(tr("These images are one flight"))
        # The dock may be narrower than the text.
        self.flight.setMinimumWidth(1)
        self.flight.setToolTip(
            tr(
                "Compute all positions together, in the order of the images’ times, or of their names if there "
                "are no times. Images without a position of their own get one from the flight."
            )
        )
        self.model = QgsFileWidget()
        self.model.setFilter(tr("ONNX models (*.onnx)"))
        self.model.setDialogTitle(tr("Choose a segmentation model"))
        self.model.lineEdit().setPlaceholderText(tr("Model (only for photos)"))
        self.model.lineEdit().setAccessibleName(tr("Model (only for photos)"))
        self.model.setToolTip(tr("Model that segments photos. Leave empty for label images."))
        self.model.setFilePath(QgsSettings().value(MODEL_SETTING, "", type=str))
        self.models = tool_button("/mActionOpenTable.svg", tr("Show models with their descriptions…"))
        self.choosing: ModelsDialog | None = None
        self.train = tool_button("/processingAlgorithm.svg", tr("Train a model with an orthophoto and polygons…"))
        self.training: QWidget | None = None
        layout = narrow(QVBoxLayout(self.content), 0)
        layout.addWidget(self.list)
        layout.addLayout(row_of((self.add_files, 1), (self.add_folder, 1), self.remove))
        layout.addWidget(self.flight)
        layout.addLayout(row_of((self.model, 1), self.models, self.train))
        self.models.clicked.connect(self._choose_model)
        self.train.clicked.connect(self._train_model)
        self.model.fileChanged.connect(self._remember_model)
        self.add_files.clicked.connect(self._choose_files)
        self.add_folder.clicked.connect(self._choose_folder)
        self.remove.clicked.connect(self.list.remove_selected)
        self.remove.setEnabled(False)
        self.list.itemSelectionChanged.connect(self._enable_remove)
        self.list.changed.connect(self._look)
        self.list.changed.connect(self.changed)
        self.list.refused.connect(self._refuse_layers)
        self._reader = Reader(self)
        self._reader.answered.connect(self._take_look)
        self._reader.failed.connect(self._take_fault)
        self._look()

    def paths(self) -> list[str]:
        return self.list.paths()

    def shut_down(self) -> None:
        self._close_models()

    def _look(self) -> None:
        """Use the file names at once; read folders and colors in the background."""
        self._reader.forget()
        self.fault, paths = "", self.paths()
        is_known = not any(map(os.path.isdir, paths))
        self._show_chosen(ChosenImages(len(paths), any(map(is_photo, paths))) if is_known else None)
        if paths:
            self._reader.read(tr("Reading the images"), count_images, paths)
        else:
            self.flight.setChecked(False)
            self.setCollapsed(False)

    def _take_look(self, chosen: ChosenImages) -> None:
        self._show_chosen(chosen)
        self.looked.emit()

    def _take_fault(self, sentence: str) -> None:
        self.fault = sentence
        self.looked.emit()

    def _show_chosen(self, chosen: ChosenImages | None) -> None:
        """Show the number of images, and choose SemRef's model for photos."""
        self.chosen = chosen
        count = 0 if chosen is None else chosen.count
        if chosen is not None and chosen.has_photos and not self.model_path():
            self.model.setFilePath(str(PHOTO_MODEL))
        self.setTitle(tr("Images ({count})").format(count=count) if count else tr("Images"))

    def model_path(self) -> str:
        """Return the path of the model for photos; empty for label images."""
        return self.model.filePath().strip()

    def restore_model(self, path: str) -> None:
        """Show a project's model. After a project without one, the next session still starts with the last model."""
        last = QgsSettings().value(MODEL_SETTING, "", type=str)
        self.model.setFilePath(path)
        QgsSettings().setValue(MODEL_SETTING, path or last)

    def _choose_model(self) -> None:
        self._close_models()
        # Not a child of the box, which shows all its children when it opens.
        self.choosing = ModelsDialog(self.model_path(), self.window())
        self.choosing.chosen.connect(self.model.setFilePath)
        self.choosing.show()

    def _close_models(self) -> None:
        if self.choosing is not None:
            self.choosing.close()
            self.choosing.deleteLater()
            self.choosing = None

    def _train_model(self) -> None:
        # As a file, the report does not open QGIS's Results Viewer, which takes half of the dock's height.
        configuration = {REPORTS_AS_FILES: True}
        algorithm = QgsApplication.processingRegistry().createAlgorithmById(TRAIN_MODEL, configuration)
        self.training = open_algorithm(algorithm, training_at_hand(QgsProject.instance(), self.model_path()))
        self.training.algorithmFinished.connect(self._take_model)

    def _take_model(self, successful: bool, results: dict) -> None:
        if successful and results.get("OUTPUT"):
            self.model.setFilePath(results["OUTPUT"])
            sentence, report = tr("The model is trained and selected in the dock."), results.get("REPORT")
            if report:
                self._messages.success_with(sentence, tr("Open report"), partial(open_file, report))
            else:
                self._messages.success(sentence)

    def _remember_model(self) -> None:
        QgsSettings().setValue(MODEL_SETTING, self.model_path())
        self.changed.emit()

    def _refuse_layers(self, names: list[str]) -> None:
        sentence = tr("Not added, because they are not image files: {layers}.")
        self._messages.warning(sentence.format(layers=", ".join(names)))

    def _enable_remove(self) -> None:
        self.remove.setEnabled(bool(self.list.selectedItems()))

    def _choose_files(self) -> None:
        filters = QgsProviderRegistry.instance().fileRasterFilters()
        # For a file, Qt opens its folder.
        last = QgsSettings().value(_FOLDER_SETTING, "", type=str)
        paths, _ = QFileDialog.getOpenFileNames(self.window(), tr("Add images"), last, filters)
        self._add(paths)

    def _choose_folder(self) -> None:
        self._add([ask_folder(self.window(), tr("Add a folder of images"), _FOLDER_SETTING)])

    def _add(self, paths: list[str]) -> None:
        if any(paths):
            QgsSettings().setValue(_FOLDER_SETTING, paths[0])
            self.list.add(paths)


class MethodRow(QWidget):
    """Choice of the method, remembered between sessions."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("SemRefMethod")
        self.choice = ChoiceBox()
        # The published method is last: it serves for comparison.
        for method in (Method.AUTOMATIC, Method.CONSTELLATION, Method.MAP_CORRELATION, Method.TOPOLOGY_VECTOR):
            self.choice.addItem(worded(method.title), method.number)
        label = QLabel(tr("Method"))
        label.setBuddy(self.choice)
        self.setLayout(narrow(row_of(label, (self.choice, 1)), 0))
        self.choice.setCurrentIndex(max(0, self.choice.findData(QgsSettings().value(_METHOD_SETTING, 0, type=int))))
        # Not the methods of projects.
        self.choice.activated.connect(self._remember)

    def method(self) -> int:
        """Return METHOD of semref:localizeimages."""
        return self.choice.currentData()

    def choose(self, method: int) -> None:
        self.choice.setCurrentIndex(self.choice.findData(method))

    def _remember(self) -> None:
        QgsSettings().setValue(_METHOD_SETTING, self.method())
