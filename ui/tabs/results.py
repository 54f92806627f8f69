"""The lower part of the dock: the table of results and what is known of the selected one."""

from __future__ import annotations

from functools import partial
from html import escape
from typing import List, Optional

from qgis.core import QgsApplication, QgsProject, QgsSettings
from qgis.gui import QgsCollapsibleGroupBox
from qgis.PyQt.QtCore import QByteArray, QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QKeySequence, QTextOption
from qgis.PyQt.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QMenu,
    QPushButton,
    QShortcut,
    QSizePolicy,
    QSplitter,
    QTextEdit,
    QToolButton,
    QVBoxLayout,
)

from ...processing.translation import tr
from ..dock.buttons import tool_button
from .findings import Finding, status_text
from .image_picture import RunnersUp
from .image_view import ImageView
from .inputs import MARGIN_PX
from .position_formats import DATABASE, DEGREES, FORMATS, format_title, position_text, possible_formats
from .results_table import ResultsTable

_ZOOM_SETTING = "semref/dock/zoom_to_hit"
_FORMAT_SETTING = "semref/dock/position_format"
_PARTS_SETTING = "semref/dock/results_parts"
_DETAIL_LINES, _LEAST_DETAIL_LINES = 6, 4


class ResultsBox(QgsCollapsibleGroupBox):
    """Emits ``findingSelected`` with a Finding or None."""

    findingSelected = pyqtSignal(object)
    keepAsked = pyqtSignal()
    saveAsked = pyqtSignal()
    drapeAsked = pyqtSignal(object)
    copied = pyqtSignal(str)

    def __init__(self, parent=None) -> None:
        super().__init__(tr("Results"), parent)
        self.setObjectName("SemRefResults")
        self.table = ResultsTable()
        self.image = ImageView()
        self.details = _Details()
        # A picture only: in French its name is as wide as the rest of the row.
        self.zoom = tool_button("/mActionZoomToSelected.svg", tr("Zoom to hit"))
        self.zoom.setCheckable(True)
        self.zoom.setChecked(QgsSettings().value(_ZOOM_SETTING, True, type=bool))
        self._make_buttons()
        self._lay_out()
        self.table.findingSelected.connect(self._select)
        self.zoom.toggled.connect(self._remember_zoom)
        self.before.clicked.connect(lambda: self.table.step(-1))
        self.after.clicked.connect(lambda: self.table.step(1))
        self.keep.clicked.connect(self.keepAsked)
        self.save.triggered.connect(self.saveAsked)
        self.drape.clicked.connect(self._drape)
        self.copy.clicked.connect(self._copy_as_before)
        self.formats.aboutToShow.connect(self._list_formats)
        self._select(None)
        self.keep.setEnabled(False)

    def _make_buttons(self) -> None:
        self.before = tool_button("/mActionArrowLeft.svg", tr("Image before (Alt+Up)"))
        self.after = tool_button("/mActionArrowRight.svg", tr("Next image (Alt+Down)"))
        self._shortcuts = []
        for keys, button in (("Alt+Up", self.before), ("Alt+Down", self.after)):
            shortcut = QShortcut(QKeySequence(keys), self)
            shortcut.setContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            shortcut.activated.connect(button.click)
            self._shortcuts.append(shortcut)
        self.copy = _split_button(tr("Copy position"), tr("Copies the position as chosen last; the arrow shows how"))
        self.formats = QMenu(self.copy)
        self.copy.setMenu(self.formats)
        self.keep = _split_button(
            tr("Keep results as layer"), tr("Adds the positions to the project as a temporary point layer")
        )
        more = QMenu(self.keep)
        self.save = more.addAction(tr("Save results to a file…"))
        self.save.setToolTip(tr("Positions, footprints and possible places as one GeoPackage, opened with the project"))
        self.keep.setMenu(more)
        self.drape = QPushButton(tr("Lay image on map"))
        self.drape.setToolTip(tr("Adds the image to the project as a half-transparent layer, placed by its fix"))

    def _lay_out(self) -> None:
        self.parts = QSplitter(Qt.Orientation.Vertical)
        self.parts.setChildrenCollapsible(False)
        for part in (self.table, self.image, self.details):
            self.parts.addWidget(part)
        self.parts.setStretchFactor(1, 1)
        self.parts.restoreState(QgsSettings().value(_PARTS_SETTING, QByteArray(), type=QByteArray))
        self.parts.splitterMoved.connect(self._remember_parts)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(MARGIN_PX, MARGIN_PX, MARGIN_PX, MARGIN_PX)
        layout.addWidget(self.parts, 1)
        steps = _row(self.before, self.after, self.zoom, self.copy)
        steps.setStretchFactor(self.copy, 1)
        layout.addLayout(steps)
        layout.addLayout(_row(self.drape, self.keep))

    def show_findings(self, findings: List[Finding]) -> None:
        self.table.show_findings(findings)
        self.keep.setEnabled(bool(findings))

    def _select(self, finding: Optional[Finding]) -> None:
        self.details.show_finding(finding)
        has_position = finding is not None and finding.center is not None
        self.copy.setEnabled(has_position)
        self.drape.setEnabled(has_position and finding.heading is not None)
        for button in (self.before, self.after):
            button.setEnabled(finding is not None)
        self.findingSelected.emit(finding)

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
        # Where the way chosen last is not possible, the database's CRS always is.
        text = text or position_text(finding, DATABASE, project)
        QgsSettings().setValue(_FORMAT_SETTING, name)
        QgsApplication.clipboard().setText(text)
        self.copied.emit(text)


def _split_button(text: str, help_text: str) -> QToolButton:
    """A button with an arrow for more of its kind."""
    button = QToolButton()
    button.setText(text)
    button.setToolTip(help_text)
    button.setPopupMode(QToolButton.ToolButtonPopupMode.MenuButtonPopup)
    button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
    return button


class _Details(QTextEdit):
    """Everything about one finding, to read and to select; long paths break anywhere, so nothing is cut off."""

    def __init__(self) -> None:
        super().__init__()
        self.setReadOnly(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.viewport().setAutoFillBackground(False)
        self.setWordWrapMode(QTextOption.WrapMode.WrapAtWordBoundaryOrAnywhere)
        self.setPlaceholderText(tr("Select a result to see its hit on the map."))
        self._lines: List[str] = []

    def show_finding(self, finding: Optional[Finding]) -> None:
        self._lines = [] if finding is None else _lines(finding)
        self.setHtml("<br>".join(self._lines))

    def add_lines(self, lines: List[str]) -> None:
        """Lines of HTML that became known later."""
        self.setHtml("<br>".join([*self._lines, *lines]))

    def sizeHint(self):
        return QSize(200, self._height_of(_DETAIL_LINES))

    def minimumSizeHint(self):
        return QSize(120, self._height_of(_LEAST_DETAIL_LINES))

    def _height_of(self, lines: int) -> int:
        return lines * self.fontMetrics().lineSpacing() + 2 * int(self.document().documentMargin())


def _lines(finding: Finding) -> List[str]:
    """Lines of HTML."""
    how_sure = _joined(
        (finding.confidence if finding.center is not None else None, tr("confidence {value:.2f}")),
        (finding.error_95, tr("within {value:.2f} m (95 %)")),
    )
    head = f"<b>{escape(finding.name)}</b>: {escape(status_text(finding))}"
    lines = [f"{head}, {escape(how_sure)}" if how_sure else head]
    if finding.reason:
        lines.append(escape(finding.reason))
    if finding.center is not None:
        project = QgsProject.instance()
        lines.append(f"{tr('lon, lat')}: {position_text(finding, DEGREES, project)}")
        lines.append(f"x, y: {position_text(finding, DATABASE, project)} ({escape(finding.crs.authid())})")
    lines += _measures(finding)
    return lines


def _measures(finding: Finding) -> List[str]:
    """Lines of what the method tells about the match; each method tells other things."""
    lines = (
        _joined((finding.heading, tr("heading {value:.1f}°")), (finding.pixel_size, tr("pixel size {value:.3g} m"))),
        _joined(
            (finding.references, tr("{value} landmarks in the image")),
            (finding.inliers, tr("{value} agree with the map")),
        ),
        _joined((finding.window, tr("window {value}")), (finding.distance, tr("distance {value:.3f}"))),
    )
    return [escape(line) for line in lines if line]


def _joined(*measures) -> str:
    """Values that are known, each in its text."""
    return ", ".join(text.format(value=value) for value, text in measures if value is not None)


def runners_up_line(windows: RunnersUp) -> str:
    """HTML: the windows after the best one, with the distances of their vectors."""
    texts = [f"{name} ({distance:.3f})" for name, distance in zip(windows.names, windows.distances)]
    return escape(tr("next best: {windows}").format(windows=", ".join(texts)))


def _row(*widgets) -> QHBoxLayout:
    row = QHBoxLayout()
    for widget in widgets:
        row.addWidget(widget)
    return row
