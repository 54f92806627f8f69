"""The table of results."""

from __future__ import annotations

from collections.abc import Sequence

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QObject, Qt
from qgis.PyQt.QtGui import QStandardItem, QStandardItemModel

from ....core.localization import Status
from ....processing.translation import tr
from ...findings import Finding, status_text
from ...widgets.tips import plain_tip

IMAGE, CONFIDENCE, ERROR, HEADING, STATUS, WINDOW, DISTANCE = range(7)
COLUMN_COUNT = 7
_DECIMALS = {CONFIDENCE: 2, ERROR: 1, HEADING: 1, DISTANCE: 3}
SORT_ROLE = Qt.ItemDataRole.UserRole
NUMBER_COLUMNS = (CONFIDENCE, ERROR, HEADING, DISTANCE)

# QGIS draws these for light and dark themes alike.
_ICONS = {Status.FIX.key: "/mIconSuccess.svg", "error": "/mIconCritical.svg"}
_OTHER_ICON = "/mIconWarning.svg"
_FLIGHT_ICON = "/mIconLineLayer.svg"


class ResultsModel(QStandardItemModel):
    """One row a finding. Qt's own model: one in Python would be asked a dozen times for each cell that is painted, and
    wait each time for the threads that segment images meanwhile."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(0, COLUMN_COUNT, parent)
        self._findings: list[Finding] = []
        self._show_headers()

    def show(self, findings: Sequence[Finding]) -> None:
        """Replaces all rows."""
        self.clear()
        self.setColumnCount(COLUMN_COUNT)
        self._show_headers()
        self._findings = list(findings)
        icons = {name: QgsApplication.getThemeIcon(name) for name in {_icon(finding) for finding in findings}}
        for finding in self._findings:
            row = [_item(finding, column) for column in range(COLUMN_COUNT)]
            row[IMAGE].setIcon(icons[_icon(finding)])
            self.appendRow(row)

    def finding(self, row: int) -> Finding:
        """The one that a row shows, whatever the view's order."""
        return self._findings[row]

    def _show_headers(self) -> None:
        for column, (title, help_text) in enumerate(zip(_headers(), _header_help())):
            self.setHeaderData(column, Qt.Orientation.Horizontal, title)
            self.setHeaderData(column, Qt.Orientation.Horizontal, help_text, Qt.ItemDataRole.ToolTipRole)


def _item(finding: Finding, column: int) -> QStandardItem:
    item = QStandardItem(_text(finding, column))
    item.setEditable(False)
    item.setData(_sort_value(finding, column), SORT_ROLE)
    item.setToolTip(plain_tip("\n".join(filter(None, (finding.image, status_text(finding), finding.reason)))))
    if column in NUMBER_COLUMNS:
        # Figures end at the same place.
        item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    return item


def _icon(finding: Finding) -> str:
    if finding.status == Status.FIX and finding.is_by_flight:
        return _OTHER_ICON if finding.outvoted else _FLIGHT_ICON
    # A check mark is for what was checked.
    if finding.status == Status.FIX and not finding.is_verified:
        return _OTHER_ICON
    return _ICONS.get(finding.status, _OTHER_ICON)


def _headers() -> list[str]:
    return [
        tr("Image"),
        tr("Confidence"),
        tr("Error (m)"),
        tr("Heading"),
        tr("Status"),
        tr("Window"),
        tr("Distance"),
    ]


def _header_help() -> list[str]:
    return [
        tr("File name of the image"),
        tr("Probability that the position is right; for the published method, how near the vectors are"),
        tr("Radius that holds the true position in 95 % of fixes, in meters"),
        tr("Where the image’s top points to, in degrees clockwise from grid north"),
        tr("Whether a position was found"),
        tr("Name of the matched window: its first column and row on the map"),
        tr("Distance of the topology vectors; 0 is a perfect match, above 2 there is none"),
    ]


def _text(finding: Finding, column: int) -> str:
    if column == IMAGE:
        return finding.name
    if column == STATUS:
        return status_text(finding)
    if column == WINDOW:
        return finding.window or ""
    if column == CONFIDENCE and finding.fixes_per_error is not None:
        return f"{finding.fixes_per_error:,.0f} : 1"
    return _number(_figure(finding, column), _DECIMALS[column])


def _figure(finding: Finding, column: int) -> float | None:
    """What a number column shows."""
    if column == CONFIDENCE:
        return finding.confidence if finding.status == Status.FIX else None
    return {ERROR: finding.error_95, HEADING: finding.heading, DISTANCE: finding.distance}[column]


def _number(value: float | None, decimals: int) -> str:
    return "" if value is None else f"{value:.{decimals}f}"


def _sort_value(finding: Finding, column: int) -> float | str:
    if column in NUMBER_COLUMNS:
        value = _figure(finding, column)
        return -1.0 if value is None else float(value)
    return _text(finding, column).lower()
