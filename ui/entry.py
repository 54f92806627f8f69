"""The way in: one button and one menu entry that show and hide the dock."""

from __future__ import annotations

from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction

from ..processing.base import ICON_PATH
from ..processing.translation import tr
from .dock import SemRefDock

MENU = "SemRef"


class DockEntry:
    """Adds dock, button and menu entry; ``remove`` takes them away in reverse order."""

    def __init__(self, iface) -> None:
        self._iface = iface
        window = iface.mainWindow()
        self._action = QAction(QIcon(str(ICON_PATH)), "SemRef", window)
        self._action.setObjectName("SemRefDockAction")
        self._action.setToolTip(tr("Show or hide the SemRef dock: find where images were taken"))
        iface.addToolBarIcon(self._action)
        iface.addPluginToMenu(MENU, self._action)
        self._dock = SemRefDock(iface.mapCanvas(), iface.messageBar(), window)
        iface.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self._dock)
        self._dock.setUserVisible(False)
        self._dock.setToggleVisibilityAction(self._action)

    def remove(self) -> None:
        self._dock.shut_down()
        self._iface.removeDockWidget(self._dock)
        self._dock.deleteLater()
        self._iface.removePluginMenu(MENU, self._action)
        self._iface.removeToolBarIcon(self._action)
        self._action.deleteLater()
        self._dock = self._action = None
