"""Prepare QGIS's window with the dock and the sample project for the scenes."""

from pathlib import Path

import qgis.utils
from qgis.core import QgsProject
from qgis.PyQt.QtCore import QPoint, QRect, Qt
from qgis.PyQt.QtGui import QGuiApplication
from qgis.PyQt.QtWidgets import QDockWidget, QToolBar
from small_pictures import frame_name
from walking import settle, wait_until

WINDOW = 1280, 900
"""Size of QGIS's window, in device-independent pixels."""

DOCK_WIDTH = 400
# Toolbars that SemRef's users do not need.
KEPT_TOOLBARS = ("mFileToolBar", "mMapNavToolBar", "mAttributesToolBar", "mPluginToolBar")


class Session:
    """The window and the dock with the sample project.

    Attributes:
        taken: File names of the pictures.
        seen: Further results, for the caller of the session.
    """

    def __init__(self, job: dict) -> None:
        self.job = job
        self.iface = qgis.utils.iface
        self.window = self.iface.mainWindow()
        self.plugin = qgis.utils.plugins["semref"]
        self.dock = self.window.findChild(QDockWidget, "SemRefDock")
        self.toolbox = self.window.findChild(QDockWidget, "ProcessingToolbox")
        self.suffix = ""
        self.localized = False
        self.taken = []
        self.seen = {}
        self.photos = []

    def tidy(self) -> None:
        """Hide parts of the window that SemRef's users do not need."""
        for bar in self.window.findChildren(QToolBar):
            if bar.parent() is self.window:
                bar.setVisible(bar.objectName() in KEPT_TOOLBARS)
        for name in ("Browser", "LayerOrder", "ProcessingToolbox"):
            dock = self.window.findChild(QDockWidget, name)
            if dock is not None:
                dock.hide()
        self.window.showNormal()
        self.resize(*WINDOW)

    def open(self) -> None:
        """Open the sample project of the job; create it if it is missing."""
        self.tidy()
        if "sample" not in self.job:
            return
        self.plugin._entry._sample_project().make(Path(self.job["sample"]))
        wait_until(lambda: self.is_open() or failures(), "the sample project")
        if failures():
            raise RuntimeError(f"the sample project could not be created: {failures()}")
        self.iface.messageBar().clearWidgets()
        self.resize(*WINDOW)
        self.show_everything()
        self.photos = self.dock.content.localize.images.paths()

    def reset(self) -> None:
        """Restore window, dock and list of photos after a scene."""
        self.resize(*WINDOW)
        self.show_layers(True)
        self.toolbox.hide()
        self.fold_inputs(False)
        tab = self.dock.content.localize
        tab.images.flight.setChecked(False)
        if tab.images.paths() != self.photos:
            tab.images.list.show_only(self.photos)
        tab.results.zoom.setChecked(True)
        tab.prior.forget()

    def fold_inputs(self, folded: bool) -> None:
        for box in (self.dock.content.database, self.dock.content.localize.images):
            box.setCollapsed(folded)

    def is_open(self) -> bool:
        """Return whether the sample project is open and its images are in the dock."""
        return bool(QgsProject.instance().fileName()) and bool(self.dock.content.localize.images.paths())

    def resize(self, width: int, height: int, dock_width: int = DOCK_WIDTH) -> None:
        self.window.setGeometry(0, 0, width, height)
        settle(0.2)
        self.window.resizeDocks([self.dock], [dock_width], Qt.Orientation.Horizontal)
        layers = self.window.findChild(QDockWidget, "Layers")
        self.window.resizeDocks([layers], [190], Qt.Orientation.Horizontal)
        settle(0.3)

    def show_layers(self, shown: bool) -> None:
        """Hide the list of layers, because animations are small."""
        self.window.findChild(QDockWidget, "Layers").setVisible(shown)
        settle(0.3)

    def show_tab(self, tab: int) -> None:
        self.toolbox.hide()
        self.dock.setUserVisible(True)
        self.dock.content.tabs.setCurrentIndex(tab)
        settle(0.2)

    def show_everything(self) -> None:
        """Show the whole sample area without marks."""
        self.dock.content.localize.results.list.clearSelection()
        self.dock.content.inspect.forget_database()
        self.iface.mapCanvas().setReferencedExtent(QgsProject.instance().viewSettings().defaultViewExtent())
        self.iface.mapCanvas().refresh()

    def take(self, name: str, *widgets) -> None:
        """Take a picture of these widgets, or of the whole window without arguments."""
        self.settle_map()
        self._grab(f"{name}{self.suffix}.png", widgets)

    def frame(self, name: str, shown_ms: int, settled: bool = True) -> None:
        """Take a frame of an animation of the window. Without settling, it shows the current state of a run."""
        if settled:
            self.settle_map()
        self._grab(frame_name(f"{name}{self.suffix}", len(self.taken), shown_ms), ())

    def settle_map(self) -> None:
        self.iface.mapCanvas().waitWhileRendering()
        settle(1.0)
        # QGIS reports every task that took some time.
        self.iface.messageBar().clearWidgets()
        settle(0.5)

    def _grab(self, file_name: str, widgets: tuple) -> None:
        area = QRect()
        for widget in widgets or (self.window,):
            area = area.united(QRect(widget.mapToGlobal(QPoint(0, 0)), widget.size()))
        screen = QGuiApplication.primaryScreen()
        picture = screen.grabWindow(0, area.x(), area.y(), area.width(), area.height())
        file = Path(self.job["pictures"]) / file_name
        if picture.isNull() or not picture.save(str(file)):
            raise RuntimeError(f"{file} could not be written")
        self.taken.append(file.name)


def failures() -> list:
    """Return the most severe text of the message bar."""
    return [item.text() for item in qgis.utils.iface.messageBar().items() if int(item.level()) == 2]
