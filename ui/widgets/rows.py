"""What tables have in common: rows are selected in any direction of writing, and are as high as the font asks."""

from __future__ import annotations

from qgis.PyQt.QtCore import QEvent, QItemSelectionModel
from qgis.PyQt.QtWidgets import QTableView

_FLAGS = QItemSelectionModel.SelectionFlag


def select_row(view: QTableView, row: int) -> None:
    """Selects a row and makes it the current one.

    Qt's own looks for a column at the edge where writing begins. From right to left there is none when the columns
    just fill the view, and nothing would be selected.
    """
    header = view.horizontalHeader()
    shown = (column for column in range(view.model().columnCount()) if not header.isSectionHidden(column))
    index = view.model().index(row, next(shown, 0))
    view.selectionModel().setCurrentIndex(index, _FLAGS.ClearAndSelect | _FLAGS.Rows)
    view.scrollTo(index)


def changes_font(event: QEvent) -> bool:
    """Whether an event may bring another font: QGIS's, and its size, come by a style sheet after a widget is made."""
    return event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange, QEvent.Type.Polish)
