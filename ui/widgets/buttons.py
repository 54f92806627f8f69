"""Buttons as the dock has them: pictures with a name for mouse and screen readers, and ones with an arrow for more."""

from __future__ import annotations

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QKeySequence
from qgis.PyQt.QtWidgets import QShortcut, QSizePolicy, QToolButton, QWidget


def tool_button(icon: str, text: str, checkable: bool = False, made: QToolButton | None = None) -> QToolButton:
    """A button that is a picture only.

    Args:
        icon: Of QGIS's theme, such as ``/mActionAdd.svg``.
        text: What it does, told to the mouse and to screen readers.
        checkable: Whether it stays pressed.
        made: The button itself where it is one of a class of its own.
    """
    button = QToolButton() if made is None else made
    button.setIcon(QgsApplication.getThemeIcon(icon))
    button.setToolTip(text)
    button.setAccessibleName(text)
    button.setCheckable(checkable)
    return button


def split_button(text: str, help_text: str) -> QToolButton:
    """A button with an arrow for more of its kind."""
    button = QToolButton()
    button.setText(text)
    button.setToolTip(help_text)
    button.setPopupMode(QToolButton.ToolButtonPopupMode.MenuButtonPopup)
    button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
    return button


def shortcut(keys: str, parent: QWidget) -> QShortcut:
    """Keys that work wherever the focus is in ``parent``; ``parent`` keeps the shortcut."""
    made = QShortcut(QKeySequence(keys), parent)
    made.setContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
    return made
