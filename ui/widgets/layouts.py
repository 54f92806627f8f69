"""Rows, margins and folding boxes that are the same all over the dock."""

from __future__ import annotations

from qgis.gui import QgsCollapsibleGroupBox
from qgis.PyQt.QtCore import QEvent, QSize
from qgis.PyQt.QtGui import QResizeEvent, QShowEvent
from qgis.PyQt.QtWidgets import QBoxLayout, QHBoxLayout, QToolButton, QVBoxLayout, QWidget

from ...processing.translation import tr

MARGIN_PX = 5
"""Around the content of the dock and of its boxes: width is scarce in a dock."""


def row_of(*widgets: QWidget | tuple[QWidget, int]) -> QHBoxLayout:
    """Widgets side by side.

    Args:
        *widgets: From left to right; (widget, stretch) for one that takes what room is left.
    """
    made = QHBoxLayout()
    for entry in widgets:
        widget, stretch = entry if isinstance(entry, tuple) else (entry, 0)
        made.addWidget(widget, stretch)
    return made


class FoldingBox(QgsCollapsibleGroupBox):
    """QGIS's box forgets what it was told while it was hidden, such as behind another tab: it stays as it looked."""

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.setCollapsed(self.isCollapsed())
        self.collapsedStateChanged.emit(self.isCollapsed())


class FoldingRow(QWidget):
    """Widgets that share the width side by side, and one below the other where there is no room for that."""

    def __init__(self, *parts: QWidget) -> None:
        super().__init__()
        self._parts = parts
        self._row = narrow(QBoxLayout(QBoxLayout.Direction.LeftToRight, self), 0)
        for part in parts:
            self._row.addWidget(part, 1)

    def minimumSizeHint(self) -> QSize:
        widest = max(map(_least_width, self._parts))
        return QSize(widest, super().minimumSizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fold()

    def event(self, event: QEvent) -> bool:
        # A part has another text now.
        if event.type() == QEvent.Type.LayoutRequest:
            self._fold()
        return super().event(event)

    def _fold(self) -> None:
        side_by_side = sum(map(_least_width, self._parts))
        side_by_side += (len(self._parts) - 1) * self._row.spacing()
        directions = QBoxLayout.Direction
        wanted = directions.LeftToRight if side_by_side <= self.width() else directions.TopToBottom
        if self._row.direction() != wanted:
            self._row.setDirection(wanted)


def _least_width(part: QWidget) -> int:
    return max(part.minimumSizeHint().width(), part.minimumWidth())


def narrow(layout: QBoxLayout, margin: int = MARGIN_PX) -> QBoxLayout:
    """The layout with margins as narrow as a dock needs them."""
    layout.setContentsMargins(margin, margin, margin, margin)
    return layout


def content_of(box: QgsCollapsibleGroupBox) -> QWidget:
    """Make the one child of a box that folds, to be laid out.

    QGIS shows every child of the box when it unfolds: widgets that are hidden, and dialogs that were closed.
    """
    content = QWidget()
    narrow(QVBoxLayout(box)).addWidget(content)
    return content


def name_fold(box: QgsCollapsibleGroupBox) -> None:
    """Gives the triangle that folds a box a name for screen readers, which QGIS does not."""
    for button in box.findChildren(QToolButton, "collapseButton"):
        button.setAccessibleName(tr("Fold or unfold: {title}").format(title=box.title()))
