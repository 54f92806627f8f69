"""SemRef's page in QGIS's options."""

from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.gui import QgsOptionsWidgetFactory
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtGui import QIcon

from ..processing.base.algorithm import ICON_PATH

if TYPE_CHECKING:
    from .diagnostics import Diagnostics
    from .packages.component_installer import ComponentInstaller
    from .packages.components_page import ComponentsPage

PAGE = "SemRefOptions"
"""Name that opens the page."""


class OptionsFactory(QgsOptionsWidgetFactory):
    """changed: packages were removed on the page."""

    changed = pyqtSignal()

    def __init__(
        self, installer: ComponentInstaller, training_installer: ComponentInstaller, diagnostics: Diagnostics
    ) -> None:
        super().__init__("SemRef", QIcon(str(ICON_PATH)))
        self._diagnostics = diagnostics
        self._installer, self._training_installer = installer, training_installer

    def createWidget(self, parent=None) -> ComponentsPage:
        # Imported here because few sessions open the options.
        from .packages.components_page import ComponentsPage

        page = ComponentsPage(self._installer, self._training_installer, parent)
        page.setObjectName(PAGE)
        page.removed.connect(self.changed)
        page.diagnosticsAsked.connect(lambda: page.state.setText(self._diagnostics.copy()))
        return page
