"""Shared parts of lists and tables: icons and placeholder texts."""

from __future__ import annotations

from pathlib import Path

from qgis.PyQt.QtCore import QRectF, Qt
from qgis.PyQt.QtGui import QIcon, QPainter, QPalette, QTextOption
from qgis.PyQt.QtWidgets import QAbstractScrollArea, QWidget

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
