"""Editor of class tables (value, name, color, role and draw order of each class), and the button that opens it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from qgis.gui import QgsColorButton, QgsFileWidget
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QColor
from qgis.PyQt.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QHeaderView,
    QMenu,
    QMessageBox,
    QPushButton,
    QTableWidget,
    QTableWidgetItem,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from ..core.errors import ClassTableError, SemRefError
from ..processing.inspection.class_tables import (
    ClassRow,
    is_shipped,
    new_row,
    read_rows,
    require_table,
    role_titles,
    save_rows,
)
from ..processing.jobs.annotation import PRESETS
from ..processing.messages.sentences import worded
from ..processing.translation import tr
from .widgets.controls import message_label, tool_button
from .widgets.layouts import row_of

VALUE, NAME, COLOR, ROLE, ORDER, HSV_MIN, HSV_MAX = range(7)
"""Columns of a class table. The colors of label images are hidden."""


class ClassTableEditor(QDialog):
    """Dialog to edit classes. After it is accepted, ``classes()`` make a valid table."""

    def __init__(self, classes: Sequence[ClassRow] = (), parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Class table"))
        self.resize(620, 460)
        self.rows = QTableWidget(0, HSV_MAX + 1, self)
        self.fault = message_label()
        self.add_button, self.remove_button = QPushButton(tr("Add class")), QPushButton(tr("Remove class"))
        self.preset_button = QPushButton(tr("Fill from nomenclature"))
        save = QDialogButtonBox.StandardButton.Save | QDialogButtonBox.StandardButton.Cancel
        self.buttons = QDialogButtonBox(save, Qt.Orientation.Horizontal, self)
        self._lay_out()
        self._connect()
        self.show_classes(classes)

    def _lay_out(self) -> None:
        titles = [tr("Value"), tr("Class"), tr("Color"), tr("Role"), tr("Draw order")]
        self.rows.setHorizontalHeaderLabels(titles)
        for column in (HSV_MIN, HSV_MAX):
            self.rows.setColumnHidden(column, True)
        self.rows.verticalHeader().hide()
        self.rows.setAccessibleName(tr("Class table"))
        self.rows.setSelectionBehavior(QTableWidget.SelectionBehavior.SelectRows)
        # The Tab key leaves the table; arrow keys move between cells.
        self.rows.setTabKeyNavigation(False)
        header = self.rows.horizontalHeader()
        # Other languages have longer words.
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(NAME, QHeaderView.ResizeMode.Stretch)
        self.fault.setVisible(False)
        menu = QMenu(self.preset_button)
        for title, path in PRESETS.items():
            menu.addAction(title).triggered.connect(partial(self._show_preset, path))
        self.preset_button.setMenu(menu)
        beside = row_of(self.add_button, self.remove_button, self.preset_button)
        beside.addStretch(1)
        layout = QVBoxLayout(self)
        layout.addWidget(self.rows, 1)
        layout.addLayout(beside)
        layout.addWidget(self.fault)
        layout.addWidget(self.buttons)

    def _connect(self) -> None:
        self.add_button.clicked.connect(self.add_class)
        self.remove_button.clicked.connect(self.remove_classes)
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)

    def show_classes(self, classes: Sequence[ClassRow]) -> None:
        self.rows.setRowCount(0)
        for one in classes:
            self._add_row(one)

    def add_class(self) -> None:
        """Add a class with the next free value, and edit its name."""
        self._add_row(new_row([row[VALUE] for row in self.classes()]))
        self.rows.setCurrentCell(self.rows.rowCount() - 1, NAME)
        self.rows.editItem(self.rows.currentItem())

    def remove_classes(self) -> None:
        for row in sorted({index.row() for index in self.rows.selectedIndexes()}, reverse=True):
            self.rows.removeRow(row)

    def accept(self) -> None:
        """Close the dialog if the classes make a valid table; otherwise show the fault."""
        try:
            require_table(self.classes())
        except ClassTableError as error:
            self.fault.setText(worded(error))
            self.fault.setVisible(True)
            return
        super().accept()

    def classes(self) -> list[ClassRow]:
        columns = range(self.rows.columnCount())
        return [[self._cell(row, column) for column in columns] for row in range(self.rows.rowCount())]

    def _cell(self, row: int, column: int) -> str:
        if column == COLOR:
            return self.rows.cellWidget(row, column).color().name()
        if column == ROLE:
            return self.rows.cellWidget(row, column).currentData()
        item = self.rows.item(row, column)
        return item.text().strip() if item is not None else ""

    def _add_row(self, cells: ClassRow) -> None:
        row = self.rows.rowCount()
        self.rows.insertRow(row)
        color, role = QgsColorButton(self.rows), QComboBox(self.rows)
        color.setColor(QColor(cells[COLOR]))
        color.setAccessibleName(tr("Color"))
        for key, title in role_titles().items():
            role.addItem(title, key)
        role.setCurrentIndex(role.findData(cells[ROLE]))
        role.setAccessibleName(tr("Role"))
        widgets = {COLOR: color, ROLE: role}
        for column, text in enumerate(cells):
            if column in widgets:
                self.rows.setCellWidget(row, column, widgets[column])
            else:
                self.rows.setItem(row, column, QTableWidgetItem(text))

    def _show_preset(self, path: str, *_checked) -> None:
        self.show_classes(read_rows(path))


def add_edit_button(box: QgsFileWidget) -> QToolButton:
    """Add a button to a file box that edits its table, or an empty table."""
    button = tool_button("/mActionToggleEditing.svg", tr("Edit class table"))
    button.setObjectName("SemRefEditClassTable")
    button.clicked.connect(lambda: _edit(box))
    box.layout().addWidget(button)
    return button


def _edit(box: QgsFileWidget) -> None:
    """Save the edited table to its file or to a file that the user chooses. The box then has its path."""
    path = box.filePath()
    try:
        editor = ClassTableEditor(read_rows(path), box.window())
        if editor.exec() != ClassTableEditor.DialogCode.Accepted:
            return
        if not path or is_shipped(path):
            path, _ = QFileDialog.getSaveFileName(box.window(), tr("Save class table"), "", tr("CSV files (*.csv)"))
        if path:
            save_rows(editor.classes(), path)
            box.setFilePath(path)
    except SemRefError as error:
        QMessageBox.warning(box.window(), tr("Class table"), worded(error))
