"""A button beside the file box of a class table that shows the table in a window, to be edited."""

from __future__ import annotations

from qgis.gui import QgsFileWidget
from qgis.PyQt.QtWidgets import QFileDialog, QMessageBox, QToolButton

from ...core.errors import SemRefError
from ...processing.inspection.class_tables import ClassRow, is_shipped, read_rows, save_rows
from ...processing.messages.sentences import worded
from ...processing.translation import tr
from ..widgets.controls import tool_button
from .editor import ClassTableEditor


class EditButton(QToolButton):
    """Opens the table that the box names, or an empty one, and has the box name what was saved."""

    def __init__(self, box: QgsFileWidget) -> None:
        super().__init__(box)
        tool_button("/mActionToggleEditing.svg", tr("Edit class table"), made=self)
        self.setObjectName("SemRefEditClassTable")
        self.clicked.connect(self.edit)
        box.layout().addWidget(self)

    def edit(self) -> None:
        """Shows the table; what is saved goes into its file, or into one that is asked for."""
        path = self.parent().filePath()
        try:
            editor = ClassTableEditor(read_rows(path), self.window())
            if editor.exec() == ClassTableEditor.DialogCode.Accepted:
                self._save(editor.classes(), path)
        except SemRefError as error:
            QMessageBox.warning(self.window(), tr("Class table"), worded(error))

    def _save(self, classes: list[ClassRow], path: str) -> None:
        """Raises SemRefError where it can't be written."""
        if not path or is_shipped(path):
            path, _ = QFileDialog.getSaveFileName(self.window(), tr("Save class table"), "", tr("CSV files (*.csv)"))
        if path:
            save_rows(classes, path)
            self.parent().setFilePath(path)
