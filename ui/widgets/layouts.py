"""Rows, margins and collapsible boxes of the dock."""

from __future__ import annotations

from qgis.gui import QgsCollapsibleGroupBox
from qgis.PyQt.QtGui import QShowEvent
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
