"""The dock: choose a database and images, localise them in the background, see each hit on the map."""

from __future__ import annotations

from typing import Optional

from qgis.core import QgsProject, QgsVectorLayer
from qgis.gui import QgsDockWidget
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QFrame, QLabel, QProgressBar, QPushButton, QScrollArea, QVBoxLayout, QWidget

from ..core.errors import DatabaseError
from ..processing.translation import tr
from .database_layers import add_database_to_map
from .findings import FIX, Finding, read_findings
from .highlight import HitHighlight
from .inputs import MARGIN_PX, DatabaseBox, ImageBox, MethodRow
from .localization_run import LocalizationRun
from .messages import Messages
from .results import ResultsBox


class SemRefDock(QgsDockWidget):
    """``shut_down`` before it is deleted: it cancels what runs and clears the canvas."""

    def __init__(self, canvas, message_bar, parent=None) -> None:
        super().__init__("SemRef", parent)
        # QGIS restores a dock's place by this name.
        self.setObjectName("SemRefDock")
        self._messages = Messages(message_bar)
        self._highlight: Optional[HitHighlight] = HitHighlight(canvas)
        self._positions: Optional[QgsVectorLayer] = None
        self.run = LocalizationRun(self)
        self.database = DatabaseBox()
        self.images = ImageBox()
        self.method = MethodRow()
        self.localize_button = QPushButton()
        self.progress = QProgressBar()
        self.state = _ShorteningLabel()
        self.results = ResultsBox()
        self._lay_out()
        self._connect()
        self._show_idle()

    def shut_down(self) -> None:
        self.run.abandon()
        self.visibilityChanged.disconnect(self._follow_visibility)
        self._highlight.remove()
        self._highlight = self._positions = None

    def _lay_out(self) -> None:
        content = QWidget()
        layout = QVBoxLayout(content)
        layout.setContentsMargins(MARGIN_PX, MARGIN_PX, MARGIN_PX, MARGIN_PX)
        for widget in (self.database, self.images, self.method, self.localize_button, self.progress, self.state):
            layout.addWidget(widget)
        layout.addWidget(self.results, 1)
        area = QScrollArea()
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setWidgetResizable(True)
        area.setWidget(content)
        # The dock can be made lower than its content, but not narrower.
        area.setMinimumWidth(content.minimumSizeHint().width() + area.verticalScrollBar().sizeHint().width())
        self.setWidget(area)

    def _connect(self) -> None:
        self.database.changed.connect(self._show_idle)
        self.database.addToMapAsked.connect(self._add_database_to_map)
        self.images.changed.connect(self._show_idle)
        self.localize_button.clicked.connect(self._localize_or_cancel)
        self.results.findingSelected.connect(self._show_hit)
        self.results.zoom.toggled.connect(self._zoom_if_asked)
        self.results.keepAsked.connect(self._keep_results)
        self.run.progressed.connect(self._show_progress)
        self.run.said.connect(self.state.show_text)
        self.run.found.connect(self._show_found)
        self.run.failed.connect(self._show_failure)
        self.run.broke.connect(self._show_bug)
        self.run.canceled.connect(self._show_canceled)
        self.visibilityChanged.connect(self._follow_visibility)

    # --- running ---

    def _localize_or_cancel(self) -> None:
        if self.run.running:
            self.localize_button.setEnabled(False)
            self.state.show_text(tr("Canceling…"))
            self.run.cancel()
            return
        if self.run.start(self.database.path(), self.images.paths(), self.method.method()):
            self._set_running(True)
            self.state.show_text(tr("Starting…"))

    def _set_running(self, running: bool) -> None:
        self.database.setEnabled(not running)
        self.images.setEnabled(not running)
        self.method.setEnabled(not running)
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

    def _show_found(self, positions: QgsVectorLayer, footprints: Optional[QgsVectorLayer]) -> None:
        findings = read_findings(positions, footprints)
        self._positions = positions
        self._set_running(False)
        fixes = sum(1 for finding in findings if finding.status == FIX)
        self.state.show_text(tr("{fixes} of {images} images have a fix.").format(fixes=fixes, images=len(findings)))
        self.results.show_findings(findings)

    def _show_failure(self, sentence: str) -> None:
        self._show_idle()
        self._messages.error(sentence)

    def _show_bug(self, report: str) -> None:
        self._show_idle()
        self._messages.bug(report)

    def _show_canceled(self) -> None:
        self._show_idle()
        self.state.show_text(tr("Canceled."))

    # --- the map ---

    def _show_hit(self, finding: Optional[Finding]) -> None:
        if not self._highlight.show(finding):
            self._messages.warning(
                tr("The hit lies outside the area of the project’s CRS; choose another one to see it.")
            )
        self._zoom_if_asked()

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
            self._messages.error(str(error))

    def _keep_results(self) -> None:
        # A copy: the user may remove the layer and keep the results again.
        QgsProject.instance().addMapLayer(self._positions.clone())
        self._messages.info(tr("The positions are a temporary layer of the project now; export it to keep them."))


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
