"""How bad something is, as an icon in the color that it has on the map, and in a shape that says the same.

QGIS's own sign of an error is gray in some versions, and looks like something that is switched off.
"""

from __future__ import annotations

from qgis.PyQt.QtCore import QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QIcon, QPainter, QPen, QPixmap, QPolygonF

from ...core.annotation.findings import ERROR, INFORMATION, WARNING
from ...processing.layers import palette

_PX = 64
"""Of the largest size that it is drawn in; Qt makes it smaller."""

_TRIANGLE = QPolygonF([QPointF(32, 5), QPointF(61, 57), QPointF(3, 57)])


def severity_icon(severity: str) -> QIcon:
    """Of one of ``findings.SEVERITIES``: a cross in a disk, a triangle, an i in a disk."""
    picture = QPixmap(_PX, _PX)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    _SIGNS.get(severity, _warning)(painter)
    painter.end()
    return QIcon(picture)


def _error(painter: QPainter) -> None:
    _disk(painter, palette.BAD)
    painter.setPen(_pen())
    painter.drawLine(QPointF(21, 21), QPointF(43, 43))
    painter.drawLine(QPointF(43, 21), QPointF(21, 43))


def _warning(painter: QPainter) -> None:
    painter.setPen(QPen(QColor(palette.CASING), 3))
    painter.setBrush(QColor(palette.WARNING))
    painter.drawPolygon(_TRIANGLE)
    _exclamation(painter, 24, 40, 49)


def _information(painter: QPainter) -> None:
    _disk(painter, palette.INFORMATION)
    _exclamation(painter, 47, 30, 18)


def _disk(painter: QPainter, color: str) -> None:
    painter.setPen(QPen(QColor(palette.CASING), 3))
    painter.setBrush(QColor(color))
    painter.drawEllipse(QRectF(4, 4, 56, 56))


def _exclamation(painter: QPainter, far: int, near: int, dot: int) -> None:
    """A line and a dot below, or above, its end: “!” or “i”."""
    painter.setPen(_pen())
    painter.drawLine(QPointF(32, far), QPointF(32, near))
    painter.drawPoint(QPointF(32, dot))


def _pen() -> QPen:
    pen = QPen(QColor(palette.CASING), 7)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap)
    return pen


_SIGNS = {ERROR: _error, WARNING: _warning, INFORMATION: _information}
