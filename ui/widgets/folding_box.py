"""A box that is folded and unfolded by the program, too, whether it is seen or not."""

from __future__ import annotations

from qgis.gui import QgsCollapsibleGroupBox
from qgis.PyQt.QtGui import QShowEvent


class FoldingBox(QgsCollapsibleGroupBox):
    """QGIS's box forgets what it was told while it was hidden, such as behind another tab: it stays as it looked."""

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.setCollapsed(self.isCollapsed())
        self.collapsedStateChanged.emit(self.isCollapsed())
