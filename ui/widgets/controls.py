"""Icon buttons, shortcuts, and a combo box that may be narrow."""

from __future__ import annotations

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QKeySequence, QPaintEvent
from qgis.PyQt.QtWidgets import (
    QComboBox,
    QShortcut,
    QStyle,
    QStyleOptionComboBox,
    QStylePainter,
    QToolButton,
    QWidget,
)

_LEAST_LETTERS = 8
_BESIDE_ICON_PX, _MARGINS_PX = 4, 2
"""Widths that Qt's styles use."""


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
    """Combo box that elides its text; Qt would cut it off."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(_LEAST_LETTERS)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter, option = QStylePainter(self), QStyleOptionComboBox()
        self.initStyleOption(option)
        painter.drawComplexControl(QStyle.ComplexControl.CC_ComboBox, option)
        room = (
            self.style()
            .subControlRect(QStyle.ComplexControl.CC_ComboBox, option, QStyle.SubControl.SC_ComboBoxEditField, self)
            .width()
        )
        if not option.currentIcon.isNull():
            room -= option.iconSize.width() + _BESIDE_ICON_PX
        text = option.fontMetrics.elidedText(option.currentText, Qt.TextElideMode.ElideRight, room - _MARGINS_PX)
        option.currentText = text
        painter.drawControl(QStyle.ControlElement.CE_ComboBoxLabel, option)
