"""Buttons with a picture, buttons with a menu, shortcuts, and a box of choices that may be narrow."""

from __future__ import annotations

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QKeySequence, QPaintEvent
from qgis.PyQt.QtWidgets import (
    QComboBox,
    QShortcut,
    QSizePolicy,
    QStyle,
    QStyleOptionComboBox,
    QStylePainter,
    QToolButton,
    QWidget,
)

_LEAST_LETTERS = 8
_BESIDE_ICON_PX, _MARGINS_PX = 4, 2
"""As Qt's styles leave them."""


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


class ChoiceBox(QComboBox):
    """Shortens the choice that it shows to what fits; Qt would cut it off."""

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
