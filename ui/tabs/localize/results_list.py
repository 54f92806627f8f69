"""List of results: two lines for each image, with one selected row."""

from __future__ import annotations

import os

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QModelIndex, QSize, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor, QFontMetrics, QIcon, QPaintEvent
from qgis.PyQt.QtWidgets import QListWidget, QListWidgetItem, QStyle, QStyledItemDelegate, QStyleOptionViewItem

from ....core.annotation import findings as annotation
from ....core.localization import Status
from ....processing.layers.localized_image import ERROR as UNREAD
from ....processing.layers.palette import WARNING
from ....processing.translation import tr
from ...findings import Finding, error_text, lat_lon_text, status_text
from ...widgets.controls import LIKELY, number_text, paint_placeholder, plain_tip, sign_icon

NAME_ROLE = Qt.ItemDataRole.UserRole
"""Role of the image's name, with which the text starts and which may be shortened."""

# QGIS draws these for light and dark themes alike.
_ICONS = {Status.FIX.key: "/mIconSuccess.svg", Status.LIKELY.key: LIKELY, UNREAD: annotation.ERROR}
_OTHER_ICON = "/mIconWarning.svg"
_FLIGHT_ICON = "/mIconLineLayer.svg"

_LIKELY_ROW = QColor(WARNING)
_LIKELY_ROW.setAlpha(50)
"""Transparent, so that the text can be read on light and dark themes."""

_DEGREE_DECIMALS = 5
_NAME_LEAST_PX = 48
_NAME_LETTERS = 12
"""Letters of a name that distinguish most photos."""

_BETWEEN = " · "
_ROW_MARGIN_PX = 4
_ROWS, _LEAST_ROWS = 3, 2


class ResultsList(QListWidget):
    """Image, status and error probability above position and 95 % radius, or the reason.

    Qt's own items, because Qt would call a Python model a dozen times for each painted row. Each call would wait for
    the threads that segment images.

    findingSelected: a Finding, or None if no row is selected.
    """

    findingSelected = pyqtSignal(object)

    def __init__(self) -> None:
        super().__init__()
        self.findings: list[Finding] = []
        self.setAccessibleName(tr("Results"))
        self.setItemDelegate(TwoLines(self))
        self.setAlternatingRowColors(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.itemSelectionChanged.connect(lambda: self.findingSelected.emit(self.selected()))

    def show_findings(self, findings: list[Finding]) -> None:
        """Show findings in their order, and select the first."""
        self.clear()
        self.findings = findings
        icons = {name: _draw_icon(name) for name in set(map(_icon, findings))}
        for finding in findings:
            self.addItem(_item(finding, icons[_icon(finding)]))
        self.findingSelected.emit(None)
        self.setCurrentRow(0)

    def selected(self) -> Finding | None:
        """Return the finding of the selected row; None without one."""
        rows = self.selectedIndexes()
        return self.findings[rows[0].row()] if rows else None

    def step(self, step: int) -> None:
        """Move the selection by ``step`` rows; the first row follows the last."""
        if self.count():
            self.setCurrentRow((self.currentRow() + step) % self.count())

    # --- QListWidget ---

    def sizeHint(self) -> QSize:
        return QSize(200, _ROWS * _row_height(self.fontMetrics()))

    def minimumSizeHint(self) -> QSize:
        return QSize(120, _LEAST_ROWS * _row_height(self.fontMetrics()))

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self.count():
            paint_placeholder(self, tr("Results appear here."))


class TwoLines(QStyledItemDelegate):
    """Paints the two lines of a result, and shortens the name of the image if needed."""

    def initStyleOption(self, option: QStyleOptionViewItem, index: QModelIndex) -> None:
        super().initStyleOption(option, index)
        lines = fit_name(index.data(), index.data(NAME_ROLE), option.fontMetrics, _room_px(option))
        # Qt converts line ends to this character before this call.
        option.text = lines.replace("\n", "\u2028")

    def sizeHint(self, option: QStyleOptionViewItem, index: QModelIndex) -> QSize:
        # The view makes each row as wide as itself.
        return QSize(0, _row_height(option.fontMetrics))


def _room_px(option: QStyleOptionViewItem) -> int:
    """Return the width for a row's text beside its icon, which each style draws in another size."""
    style, widget = option.widget.style(), option.widget
    margin = style.pixelMetric(QStyle.PixelMetric.PM_FocusFrameHMargin, option, widget) + 1
    return style.subElementRect(QStyle.SubElement.SE_ItemViewItemText, option, widget).width() - 2 * margin


def _row_height(metrics: QFontMetrics) -> int:
    return 2 * (metrics.height() + _ROW_MARGIN_PX)


def fit_name(text: str, name: str, metrics: QFontMetrics, width_px: int) -> str:
    """Return ``text`` with a shortened name at its start, so that the first line fits.

    The file suffix is removed first, because the number before it distinguishes the photos of a flight. If little of
    the name would remain, the status before the error probability is removed; the icon shows it as well.
    """
    above, _, below = text.partition("\n")
    rest = above[len(name) :]
    least = metrics.horizontalAdvance(name[:_NAME_LETTERS])
    if width_px - metrics.horizontalAdvance(rest) < least and rest.count(_BETWEEN) > 1:
        rest = _BETWEEN + rest.rpartition(_BETWEEN)[2]
    # Qt cuts off the end of a longer line. A status may lose it, because the reason follows; a number may not.
    least = _NAME_LEAST_PX if any(map(str.isdigit, rest)) else least
    room = max(width_px - metrics.horizontalAdvance(rest), least)
    if metrics.horizontalAdvance(name) > room:
        name = os.path.splitext(name)[0]
    return f"{metrics.elidedText(name, Qt.TextElideMode.ElideMiddle, room)}{rest}\n{below}"


def _item(finding: Finding, icon: QIcon) -> QListWidgetItem:
    item = QListWidgetItem(icon, _text(finding))
    item.setData(NAME_ROLE, finding.name)
    item.setToolTip(plain_tip("\n".join(filter(None, (finding.image, status_text(finding), finding.reason)))))
    if finding.is_likely:
        item.setBackground(_LIKELY_ROW)
    return item


def _icon(finding: Finding) -> str:
    if finding.speaks_against:
        return _OTHER_ICON
    if finding.status == Status.FIX and finding.is_by_flight:
        return _OTHER_ICON if finding.outvoted else _FLIGHT_ICON
    # A check mark means that the position was verified.
    if finding.status == Status.FIX and not finding.is_verified:
        return _OTHER_ICON
    return _ICONS.get(finding.status, _OTHER_ICON)


def _draw_icon(name: str) -> QIcon:
    return sign_icon(name) if name in (annotation.ERROR, LIKELY) else QgsApplication.getThemeIcon(name)


def _text(finding: Finding) -> str:
    """Return two lines: name, status and error probability; position and 95 % radius, or the reason."""
    position, error = lat_lon_text(finding, _DEGREE_DECIMALS), error_text(finding)
    if position and finding.error_95 is not None:
        position = f"{position} ± {number_text(finding.error_95, 1)} m"
    sure = tr("error {probability}").format(probability=error) if error else ""
    status, below = status_text(finding), position or finding.reason or ""
    if finding.speaks_against:
        # The first line may be too short for the status, and the icon does not show the reason.
        status, below = "", _BETWEEN.join(filter(None, (finding.speaks_against, below)))
    above = _BETWEEN.join(filter(None, (finding.name, status, sure)))
    return f"{above}\n{below}"
