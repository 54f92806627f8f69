"""A box for the one class that all polygons of a layer are of."""

from __future__ import annotations

from qgis.PyQt.QtWidgets import QComboBox

from ...processing.translation import tr
from .guessed import BUILDING


class ClassNameBox(QComboBox):
    """Takes any name and offers “building”; empty where a field has the classes."""

    def __init__(self) -> None:
        super().__init__()
        self.setEditable(True)
        self.addItems(["", BUILDING])
        self.lineEdit().setPlaceholderText(tr("Only if all are of one class, such as “building”"))

    def class_name(self) -> str:
        """The name; empty without one."""
        return self.currentText().strip()
