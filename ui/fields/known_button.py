"""A button beside a file box that offers the files at hand; the box stays for all others."""

from __future__ import annotations

from functools import partial

from qgis.core import QgsApplication
from qgis.gui import QgsFileWidget
from qgis.PyQt.QtWidgets import QMenu, QToolButton

from ...processing.translation import tr
from ..widgets.controls import tool_button
from ..widgets.texts import plain_tip
from .known import DATABASE, MODEL, known_files


class KnownButton(QToolButton):
    """Its menu lists the files of a kind when it is opened; the chosen one goes into the box."""

    def __init__(self, box: QgsFileWidget, kind: str) -> None:
        super().__init__(box)
        self._kind = kind
        text = tr("Databases at hand") if kind == DATABASE else tr("Models at hand")
        tool_button("/mActionOpenTable.svg" if kind == MODEL else "/mIconDbSchema.svg", text, made=self)
        self.setObjectName("SemRefKnown")
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.files = QMenu(self)
        self.files.setToolTipsVisible(True)
        self.setMenu(self.files)
        self.files.aboutToShow.connect(self.list_files)
        box.layout().addWidget(self)

    def list_files(self) -> None:
        """Lists what is at hand now."""
        self.files.clear()
        icon = QgsApplication.getThemeIcon("/mIconVector.svg" if self._kind == DATABASE else "/mIconFile.svg")
        for heading, files in known_files(self._kind):
            self.files.addSection(heading)
            for name, path in files:
                # An ampersand would underline what follows.
                action = self.files.addAction(icon, name.replace("&", "&&"))
                action.setToolTip(plain_tip(path))
                action.setCheckable(True)
                action.setChecked(path == self.parent().filePath())
                action.triggered.connect(partial(self._take, path))
        if self.files.isEmpty():
            nothing = tr("No database yet") if self._kind == DATABASE else tr("No model yet")
            self.files.addAction(nothing).setEnabled(False)

    def _take(self, path: str, *_checked) -> None:
        self.parent().setFilePath(path)
