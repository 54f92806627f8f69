"""The ways in: button and menu entries – dock, sample project, guide, diagnostics –, options page."""

from __future__ import annotations

from qgis.core import QgsApplication, QgsSettings
from qgis.gui import QgisInterface
from qgis.PyQt.QtCore import Qt, QUrl
from qgis.PyQt.QtGui import QDesktopServices, QIcon
from qgis.PyQt.QtWidgets import QAction

from ..processing.base.algorithm import ICON_PATH
from ..processing.packages.components import NEEDED, missing
from ..processing.translation import tr
from ..processing.version import guide_url
from .database_drop import DatabaseDrop
from .diagnostics import Diagnostics
from .dock.dock import SemRefDock
from .dock.preload import Preload
from .options import PAGE, OptionsFactory
from .packages.component_installer import ComponentInstaller
from .widgets.messages import Messages

MENU = "SemRef"

_VISIBLE_SETTING = "semref/dock/visible"
"""Whether the dock was open when the plugin was taken away: it then is when the plugin comes back."""


class DockEntry:
    """Adds dock, button, menu entries and options page; ``remove`` takes them away in reverse order."""

    def __init__(self, iface: QgisInterface) -> None:
        self._iface = iface
        window = iface.mainWindow()
        self._action = QAction(QIcon(str(ICON_PATH)), "SemRef", window)
        self._action.setObjectName("SemRefDockAction")
        self._action.setToolTip(tr("Show or hide the SemRef dock: find where images were taken"))
        iface.addToolBarIcon(self._action)
        iface.addPluginToMenu(MENU, self._action)
        self._dock = SemRefDock(iface.mapCanvas(), iface.messageBar(), window)
        iface.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, self._dock)
        if not QgsSettings().value(_VISIBLE_SETTING, False, type=bool):
            # setUserVisible would do nothing to a dock that its window has not laid out yet.
            self._dock.hide()
        self._dock.setToggleVisibilityAction(self._action)
        self._dock.let_open()
        self._preload = Preload(self._dock)
        self._drop = DatabaseDrop()
        iface.registerCustomDropHandler(self._drop)
        self._sample = None
        self._sample_action = QAction(tr("Open the sample project…"), window)
        self._sample_action.setObjectName("SemRefSampleAction")
        self._sample_action.triggered.connect(self._open_sample)
        iface.addPluginToMenu(MENU, self._sample_action)
        self._help = QAction(QgsApplication.getThemeIcon("/mActionHelpContents.svg"), tr("User guide"), window)
        self._help.setObjectName("SemRefHelpAction")
        self._help.triggered.connect(_open_user_guide)
        iface.addPluginToMenu(MENU, self._help)
        self._diagnostics = Diagnostics(window)
        copy_icon = QgsApplication.getThemeIcon("/mActionEditCopy.svg")
        self._diagnostics_action = QAction(copy_icon, tr("Copy diagnostics"), window)
        self._diagnostics_action.setObjectName("SemRefDiagnosticsAction")
        self._diagnostics_action.triggered.connect(self._copy_diagnostics)
        iface.addPluginToMenu(MENU, self._diagnostics_action)
        # Not the page's: it goes on when the options are closed.
        self._installer, self._training_installer = ComponentInstaller(window), ComponentInstaller(window)
        self._options = OptionsFactory(self._installer, self._training_installer, self._diagnostics)
        iface.registerOptionsWidgetFactory(self._options)
        self._dock.helpAsked.connect(_open_user_guide)
        self._dock.installAsked.connect(self._show_options)
        self._options.changed.connect(self._dock.refresh_notice)
        for signal in (self._installer.installed, self._installer.failed, self._installer.canceled):
            signal.connect(self._dock.refresh_notice)
        for installer in (self._installer, self._training_installer):
            installer.failed.connect(self._dock.messages.error)
            installer.broke.connect(self._dock.messages.bug)

    def _open_sample(self) -> None:
        lacking = missing(NEEDED)
        if lacking:
            titles = ", ".join(package.title for package in lacking)
            sentence = tr("The sample project needs {packages}.").format(packages=titles)
            notice = Messages(self._iface.messageBar()).error_with(sentence, tr("Install…"), self._show_options)
            self._installer.installed.connect(notice.dismiss)
            return
        self._sample_project().ask()

    def _copy_diagnostics(self) -> None:
        Messages(self._iface.messageBar()).success(self._diagnostics.copy())

    def _sample_project(self):
        if self._sample is None:
            # Not at the top: the plugin has to load where OpenCV is missing.
            from .sample_project import SampleProject

            self._sample = SampleProject(self._iface, self._dock)
        return self._sample

    def remove(self) -> None:
        """Takes everything away again."""
        self._preload.stop()
        for installer in (self._installer, self._training_installer):
            installer.cancel()
            installer.deleteLater()
        self._iface.unregisterOptionsWidgetFactory(self._options)
        self._options.deleteLater()
        self._iface.removePluginMenu(MENU, self._diagnostics_action)
        self._diagnostics_action.deleteLater()
        self._diagnostics.shut_down()
        self._diagnostics.deleteLater()
        self._iface.removePluginMenu(MENU, self._help)
        self._help.deleteLater()
        self._iface.removePluginMenu(MENU, self._sample_action)
        self._sample_action.deleteLater()
        if self._sample is not None:
            self._sample.shut_down()
            self._sample.deleteLater()
        self._sample = self._sample_action = None
        self._iface.unregisterCustomDropHandler(self._drop)
        # QGIS deletes it.
        QgsSettings().setValue(_VISIBLE_SETTING, not self._dock.isHidden())
        self._dock.shut_down()
        self._iface.removeDockWidget(self._dock)
        self._dock.deleteLater()
        self._iface.removePluginMenu(MENU, self._action)
        self._iface.removeToolBarIcon(self._action)
        self._action.deleteLater()
        self._dock = self._action = self._drop = self._help = self._options = self._installer = None
        self._training_installer = self._preload = self._diagnostics = self._diagnostics_action = None

    def _show_options(self) -> None:
        self._iface.showOptionsDialog(self._iface.mainWindow(), PAGE)


def _open_user_guide() -> None:
    QDesktopServices.openUrl(QUrl(guide_url()))
