"""List of packages on the options page, without scroll bars and with wrapped texts."""

from __future__ import annotations

from collections.abc import Sequence

from qgis.PyQt.QtCore import QEvent, QModelIndex, QRect, QSize, Qt
from qgis.PyQt.QtGui import QResizeEvent
from qgis.PyQt.QtWidgets import QHeaderView, QStyledItemDelegate, QStyleOptionViewItem, QTreeWidget

from ..widgets.tables import changes_font


class _Wrapped(QStyledItemDelegate):
    """Delegate that returns the height of wrapped text; Qt's trees return the height of one line."""

    def sizeHint(self, option: QStyleOptionViewItem, index: QModelIndex) -> QSize:
        # Qt uses the width only if the rectangle has a height.
        option.rect = QRect(0, 0, self.parent().columnWidth(index.column()), option.fontMetrics.height())
        return super().sizeHint(option, index)


class PackageList(QTreeWidget):
    """List as high as its rows; one column with wrapped texts takes the remaining width."""

    def __init__(self, headings: Sequence[str], wrapped: int) -> None:
        """Create an empty list.

        Args:
            wrapped: Index of the column with wrapped texts.
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
        """Set the height to the height of the rows."""
        # Otherwise rows keep their heights after the column width changed.
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
