"""All data of one result as text."""

from __future__ import annotations

from html import escape

from qgis.PyQt.QtCore import QSize
from qgis.PyQt.QtGui import QTextOption
from qgis.PyQt.QtWidgets import QFrame, QTextEdit

from ....processing.messages.numbers import LocalTemplate
from ....processing.translation import tr
from ...findings import Finding, error_text, lon_lat_text, status_text, x_y_text

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
    """Lines of HTML."""
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
        lines.append(f"{tr('lon, lat')}: {lon_lat_text(finding)}")
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
            (finding.references, tr("{value} landmarks in the image")),
            (finding.inliers, tr("{value} agree with the map")),
        ),
        _joined((finding.window, tr("window {value}")), (finding.distance, tr("distance {value:.3f}"))),
    )
    return [escape(line) for line in lines if line]


def _joined(*measures: tuple[object | None, str]) -> str:
    """Join the texts of known values."""
    return ", ".join(LocalTemplate(text).format(value=value) for value, text in measures if value is not None)
