"""The view of the results: sortable, one row selected at a time."""

from __future__ import annotations

from qgis.PyQt.QtCore import QSize, QSortFilterProxyModel, Qt, pyqtSignal
from qgis.PyQt.QtGui import QPaintEvent, QResizeEvent
from qgis.PyQt.QtWidgets import QAbstractItemView, QTableView, QWidget

from ....processing.translation import tr
from ...findings import Finding
from ...widgets.placeholder import paint_placeholder
from .results_model import COLUMN_COUNT, CONFIDENCE, IMAGE, SORT_ROLE, ResultsModel

_IMAGE_COLUMN_MINIMUM_PX = 150
_ROW_MARGIN_PX = 4
_ROWS, _LEAST_ROWS = 6, 3


class ResultsTable(QTableView):
    """Emits ``findingSelected`` with a Finding, or None when no row is selected."""

    findingSelected = pyqtSignal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._model = ResultsModel(self)
        self._sorted = QSortFilterProxyModel(self)
        self._sorted.setSourceModel(self._model)
        self._sorted.setSortRole(SORT_ROLE)
        self.setModel(self._sorted)
        # Unsorted, in the order of the images, until a header is clicked.
        self.horizontalHeader().setSortIndicator(-1, Qt.SortOrder.AscendingOrder)
        self.setSortingEnabled(True)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.setWordWrap(False)
        self.setShowGrid(False)
        self.setAlternatingRowColors(True)
        self.setTabKeyNavigation(False)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 2 * _ROW_MARGIN_PX)
        self.horizontalHeader().setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        self.horizontalHeader().setHighlightSections(False)
        self._fit_columns()
        self.selectionModel().selectionChanged.connect(self._tell_selected)

    def show_findings(self, findings: list[Finding]) -> None:
        """Shows them in their order and selects the first."""
        # Resetting the model drops the selection without a signal.
        self._model.show(findings)
        self.sortByColumn(-1, Qt.SortOrder.AscendingOrder)
        self._fit_columns()
        self.findingSelected.emit(None)
        if findings:
            self.selectRow(0)

    def selected(self) -> Finding | None:
        """The finding of the selected row, None without one."""
        rows = self.selectionModel().selectedRows()
        return self._model.finding(self._sorted.mapToSource(rows[0]).row()) if rows else None

    def step(self, step: int) -> None:
        """Selects the row so many rows on, from the last to the first."""
        count = self.model().rowCount()
        if count:
            rows = self.selectionModel().selectedRows()
            row = rows[0].row() + step if rows else 0
            self.selectRow(row % count)
            self.scrollTo(self.model().index(row % count, 0))

    def step_on(self) -> bool:
        """Selects the next row; False where there is none."""
        rows = self.selectionModel().selectedRows()
        if rows and rows[0].row() + 1 >= self.model().rowCount():
            return False
        self.step(1)
        return True

    def sizeHint(self) -> QSize:
        return QSize(200, self._height_of(_ROWS))

    def minimumSizeHint(self) -> QSize:
        return QSize(120, self._height_of(_LEAST_ROWS))

    def _height_of(self, rows: int) -> int:
        return self.horizontalHeader().sizeHint().height() + rows * self.verticalHeader().defaultSectionSize()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_image_column()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self._model.rowCount():
            paint_placeholder(self, tr("Results appear here."))

    def _tell_selected(self, *_selection) -> None:
        self.findingSelected.emit(self.selected())

    def _fit_columns(self) -> None:
        for column in range(COLUMN_COUNT):
            self.resizeColumnToContents(column)
        self._fit_image_column()

    def _fit_image_column(self) -> None:
        """Fills the view: with all columns where they fit, else with image and confidence, the rest by scrolling."""
        width = self.viewport().width()
        others = sum(self.columnWidth(column) for column in range(COLUMN_COUNT) if column != IMAGE)
        if width - others < _IMAGE_COLUMN_MINIMUM_PX:
            others = self.columnWidth(CONFIDENCE)
        self.setColumnWidth(IMAGE, max(width - others, _IMAGE_COLUMN_MINIMUM_PX))
