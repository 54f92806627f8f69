"""The ways in: one button and one menu entry that show and hide the dock, and the locator bar."""

from __future__ import annotations

from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction

from ..processing.base import ICON_PATH
from ..processing.translation import tr
from .dock import SemRefDock
from .window_locator import WindowLocator

MENU = "SemRef"


class DockEntry:
    """Adds dock, button, menu entry and locator filter; ``remove`` takes them away in reverse order."""

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
        self._locator = WindowLocator(self._dock.read_database, self._dock.inspect_window)
        iface.registerLocatorFilter(self._locator)

    def remove(self) -> None:
        # QGIS deletes it.
        self._iface.deregisterLocatorFilter(self._locator)
        self._dock.shut_down()
        self._iface.removeDockWidget(self._dock)
        self._dock.deleteLater()
        self._iface.removePluginMenu(MENU, self._action)
        self._iface.removeToolBarIcon(self._action)
        self._action.deleteLater()
        self._dock = self._action = self._locator = None
