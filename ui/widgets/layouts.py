"""Rows, margins and collapsible boxes of the dock."""

from __future__ import annotations

from qgis.gui import QgsCollapsibleGroupBox
from qgis.PyQt.QtCore import QEvent, QSize
from qgis.PyQt.QtGui import QResizeEvent, QShowEvent
from qgis.PyQt.QtWidgets import QBoxLayout, QHBoxLayout, QToolButton, QVBoxLayout, QWidget

from ...processing.translation import tr

MARGIN_PX = 5
"""Margin around the dock's content and its boxes; docks are narrow."""


def row_of(*widgets: QWidget | tuple[QWidget, int]) -> QHBoxLayout:
    """Return a layout with widgets side by side.

    Args:
        *widgets: From left to right; (widget, stretch) for a widget that takes the remaining room.
    """
    made = QHBoxLayout()
    for entry in widgets:
        widget, stretch = entry if isinstance(entry, tuple) else (entry, 0)
        made.addWidget(widget, stretch)
    return made


class FoldingBox(QgsCollapsibleGroupBox):
    """Collapsible box that also collapses while it is hidden behind another tab; QGIS's box ignores that."""

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.setCollapsed(self.isCollapsed())
        self.collapsedStateChanged.emit(self.isCollapsed())


class FoldingRow(QWidget):
    """Places widgets side by side, or below each other where the width is too small."""

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
        # The text of a part has changed.
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
    """Return the layout with narrow margins."""
    layout.setContentsMargins(margin, margin, margin, margin)
    return layout


def content_of(box: QgsCollapsibleGroupBox) -> QWidget:
    """Return the only child of a collapsible box, for the box's content.

    QGIS shows every child of a box when it opens, also hidden widgets and closed dialogs.
    """
    content = QWidget()
    narrow(QVBoxLayout(box)).addWidget(content)
    return content


def name_fold(box: QgsCollapsibleGroupBox) -> None:
    """Name the triangle of a collapsible box for screen readers; QGIS gives it no name."""
    for button in box.findChildren(QToolButton, "collapseButton"):
        button.setAccessibleName(tr("Fold or unfold: {title}").format(title=box.title()))
