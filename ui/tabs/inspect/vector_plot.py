"""Plot of a topology vector: rays with the distance ratios as lengths, in the colors of the classes."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, sin

from qgis.PyQt.QtCore import QPointF, QSize, Qt
from qgis.PyQt.QtGui import QColor, QPainter, QPaintEvent, QPalette, QPen
from qgis.PyQt.QtWidgets import QWidget

from ....processing.inspection.window import Ray
from ...widgets.controls import paint_placeholder

_MARGIN_PX = 12
_DOT_PX = 4.5
_RINGS = (0.25, 0.5, 0.75, 1.0)


class VectorPlot(QWidget):
    """Plot of one vector, and optionally of a second one to compare with."""

    def __init__(self) -> None:
        super().__init__()
        self._rays: Sequence[Ray] = ()
        self._compared: Sequence[Ray] = ()
        self._text = ""

    def show_rays(self, rays: Sequence[Ray], compared: Sequence[Ray] = ()) -> None:
        """Draw a vector with its first landmark at the top, and a second vector with dashed lines."""
        self._rays, self._compared, self._text = rays, compared, ""
        self.update()

    def clear(self, text: str) -> None:
        """Show a text instead of a vector."""
        self._rays = self._compared = ()
        self._text = text
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(200, 200)

    def minimumSizeHint(self) -> QSize:
        return QSize(120, 120)

    def paintEvent(self, event: QPaintEvent) -> None:
        if not self._rays:
            paint_placeholder(self, self._text)
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        radius = min(self.width(), self.height()) / 2 - _MARGIN_PX
        center = QPointF(self.width() / 2, self.height() / 2)
        grid = self.palette().color(QPalette.ColorRole.Mid)
        painter.setPen(QPen(grid, 1))
        for ring in _RINGS:
            painter.drawEllipse(center, ring * radius, ring * radius)
        self._draw(painter, center, radius, self._compared, Qt.PenStyle.DashLine)
        self._draw(painter, center, radius, self._rays, Qt.PenStyle.SolidLine)
        painter.end()

    def _draw(self, painter: QPainter, center: QPointF, radius: float, rays: Sequence[Ray], style: Qt.PenStyle) -> None:
        line = self.palette().color(QPalette.ColorRole.WindowText)
        for ray in rays:
            end = center + QPointF(sin(ray.turn), -cos(ray.turn)) * (radius * ray.length)
            painter.setPen(QPen(line, 1.2, style))
            painter.drawLine(center, end)
            painter.setPen(QPen(line, 1))
            painter.setBrush(QColor(ray.color) if style == Qt.PenStyle.SolidLine else Qt.BrushStyle.NoBrush)
            painter.drawEllipse(end, _DOT_PX, _DOT_PX)
            painter.setBrush(Qt.BrushStyle.NoBrush)
