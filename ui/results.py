"""The lower part of the dock: the table of results and what is known of the selected one."""

from __future__ import annotations

from html import escape
from typing import List, Optional

from qgis.core import QgsApplication, QgsSettings
from qgis.gui import QgsCollapsibleGroupBox
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtGui import QTextOption
from qgis.PyQt.QtWidgets import QCheckBox, QFrame, QHBoxLayout, QPushButton, QSplitter, QTextEdit, QVBoxLayout

from ..processing.translation import tr
from .findings import Finding, status_text
from .image_view import ImageView
from .inputs import MARGIN_PX
from .results_table import ResultsTable

_ZOOM_SETTING = "semref/dock/zoom_to_hit"
_DETAIL_LINES = 7


class ResultsBox(QgsCollapsibleGroupBox):
    """Emits ``findingSelected`` with a Finding or None."""

    findingSelected = pyqtSignal(object)
    keepAsked = pyqtSignal()
    drapeAsked = pyqtSignal(object)

    def __init__(self, parent=None) -> None:
        super().__init__(tr("Results"), parent)
        self.setObjectName("SemRefResults")
        self.table = ResultsTable()
        self.image = ImageView()
        self.details = _Details()
        self.copy_degrees = QPushButton(tr("Copy longitude, latitude"))
        self.copy_map = QPushButton(tr("Copy x, y"))
        self.zoom = QCheckBox(tr("Zoom to hit"))
        self.zoom.setChecked(QgsSettings().value(_ZOOM_SETTING, True, type=bool))
        self.keep = QPushButton(tr("Keep results as layer"))
        self.keep.setToolTip(tr("Adds the positions to the project as a temporary point layer"))
        self.drape = QPushButton(tr("Lay image on map"))
        self.drape.setToolTip(tr("Adds the image to the project as a half-transparent layer, placed by its fix"))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(MARGIN_PX, MARGIN_PX, MARGIN_PX, MARGIN_PX)
        parts = QSplitter(Qt.Orientation.Vertical)
        parts.setChildrenCollapsible(False)
        parts.addWidget(self.table)
        parts.addWidget(self.image)
        parts.setStretchFactor(1, 1)
        layout.addWidget(parts, 1)
        layout.addWidget(self.details)
        layout.addLayout(_row(self.copy_degrees, self.copy_map))
        layout.addLayout(_row(self.drape, self.keep))
        layout.addWidget(self.zoom)
        self.table.findingSelected.connect(self._select)
        self.zoom.toggled.connect(self._remember_zoom)
        self.keep.clicked.connect(self.keepAsked)
        self.copy_degrees.clicked.connect(self._copy_degrees)
        self.copy_map.clicked.connect(self._copy_map)
        self.drape.clicked.connect(self._drape)
        self._select(None)
        self.keep.setEnabled(False)

    def show_findings(self, findings: List[Finding]) -> None:
        self.table.show_findings(findings)
        self.keep.setEnabled(bool(findings))

    def _select(self, finding: Optional[Finding]) -> None:
        self.details.show_finding(finding)
        has_position = finding is not None and finding.center is not None
        for button in (self.copy_degrees, self.copy_map):
            button.setEnabled(has_position)
        self.drape.setEnabled(has_position and finding.heading is not None)
        self.findingSelected.emit(finding)

    def _remember_zoom(self, checked: bool) -> None:
        QgsSettings().setValue(_ZOOM_SETTING, checked)

    def _drape(self) -> None:
        self.drapeAsked.emit(self.table.selected())

    def _copy_degrees(self) -> None:
        finding = self.table.selected()
        if finding is not None:
            QgsApplication.clipboard().setText(_degrees(finding))

    def _copy_map(self) -> None:
        finding = self.table.selected()
        if finding is not None:
            QgsApplication.clipboard().setText(_map_units(finding))


class _Details(QTextEdit):
    """Everything about one finding, to read and to select; long paths break anywhere, so nothing is cut off."""

    def __init__(self) -> None:
        super().__init__()
        self.setReadOnly(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.viewport().setAutoFillBackground(False)
        self.setWordWrapMode(QTextOption.WrapMode.WrapAtWordBoundaryOrAnywhere)
        self.setPlaceholderText(tr("Select a result to see its hit on the map."))
        margins = 2 * int(self.document().documentMargin())
        self.setFixedHeight(_DETAIL_LINES * self.fontMetrics().lineSpacing() + margins)

    def show_finding(self, finding: Optional[Finding]) -> None:
        self.setHtml("" if finding is None else "<br>".join(_lines(finding)))


def _lines(finding: Finding) -> List[str]:
    """Lines of HTML."""
    lines = [f"<b>{escape(finding.name)}</b>: {escape(status_text(finding))}"]
    if finding.reason:
        lines.append(escape(finding.reason))
    if finding.center is not None:
        lines.append(f"lon, lat: {_degrees(finding)}")
        lines.append(f"x, y: {_map_units(finding)} ({escape(finding.crs.authid())})")
    lines += _measures(finding)
    return lines


def _measures(finding: Finding) -> List[str]:
    """Lines of what the method tells about the match; each method tells other things."""
    confidence = finding.confidence if finding.center is not None else None
    lines = [
        [(confidence, tr("confidence {value:.2f}")), (finding.distance, tr("distance {value:.3f}"))],
        [(finding.window, tr("window {value}")), (finding.references, tr("{value} landmarks in the image"))],
        [(finding.heading, tr("heading {value:.1f}°")), (finding.pixel_size, tr("pixel size {value:.3g} m"))],
        [(finding.error_95, tr("within {value:.2f} m (95 %)"))],
    ]
    texts = [", ".join(text.format(value=value) for value, text in line if value is not None) for line in lines]
    return [escape(text) for text in texts if text]


def _degrees(finding: Finding) -> str:
    """Seven decimals are a centimetre."""
    return f"{finding.longitude:.7f}, {finding.latitude:.7f}"


def _map_units(finding: Finding) -> str:
    return f"{finding.x:.2f}, {finding.y:.2f}"


def _row(*widgets) -> QHBoxLayout:
    row = QHBoxLayout()
    for widget in widgets:
        row.addWidget(widget)
    return row
