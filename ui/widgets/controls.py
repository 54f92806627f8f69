"""Icon buttons, shortcuts, and a combo box that may be narrow."""

from __future__ import annotations

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QKeySequence
from qgis.PyQt.QtWidgets import QComboBox, QShortcut, QToolButton, QWidget

_LEAST_LETTERS = 8


def tool_button(icon: str, text: str, checkable: bool = False, made: QToolButton | None = None) -> QToolButton:
    """Return a button with an icon only.

    Args:
        icon: Icon of QGIS's theme, such as ``/mActionAdd.svg``.
        text: Tool tip and name for screen readers.
        made: Button to set up; by default a new one.
    """
    button = QToolButton() if made is None else made
    button.setIcon(QgsApplication.getThemeIcon(icon))
    button.setToolTip(text)
    button.setAccessibleName(text)
    button.setCheckable(checkable)
    return button


def shortcut(keys: str, parent: QWidget) -> QShortcut:
    """Return a shortcut that works wherever the focus is in ``parent``, which owns it."""
    made = QShortcut(QKeySequence(keys), parent)
    made.setContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
    return made


class ChoiceBox(QComboBox):
    """Combo box that may be narrower than its longest text."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(_LEAST_LETTERS)
