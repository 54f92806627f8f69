"""Ways to open SemRef: toolbar button, menu entries, options page, and files dropped on QGIS."""

from __future__ import annotations

import os
from collections import deque
from typing import TYPE_CHECKING, Callable

from qgis.core import Qgis, QgsApplication, QgsProject, QgsSettings
from qgis.gui import QgisInterface, QgsCustomDropHandler, QgsOptionsWidgetFactory
from qgis.PyQt.QtCore import QObject, Qt, pyqtSlot
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction

from ..core.errors import SemRefError
from ..processing.base.algorithm import ICON_PATH
from ..processing.inspection.chosen import require_database
from ..processing.layers.database_layers import add_database_to_map
from ..processing.packages.components import NEEDED, missing
from ..processing.translation import tr
from ..processing.version import tracker_url
from .dock.dock import SemRefDock
from .packages.component_installer import ComponentInstaller
from .running.background import end_idle_threads, keep_threads, shut_down
from .running.localization_run import named_results
from .widgets.messages import TAG, open_guide

if TYPE_CHECKING:
    from .packages.components_page import ComponentsPage

MENU = "SemRef"

PAGE = "SemRefOptions"
"""Name of the options page, by which QGIS opens it."""

_VISIBLE_SETTING = "semref/dock/visible"
"""Whether the dock was open when the plugin was unloaded."""


class DockEntry:
    """Adds dock, button, menu entries and options page. ``remove`` removes them."""

    def __init__(self, iface: QgisInterface) -> None:
        self._iface = iface
        keep_threads()
        window = iface.mainWindow()
        self._action = QAction(QIcon(str(ICON_PATH)), "SemRef", window)
        self._action.setObjectName("SemRefDockAction")
        self._action.setToolTip(tr("Show or hide the SemRef dock, which finds the positions of images"))
        iface.addToolBarIcon(self._action)
        iface.addPluginToMenu(MENU, self._action)
        self._menu = [self._action]
        self._dock = SemRefDock(iface.mapCanvas(), iface.messageBar(), window)
        iface.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self._dock)
        if not QgsSettings().value(_VISIBLE_SETTING, False, type=bool):
            # setUserVisible has no effect before the window has laid out the dock.
            self._dock.hide()
        self._dock.setToggleVisibilityAction(self._action)
        self._dock.let_open()
        self._drop = DatabaseDrop()
        iface.registerCustomDropHandler(self._drop)
        self._sample = None
        self._diagnostics = Diagnostics()
        self._add_to_menu("SemRefSampleAction", tr("Open the sample project…"), "", self._open_sample)
        self._add_to_menu("SemRefSetUpAction", tr("Set up an area…"), "", self._dock.set_up_area)
        self._add_to_menu("SemRefHelpAction", tr("User guide"), "/mActionHelpContents.svg", open_guide)
        copy = "SemRefDiagnosticsAction", tr("Copy diagnostics"), "/mActionEditCopy.svg"
        self._add_to_menu(*copy, lambda: self._dock.messages.success(self._diagnostics.copy()))
        # The page does not own them: an installation continues when the options are closed.
        self._installer, self._training_installer = ComponentInstaller(window), ComponentInstaller(window)
        self._options = OptionsFactory(self._installer, self._training_installer, self._dock.refresh_notice)
        iface.registerOptionsWidgetFactory(self._options)
        self._dock.notice.install.clicked.connect(self._show_options)
        for signal in (self._installer.installed, self._installer.failed, self._installer.canceled):
            signal.connect(self._dock.refresh_notice)
        for installer in (self._installer, self._training_installer):
            installer.failed.connect(self._dock.messages.error)

    def _add_to_menu(self, name: str, text: str, icon: str, triggered: Callable[[], None]) -> None:
        action = QAction(QgsApplication.getThemeIcon(icon) if icon else QIcon(), text, self._iface.mainWindow())
        action.setObjectName(name)
        action.triggered.connect(lambda _checked: triggered())
        self._iface.addPluginToMenu(MENU, action)
        self._menu.append(action)

    def _open_sample(self) -> None:
        lacking = missing(NEEDED)
        if lacking:
            titles = ", ".join(package.title for package in lacking)
            sentence = tr("The sample project needs {packages}.").format(packages=titles)
            notice = self._dock.messages.error_with(sentence, tr("Install…"), self._show_options)
            self._installer.installed.connect(notice.dismiss)
            return
        self._sample_project().ask()

    def _sample_project(self):
        if self._sample is None:
            # Imported here because the plugin must load without OpenCV.
            from .sample_project import SampleProject

            self._sample = SampleProject(self._iface, self._dock)
        return self._sample

    def remove(self) -> None:
        for installer in (self._installer, self._training_installer):
            installer.cancel()
            installer.deleteLater()
        self._iface.unregisterOptionsWidgetFactory(self._options)
        self._options.deleteLater()
        self._diagnostics.shut_down()
        if self._sample is not None:
            shut_down(self._sample)
            self._sample.deleteLater()
        self._iface.unregisterCustomDropHandler(self._drop)
        # QGIS deletes the handler.
        QgsSettings().setValue(_VISIBLE_SETTING, not self._dock.isHidden())
        self._dock.shut_down()
        self._iface.removeDockWidget(self._dock)
        self._dock.deleteLater()
        self._iface.removeToolBarIcon(self._action)
        for action in reversed(self._menu):
            self._iface.removePluginMenu(MENU, action)
            action.deleteLater()
        end_idle_threads()

    def _show_options(self) -> None:
        self._iface.showOptionsDialog(self._iface.mainWindow(), PAGE)


class OptionsFactory(QgsOptionsWidgetFactory):
    """Creates the options page."""

    def __init__(
        self, installer: ComponentInstaller, training_installer: ComponentInstaller, removed: Callable[[], None]
    ) -> None:
        super().__init__("SemRef", QIcon(str(ICON_PATH)))
        self._installer, self._training_installer, self._removed = installer, training_installer, removed

    def createWidget(self, parent=None) -> ComponentsPage:
        # Imported here because few sessions open the options.
        from .packages.components_page import ComponentsPage

        page = ComponentsPage(self._installer, self._training_installer, parent)
        page.setObjectName(PAGE)
        page.removed.connect(self._removed)
        return page


class DatabaseDrop(QgsCustomDropHandler):
    """Adds dropped databases and results with all layers. QGIS alone would ask for tables and lose names and order."""

    def handleFileDrop(self, file):
        return file.lower().endswith(".gpkg") and (_did(_add_database, file) or _did(_add_results, file))


def _add_database(path: str) -> None:
    require_database(path)
    add_database_to_map(path, QgsProject.instance())


def _add_results(path: str) -> None:
    layers = named_results(path, os.path.splitext(os.path.basename(path))[0])
    QgsProject.instance().addMapLayers([layer for layer in layers if layer is not None])


def _did(add: Callable[[str], None], path: str) -> bool:
    """Return whether the file was added; QGIS handles any other GeoPackage."""
    try:
        add(path)
    except SemRefError:
        return False
    return True


_MOST_MESSAGES = 30
_LONGEST_MESSAGE = 4000
"""Characters. The end of a message is kept, because the end of a traceback names the error."""


class Diagnostics(QObject):
    """Records log messages about SemRef until ``shut_down``."""

    def __init__(self) -> None:
        super().__init__()
        self._lines: deque[str] = deque(maxlen=_MOST_MESSAGES)
        QgsApplication.messageLog().messageReceived.connect(self._keep)

    def shut_down(self) -> None:
        QgsApplication.messageLog().messageReceived.disconnect(self._keep)

    @pyqtSlot(str, str, Qgis.MessageLevel)
    def _keep(self, message: str, tag: str, level: Qgis.MessageLevel) -> None:
        if tag == TAG or TAG.lower() in message.lower():
            self._lines.append(f"{tag}: {message[-_LONGEST_MESSAGE:]}")

    def copy(self) -> str:
        """Copy the diagnostics to the clipboard. Return a sentence for the user."""
        # Imported here because few sessions need it.
        from ..processing.packages.diagnostics import diagnostics

        QgsApplication.clipboard().setText(diagnostics(tuple(self._lines)))
        copied = tr(
            "Diagnostics are on the clipboard: versions, packages, devices and the last messages. Check "
            "them, then paste them into a new issue."
        )
        return f"{copied} {tracker_url()}".strip()
