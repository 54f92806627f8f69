"""The inspected window on the canvas with landmarks and similar windows, and the map tool that picks a window."""

from __future__ import annotations

from qgis.core import QgsCoordinateReferenceSystem, QgsGeometry, QgsPointXY
from qgis.gui import QgsMapCanvas, QgsMapMouseEvent, QgsMapToolEmitPoint
from qgis.PyQt.QtCore import Qt, pyqtSignal
from qgis.PyQt.QtGui import QKeyEvent

from ...processing.compat import LINE_GEOMETRY, POLYGON_GEOMETRY
from ...processing.inspection.window import InspectedWindow
from .marks import BLUE, ORANGE, Marks, band, square

_ZOOM_MARGIN = 1.6


class WindowMarks(Marks):
    """A window of the database, lines to the landmarks of its vector, and similar windows."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(
            canvas,
            {
                "window": band(canvas, POLYGON_GEOMETRY, BLUE, width=3),
                "star": band(canvas, LINE_GEOMETRY, BLUE, width=1),
                "look-alikes": band(canvas, POLYGON_GEOMETRY, ORANGE),
            },
        )

    def show(self, window: InspectedWindow, crs: QgsCoordinateReferenceSystem) -> None:
        """Draw a window with coordinates in ``crs``."""
        center = QgsPointXY(*window.center_xy)
        star = [[center, QgsPointXY(*end)] for end in window.ends_xy]
        look_alikes = [square(*other.center_xy, other.size) for other in window.look_alikes]
        shapes = {
            "window": square(*window.center_xy, window.size),
            "star": QgsGeometry.fromMultiPolylineXY(star),
            "look-alikes": QgsGeometry.collectGeometry(look_alikes),
        }
        self.draw(shapes, crs)

    def zoom(self) -> None:
        """Move the canvas to the window unless all of it is visible."""
        if not self._canvas.extent().contains(self.drawn("window").boundingBox()):
            self.zoom_to("window", _ZOOM_MARGIN)


class WindowTool(QgsMapToolEmitPoint):
    """Emits ``picked`` with the point in the canvas's CRS; Escape returns to the previous tool."""

    picked = pyqtSignal(QgsPointXY)

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self.setCursor(Qt.CursorShape.WhatsThisCursor)

    def canvasReleaseEvent(self, event: QgsMapMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.picked.emit(event.mapPoint())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.canvas().unsetMapTool(self)
        else:
            super().keyPressEvent(event)
