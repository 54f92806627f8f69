"""The dock: choose a database and images, localize them in the background, see each hit on the map; inspect windows."""

from __future__ import annotations

import os
from typing import List, Optional

from qgis.core import QgsProject, QgsSettings, QgsVectorLayer
from qgis.gui import QgsDockWidget
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtWidgets import (
    QFileDialog,
    QFrame,
    QLabel,
    QProgressBar,
    QPushButton,
    QScrollArea,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from ...core.errors import DatabaseError, LabelMapError, ParameterError
from ...processing.compat import wkt_for_gdal
from ...processing.exchange.results_file import open_results, write_results
from ...processing.translation import tr
from ..canvas.database_layers import add_database_to_map
from ..canvas.drapes import add_placed, place_image
from ..canvas.highlight import HitHighlight
from ..canvas.match_marks import MatchMarks
from ..packages.missing_notice import MissingNotice
from ..running.background import DatabaseShelf, Reader
from ..running.localization_run import LocalizationRun
from ..tabs.correct_tab import CorrectTab
from ..tabs.findings import FIX, Finding, read_findings
from ..tabs.image_picture import ImagePicture, PictureShelf
from ..tabs.inputs import AUTOMATIC, MARGIN_PX, DatabaseBox, ImageBox, MethodRow
from ..tabs.inspect_tab import InspectTab
from ..tabs.prior_row import PriorRow
from ..tabs.results import ResultsBox, runners_up_line
from .buttons import tool_button
from .messages import Messages
from .project_state import DockState, ProjectState

UPDATE_DATABASE = "semref:updatedatabase"

LOCALIZE, INSPECT, CORRECT = range(3)
"""The dock's tabs."""

_TAB_SETTING = "semref/dock/tab"
_RESULTS_FOLDER_SETTING = "semref/dock/results_folder"


class SemRefDock(QgsDockWidget):
    """``shut_down`` before it is deleted: it cancels what runs and clears the canvas."""

    helpAsked = pyqtSignal()

    def __init__(self, canvas, message_bar, parent=None) -> None:
        super().__init__("SemRef", parent)
        # QGIS restores a dock's place by this name.
        self.setObjectName("SemRefDock")
        self.messages = Messages(message_bar)
        self._highlight: Optional[HitHighlight] = HitHighlight(canvas)
        self._matches: Optional[MatchMarks] = MatchMarks(canvas)
        self._layers: tuple = (None, None, None)
        self._results_file = ""
        self.run = LocalizationRun(self)
        self.notice = MissingNotice()
        self.database = DatabaseBox()
        self.images = ImageBox()
        self.method = MethodRow()
        self.prior = PriorRow(canvas)
        self.localize_button = QPushButton()
        self.progress = QProgressBar()
        self.state = _ShorteningLabel()
        self.results = ResultsBox()
        self.inspect = InspectTab(canvas)
        self.correct = CorrectTab(canvas)
        self.tabs = QTabWidget()
        self._shelf = DatabaseShelf()
        self._picture_shelf = PictureShelf(self._shelf)
        self._pictures = Reader(self)
        self._model_used = ""
        self._databases = Reader(self)
        self._drapes = Reader(self)
        self._draped_name = ""
        self._lay_out()
        self._connect()
        self._state = ProjectState(self._state_now, self)
        self._state.opened.connect(self._restore)
        self._show_idle()

    def shut_down(self) -> None:
        self.run.abandon()
        self.visibilityChanged.disconnect(self._follow_visibility)
        self._state.shut_down()
        for reader in self._readers:
            reader.shut_down()
        for part in (self.database, self.inspect, self.correct, self.prior):
            part.shut_down()
        self._matches.remove()
        self._highlight.remove()
        self._highlight = self._matches = None
        self._layers = (None, None, None)

    def read_database(self):
        """The chosen database, None without one; for background threads. Raises DatabaseError."""
        path = self.database.chosen
        return self._shelf.read(path) if path else None

    def inspect_window(self, name: str) -> None:
        """Shows the window of this name in the second tab."""
        self.setUserVisible(True)
        self.tabs.setCurrentIndex(INSPECT)
        self.inspect.show_window(name)

    def prepare(self, database: str, model: str, images: List[str]) -> None:
        """Shows the dock with these images, the first one selected, ready to be localized by the automatic method."""
        self._show_state(DockState(database, model, AUTOMATIC, images, self.results.image.opacity.value()))
        self.setUserVisible(True)
        self.tabs.setCurrentIndex(LOCALIZE)

    # --- the project ---

    def _state_now(self) -> DockState:
        return DockState(
            self.database.path(),
            self.images.model_path(),
            self.method.method(),
            self.images.paths(),
            self.results.image.opacity.value(),
            self._results_file,
            self.prior.circle(),
        )

    def _show_state(self, state: DockState) -> None:
        self.run.cancel()
        self._show_layers((None, None, None), "", state.model)
        self.method.choose(state.method)
        self.database.file.setFilePath(state.database)
        self.images.model.setFilePath(state.model)
        self.images.list.show_only(state.images)
        self.results.image.opacity.setValue(state.opacity)
        self.prior.restore(state.prior)

    def _restore(self, state: DockState) -> None:
        """As it was when the project that is opened now was saved."""
        self._show_state(state)
        if not state.results:
            return
        try:
            self._show_layers(open_results(state.results), state.results, state.model)
        except ParameterError as error:
            self.messages.warning(str(error))

    def _lay_out(self) -> None:
        localize = QWidget()
        layout = QVBoxLayout(localize)
        layout.setContentsMargins(0, MARGIN_PX, 0, 0)
        for widget in (self.images, self.method, self.prior, self.localize_button, self.progress, self.state):
            layout.addWidget(widget)
        layout.addWidget(self.results, 1)
        self.tabs.setDocumentMode(True)
        for page, title in (
            (localize, tr("Localize")),
            (self.inspect, tr("Inspect")),
            (self.correct, tr("Correct")),
        ):
            self.tabs.addTab(_scrolling(page), title)
        self.help = tool_button("/mActionHelpContents.svg", tr("User guide"))
        self.help.setAutoRaise(True)
        self.tabs.setCornerWidget(self.help)
        self.tabs.setCurrentIndex(QgsSettings().value(_TAB_SETTING, LOCALIZE, type=int))
        content = QWidget()
        layout = QVBoxLayout(content)
        layout.setContentsMargins(MARGIN_PX, MARGIN_PX, MARGIN_PX, MARGIN_PX)
        layout.addWidget(self.notice)
        layout.addWidget(self.database)
        layout.addWidget(self.tabs, 1)
        self.setWidget(content)

    def _connect(self) -> None:
        self.database.changed.connect(self._show_idle)
        self.database.changed.connect(self._forget_database)
        self.database.addToMapAsked.connect(self._add_database_to_map)
        self.images.changed.connect(self._show_idle)
        self.images.refused.connect(self._refuse_layers)
        self.tabs.currentChanged.connect(self._remember_tab)
        self.help.clicked.connect(self.helpAsked)
        self.localize_button.clicked.connect(self._localize_or_cancel)
        self.results.findingSelected.connect(self._show_hit)
        self.results.zoom.toggled.connect(self._zoom_if_asked)
        self.results.keepAsked.connect(self._keep_results)
        self.results.saveAsked.connect(self._save_results)
        self.results.drapeAsked.connect(self._drape)
        self.results.copied.connect(self._show_copied)
        self.results.image.pointed.connect(self._point_at)
        self._matches.pointed.connect(self._point_at)
        self.run.progressed.connect(self._show_progress)
        self.run.said.connect(self.state.show_text)
        self.run.found.connect(self._show_found)
        self.run.failed.connect(self._show_failure)
        self.run.broke.connect(self._show_bug)
        self.run.canceled.connect(self._show_canceled)
        self.visibilityChanged.connect(self._follow_visibility)
        self.inspect.databaseWanted.connect(self._read_database)
        self.inspect.said.connect(self.messages.info)
        self.correct.updateAsked.connect(self._update_database)
        self._pictures.answered.connect(self._show_picture)
        self._pictures.failed.connect(self._show_no_picture)
        self._databases.answered.connect(self.inspect.use)
        self._databases.failed.connect(self.messages.error)
        self._drapes.answered.connect(self._show_drape)
        self._drapes.failed.connect(self.messages.error)
        self._readers = (self._pictures, self._databases, self._drapes)
        for reader in self._readers:
            reader.broke.connect(self.messages.bug)
        self.run.logged.connect(self.messages.log)

    # --- running ---

    def _localize_or_cancel(self) -> None:
        if self.run.running:
            self.localize_button.setEnabled(False)
            self.state.show_text(tr("Canceling…"))
            self.run.cancel()
            return
        settings = self.prior.parameters()
        if self.images.model_path():
            settings["MODEL"] = self.images.model_path()
        if self.run.start(self.database.path(), self.images.paths(), self.method.method(), settings):
            self._model_used = self.images.model_path()
            self._set_running(True)
            self.state.show_text(tr("Starting…"))

    def _set_running(self, running: bool) -> None:
        self.database.setEnabled(not running)
        self.images.setEnabled(not running)
        self.method.setEnabled(not running)
        self.prior.setEnabled(not running)
        self.progress.setVisible(running)
        self.progress.setValue(0)
        self.localize_button.setText(tr("Cancel") if running else tr("Localize"))
        self.localize_button.setEnabled(running or self._is_ready())

    def _is_ready(self) -> bool:
        return bool(self.database.path() and self.images.paths())

    def _show_idle(self) -> None:
        self.notice.use_model(self.images.model_path())
        self._set_running(False)
        if self._is_ready():
            self.state.show_text(tr("Ready to localize."))
        elif self.images.paths():
            self.state.show_text(tr("Choose a database."))
        elif self.database.path():
            self.state.show_text(tr("Add images."))
        else:
            self.state.show_text(tr("Choose a database and add images."))

    def _show_progress(self, percent: float) -> None:
        self.progress.setValue(round(percent))

    def _show_found(
        self,
        positions: QgsVectorLayer,
        footprints: Optional[QgsVectorLayer],
        places: Optional[QgsVectorLayer],
    ) -> None:
        self._set_running(False)
        self._show_layers((positions, footprints, places), "", self._model_used)
        # Whoever has the dock open sees it there.
        if not self.isUserVisible():
            self.messages.success(self.state.text_shown)

    def _show_layers(self, layers: tuple, file: str, model: str) -> None:
        """Results: positions, footprints and possible places, None for what there is not; ``file`` that holds them."""
        self._layers, self._results_file, self._model_used = layers, file, model
        findings = [] if layers[0] is None else read_findings(*layers)
        if findings:
            fixes = sum(1 for finding in findings if finding.status == FIX)
            self.state.show_text(tr("{fixes} of {images} images have a fix.").format(fixes=fixes, images=len(findings)))
        self.results.show_findings(findings)

    def _show_failure(self, sentence: str) -> None:
        self._show_idle()
        self.messages.error(sentence)

    def _show_bug(self, report: str) -> None:
        self._show_idle()
        self.messages.bug(report)

    def _show_canceled(self) -> None:
        self._show_idle()
        self.state.show_text(tr("Canceled."))

    # --- the map ---

    def _show_hit(self, finding: Optional[Finding]) -> None:
        if not self._highlight.show(finding):
            self.messages.warning(
                tr("The hit lies outside the area of the project’s CRS; choose another one to see it.")
            )
        self._zoom_if_asked()
        self._matches.show(None, None)
        self._read_picture(finding)

    def _read_picture(self, finding: Optional[Finding]) -> None:
        self._pictures.forget()
        self.inspect.compare_with("", None)
        if finding is None:
            self.results.image.clear(tr("The selected image appears here."))
            return
        self.results.image.clear(tr("Reading…"))
        arguments = finding.hit, self.database.path(), self._model_used
        self._pictures.read(tr("Reading an image"), self._picture_shelf.read, *arguments)

    def _show_picture(self, picture: ImagePicture) -> None:
        self.results.image.show_picture(picture)
        self.inspect.compare_with(os.path.basename(picture.path), picture.vector)
        self._matches.show(picture.matches, self.results.table.selected().crs)
        if picture.runners_up is not None:
            self._highlight.show_runners_up(picture.runners_up)
            self.results.details.add_lines([runners_up_line(picture.runners_up)])

    def _show_no_picture(self, sentence: str) -> None:
        self.results.image.clear(sentence)

    def _point_at(self, number: int) -> None:
        """One of the matched landmarks, in the image and on the map."""
        self.results.image.point_at(number)
        self._matches.point_at(number)

    def _read_database(self) -> None:
        """The inspected database, in the background."""
        if not self.database.path():
            self.messages.info(tr("Choose a database."))
            return
        self._databases.read(tr("Reading the database"), self._shelf.read, self.database.path())

    def _update_database(self, places: QgsVectorLayer) -> None:
        """Opens the algorithm's dialog: the corrected label map has to be chosen."""
        from processing import execAlgorithmDialog

        QgsProject.instance().addMapLayer(places)
        execAlgorithmDialog(UPDATE_DATABASE, {"DATABASE": self.database.path(), "CHANGED": places})

    def _forget_database(self) -> None:
        self._databases.forget()
        self.inspect.use(None)

    def _zoom_if_asked(self) -> None:
        if self.results.zoom.isChecked():
            self._highlight.zoom()

    def _follow_visibility(self) -> None:
        # A dock behind another one's tab is not hidden: its hit stays.
        for marks in (self._highlight, self._matches):
            marks.set_visible(not self.isHidden())

    def _add_database_to_map(self) -> None:
        try:
            add_database_to_map(self.database.path(), QgsProject.instance())
        except DatabaseError as error:
            self.messages.error(str(error))

    def _keep_results(self) -> None:
        # A copy: the user may remove the layer and keep the results again.
        QgsProject.instance().addMapLayer(self._layers[0].clone())
        self.messages.info(tr("The positions are a temporary layer of the project now; export it to keep them."))

    def _save_results(self) -> None:
        folder = QgsSettings().value(_RESULTS_FOLDER_SETTING, "", type=str)
        path, _ = QFileDialog.getSaveFileName(self, tr("Save results"), folder, tr("GeoPackage (*.gpkg)"))
        if not path:
            return
        path = path if path.lower().endswith(".gpkg") else f"{path}.gpkg"
        QgsSettings().setValue(_RESULTS_FOLDER_SETTING, os.path.dirname(path))
        try:
            write_results(path, self._layers)
            positions = open_results(path)[0]
        except ParameterError as error:
            self.messages.error(str(error))
            return
        self._results_file = path
        positions.setName(os.path.splitext(os.path.basename(path))[0])
        QgsProject.instance().addMapLayer(positions)
        self.messages.info(tr("Saved; the dock shows these results again when this project is opened."))

    def _drape(self, finding: Finding) -> None:
        self._draped_name = finding.name
        arguments = finding.image, finding.hit.footprint, wkt_for_gdal(finding.crs)
        self._drapes.read(tr("Laying an image on the map"), place_image, *arguments)

    def _show_drape(self, placed: str) -> None:
        try:
            add_placed(placed, self._draped_name, self.database.path(), QgsProject.instance())
        except LabelMapError as error:
            self.messages.error(str(error))

    def _show_copied(self, text: str) -> None:
        self.state.show_text(tr("Copied: {command}").format(command=text))

    def _refuse_layers(self, names: List[str]) -> None:
        sentence = tr("{layers}: not added, because a layer has to be one file of an image.")
        self.messages.warning(sentence.format(layers=", ".join(names)))

    def _remember_tab(self, tab: int) -> None:
        QgsSettings().setValue(_TAB_SETTING, tab)


def _scrolling(page: QWidget) -> QScrollArea:
    """The dock can be made lower than a page's content, but not narrower."""
    area = QScrollArea()
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setWidgetResizable(True)
    area.setWidget(page)
    area.setMinimumWidth(page.minimumSizeHint().width() + area.verticalScrollBar().sizeHint().width())
    return area


class _ShorteningLabel(QLabel):
    """One line that shortens long file names in the middle instead of widening the dock."""

    _full_text = ""

    @property
    def text_shown(self) -> str:
        """As a whole."""
        return self._full_text

    def show_text(self, text: str) -> None:
        self._full_text = text
        self._shorten()

    def minimumSizeHint(self):
        hint = super().minimumSizeHint()
        hint.setWidth(0)
        return hint

    def resizeEvent(self, event):
        super().resizeEvent(event)
        self._shorten()

    def _shorten(self) -> None:
        self.setText(self.fontMetrics().elidedText(self._full_text, Qt.TextElideMode.ElideMiddle, self.width()))
        self.setToolTip(self._full_text)
