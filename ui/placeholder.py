"""What an empty list or table says to do."""

from __future__ import annotations

from qgis.PyQt.QtCore import QRectF, Qt
from qgis.PyQt.QtGui import QPainter, QPalette, QTextOption

_MARGIN_PX = 12


def paint_placeholder(view, text: str) -> None:
    """Writes ``text`` in the middle of an item view; to be called in its paintEvent when it is empty."""
    painter = QPainter(view.viewport())
    painter.setPen(view.palette().color(QPalette.ColorRole.PlaceholderText))
    area = view.viewport().rect().adjusted(_MARGIN_PX, 0, -_MARGIN_PX, 0)
    painter.drawText(QRectF(area), text, QTextOption(Qt.AlignmentFlag.AlignCenter))
    painter.end()
