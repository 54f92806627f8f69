"""Lower part of the tab *Localize*: table of results, selected image, and its details."""

from __future__ import annotations

from functools import partial

from qgis.core import QgsApplication, QgsProject, QgsSettings
from qgis.gui import QgsCollapsibleGroupBox
from qgis.PyQt.QtCore import QByteArray, Qt, QTimer, pyqtSignal
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import QMenu, QPushButton, QSplitter, QToolButton, QVBoxLayout, QWidget

from ....processing.translation import tr
from ...findings import Finding
from ...widgets.controls import shortcut, split_button, tool_button
from ...widgets.layouts import FoldingRow, content_of, name_fold, narrow, row_of
from .details import Details
from .image_view import ImageView
from .position_formats import DATABASE, FORMATS, format_title, position_text, possible_formats
from .results_table import ResultsTable

_ZOOM_SETTING = "semref/dock/zoom_to_hit"
_FORMAT_SETTING = "semref/dock/position_format"
_PARTS_SETTING = "semref/dock/results_parts_2"
_SHARES = 1, 5, 0
"""Shares of table, image and details in the remaining height."""

_PLAY_EVERY_MS = 700
"""Long enough to see each position, short enough for a hundred images."""


class _Parts(QSplitter):
    """Splitter that emits ``resized`` after its parts are resized."""

    resized = pyqtSignal()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.resized.emit()


class ResultsBox(QgsCollapsibleGroupBox):
    """Results with buttons. findingSelected: a Finding or None."""

    findingSelected = pyqtSignal(object)
    saveAsked = pyqtSignal()
    drapeAsked = pyqtSignal(object)
    copied = pyqtSignal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Results"), parent)
        self.setObjectName("SemRefResults")
        self.table = ResultsTable()
        self.image = ImageView()
        self.details = Details()
        # Icon only: in French its text is as wide as the rest of the row.
        self.zoom = tool_button("/mActionZoomToSelected.svg", tr("Zoom to the position"), checkable=True)
        self.zoom.setChecked(QgsSettings().value(_ZOOM_SETTING, True, type=bool))
        self._make_buttons()
        self._lay_out()
        self.table.findingSelected.connect(self._select)
        self.zoom.toggled.connect(self._remember_zoom)
        self.before.clicked.connect(lambda: self.table.step(-1))
        self.after.clicked.connect(lambda: self.table.step(1))
        self.save.clicked.connect(self._ask_to_save)
        self.drape.clicked.connect(self._drape)
        self.copy.clicked.connect(self._copy_as_before)
        self.formats.aboutToShow.connect(self._list_formats)
        self._select(None)
        self._allow_saving(False)
        self.play.setVisible(False)

    def _make_buttons(self) -> None:
        self.before = tool_button("/mActionArrowLeft.svg", tr("Previous image (Alt+Up)"))
        self.after = tool_button("/mActionArrowRight.svg", tr("Next image (Alt+Down)"))
        self.play = tool_button("/mTaskRunning.svg", tr("Show one image after the other"), checkable=True)
        self._player = QTimer(self)
        self._player.setInterval(_PLAY_EVERY_MS)
        self._player.timeout.connect(self._play_on)
        self.play.toggled.connect(self._play)
        for keys, button in (("Alt+Up", self.before), ("Alt+Down", self.after)):
            shortcut(keys, self).activated.connect(button.click)
        self.copy = split_button(
            tr("Copy position"), tr("Copy the position in the format used last. The arrow shows all formats.")
        )
        self.formats = QMenu(self.copy)
        self.copy.setMenu(self.formats)
        self.save = split_button(
            tr("Save results…"),
            tr(
                "Save positions, footprints and possible places in a GeoPackage. The dock shows them again with "
                "the project."
            ),
        )
        # The dock needs the same width with and without results.
        self.save.setMinimumWidth(self.save.sizeHint().width())
        more = QMenu(self.save)
        self.earlier = more.addMenu(tr("Earlier results"))
        self.save.setMenu(more)
        self.drape = QPushButton(tr("Add image to map"))
        self.drape.setToolTip(tr("Add the image to the project as a half-transparent layer at its position"))

    def _lay_out(self) -> None:
        self.parts = _Parts(Qt.Orientation.Vertical)
        self.parts.resized.connect(self.share_room)
        self.parts.setChildrenCollapsible(False)
        for part in (self.table, self.image, self.details):
            self.parts.addWidget(part)
        # The image gets most of the height.
        for number, share in enumerate(_SHARES):
            self.parts.setStretchFactor(number, share)
        self.parts.restoreState(QgsSettings().value(_PARTS_SETTING, QByteArray(), type=QByteArray))
        self.parts.splitterMoved.connect(self._remember_parts)
        layout = narrow(QVBoxLayout(content_of(self)), 0)
        layout.addWidget(self.parts, 1)
        layout.addLayout(row_of(self.before, self.after, self.play, self.zoom, (self.copy, 1)))
        layout.addWidget(FoldingRow(self.drape, self.save))
        name_fold(self)

    def share_room(self) -> None:
        """Give height that the picture does not need to table and details, unless the user moved the splitter."""
        if QgsSettings().contains(_PARTS_SETTING):
            return
        room = sum(self.parts.sizes())
        # The details get less than they need only if the height is small.
        details = max(self.details.minimumSizeHint().height(), min(self.details.sizeHint().height(), room // 5))
        both = room - details
        wanted = self.image.height_for_all(self.parts.width())
        least = max(self.table.minimumSizeHint().height(), both // (_SHARES[0] + _SHARES[1]))
        height = max(least, min(both - wanted, self.table.height_of_all())) if wanted else least
        spare = min(max(0, both - height - wanted), self.details.sizeHint().height()) if wanted else 0
        self.parts.setSizes([height, both - height - spare, details + spare])

    def show_findings(self, findings: list[Finding]) -> None:
        """Replace the results, and select the first one."""
        self.table.show_findings(findings)
        self._allow_saving(bool(findings))
        self.play.setChecked(False)
        self.play.setVisible(any(finding.track for finding in findings))

    def _allow_saving(self, on: bool) -> None:
        """Make the button save, or only open its menu of earlier results."""
        self._can_save = on
        mode = QToolButton.ToolButtonPopupMode
        self.save.setPopupMode(mode.MenuButtonPopup if on else mode.InstantPopup)
        self.save.setText(tr("Save results…") if on else tr("Earlier results"))

    def _play(self, checked: bool) -> None:
        if checked:
            self._player.start()
        else:
            self._player.stop()

    def _play_on(self) -> None:
        """Select the next image; stop at the last one."""
        if not self.table.step_on():
            self.play.setChecked(False)

    def _select(self, finding: Finding | None) -> None:
        self.details.show_finding(finding)
        has_position = finding is not None and finding.center is not None
        self.copy.setEnabled(has_position)
        self.drape.setEnabled(has_position and finding.heading is not None)
        for button in (self.before, self.after):
            button.setEnabled(finding is not None)
        self.findingSelected.emit(finding)

    def _ask_to_save(self) -> None:
        if self._can_save:
            self.saveAsked.emit()

    def _remember_zoom(self, checked: bool) -> None:
        QgsSettings().setValue(_ZOOM_SETTING, checked)

    def _remember_parts(self, *_moved) -> None:
        QgsSettings().setValue(_PARTS_SETTING, self.parts.saveState())

    def _drape(self) -> None:
        self.drapeAsked.emit(self.table.selected())

    # --- copying ---

    def _list_formats(self) -> None:
        self.formats.clear()
        finding, project = self.table.selected(), QgsProject.instance()
        for name in [] if finding is None else possible_formats(finding, project):
            text = position_text(finding, name, project)
            action = self.formats.addAction(f"{format_title(name, project)}: {text}")
            action.triggered.connect(partial(self._copy, name))

    def _copy_as_before(self) -> None:
        self._copy(QgsSettings().value(_FORMAT_SETTING, FORMATS[0], type=str))

    def _copy(self, name: str, *_checked) -> None:
        finding, project = self.table.selected(), QgsProject.instance()
        text = "" if finding is None else position_text(finding, name, project)
        # The database's CRS is always possible.
        text = text or position_text(finding, DATABASE, project)
        QgsSettings().setValue(_FORMAT_SETTING, name)
        QgsApplication.clipboard().setText(text)
        self.copied.emit(text)
