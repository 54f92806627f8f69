"""Lower part of the tab *Localize*: list of results, selected image, and its details."""

from __future__ import annotations

from html import escape

from qgis.core import QgsSettings
from qgis.PyQt.QtCore import QByteArray, QSize, Qt
from qgis.PyQt.QtGui import QTextOption
from qgis.PyQt.QtWidgets import QFrame, QMenu, QPushButton, QSplitter, QTextEdit, QToolButton, QVBoxLayout

from ....processing.messages.numbers import LocalTemplate
from ....processing.translation import tr
from ...findings import Finding, error_text, lat_lon_text, status_text, x_y_text
from ...widgets.controls import remember, shortcut, tool_button
from ...widgets.layouts import FoldingBox, narrow, row_of
from .image_view import ImageView
from .results_list import ResultsList

_ZOOM_SETTING = "semref/dock/zoom_to_hit"
_PARTS_SETTING = "semref/dock/results_parts_3"
_SHARES = 2, 3, 0
"""Shares of list, image and details in the remaining height."""


class ResultsBox(FoldingBox):
    def __init__(self) -> None:
        super().__init__(tr("Results"), "SemRefResults")
        self.list = ResultsList()
        self.image = ImageView()
        self.details = Details()
        # Icon only: in French its text is as wide as the rest of the row.
        self.zoom = tool_button("/mActionZoomToSelected.svg", tr("Zoom to the position"), checkable=True)
        remember(self.zoom, _ZOOM_SETTING, True)
        self._make_buttons()
        self._lay_out()
        self.list.findingSelected.connect(self._select)
        self.before.clicked.connect(lambda: self.list.step(-1))
        self.after.clicked.connect(lambda: self.list.step(1))
        self._select(None)

    def _make_buttons(self) -> None:
        self.before = tool_button("/mActionArrowLeft.svg", tr("Previous image (Alt+Up)"))
        self.after = tool_button("/mActionArrowRight.svg", tr("Next image (Alt+Down)"))
        for keys, button in (("Alt+Up", self.before), ("Alt+Down", self.after)):
            shortcut(keys, self).activated.connect(button.click)
        self.drape = tool_button("/mActionAddLayer.svg", tr("Add image to map"))
        self.copy = QPushButton(tr("Copy position"))
        self.copy.setToolTip(tr("Copy latitude and longitude (WGS 84), as web maps read them"))
        self.save = QPushButton(tr("Save results…"))
        self.save.setToolTip(
            tr(
                "Save positions, footprints and possible places in a GeoPackage. The dock shows them again with "
                "the project."
            )
        )
        self.save.setEnabled(False)
        self.history = tool_button("/propertyicons/temporal.svg", tr("Earlier results"))
        self.earlier = QMenu(self.history)
        self.history.setMenu(self.earlier)
        self.history.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)

    def _lay_out(self) -> None:
        self.parts = QSplitter(Qt.Orientation.Vertical)
        self.parts.setChildrenCollapsible(False)
        for part in (self.list, self.image, self.details):
            self.parts.addWidget(part)
        for number, share in enumerate(_SHARES):
            self.parts.setStretchFactor(number, share)
        self.parts.restoreState(QgsSettings().value(_PARTS_SETTING, QByteArray(), type=QByteArray))
        self.parts.splitterMoved.connect(lambda *_: QgsSettings().setValue(_PARTS_SETTING, self.parts.saveState()))
        layout = narrow(QVBoxLayout(self.content), 0)
        layout.addWidget(self.parts, 1)
        layout.addLayout(row_of(self.before, self.after, self.zoom, self.drape, (self.copy, 1)))
        layout.addLayout(row_of((self.save, 1), self.history))

    def show_findings(self, findings: list[Finding]) -> None:
        """Replace the results, and select the first one."""
        self.list.show_findings(findings)
        self.save.setEnabled(bool(findings))

    def _select(self, finding: Finding | None) -> None:
        self.details.show_finding(finding)
        has_position = finding is not None and finding.center is not None
        self.copy.setEnabled(has_position)
        self.drape.setEnabled(has_position and finding.heading is not None)
        for button in (self.before, self.after):
            button.setEnabled(finding is not None)


_LINES, _LEAST_LINES = 5, 2


class Details(QTextEdit):
    """Read-only text about one finding. Lines break anywhere, so that long paths are not cut off."""

    def __init__(self) -> None:
        super().__init__()
        self.setReadOnly(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.viewport().setAutoFillBackground(False)
        self.setWordWrapMode(QTextOption.WrapMode.WrapAtWordBoundaryOrAnywhere)
        # Otherwise the Tab key would not leave this widget.
        self.setTabChangesFocus(True)
        self.setAccessibleName(tr("Details of the selected result"))
        self.setPlaceholderText(tr("Select a result to show its position on the map."))

    def show_finding(self, finding: Finding | None) -> None:
        """Show all data of a finding; nothing for None."""
        self.setHtml("<br>".join([] if finding is None else _lines(finding)))

    def sizeHint(self) -> QSize:
        return QSize(200, self._height_of(_LINES))

    def minimumSizeHint(self) -> QSize:
        return QSize(120, self._height_of(_LEAST_LINES))

    def _height_of(self, lines: int) -> int:
        return lines * self.fontMetrics().lineSpacing() + 2 * int(self.document().documentMargin())


def _lines(finding: Finding) -> list[str]:
    how_sure = _joined(
        (finding.confidence if finding.is_by_vector else None, tr("confidence {value:.2f}")),
        (error_text(finding) or None, tr("error probability {value}")),
        (finding.error_95, tr("95 % radius {value:.2f} m")),
    )
    head = f"<b>{escape(finding.name)}</b>: {escape(status_text(finding))}"
    lines = [f"{head}, {escape(how_sure)}" if how_sure else head]
    if finding.reason:
        lines.append(escape(finding.reason))
    if finding.search_capped:
        lines.append(
            escape(tr("The search was limited: common patterns were left out, so a better place may have been missed."))
        )
    if finding.center is not None:
        lines.append(f"{tr('lat, lon')}: {lat_lon_text(finding)}")
        lines.append(f"x, y: {x_y_text(finding)} ({escape(finding.crs.authid())})")
    lines += _measures(finding)
    if finding.camera:
        lines.append(escape(tr("camera: {camera}").format(camera=finding.camera)))
    return lines


def _measures(finding: Finding) -> list[str]:
    """Return lines with measures of the match, which differ between methods."""
    lines = (
        _joined((finding.heading, tr("heading {value:.1f}°")), (finding.pixel_size, tr("pixel size {value:.3g} m"))),
        _joined(
            (finding.references, tr("landmarks in the image: {value}")),
            (finding.inliers, tr("in agreement with the map: {value}")),
        ),
        _joined((finding.window, tr("window {value}")), (finding.distance, tr("distance {value:.3f}"))),
    )
    return [escape(line) for line in lines if line]


def _joined(*measures: tuple[object | None, str]) -> str:
    """Join the texts of known values."""
    return ", ".join(LocalTemplate(text).format(value=value) for value, text in measures if value is not None)
