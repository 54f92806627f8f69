"""Shell of the dock. Its content is created when the dock opens and the required packages are installed."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from qgis.core import QgsProject, QgsSettings
from qgis.gui import QgsDockWidget, QgsMapCanvas, QgsMessageBar
from qgis.PyQt.QtCore import Qt, QTimer
from qgis.PyQt.QtGui import QShowEvent
from qgis.PyQt.QtWidgets import QMainWindow, QVBoxLayout, QWidget

from ...core.localization import Method
from ...processing.layers.database_layers import OPENED, reload_raster
from ...processing.translation import tr
from ..packages.missing_notice import MissingNotice
from ..project_state import DATABASE_SETTING, DockState, read_state, write_state
from ..running.background import shut_down
from ..widgets.layouts import narrow
from ..widgets.messages import Messages, open_file

if TYPE_CHECKING:
    from ..set_up_area import SetUpAreaDialog
    from .content import DockContent


FIRST_WIDTH_PX, LEAST_WINDOW_PX = 400, 1200
"""Width of the dock when it opens for the first time, in windows of at least this width. Later QGIS restores it."""

_SIZED_SETTING = "semref/dock/sized"


class SemRefDock(QgsDockWidget):
    """Dock widget. Call ``shut_down`` before deleting it."""

    def __init__(self, canvas: QgsMapCanvas, message_bar: QgsMessageBar, parent: QWidget | None = None) -> None:
        super().__init__("SemRef", parent)
        # QGIS restores the place of a dock by this name.
        self.setObjectName("SemRefDock")
        self.messages = Messages(message_bar)
        self.notice = MissingNotice()
        whole = QWidget()
        self._layout = narrow(QVBoxLayout(whole))
        self._layout.addWidget(self.notice)
        # Keeps the notice at the top while there is no content.
        self._layout.addStretch()
        self.setWidget(whole)
        self._canvas = canvas
        self._content: DockContent | None = None
        self.setting_up: SetUpAreaDialog | None = None
        self._opens = False
        project = QgsProject.instance()
        # A project may be open when the plugin is loaded.
        self._wanted_state: DockState | None = read_state(project)
        project.readProject.connect(self._restore)
        project.writeProject.connect(self._write)
        project.cleared.connect(self._forget)
        OPENED.database.connect(self.choose_database)
        OPENED.raster.connect(self._reload_raster)
        self.visibilityChanged.connect(self._follow_visibility)

    def let_open(self) -> None:
        """Create the content whenever the dock is shown from now on. QGIS shows each dock once when it is added."""
        self._opens = True
        if not self.isHidden():
            self.fill()

    def fill(self) -> None:
        """Show the content, or the packages that it needs."""
        self.notice.refresh()
        if not self.notice.blocks:
            self.content.show()

    @property
    def content(self) -> DockContent:
        """Content; created on first use, because its modules load slowly and many sessions never open the dock."""
        if self._content is None:
            self._content = self._make_content()
        return self._content

    def _make_content(self) -> DockContent:
        from .content import DockContent

        content = DockContent(self._canvas, self.messages)
        content.localize.found.connect(self._show_found)
        content.database.set_up.clicked.connect(self.set_up_area)
        images = content.localize.images
        images.changed.connect(lambda: self.notice.use_model(images.model_path()))
        self.notice.use_model(images.model_path())
        self._layout.addWidget(content, 1)
        if self._wanted_state is not None:
            content.localize.show_state(self._wanted_state)
        return content

    def shut_down(self) -> None:
        """Cancel runs and clear the canvas."""
        self.visibilityChanged.disconnect(self._follow_visibility)
        project = QgsProject.instance()
        project.readProject.disconnect(self._restore)
        project.writeProject.disconnect(self._write)
        project.cleared.disconnect(self._forget)
        OPENED.database.disconnect(self.choose_database)
        OPENED.raster.disconnect(self._reload_raster)
        self._opens = False
        if self.setting_up is not None:
            self.setting_up.shut_down()
            self.setting_up = None
        shut_down(self)

    def prepare(self, database: str, model: str, images: list[str], results: str = "", is_flight: bool = False) -> None:
        """Show the dock with database, model, images and results, and the automatic method."""
        from .content import LOCALIZE

        state = DockState(database, model, Method.AUTOMATIC.number, images, results, is_flight=is_flight)
        self.content.localize.show_state(state)
        self.setUserVisible(True)
        self.content.tabs.setCurrentIndex(LOCALIZE)

    def set_up_area(self) -> None:
        """Open the dialog *Set up an area*, or show it again."""
        self.setUserVisible(True)
        self.fill()
        if self.notice.blocks:
            return
        if self.setting_up is None:
            from ..set_up_area import SetUpAreaDialog

            self.setting_up = SetUpAreaDialog(self.content.localize.images.model_path(), self.window())
            self.setting_up.finished_with.connect(self._show_area)
        self.setting_up.choose_layers()
        self.setting_up.show()
        self.setting_up.raise_()

    def _show_area(self, results: dict, given: dict) -> None:
        """Show map, landmarks and positions in the project, and the photos in the dock."""
        from ..set_up_area import add_area

        results_file = add_area(results, given, QgsProject.instance())
        chosen = results["DATABASE"], results["TRAINED_MODEL"], given["PHOTOS"]
        self.prepare(*chosen, results_file, given["FLIGHT"])
        self.messages.success_with(tr("The area is set up."), tr("Open report"), partial(open_file, results["REPORT"]))

    def choose_database(self, path: str) -> None:
        """Choose a database, also one that was replaced under the same name."""
        QgsSettings().setValue(DATABASE_SETTING, path)
        if self._content is not None:
            self._content.database.choose(path)
        elif self._wanted_state is not None:
            self._wanted_state = replace(self._wanted_state, database=path)

    def _reload_raster(self, path: str) -> None:
        reload_raster(path, QgsProject.instance())

    def refresh_notice(self) -> None:
        """Check again which packages are missing."""
        if self._opens and not self.isHidden():
            self.fill()

    # --- the project ---

    def _restore(self, *_document) -> None:
        state = read_state(QgsProject.instance())
        if self._content is None:
            self._wanted_state = state
        elif state is not None:
            self._content.localize.show_state(state)

    def _write(self, *_document) -> None:
        # A dock that was never opened has the state of its project.
        state = self._wanted_state if self._content is None else self._content.localize.state_now()
        if state is not None:
            write_state(QgsProject.instance(), state)

    def _forget(self) -> None:
        self._wanted_state = None
        if self._content is not None:
            self._content.localize.show_state(DockState())

    # --- the window ---

    def showEvent(self, event: QShowEvent) -> None:
        if self._opens:
            self.fill()
            if not QgsSettings().value(_SIZED_SETTING, False, type=bool):
                QgsSettings().setValue(_SIZED_SETTING, True)
                # Later, when the window has laid out the dock.
                QTimer.singleShot(0, self._widen)
        super().showEvent(event)

    def _widen(self) -> None:
        window = self.parent()
        if isinstance(window, QMainWindow) and window.width() >= LEAST_WINDOW_PX and self.width() < FIRST_WIDTH_PX:
            window.resizeDocks([self], [FIRST_WIDTH_PX], Qt.Orientation.Horizontal)

    def _follow_visibility(self) -> None:
        # A dock behind the tab of another dock is not hidden: its marks stay.
        if self._content is not None:
            self._content.localize.hit.set_visible(not self.isHidden())

    def _show_found(self, sentence: str) -> None:
        # An open dock shows the sentence itself.
        if not self.isUserVisible():
            self.messages.success(sentence)
