"""What an empty list or table says to do."""

from __future__ import annotations

from qgis.PyQt.QtCore import QRectF, Qt
from qgis.PyQt.QtGui import QPainter, QPalette, QTextOption
from qgis.PyQt.QtWidgets import QAbstractScrollArea, QWidget

_MARGIN_PX = 12


def paint_placeholder(view: QWidget, text: str) -> None:
    """Writes ``text`` in the middle of a view or widget; to be called in its paintEvent when it is empty."""
    surface = view.viewport() if isinstance(view, QAbstractScrollArea) else view
    painter = QPainter(surface)
    painter.setPen(view.palette().color(QPalette.ColorRole.PlaceholderText))
    area = surface.rect().adjusted(_MARGIN_PX, 0, -_MARGIN_PX, 0)
    painter.drawText(QRectF(area), text, QTextOption(Qt.AlignmentFlag.AlignCenter))
    painter.end()
