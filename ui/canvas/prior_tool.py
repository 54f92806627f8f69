"""Map tool that draws the search area: press at its center and drag to its edge."""

from __future__ import annotations

from qgis.core import QgsCoordinateReferenceSystem, QgsCsException, QgsGeometry, QgsPointXY
from qgis.gui import QgsMapCanvas, QgsMapMouseEvent, QgsMapTool
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtGui import QKeyEvent

from ...processing.compat import POLYGON_GEOMETRY
from .marks import BLUE, POINTS_A_SIDE, Marks, band, to_canvas


class CircleMark(Marks):
    """Circle that is round in the CRS of the canvas."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas, {"circle": band(canvas, POLYGON_GEOMETRY, BLUE, filled=30, rim=False)})
        self._ends: tuple | None = None

    def show(self, middle: QgsPointXY, edge: QgsPointXY, crs: QgsCoordinateReferenceSystem) -> None:
        """Draw a circle around ``middle`` through ``edge``, both in ``crs``."""
        self._ends, self._crs = (middle, edge), crs
        self._place()

    def clear(self) -> None:
        self._ends = None
        self._place()

    def _on_canvas(self) -> dict | None:
        if self._ends is None:
            return {}
        transform = to_canvas(self._canvas, self._crs)
        try:
            middle, edge = (QgsPointXY(transform.transform(end)) for end in self._ends)
        except QgsCsException:
            return None
        return {"circle": QgsGeometry.fromPointXY(middle).buffer(middle.distance(edge), POINTS_A_SIDE)}


class PriorTool(QgsMapTool):
    """Emits ``drawn`` with center and edge point in the canvas's CRS. Call ``remove`` before deleting it."""

    drawn = pyqtSignal(QgsPointXY, QgsPointXY)

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self.setCursor(Qt.CursorShape.CrossCursor)
        self._middle: QgsPointXY | None = None
        self.circle = CircleMark(canvas)

    def remove(self) -> None:
        """Remove the circle from the canvas for good."""
        self.circle.remove()

    # --- QgsMapTool ---

    def canvasPressEvent(self, event: QgsMapMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._middle = event.mapPoint()

    def canvasMoveEvent(self, event: QgsMapMouseEvent) -> None:
        if self._middle is not None:
            crs = self.canvas().mapSettings().destinationCrs()
            self.circle.show(self._middle, event.mapPoint(), crs)

    def canvasReleaseEvent(self, event: QgsMapMouseEvent) -> None:
        middle, self._middle = self._middle, None
        if middle is not None and middle.distance(event.mapPoint()) > 0:
            self.drawn.emit(middle, event.mapPoint())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.canvas().unsetMapTool(self)
        else:
            super().keyPressEvent(event)
