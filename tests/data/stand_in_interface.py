"""A replacement for QGIS's window, for tests that load the plugin into their own process."""

from qgis.core import QgsProject
from qgis.gui import QgsMapCanvas, QgsMessageBar
from qgis.PyQt.QtWidgets import QMainWindow, QVBoxLayout, QWidget


class InterfaceStandIn:
    def __init__(self):
        self.window = QMainWindow()
        self.window.resize(1200, 800)
        self.canvas = QgsMapCanvas()
        self.bar = QgsMessageBar()
        central = QWidget()
        layout = QVBoxLayout(central)
        layout.addWidget(self.bar)
        layout.addWidget(self.canvas)
        self.window.setCentralWidget(central)
        self.tool_bar = self.window.addToolBar("Plugins")
        self.plugin_menu = self.window.menuBar().addMenu("Plugins")
        self.docks = []
        self.lets_projects_go = True
        self.tool_bar_actions = []
        self.menu_actions = []
        self.options_factories = []
        self.drop_handlers = []
        self.options_pages_shown = []

    def mainWindow(self):
        return self.window

    def mapCanvas(self):
        return self.canvas

    def messageBar(self):
        return self.bar

    def pluginMenu(self):
        return self.plugin_menu

    def pluginToolBar(self):
        return self.tool_bar

    def addDockWidget(self, area, dock):
        self.docks.append(dock)
        self.window.addDockWidget(area, dock)

    def removeDockWidget(self, dock):
        self.docks.remove(dock)
        self.window.removeDockWidget(dock)

    def addToolBarIcon(self, action):
        self.tool_bar_actions.append(action)
        self.tool_bar.addAction(action)

    def removeToolBarIcon(self, action):
        self.tool_bar_actions.remove(action)
        self.tool_bar.removeAction(action)

    def addPluginToMenu(self, menu, action):
        self.menu_actions.append(action)
        self.plugin_menu.addAction(action)

    def removePluginMenu(self, menu, action):
        self.menu_actions.remove(action)
        self.plugin_menu.removeAction(action)

    def registerOptionsWidgetFactory(self, factory):
        self.options_factories.append(factory)

    def unregisterOptionsWidgetFactory(self, factory):
        self.options_factories.remove(factory)

    def showOptionsDialog(self, parent, page):
        self.options_pages_shown.append(page)

    def newProject(self, promptToSaveFlag=False):
        """Answer the question about saving with `lets_projects_go`."""
        if self.lets_projects_go:
            QgsProject.instance().clear()
        return self.lets_projects_go

    def addProject(self, path):
        return QgsProject.instance().read(path)

    def registerCustomDropHandler(self, handler):
        self.drop_handlers.append(handler)

    def unregisterCustomDropHandler(self, handler):
        self.drop_handlers.remove(handler)

    def leftovers(self) -> list:
        """Return what a plugin added and did not remove."""
        actions = self.tool_bar_actions + self.menu_actions
        return self.docks + actions + self.options_factories + self.drop_handlers
