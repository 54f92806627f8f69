"""Choose the reference database."""

from __future__ import annotations

import os
from pathlib import Path

from qgis.core import QgsProject, QgsSettings
from qgis.gui import QgsFileWidget
from qgis.PyQt.QtCore import QSize, pyqtSignal
from qgis.PyQt.QtGui import QDragEnterEvent, QDropEvent
from qgis.PyQt.QtWidgets import QPushButton, QVBoxLayout, QWidget

from ...processing.inspection.chosen import require_database
from ...processing.translation import tr
from ..layer_files import dropped_files
from ..project_state import DATABASE_SETTING
from ..proposals import annotation_at_hand
from ..running.background import Reader
from .controls import message_label, open_algorithm, tool_button
from .layouts import InputBox, narrow, row_of

MAKE_DATABASE = "semref:annotationtodatabase"


class DatabaseBox(InputBox):
    """The chosen database, remembered between sessions; a file or layer can be dropped on it.

    fault: why the file is not a database, empty while that is unknown; replaced: the file has new content; checked: the
    file was checked.
    """

    changed = pyqtSignal()
    replaced = pyqtSignal()
    checked = pyqtSignal()

    def __init__(self) -> None:
        super().__init__(tr("Reference database"), "SemRefDatabase")
        self.collapsedStateChanged.connect(self._show_title)
        self.setAcceptDrops(True)
        self.file = QgsFileWidget()
        self.file.setFilter(tr("Reference databases (*.gpkg)"))
        self.file.setDialogTitle(tr("Choose a reference database"))
        self.file.lineEdit().setPlaceholderText(tr("Choose a reference database"))
        self.file.lineEdit().setAccessibleName(tr("Reference database"))
        self.file.setFilePath(QgsSettings().value(DATABASE_SETTING, "", type=str))
        self.add_to_map = tool_button("/mActionAddLayer.svg", tr("Add database to map"))
        self.make = tool_button("/mActionNewGeoPackageLayer.svg", tr("Build a reference database from polygons…"))
        self.set_up = QPushButton(tr("Set up an area…"))
        self.set_up.setToolTip(tr("Go from a map and a folder of photos to their positions"))
        self.making: QWidget | None = None
        self.fault = ""
        self.fault_label = message_label()
        self.fault_label.setMinimumWidth(1)
        self.fault_label.setVisible(False)
        layout = narrow(QVBoxLayout(self.content), 0)
        layout.addLayout(row_of((self.file, 1), self.add_to_map, self.make))
        layout.addWidget(self.fault_label)
        layout.addWidget(self.set_up)
        self.file.fileChanged.connect(self._remember)
        self.make.clicked.connect(self._make_database)
        self._reader = Reader(self)
        self._reader.answered.connect(lambda _nothing: self._show_fault(""))
        self._reader.failed.connect(self._show_fault)
        self._check()

    def path(self) -> str:
        """Return the path of the chosen database; may be empty."""
        return self.file.filePath().strip()

    def choose(self, path: str) -> None:
        """Choose a database. Emits ``changed`` also for the chosen one, because its content may be new."""
        if path == self.path():
            self._check()
            self.replaced.emit()
            self.changed.emit()
        else:
            self.file.setFilePath(path)

    def _make_database(self) -> None:
        self.making = open_algorithm(MAKE_DATABASE, annotation_at_hand(QgsProject.instance()))

    def _remember(self) -> None:
        path = self.path()
        if path:
            # Clearing a project clears the database, but the next session starts with it.
            QgsSettings().setValue(DATABASE_SETTING, path)
        self._check()
        if not path:
            self.setCollapsed(False)
        self._show_title()
        self.changed.emit()

    def _check(self) -> None:
        """Check the file in the background: it may be of any kind, and on a slow disk."""
        self._reader.forget()
        # A user without a database sees it first.
        self.set_up.setVisible(not self.path())
        self._show_fault("")
        if self.path():
            self._reader.read(tr("Reading the database"), require_database, self.path())

    def _show_fault(self, sentence: str) -> None:
        # The path is shown above.
        self.fault = sentence.replace(self.path(), os.path.basename(self.path()))
        self.fault_label.setText(self.fault)
        self.fault_label.setVisible(bool(self.fault))
        if self.fault:
            self.setCollapsed(False)
        self.add_to_map.setEnabled(bool(self.path()) and not self.fault)
        self.checked.emit()

    def _show_title(self, *_) -> None:
        name = Path(self.path()).stem
        is_named = self.isCollapsed() and name
        self.setTitle(tr("Reference database: {name}").format(name=name) if is_named else tr("Reference database"))

    # --- QWidget ---

    def minimumSizeHint(self) -> QSize:
        # A long file name must not widen the dock.
        least = super().minimumSizeHint()
        return QSize(min(least.width(), self.layout().minimumSize().width()), least.height())

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if any(dropped_files(event.mimeData())[0]):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        self.file.setFilePath(dropped_files(event.mimeData())[0][0])
        event.acceptProposedAction()
