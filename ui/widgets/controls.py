"""Icon buttons, shortcuts, labels, combo boxes, icons, placeholder texts, and choices that QGIS remembers."""

from __future__ import annotations

from html import escape
from pathlib import Path

from qgis.core import QgsApplication, QgsProcessingAlgorithm, QgsSettings
from qgis.PyQt.QtCore import QRectF, Qt
from qgis.PyQt.QtGui import QIcon, QKeySequence, QPainter, QPalette, QTextOption
from qgis.PyQt.QtWidgets import (
    QAbstractButton,
    QAbstractScrollArea,
    QComboBox,
    QFileDialog,
    QLabel,
    QShortcut,
    QToolButton,
    QWidget,
)

from ...processing.layers.guess_fields import BUILDING
from ...processing.messages.numbers import shown
from ...processing.translation import tr

_LEAST_LETTERS = 8


def tool_button(icon: str, text: str, checkable: bool = False) -> QToolButton:
    """Return a button with an icon only.

    Args:
        icon: Icon of QGIS's theme, such as ``/mActionAdd.svg``.
        text: Tool tip and name for screen readers.
    """
    button = QToolButton()
    button.setIcon(QgsApplication.getThemeIcon(icon))
    button.setToolTip(text)
    button.setAccessibleName(text)
    button.setCheckable(checkable)
    return button


def remember(button: QAbstractButton, setting: str, checked: bool) -> None:
    """Check or uncheck a button as in the last session, and store each change; ``checked``: the first state."""
    button.setChecked(QgsSettings().value(setting, checked, type=bool))
    button.toggled.connect(lambda on: QgsSettings().setValue(setting, on))


def shortcut(keys: str, parent: QWidget) -> QShortcut:
    """Return a shortcut that works wherever the focus is in ``parent``, which owns it."""
    made = QShortcut(QKeySequence(keys), parent)
    made.setContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
    return made


def message_label() -> QLabel:
    """Return a label for messages: it wraps them, shows names that look like HTML as they are, and lets users copy."""
    label = QLabel()
    label.setWordWrap(True)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    return label


def ask_folder(window: QWidget, title: str, setting: str) -> str:
    """Ask for a folder, and remember it. Return an empty text if the user cancels."""
    folder = QFileDialog.getExistingDirectory(window, title, QgsSettings().value(setting, "", type=str))
    if folder:
        QgsSettings().setValue(setting, folder)
    return folder


def open_algorithm(algorithm: str | QgsProcessingAlgorithm, parameters: dict) -> QWidget:
    """Open the dialog of an algorithm, which is not modal. The caller keeps it."""
    from processing import createAlgorithmDialog

    dialog = createAlgorithmDialog(algorithm, parameters)
    dialog.show()
    return dialog


class ChoiceBox(QComboBox):
    """Combo box that may be narrower than its longest text."""

    def __init__(self) -> None:
        super().__init__()
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(_LEAST_LETTERS)


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


_SIGNS = Path(__file__).resolve().parents[2] / "resources" / "severity"
"""QGIS's own error sign is gray in some versions."""

LIKELY = "likely"
"""Name of the sign of a likely position."""

_MARGIN_PX = 12


def sign_icon(name: str) -> QIcon:
    """Return the sign of a severity, or of a likely position: a question mark in an amber disk."""
    return QIcon(str(_SIGNS / f"{name}.svg"))


def paint_placeholder(view: QWidget, text: str) -> None:
    """Paint ``text`` in the middle of an empty view or widget; call it in paintEvent."""
    surface = view.viewport() if isinstance(view, QAbstractScrollArea) else view
    painter = QPainter(surface)
    painter.setPen(view.palette().color(QPalette.ColorRole.PlaceholderText))
    area = surface.rect().adjusted(_MARGIN_PX, 0, -_MARGIN_PX, 0)
    painter.drawText(QRectF(area), text, QTextOption(Qt.AlignmentFlag.AlignCenter))
    painter.end()


def number_text(value: float, decimals: int = 0) -> str:
    """Format a number with the language's decimal sign and groups of digits."""
    return shown(float(value), f",.{decimals}f")


def plain_tip(text: str) -> str:
    """Return a tool tip with the text as it is. Qt would interpret text that looks like HTML, and load its images."""
    return f"<p>{escape(text)}</p>".replace("\n", "<br>") if "<" in text else text
