"""The dock: choose a database and images, localise them in the background, see each hit on the map; inspect windows."""

from __future__ import annotations

import os
from typing import List, Optional

from qgis.core import QgsProject, QgsVectorLayer
from qgis.gui import QgsDockWidget
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QFrame, QLabel, QProgressBar, QPushButton, QScrollArea, QTabWidget, QVBoxLayout, QWidget

from ..core.errors import DatabaseError, LabelMapError
from ..processing.translation import tr
from .background import DatabaseShelf, Reader
from .correct_tab import CorrectTab
from .database_layers import add_database_to_map
from .drapes import lay_on_map
from .findings import FIX, Finding, read_findings
from .highlight import HitHighlight
from .image_picture import ImagePicture, read_picture
from .inputs import AUTOMATIC, MARGIN_PX, DatabaseBox, ImageBox, MethodRow
from .inspect_tab import InspectTab
from .localization_run import LocalizationRun
from .messages import Messages
from .missing_notice import MissingNotice
from .prior_row import PriorRow
from .results import ResultsBox

UPDATE_DATABASE = "semref:updatedatabase"

LOCALIZE, INSPECT, CORRECT = range(3)
"""The dock's tabs."""


class SemRefDock(QgsDockWidget):
    """``shut_down`` before it is deleted: it cancels what runs and clears the canvas."""

    def __init__(self, canvas, message_bar, parent=None) -> None:
        super().__init__("SemRef", parent)
        # QGIS restores a dock's place by this name.
        self.setObjectName("SemRefDock")
        self.messages = Messages(message_bar)
        self._highlight: Optional[HitHighlight] = HitHighlight(canvas)
        self._positions: Optional[QgsVectorLayer] = None
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
        self._pictures = Reader(self)
        self._model_used = ""
        self._databases = Reader(self)
        self._lay_out()
        self._connect()
        self._show_idle()

    def shut_down(self) -> None:
        self.run.abandon()
        self.visibilityChanged.disconnect(self._follow_visibility)
        self._pictures.forget()
        self._databases.forget()
        self.inspect.shut_down()
        self.correct.shut_down()
        self.prior.shut_down()
        self._highlight.remove()
        self._highlight = self._positions = None

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
        self.run.cancel()
        self.results.show_findings([])
        self.prior.forget()
        self.method.choose(AUTOMATIC)
        self.database.file.setFilePath(database)
        self.images.model.setFilePath(model)
        self.images.list.show_only(images)
        self.setUserVisible(True)
        self.tabs.setCurrentIndex(0)

    def _lay_out(self) -> None:
        localize = QWidget()
        layout = QVBoxLayout(localize)
        layout.setContentsMargins(0, MARGIN_PX, 0, 0)
        for widget in (self.images, self.method, self.prior, self.localize_button, self.progress, self.state):
            layout.addWidget(widget)
        layout.addWidget(self.results, 1)
        self.tabs.setDocumentMode(True)
        for page, title in (
            (localize, tr("Localize")), (self.inspect, tr("Inspect")), (self.correct, tr("Correct")),
        ):  # fmt: skip
            self.tabs.addTab(_scrolling(page), title)
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
        self.localize_button.clicked.connect(self._localize_or_cancel)
        self.results.findingSelected.connect(self._show_hit)
        self.results.zoom.toggled.connect(self._zoom_if_asked)
        self.results.keepAsked.connect(self._keep_results)
        self.results.drapeAsked.connect(self._drape)
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
        for reader in (self._pictures, self._databases):
            reader.broke.connect(self.messages.bug)

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
        findings = read_findings(positions, footprints, places)
        self._positions = positions
        self._set_running(False)
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
        self._read_picture(finding)

    def _read_picture(self, finding: Optional[Finding]) -> None:
        self._pictures.forget()
        self.inspect.compare_with("", None)
        if finding is None:
            self.results.image.clear(tr("The selected image appears here."))
            return
        self.results.image.clear(tr("Reading…"))
        arguments = self._shelf, self.database.path(), finding.image, self._model_used
        self._pictures.read(tr("Reading an image"), _picture, *arguments)

    def _show_picture(self, picture: ImagePicture) -> None:
        self.results.image.show_picture(picture)
        self.inspect.compare_with(os.path.basename(picture.path), picture.vector)

    def _show_no_picture(self, sentence: str) -> None:
        self.results.image.clear(sentence)

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
        self._highlight.set_visible(not self.isHidden())

    def _add_database_to_map(self) -> None:
        try:
            add_database_to_map(self.database.path(), QgsProject.instance())
        except DatabaseError as error:
            self.messages.error(str(error))

    def _keep_results(self) -> None:
        # A copy: the user may remove the layer and keep the results again.
        QgsProject.instance().addMapLayer(self._positions.clone())
        self.messages.info(tr("The positions are a temporary layer of the project now; export it to keep them."))

    def _drape(self, finding: Finding) -> None:
        try:
            lay_on_map(finding, self.database.path())
        except LabelMapError as error:
            self.messages.error(str(error))


def _scrolling(page: QWidget) -> QScrollArea:
    """The dock can be made lower than a page's content, but not narrower."""
    area = QScrollArea()
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setWidgetResizable(True)
    area.setWidget(page)
    area.setMinimumWidth(page.minimumSizeHint().width() + area.verticalScrollBar().sizeHint().width())
    return area


def _picture(shelf: DatabaseShelf, database: str, image: str, model: str) -> ImagePicture:
    """In the background."""
    return read_picture(image, shelf.read(database), model)


class _ShorteningLabel(QLabel):
    """One line that shortens long file names in the middle instead of widening the dock."""

    _full_text = ""

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
