"""The upper part of the dock: which database, which images, which method."""

from __future__ import annotations

from functools import partial
from typing import List

from qgis.core import QgsApplication, QgsProject, QgsProviderRegistry, QgsSettings
from qgis.gui import QgsCollapsibleGroupBox, QgsFileWidget
from qgis.PyQt.QtCore import Qt, QTimer, pyqtSignal
from qgis.PyQt.QtWidgets import (
    QComboBox,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QMenu,
    QPushButton,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ...processing.translation import tr
from ..dock.buttons import tool_button
from ..layer_files import dropped_files, layer_file, project_databases, raster_layers
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
    """The chosen database, remembered from session to session; ``chosen`` is its path for other threads.

    A file, or one whose layers the project has; a file or layer can be dropped. ``shut_down`` before it is deleted.
    """

    changed = pyqtSignal()
    addToMapAsked = pyqtSignal()

    def __init__(self, parent=None) -> None:
        super().__init__(tr("Reference database"), parent)
        self.setObjectName("SemRefDatabase")
        self.setAcceptDrops(True)
        self.file = QgsFileWidget()
        self.file.setFilter(tr("GeoPackage (*.gpkg)"))
        self.file.setDialogTitle(tr("Choose a reference database"))
        self.file.lineEdit().setPlaceholderText(tr("Choose a GeoPackage"))
        self.file.setFilePath(QgsSettings().value(_DATABASE_SETTING, "", type=str))
        self.in_project = QComboBox()
        self.in_project.setToolTip(tr("Databases whose layers are in the project"))
        self.in_project.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.in_project.setMinimumContentsLength(8)
        self.add_to_map = tool_button("/mActionAddLayer.svg", tr("Add database to map"))
        row = QHBoxLayout()
        row.addWidget(self.file, 1)
        row.addWidget(self.add_to_map)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(MARGIN_PX, MARGIN_PX, MARGIN_PX, MARGIN_PX)
        layout.addLayout(row)
        layout.addWidget(self.in_project)
        self.chosen = self.path()
        self.file.fileChanged.connect(self._remember)
        self.in_project.activated.connect(self._choose_in_project)
        self.add_to_map.clicked.connect(self.addToMapAsked)
        self.add_to_map.setEnabled(bool(self.path()))
        # Layers come into the project before they come into its tree, which has the names of their groups.
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self.list_databases)
        project = QgsProject.instance()
        project.layersAdded.connect(self._list_soon)
        project.layersRemoved.connect(self._list_soon)
        self.list_databases()

    def shut_down(self) -> None:
        project = QgsProject.instance()
        project.layersAdded.disconnect(self._list_soon)
        project.layersRemoved.disconnect(self._list_soon)
        self._soon.stop()

    def path(self) -> str:
        return self.file.filePath().strip()

    def _list_soon(self, *_layers) -> None:
        self._soon.start(0)

    def list_databases(self) -> None:
        """Offers the databases whose layers the project has now; nothing is shown where it has none."""
        self.in_project.clear()
        self.in_project.addItem(tr("In the project…"), "")
        for path, name in project_databases(QgsProject.instance()).items():
            self.in_project.addItem(QgsApplication.getThemeIcon("/mIconVector.svg"), name, path)
            self.in_project.setItemData(self.in_project.count() - 1, path, Qt.ItemDataRole.ToolTipRole)
        self.in_project.setVisible(self.in_project.count() > 1)
        self._show_in_project()

    def _show_in_project(self) -> None:
        self.in_project.setCurrentIndex(max(0, self.in_project.findData(self.path())))

    def _choose_in_project(self, row: int) -> None:
        if self.in_project.itemData(row):
            self.file.setFilePath(self.in_project.itemData(row))

    def _remember(self) -> None:
        self.chosen = self.path()
        QgsSettings().setValue(_DATABASE_SETTING, self.chosen)
        self.add_to_map.setEnabled(bool(self.path()))
        self._show_in_project()
        self.changed.emit()

    # --- QWidget ---

    def dragEnterEvent(self, event):
        if any(dropped_files(event.mimeData())[0]):
            event.acceptProposedAction()

    def dropEvent(self, event):
        self.file.setFilePath(dropped_files(event.mimeData())[0][0])
        event.acceptProposedAction()


class ImageBox(QgsCollapsibleGroupBox):
    """The images, and the buttons that add and remove them.

    refused: names of layers that are not added because they are no file.
    """

    changed = pyqtSignal()
    refused = pyqtSignal(list)

    def __init__(self, parent=None) -> None:
        super().__init__(tr("Images"), parent)
        self.setObjectName("SemRefImages")
        self.list = ImageList()
        self.add_files = QPushButton(tr("Add files…"))
        self.add_folder = QPushButton(tr("Add folder…"))
        self.add_layer = tool_button("/mActionAddRasterLayer.svg", tr("Add a raster layer of the project"))
        self.add_layer.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.layers = QMenu(self.add_layer)
        self.add_layer.setMenu(self.layers)
        self.remove = tool_button("/mActionDeleteSelected.svg", tr("Remove the selected images (Del)"))
        self.model = QgsFileWidget()
        self.model.setFilter(tr("ONNX models (*.onnx)"))
        self.model.setDialogTitle(tr("Choose a segmentation model"))
        self.model.lineEdit().setPlaceholderText(tr("Model, for photos"))
        self.model.setToolTip(tr("The network that makes labels of photos; leave empty for label images"))
        self.model.setFilePath(QgsSettings().value(_MODEL_SETTING, "", type=str))
        buttons = QHBoxLayout()
        for button, stretch in ((self.add_files, 1), (self.add_folder, 1), (self.add_layer, 0), (self.remove, 0)):
            buttons.addWidget(button, stretch)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(MARGIN_PX, MARGIN_PX, MARGIN_PX, MARGIN_PX)
        layout.addWidget(self.list)
        layout.addLayout(buttons)
        layout.addWidget(self.model)
        self.model.fileChanged.connect(self._remember_model)
        self.add_files.clicked.connect(self._choose_files)
        self.add_folder.clicked.connect(self._choose_folder)
        self.layers.aboutToShow.connect(self._list_layers)
        self.remove.clicked.connect(self.list.remove_selected)
        self.remove.setEnabled(False)
        self.list.itemSelectionChanged.connect(self._enable_remove)
        self.list.changed.connect(self.changed)
        self.list.refused.connect(self.refused)

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

    def _list_layers(self) -> None:
        self.layers.clear()
        for layer in raster_layers(QgsProject.instance()):
            action = self.layers.addAction(QgsApplication.getThemeIcon("/mIconRaster.svg"), layer.name())
            # The file, not the layer, which may be removed while the menu is open.
            action.triggered.connect(partial(self._add_layer, layer_file(layer)))
        if self.layers.isEmpty():
            self.layers.addAction(tr("The project has no raster layer of a file.")).setEnabled(False)

    def _add_layer(self, path: str, *_checked) -> None:
        self.list.add([path])

    def _add(self, paths: List[str]) -> None:
        if any(paths):
            QgsSettings().setValue(_FOLDER_SETTING, paths[0])
            self.list.add(paths)


class MethodRow(QWidget):
    """How images are localized, remembered from session to session."""

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
