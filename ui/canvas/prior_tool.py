"""The map tool that draws where images are known to be: press at the middle, drag to the edge."""

from __future__ import annotations

from typing import Optional

from qgis.core import QgsGeometry, QgsPointXY
from qgis.gui import QgsMapCanvas, QgsMapTool, QgsRubberBand
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor

from ...processing.compat import POLYGON_GEOMETRY

_LINE = QColor("#1f6fd6")
_POINTS_A_QUARTER = 16


class PriorTool(QgsMapTool):
    """Emits ``drawn`` with the middle and a point of the edge in the canvas's CRS. ``remove`` before it is deleted."""

    drawn = pyqtSignal(QgsPointXY, QgsPointXY)

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self.setCursor(Qt.CursorShape.CrossCursor)
        self._middle: Optional[QgsPointXY] = None
        self._band = QgsRubberBand(canvas, POLYGON_GEOMETRY)
        self._band.setStrokeColor(_LINE)
        self._band.setFillColor(QColor(_LINE.red(), _LINE.green(), _LINE.blue(), 30))
        self._band.setWidth(2)

    def show_circle(self, middle: Optional[QgsPointXY], edge: Optional[QgsPointXY]) -> None:
        """Keeps a circle on the canvas, or none."""
        self._band.reset(POLYGON_GEOMETRY)
        if middle is not None:
            circle = QgsGeometry.fromPointXY(middle).buffer(middle.distance(edge), _POINTS_A_QUARTER)
            self._band.setToGeometry(circle)

    def remove(self) -> None:
        self.canvas().scene().removeItem(self._band)
        self._band = None

    def canvasPressEvent(self, event):
        if event.button() == Qt.MouseButton.LeftButton:
            self._middle = event.mapPoint()

    def canvasMoveEvent(self, event):
        if self._middle is not None:
            self.show_circle(self._middle, event.mapPoint())

    def canvasReleaseEvent(self, event):
        middle, self._middle = self._middle, None
        if middle is not None and middle.distance(event.mapPoint()) > 0:
            self.drawn.emit(middle, event.mapPoint())

    def keyPressEvent(self, event):
        if event.key() == Qt.Key.Key_Escape:
            self.canvas().unsetMapTool(self)
        else:
            super().keyPressEvent(event)
