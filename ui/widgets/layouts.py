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
    """Collapsible box.

    content: the only child, because QGIS shows every child when a box opens, also hidden widgets and closed dialogs.
    """

    def __init__(self, title: str, name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setTitle(title)
        self.content = QWidget()
        narrow(QVBoxLayout(self)).addWidget(self.content)

    def setTitle(self, title: str) -> None:
        super().setTitle(title)
        # For screen readers; QGIS gives the triangle no name.
        triangle = self.findChild(QToolButton, "collapseButton")
        triangle.setAccessibleName(tr("Fold or unfold: {title}").format(title=title))


class InputBox(FoldingBox):
    """Box that is collapsed after a run, also behind another tab, where QGIS's box ignores that."""

    def __init__(self, title: str, name: str) -> None:
        super().__init__(title, name)
        # The next session starts with an open box.
        self.setSaveCollapsedState(False)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.setCollapsed(self.isCollapsed())
        self.collapsedStateChanged.emit(self.isCollapsed())


def narrow(layout: QBoxLayout, margin: int = MARGIN_PX) -> QBoxLayout:
    layout.setContentsMargins(margin, margin, margin, margin)
    return layout
