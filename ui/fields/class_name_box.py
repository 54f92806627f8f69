"""Combo box for the name of a class."""

from __future__ import annotations

from qgis.PyQt.QtWidgets import QComboBox

from ...processing.layers.guess_fields import BUILDING
from ...processing.translation import tr


class ClassNameBox(QComboBox):
    """Combo box for any class name that offers “building”; empty if a field has the classes."""

    def __init__(self) -> None:
        super().__init__()
        self.setEditable(True)
        self.addItems(["", BUILDING])
        self.lineEdit().setPlaceholderText(tr("Optional, such as “building”"))

    def class_name(self) -> str:
        """Return the name, possibly empty."""
        return self.currentText().strip()
