"""Buttons that are a picture only: what they do is told to the mouse and to screen readers."""

from __future__ import annotations

from qgis.core import QgsApplication
from qgis.PyQt.QtWidgets import QToolButton


def tool_button(icon: str, text: str) -> QToolButton:
    """``icon``: of QGIS's theme, such as ``/mActionAdd.svg``."""
    button = QToolButton()
    button.setIcon(QgsApplication.getThemeIcon(icon))
    button.setToolTip(text)
    button.setAccessibleName(text)
    return button
