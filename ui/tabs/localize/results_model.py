"""Model of the table of results."""

from __future__ import annotations

from collections.abc import Sequence

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QObject, Qt
from qgis.PyQt.QtGui import QColor, QIcon, QStandardItem, QStandardItemModel

from ....core.annotation import findings as annotation
from ....core.localization import Status
from ....processing.base.localized_image import ERROR as UNREAD
from ....processing.layers.palette import WARNING
from ....processing.translation import tr
from ...findings import Finding, error_text, lon_lat_text, status_text
from ...widgets.tables import LIKELY, sign_icon
from ...widgets.texts import number_text, plain_tip

IMAGE, PROBABILITY, ERROR, HEADING, STATUS, WINDOW, DISTANCE, POSITION, SUMMARY = range(9)
COLUMN_COUNT = 9
ORDER = (SUMMARY, IMAGE, STATUS, POSITION, ERROR, PROBABILITY, HEADING, WINDOW, DISTANCE)
"""Columns from left to right. SUMMARY has two lines and replaces the others in a narrow dock."""

_DECIMALS = {ERROR: 1, HEADING: 1, DISTANCE: 3}
_DEGREE_DECIMALS = 5

SORT_ROLE = Qt.ItemDataRole.UserRole
NAME_ROLE = SORT_ROLE + 1
"""Role of SUMMARY: the image's name, with which the text starts and which may be shortened."""
NUMBER_COLUMNS = (PROBABILITY, ERROR, HEADING, DISTANCE)

# QGIS draws these for light and dark themes alike.
_ICONS = {Status.FIX.key: "/mIconSuccess.svg", Status.LIKELY.key: LIKELY, UNREAD: annotation.ERROR}
_OTHER_ICON = "/mIconWarning.svg"
_FLIGHT_ICON = "/mIconLineLayer.svg"

_LIKELY_ROW = QColor(WARNING)
_LIKELY_ROW.setAlpha(50)
"""Transparent, so that the text can be read on light and dark themes."""


class ResultsModel(QStandardItemModel):
    """One row for each finding.

    Qt's own model, because Qt would call a Python model a dozen times for each painted cell. Each call would wait for
    the threads that segment images.
    """

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(0, COLUMN_COUNT, parent)
        self._findings: list[Finding] = []
        self._show_headers()

    def show(self, findings: Sequence[Finding]) -> None:
        """Replace all rows."""
        self.clear()
        self.setColumnCount(COLUMN_COUNT)
        self._show_headers()
        self._findings = list(findings)
        icons = {name: _draw_icon(name) for name in {_icon(finding) for finding in findings}}
        for finding in self._findings:
            row = [_item(finding, column) for column in range(COLUMN_COUNT)]
            for column in (IMAGE, SUMMARY):
                row[column].setIcon(icons[_icon(finding)])
            self.appendRow(row)

    def is_empty(self, column: int) -> bool:
        """Return whether a column has no text in any row."""
        return not any(self.item(row, column).text() for row in range(self.rowCount()))

    def finding(self, row: int) -> Finding:
        """Return the finding of a row of this model."""
        return self._findings[row]

    def _show_headers(self) -> None:
        for column, (title, help_text) in enumerate(_headers()):
            self.setHeaderData(column, Qt.Orientation.Horizontal, title)
            self.setHeaderData(column, Qt.Orientation.Horizontal, help_text, Qt.ItemDataRole.ToolTipRole)


def _item(finding: Finding, column: int) -> QStandardItem:
    item = QStandardItem(_text(finding, column))
    item.setEditable(False)
    item.setData(_sort_value(finding, column), SORT_ROLE)
    if finding.is_likely:
        item.setBackground(_LIKELY_ROW)
    item.setToolTip(plain_tip("\n".join(filter(None, (finding.image, status_text(finding), finding.reason)))))
    if column == SUMMARY:
        item.setData(finding.name, NAME_ROLE)
    if column in NUMBER_COLUMNS:
        # Numbers are aligned to the right.
        item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
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


def _headers() -> list[tuple[str, str]]:
    """Return heading and tool tip of each column."""
    return [
        (tr("Image"), tr("File name of the image")),
        (tr("Error probability"), tr("Probability that the position is wrong")),
        (tr("Radius (m)"), tr("95 % radius in m: it contains the true position in 95 % of cases")),
        (tr("Heading"), tr("Direction of the image’s top, in degrees clockwise from grid north")),
        (tr("Status"), tr("Whether a position was found")),
        (tr("Window"), tr("Name of the matched window: its first column and row on the map")),
        (tr("Distance"), tr("Distance between the topology vectors: 0 is a perfect match, above 2 is no match")),
        (tr("Longitude, latitude"), tr("Position of the image’s center, in degrees (WGS 84)")),
        (tr("Image"), tr("File name, status, error probability, and position with its 95 % radius")),
    ]


def _text(finding: Finding, column: int) -> str:
    if column == IMAGE:
        return finding.name
    if column == STATUS:
        return status_text(finding)
    if column == WINDOW:
        return finding.window or ""
    if column == PROBABILITY:
        return error_text(finding)
    if column == POSITION:
        return lon_lat_text(finding, _DEGREE_DECIMALS)
    if column == SUMMARY:
        return _summary(finding)
    return _number(_figure(finding, column), _DECIMALS[column])


def _figure(finding: Finding, column: int) -> float | None:
    """Return the value of a number column."""
    if column == PROBABILITY:
        return finding.probability
    return {ERROR: finding.error_95, HEADING: finding.heading, DISTANCE: finding.distance}[column]


def _number(value: float | None, decimals: int) -> str:
    return "" if value is None else number_text(value, decimals)


def _summary(finding: Finding) -> str:
    """Return two lines: name, status and error probability; position and 95 % radius, or the reason."""
    position, error = lon_lat_text(finding, _DEGREE_DECIMALS), error_text(finding)
    if position and finding.error_95 is not None:
        position = f"{position} ± {number_text(finding.error_95, 1)} m"
    sure = tr("error {probability}").format(probability=error) if error else ""
    status, below = status_text(finding), position or finding.reason or ""
    if finding.speaks_against:
        # The first line may be too short for the status, and the icon does not show the reason.
        status, below = "", " · ".join(filter(None, (finding.speaks_against, below)))
    above = " · ".join(filter(None, (finding.name, status, sure)))
    return f"{above}\n{below}"


def _sort_value(finding: Finding, column: int) -> float | str:
    if column in NUMBER_COLUMNS:
        value = _figure(finding, column)
        return -1.0 if value is None else float(value)
    return _text(finding, column).lower()
