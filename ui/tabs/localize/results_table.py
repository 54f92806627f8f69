"""Table of results: sortable, with one selected row."""

from __future__ import annotations

import os

from qgis.PyQt.QtCore import QEvent, QModelIndex, QSize, QSortFilterProxyModel, Qt, pyqtSignal
from qgis.PyQt.QtGui import QFontMetrics, QPaintEvent, QResizeEvent
from qgis.PyQt.QtWidgets import (
    QAbstractItemView,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QWidget,
)

from ....processing.translation import tr
from ...findings import Finding
from ...widgets.tables import changes_font, paint_placeholder, select_row
from .results_model import COLUMN_COUNT, IMAGE, NAME_ROLE, ORDER, SORT_ROLE, SUMMARY, ResultsModel

_IMAGE_COLUMN_MINIMUM_PX = 120
_ICON_AND_MARGINS_PX = 32
_NAME_LEAST_PX = 48
_NAME_LETTERS = 12
"""Letters of a name that distinguish most photos."""

_BETWEEN = " · "
_ROW_MARGIN_PX = 4
_ROWS, _LEAST_ROWS = 6, 4
"""Lines of text. In a narrow dock a result has two lines."""


class TwoLines(QStyledItemDelegate):
    """Paints the two lines of a result, and shortens the name of the image if needed."""

    def initStyleOption(self, option: QStyleOptionViewItem, index: QModelIndex) -> None:
        super().initStyleOption(option, index)
        name, text = index.data(NAME_ROLE) or "", index.data() or ""
        lines = fit_name(text, name, option.fontMetrics, option.rect.width() - _ICON_AND_MARGINS_PX)
        # Qt converts line ends to this character before this call.
        option.text = lines.replace("\n", "\u2028")


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
    room = max(width_px - metrics.horizontalAdvance(rest), _NAME_LEAST_PX)
    if metrics.horizontalAdvance(name) > room:
        name = os.path.splitext(name)[0]
    return f"{metrics.elidedText(name, Qt.TextElideMode.ElideMiddle, room)}{rest}\n{below}"


class ResultsTable(QTableView):
    """Table with all columns if they fit, otherwise with two lines a row.

    findingSelected: a Finding, or None if no row is selected.
    """

    findingSelected = pyqtSignal(object)
    _arranging = True

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._model = ResultsModel(self)
        self._sorted = QSortFilterProxyModel(self)
        self._sorted.setSourceModel(self._model)
        self._sorted.setSortRole(SORT_ROLE)
        self.setModel(self._sorted)
        self.setAccessibleName(tr("Results"))
        self._used = [column for column in ORDER if column != SUMMARY]
        self.setItemDelegateForColumn(SUMMARY, TwoLines(self))
        # In the order of the images until the user clicks a header.
        self.horizontalHeader().setSortIndicator(-1, Qt.SortOrder.AscendingOrder)
        self.setSortingEnabled(True)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        # The columns always fit. A scroll bar from a wider dock would remain.
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.setWordWrap(False)
        self.setShowGrid(False)
        self.setAlternatingRowColors(True)
        self.setTabKeyNavigation(False)
        self.verticalHeader().hide()
        self.horizontalHeader().setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        self.horizontalHeader().setHighlightSections(False)
        self._order_columns()
        self._arranging = False
        self._arrange()
        self.selectionModel().selectionChanged.connect(self._emit_selected)

    def show_findings(self, findings: list[Finding]) -> None:
        """Show findings in their order, and select the first."""
        # Resetting the model clears the selection without a signal.
        self._model.show(findings)
        self._order_columns()
        self.sortByColumn(-1, Qt.SortOrder.AscendingOrder)
        self._used = [c for c in ORDER if c != SUMMARY and not (findings and self._model.is_empty(c))]
        self._arrange()
        self.findingSelected.emit(None)
        if findings:
            self.selectRow(0)

    def selected(self) -> Finding | None:
        """Return the finding of the selected row; None without one."""
        rows = self.selectionModel().selectedRows()
        return self._model.finding(self._sorted.mapToSource(rows[0]).row()) if rows else None

    def selectRow(self, row: int) -> None:
        select_row(self, row)

    def step(self, step: int) -> None:
        """Move the selection by ``step`` rows; the first row follows the last."""
        count = self.model().rowCount()
        if count:
            rows = self.selectionModel().selectedRows()
            row = rows[0].row() + step if rows else 0
            self.selectRow(row % count)
            self.scrollTo(self.model().index(row % count, SUMMARY if self.is_narrow else IMAGE))

    def sizeHint(self) -> QSize:
        return QSize(200, self._height_of(_ROWS))

    def height_of_all(self) -> int:
        """Return the height of all rows."""
        header = 0 if self.is_narrow else self.horizontalHeader().height()
        return header + self.verticalHeader().length() + 2 * self.frameWidth()

    def minimumSizeHint(self) -> QSize:
        return QSize(120, self._height_of(_LEAST_ROWS))

    def _height_of(self, lines: int) -> int:
        return lines * (self.fontMetrics().height() + _ROW_MARGIN_PX)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._arrange()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if changes_font(event):
            self._arrange()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self._model.rowCount():
            paint_placeholder(self, tr("Results appear here."))

    def _emit_selected(self, *_selection) -> None:
        self.findingSelected.emit(self.selected())

    def _order_columns(self) -> None:
        """Order the columns; clearing the model resets their order."""
        header = self.horizontalHeader()
        for place, column in enumerate(ORDER):
            header.moveSection(header.visualIndex(column), place)

    @property
    def is_narrow(self) -> bool:
        """Whether rows have two lines instead of columns."""
        return not self.isColumnHidden(SUMMARY)

    def _arrange(self) -> None:
        """Show all non-empty columns if they fit, otherwise two lines a row."""
        if self._arranging:
            # Showing or hiding the header changes the scroll bar and the width, which would call this again.
            return
        self._arranging = True
        self._arrange_now()
        self._arranging = False

    def _arrange_now(self) -> None:
        header = self.horizontalHeader()
        for column in self._used:
            # A hidden column returns no width for its heading.
            self.setColumnHidden(column, False)
        wanted = {c: max(self.sizeHintForColumn(c), header.sectionSizeHint(c)) + 1 for c in self._used}
        wanted[IMAGE] = max(wanted[IMAGE], _IMAGE_COLUMN_MINIMUM_PX)
        # With the width of the scroll bar, which may appear with the header.
        beside = self.style().pixelMetric(QStyle.PixelMetric.PM_ScrollView_ScrollBarSpacing, None, self)
        bar = self.verticalScrollBar().sizeHint().width() + max(0, beside)
        narrow = sum(wanted.values()) > self.maximumViewportSize().width() - bar
        for column in range(COLUMN_COUNT):
            self.setColumnHidden(column, column != SUMMARY if narrow else column not in self._used)
        header.setVisible(not narrow)
        lines = 2 if narrow else 1
        self.verticalHeader().setDefaultSectionSize(lines * self.fontMetrics().height() + 2 * _ROW_MARGIN_PX)
        self.setTextElideMode(Qt.TextElideMode.ElideRight if narrow else Qt.TextElideMode.ElideMiddle)
        if narrow:
            self.setColumnWidth(SUMMARY, self.viewport().width())
            return
        for column, size in wanted.items():
            self.setColumnWidth(column, size)
        self.setColumnWidth(IMAGE, self.viewport().width() - sum(wanted.values()) + wanted[IMAGE])
