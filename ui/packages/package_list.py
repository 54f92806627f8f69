"""The list of packages on the options page: all of it is seen, what each is for on as many lines as that takes."""

from __future__ import annotations

from collections.abc import Sequence

from qgis.PyQt.QtCore import QEvent, QModelIndex, QRect, QSize, Qt
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import QHeaderView, QStyledItemDelegate, QStyleOptionViewItem, QTreeWidget

from ..widgets.tables import changes_font


class _Wrapped(QStyledItemDelegate):
    """Asks for the height that a text takes in its column; Qt's trees ask for one line, whatever its width."""

    def sizeHint(self, option: QStyleOptionViewItem, index: QModelIndex) -> QSize:
        """As Qt tells it, for the width that there is."""
        # Qt heeds the width of a rectangle that has a height alone.
        option.rect = QRect(0, 0, self.parent().columnWidth(index.column()), option.fontMetrics.height())
        return super().sizeHint(option, index)


class PackageList(QTreeWidget):
    """Never scrolls: one column is as wide as the others leave it, and the list as high as its rows."""

    def __init__(self, headings: Sequence[str], wrapped: int) -> None:
        """Without rows.

        Args:
            wrapped: The column whose texts are wrapped.
        """
        super().__init__()
        self.setHeaderLabels(headings)
        self.setRootIsDecorated(False)
        self.setWordWrap(True)
        self.setItemDelegateForColumn(wrapped, _Wrapped(self))
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        header = self.header()
        header.setStretchLastSection(False)
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(wrapped, QHeaderView.ResizeMode.Stretch)
        header.sectionResized.connect(self.fit)

    def fit(self, *_what_changed) -> None:
        """Makes it as high as its rows are now."""
        # Rows keep the heights that they had before the column's width changed, else.
        self.doItemsLayout()
        rows = (self.visualItemRect(self.topLevelItem(n)).height() for n in range(self.topLevelItemCount()))
        self.setFixedHeight(self.header().sizeHint().height() + sum(rows) + 2 * self.frameWidth())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self.fit()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if changes_font(event):
            self.fit()
