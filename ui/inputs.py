"""The upper part of the dock: which database, which images, which method."""

from __future__ import annotations

from typing import List

from qgis.core import QgsApplication, QgsProviderRegistry, QgsSettings
from qgis.gui import QgsCollapsibleGroupBox, QgsFileWidget
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtWidgets import QComboBox, QFileDialog, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from ..processing.translation import tr
from .image_list import ImageList

MARGIN_PX = 5
"""Around the content of the dock and of its boxes: width is scarce in a dock."""

AUTOMATIC = 0
"""METHOD of semref:localizeimages."""

_DATABASE_SETTING = "semref/dock/database"
_METHOD_SETTING = "semref/dock/method"
_MODEL_SETTING = "semref/dock/model"
_FOLDER_SETTING = "semref/dock/image_folder"


class DatabaseBox(QgsCollapsibleGroupBox):
    """The chosen database, remembered from session to session; ``chosen`` is its path for other threads."""

    changed = pyqtSignal()
    addToMapAsked = pyqtSignal()

    def __init__(self, parent=None) -> None:
        super().__init__(tr("Reference database"), parent)
        self.setObjectName("SemRefDatabase")
        self.file = QgsFileWidget()
        self.file.setFilter(tr("GeoPackage (*.gpkg)"))
        self.file.setDialogTitle(tr("Choose a reference database"))
        self.file.lineEdit().setPlaceholderText(tr("Choose a GeoPackage"))
        self.file.setFilePath(QgsSettings().value(_DATABASE_SETTING, "", type=str))
        self.add_to_map = QPushButton(QgsApplication.getThemeIcon("/mActionAddLayer.svg"), tr("Add database to map"))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(MARGIN_PX, MARGIN_PX, MARGIN_PX, MARGIN_PX)
        layout.addWidget(self.file)
        layout.addWidget(self.add_to_map)
        self.chosen = self.path()
        self.file.fileChanged.connect(self._remember)
        self.add_to_map.clicked.connect(self.addToMapAsked)
        self.add_to_map.setEnabled(bool(self.path()))

    def path(self) -> str:
        return self.file.filePath().strip()

    def _remember(self) -> None:
        self.chosen = self.path()
        QgsSettings().setValue(_DATABASE_SETTING, self.chosen)
        self.add_to_map.setEnabled(bool(self.path()))
        self.changed.emit()


class ImageBox(QgsCollapsibleGroupBox):
    """The images, and the buttons that add and remove them."""

    changed = pyqtSignal()

    def __init__(self, parent=None) -> None:
        super().__init__(tr("Images"), parent)
        self.setObjectName("SemRefImages")
        self.list = ImageList()
        self.add_files = QPushButton(tr("Add files…"))
        self.add_folder = QPushButton(tr("Add folder…"))
        self.remove = QPushButton(tr("Remove"))
        self.model = QgsFileWidget()
        self.model.setFilter(tr("ONNX models (*.onnx)"))
        self.model.setDialogTitle(tr("Choose a segmentation model"))
        self.model.lineEdit().setPlaceholderText(tr("Model, for photos"))
        self.model.setToolTip(tr("The network that makes labels of photos; leave empty for label images"))
        self.model.setFilePath(QgsSettings().value(_MODEL_SETTING, "", type=str))
        buttons = QHBoxLayout()
        for button in (self.add_files, self.add_folder, self.remove):
            buttons.addWidget(button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(MARGIN_PX, MARGIN_PX, MARGIN_PX, MARGIN_PX)
        layout.addWidget(self.list)
        layout.addLayout(buttons)
        layout.addWidget(self.model)
        self.model.fileChanged.connect(self._remember_model)
        self.add_files.clicked.connect(self._choose_files)
        self.add_folder.clicked.connect(self._choose_folder)
        self.remove.clicked.connect(self.list.remove_selected)
        self.remove.setEnabled(False)
        self.list.itemSelectionChanged.connect(self._enable_remove)
        self.list.changed.connect(self.changed)

    def paths(self) -> List[str]:
        return self.list.paths()

    def model_path(self) -> str:
        """Of the network for photos; empty for label images."""
        return self.model.filePath().strip()

    def _remember_model(self) -> None:
        QgsSettings().setValue(_MODEL_SETTING, self.model_path())
        self.changed.emit()

    def _enable_remove(self) -> None:
        self.remove.setEnabled(bool(self.list.selectedItems()))

    def _choose_files(self) -> None:
        filters = QgsProviderRegistry.instance().fileRasterFilters()
        paths, _ = QFileDialog.getOpenFileNames(self, tr("Add images"), _last_folder(), filters)
        self._add(paths)

    def _choose_folder(self) -> None:
        self._add([QFileDialog.getExistingDirectory(self, tr("Add a folder of images"), _last_folder())])

    def _add(self, paths: List[str]) -> None:
        if any(paths):
            QgsSettings().setValue(_FOLDER_SETTING, paths[0])
            self.list.add(paths)


class MethodRow(QWidget):
    """How images are localised, remembered from session to session."""

    def __init__(self, parent=None) -> None:
        super().__init__(parent)
        self.setObjectName("SemRefMethod")
        self.choice = QComboBox()
        # The numbers are METHOD of semref:localizeimages, which is public.
        for number, name in (
            (AUTOMATIC, tr("Automatic")),
            (2, tr("Constellation")),
            (3, tr("Map correlation")),
            (1, tr("Topology vector (published)")),
        ):
            self.choice.addItem(name, number)
        label = QLabel(tr("Method"))
        label.setBuddy(self.choice)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(label)
        layout.addWidget(self.choice, 1)
        self.choice.setCurrentIndex(max(0, self.choice.findData(QgsSettings().value(_METHOD_SETTING, 0, type=int))))
        self.choice.currentIndexChanged.connect(self._remember)

    def method(self) -> int:
        return self.choice.currentData()

    def choose(self, method: int) -> None:
        self.choice.setCurrentIndex(self.choice.findData(method))

    def _remember(self) -> None:
        QgsSettings().setValue(_METHOD_SETTING, self.method())


def _last_folder() -> str:
    """Qt takes a file for the folder it lies in."""
    return QgsSettings().value(_FOLDER_SETTING, "", type=str)
