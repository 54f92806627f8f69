"""Numbers next to landmarks, the same in the image and on the map."""

from __future__ import annotations

from collections.abc import Iterable

from qgis.PyQt.QtCore import QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPainterPath, QPen

from .marks import RIM

_INK = QColor("#000000")
_AWAY_PX = 6.0
_CELL_PX = 16.0


def paint_numbers(painter: QPainter, font: QFont, places: Iterable[tuple[int, QPointF]]) -> None:
    """Write each number next to its place (pixels of ``painter``); numbers that would overlap are left out."""
    small = QFont(font)
    small.setPointSizeF(max(font.pointSizeF() * 0.85, 6.0))
    metrics = QFontMetricsF(small)
    taken: set[tuple[int, int]] = set()
    for number, place in places:
        text = str(number)
        box = QRectF(
            place.x() + _AWAY_PX, place.y() - metrics.height(), metrics.horizontalAdvance(text), metrics.height()
        )
        cells = _cells(box)
        if not taken.isdisjoint(cells):
            continue
        taken.update(cells)
        path = QPainterPath()
        path.addText(QPointF(box.left(), box.bottom() - metrics.descent()), small, text)
        painter.setPen(QPen(RIM, 3))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawPath(path)
        painter.fillPath(path, _INK)


def paint_ring(painter: QPainter, place: QPointF, radius: float, color: QColor) -> None:
    """Paint a ring with a rim, in the painter's pixels."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for pen_color, width in ((RIM, 3.5), (color, 1.5)):
        painter.setPen(QPen(pen_color, width))
        painter.drawEllipse(place, radius, radius)


def _cells(box: QRectF) -> set[tuple[int, int]]:
    """Return the cells of a grid that a box touches."""
    columns = range(int(box.left() // _CELL_PX), int(box.right() // _CELL_PX) + 1)
    rows = range(int(box.top() // _CELL_PX), int(box.bottom() // _CELL_PX) + 1)
    return {(column, row) for column in columns for row in rows}
