"""The sample project: made step by step in the background, opened as a project, with the dock ready on its photos."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from qgis.core import Qgis, QgsProject, QgsRasterLayer, QgsReferencedRectangle, QgsSettings, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal
from qgis.PyQt.QtWidgets import QFileDialog, QPushButton

from ..processing.exchange.database_layers import add_database_to_map
from ..processing.exchange.styles import annotation_renderer
from ..processing.inspection.models import SHIPPED
from ..processing.translation import tr
from ..storage.sample_files import (
    ANNOTATION_FILE,
    CLASS_FIELD,
    MARKER,
    ORTHOPHOTO_FILE,
    PHOTOS_FOLDER,
    PIXEL_SIZE_M,
    PRIORITY_FIELD,
)
from ..storage.text_tables import CLASSES_FILE, read_class_table
from .project_state import read_state
from .running.algorithm_run import AlgorithmRun
from .widgets.messages import TAG, Messages
from .widgets.remaining_bar import RemainingBar

FOLDER = "semref_sample"
"""Made in the folder that the user picks, unless that one is empty."""

LABEL_MAP_FILE, DATABASE_FILE, PROJECT_FILE = "label_map.tif", "reference_database.gpkg", "semref_sample.qgz"
MODEL = SHIPPED / "sample_area.onnx"
WINDOW_SIZE_M, STRIDE_M, MINIMUM_AREA_M2 = 640, 160, 50

LAND_COVER_OPACITY = 0.5
"""The orthophoto below stays visible."""

_FOLDER_SETTING = "semref/sample_folder"


@dataclass(frozen=True)
class Step:
    """One algorithm: the file that tells that it is done, its id, parameters, and what the user is told."""

    result: Path
    algorithm: str
    parameters: dict
    text: str


class SampleProject(QObject):
    """Asks for a folder, makes there what is missing, and opens it; ``shut_down`` before it is deleted."""

    percent = pyqtSignal(int)
    said = pyqtSignal(str)
    ended = pyqtSignal()

    def __init__(self, iface, dock) -> None:
        super().__init__(iface.mainWindow())
        self._iface, self._dock = iface, dock
        self._messages = Messages(iface.messageBar())
        self._folder = Path()
        self._steps: list[Step] = []
        self._step_count = 0
        self.run = AlgorithmRun(self)
        self.run.progressed.connect(self._show_progress)
        self.run.said.connect(self.said)
        self.run.done.connect(self._go_on)
        self.run.failed.connect(self._fail)
        self.run.broke.connect(self._break)
        self.run.canceled.connect(self.ended)
        self.run.canceled.connect(lambda: self._messages.take_back_failure(self.run.title))

    def shut_down(self) -> None:
        self.run.abandon()
        self.ended.emit()

    def ask(self) -> None:
        if self.run.running:
            self._messages.info(tr("The sample project is being made."))
            return
        last = QgsSettings().value(_FOLDER_SETTING, "", type=str)
        picked = QFileDialog.getExistingDirectory(
            self._iface.mainWindow(), tr("Choose a folder for the sample project"), last
        )
        if picked:
            QgsSettings().setValue(_FOLDER_SETTING, picked)
            self.make(Path(picked))

    def make(self, picked: Path) -> None:
        """In a folder that the user picked; what an earlier run finished is kept."""
        try:
            self._folder = sample_folder(picked)
        except OSError:
            self._messages.error(tr("{folder} can’t be read; choose another folder.").format(folder=picked))
            return
        self._steps = [step for step in steps(self._folder) if not step.result.exists()]
        self._step_count = len(self._steps)
        if self._steps:
            self._show_bar()
        self._go_on()

    def _go_on(self, *_) -> None:
        if self._steps:
            step = self._steps.pop(0)
            self.said.emit(step.text)
            self.run.start_algorithm(step.algorithm, step.parameters, step.text)
        else:
            self.ended.emit()
            self._open()

    def _show_progress(self, percent: float) -> None:
        done = self._step_count - len(self._steps) - 1
        self.percent.emit(round((100 * done + percent) / self._step_count))

    def _fail(self, sentence: str) -> None:
        self.ended.emit()
        self._messages.error(sentence)

    def _break(self, report: str) -> None:
        self.ended.emit()
        self._messages.bug(report)

    def _show_bar(self) -> None:
        """What is being done, how far, and a way to stop it; the user may close it and let the work go on."""
        bar = self._iface.messageBar()
        item = bar.createMessage(TAG, tr("Making the sample project"))
        progress, cancel = RemainingBar(), QPushButton(tr("Cancel"))
        progress.begin()
        for widget in (progress, cancel):
            item.layout().addWidget(widget)
        self.said.connect(item.setText)
        self.percent.connect(progress.show_percent)
        cancel.clicked.connect(self.run.cancel)
        self.ended.connect(item.dismiss)
        bar.pushWidget(item, Qgis.MessageLevel.Info)

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
            # Only now does the project know what the dock shows.
            QgsProject.instance().write(str(project))
        else:
            self._dock.setUserVisible(True)
        self._messages.info(tr("Press “Localize” in the dock to find where the photos were taken."))


def sample_folder(picked: Path) -> Path:
    """Where the sample project is to be: the picked folder if it is empty or holds one, else a new one in it."""
    if (picked / MARKER).exists() or not any(picked.iterdir()):
        return picked
    return picked / FOLDER


def steps(folder: Path) -> list[Step]:
    """What makes the sample project, in order."""
    labels, database = folder / LABEL_MAP_FILE, folder / DATABASE_FILE
    return [
        Step(folder / MARKER, "semref:makesample", {"OUTPUT": str(folder)}, tr("Making the sample area")),
        Step(
            labels,
            "semref:rasterizeannotation",
            {
                "INPUT": str(folder / ANNOTATION_FILE),
                "CLASS_FIELD": CLASS_FIELD,
                "PRIORITY_FIELD": PRIORITY_FIELD,
                "CLASS_TABLE": str(folder / CLASSES_FILE),
                "PIXEL_SIZE": PIXEL_SIZE_M,
                "OUTPUT": str(labels),
            },
            tr("Rasterizing the sample area"),
        ),
        Step(
            database,
            "semref:builddatabase",
            {
                "LABELS": str(labels),
                "WINDOW_SIZE": WINDOW_SIZE_M,
                "STRIDE": STRIDE_M,
                "MINIMUM_AREA": MINIMUM_AREA_M2,
                "DATABASE": str(database),
            },
            tr("Building the sample’s reference database"),
        ),
    ]


def fill_project(project: QgsProject, folder: Path) -> QgsReferencedRectangle:
    """Adds the sample's layers, styled, to an empty project; gives the sample's extent."""
    photo = QgsRasterLayer(str(folder / ORTHOPHOTO_FILE), tr("Orthophoto"))
    labels = QgsRasterLayer(str(folder / LABEL_MAP_FILE), tr("Label map"))
    annotation = QgsVectorLayer(str(folder / ANNOTATION_FILE), tr("Land cover"), "ogr")
    annotation.setRenderer(
        annotation_renderer(read_class_table(str(folder / CLASSES_FILE)), CLASS_FIELD, PRIORITY_FIELD)
    )
    annotation.setOpacity(LAND_COVER_OPACITY)
    project.setTitle(tr("SemRef sample project"))
    project.setCrs(annotation.crs())
    # Bottom first.
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
