"""Create and open the sample project: copy its files, build its database, and fill the dock."""

from __future__ import annotations

import shutil
from pathlib import Path

from qgis.core import QgsProject, QgsRasterLayer, QgsReferencedRectangle, QgsVectorLayer
from qgis.PyQt.QtCore import QObject

from ..core.errors import ParameterError, SemRefError, reason_of
from ..processing.inspection.models import SHIPPED
from ..processing.layers.class_styles import annotation_renderer
from ..processing.layers.database_layers import add_database_to_map
from ..processing.messages.sentences import worded
from ..processing.translation import tr
from ..storage.atomic_output import folder_written_beside
from ..storage.text_tables import CLASSES_FILE, read_class_table
from .project_state import read_state
from .running.algorithm_run import AlgorithmRun
from .widgets.controls import ask_folder
from .widgets.database_box import MAKE_DATABASE

FOLDER = "semref_sample"
"""Folder that is created in the chosen folder, unless the chosen folder is empty."""

SAMPLE = Path(__file__).resolve().parents[1] / "sample"
"""Files that ship with the plugin; in a checkout, ``python -m tools.sample`` creates them."""

MARKER, ANNOTATION_FILE, ORTHOPHOTO_FILE, PHOTOS_FOLDER = "sample.json", "landcover.shp", "orthophoto.tif", "photos"
LABEL_MAP_FILE, DATABASE_FILE, PROJECT_FILE = "label_map.tif", "reference_database.gpkg", "semref_sample.qgz"
MODEL = SHIPPED / "sample_area.onnx"
CLASS_FIELD, PRIORITY_FIELD = "class", "zorder"
PIXEL_SIZE_M, WINDOW_SIZE_M, STRIDE_M, MINIMUM_AREA_M2 = 1.0, 640, 160, 50

LAND_COVER_OPACITY = 0.5
"""Keeps the orthophoto below visible."""

_FOLDER_SETTING = "semref/sample_folder"


class SampleProject(QObject):
    """Asks for a folder, creates the sample project there, and opens it."""

    def __init__(self, iface, dock) -> None:
        super().__init__(iface.mainWindow())
        self._iface, self._dock = iface, dock
        self._messages = dock.messages
        self._folder = Path()
        self.run = AlgorithmRun(self)
        self.run.done.connect(lambda *_: self._open())
        self.run.failed.connect(self._messages.error)

    def ask(self) -> None:
        if self.run.running:
            self._messages.info(tr("SemRef is already creating the sample project."))
            return
        title = tr("Choose a folder for the sample project")
        picked = ask_folder(self._iface.mainWindow(), title, _FOLDER_SETTING)
        if picked:
            self.make(Path(picked))

    def make(self, picked: Path) -> None:
        """Create the project in the chosen folder; files of an earlier run stay."""
        if not (SAMPLE / MARKER).exists():
            self._messages.error(tr("This copy of SemRef has no sample area. Install SemRef from its zip file."))
            return
        try:
            self._folder = sample_folder(picked)
            copy_sample(self._folder)
        except SemRefError as error:
            self._messages.error(worded(error))
            return
        except OSError:
            self._messages.error(tr("The folder {folder} can’t be read. Choose another folder.").format(folder=picked))
            return
        if (self._folder / DATABASE_FILE).exists():
            self._open()
            return
        # QGIS shows progress and a button to cancel in its status bar.
        self._messages.info(tr("Creating the sample project"))
        self.run.start_algorithm(MAKE_DATABASE, parameters(self._folder), tr("Creating the sample project"))

    def _open(self) -> None:
        if not self._iface.newProject(True):
            self._messages.info(tr("The sample project is in {folder}.").format(folder=self._folder))
            return
        project = self._folder / PROJECT_FILE
        if project.exists():
            self._iface.addProject(str(project))
        else:
            extent = fill_project(QgsProject.instance(), self._folder)
            self._iface.mapCanvas().setReferencedExtent(extent)
        if read_state(QgsProject.instance()) is None:
            photos = sorted(str(path) for path in (self._folder / PHOTOS_FOLDER).glob("*.jpg"))
            self._dock.prepare(str(self._folder / DATABASE_FILE), str(MODEL), photos)
            # The project file stores the state of the dock as well.
            QgsProject.instance().write(str(project))
        else:
            self._dock.setUserVisible(True)
        self._messages.info(tr("Press “Localize” in the dock to find the positions of the photos."))


def sample_folder(picked: Path) -> Path:
    """Return the chosen folder if it is empty or has a sample project; otherwise a new folder in it."""
    if (picked / MARKER).exists() or not any(picked.iterdir()):
        return picked
    return picked / FOLDER


def copy_sample(folder: Path) -> None:
    """Copy the shipped files into a new or empty folder. A folder that has them stays unchanged.

    Raises:
        ParameterError: The folder has other files or can't be written to.
    """
    if (folder / MARKER).exists():
        return
    try:
        with folder_written_beside(str(folder)) as made:
            shutil.copytree(SAMPLE, made, dirs_exist_ok=True, ignore=shutil.ignore_patterns(".*"))
    except OSError as error:
        raise ParameterError("{path} can't be written: {reason}.", path=folder, reason=reason_of(error)) from error


def parameters(folder: Path) -> dict:
    """Return the parameters of the algorithm that creates label map and database."""
    return {
        "INPUT": str(folder / ANNOTATION_FILE),
        "CLASS_FIELD": CLASS_FIELD,
        "PRIORITY_FIELD": PRIORITY_FIELD,
        "CLASS_TABLE": str(folder / CLASSES_FILE),
        "PIXEL_SIZE": PIXEL_SIZE_M,
        "WINDOW_SIZE": WINDOW_SIZE_M,
        "STRIDE": STRIDE_M,
        "MINIMUM_AREA": MINIMUM_AREA_M2,
        "rasterize:Label map": str(folder / LABEL_MAP_FILE),
        "build:Reference database": str(folder / DATABASE_FILE),
    }


def fill_project(project: QgsProject, folder: Path) -> QgsReferencedRectangle:
    """Add the sample's styled layers to an empty project. Return their extent."""
    photo = QgsRasterLayer(str(folder / ORTHOPHOTO_FILE), tr("Orthophoto"))
    labels = QgsRasterLayer(str(folder / LABEL_MAP_FILE), tr("Label map"))
    annotation = QgsVectorLayer(str(folder / ANNOTATION_FILE), tr("Land cover"), "ogr")
    annotation.setRenderer(
        annotation_renderer(read_class_table(str(folder / CLASSES_FILE)), CLASS_FIELD, PRIORITY_FIELD)
    )
    annotation.setOpacity(LAND_COVER_OPACITY)
    project.setTitle(tr("SemRef sample project"))
    project.setCrs(annotation.crs())
    # From bottom to top.
    for layer in (photo, labels, annotation):
        project.addMapLayer(layer)
    add_database_to_map(str(folder / DATABASE_FILE), project)
    label_node, photo_node = (project.layerTreeRoot().findLayer(layer.id()) for layer in (labels, photo))
    label_node.setItemVisibilityChecked(False)
    for node in (label_node, photo_node):
        node.setExpanded(False)
    extent = QgsReferencedRectangle(annotation.extent(), annotation.crs())
    project.viewSettings().setDefaultViewExtent(extent)
    return extent
