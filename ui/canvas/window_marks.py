"""The inspected window on the canvas with landmarks and similar windows."""

from __future__ import annotations

from qgis.core import QgsCoordinateReferenceSystem, QgsGeometry, QgsPointXY
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QObject

from ...processing.compat import LINE_GEOMETRY, POLYGON_GEOMETRY
from ...processing.inspection.window import InspectedWindow
from .marks import AMBER, BLUE, Marks, band, square

_ZOOM_MARGIN = 1.6


class WindowMarks(Marks):
    """A window of the database, lines to the landmarks of its vector, and similar windows."""

    def __init__(self, canvas: QgsMapCanvas, parent: QObject) -> None:
        super().__init__(
            canvas,
            parent,
            {
                "window": band(canvas, POLYGON_GEOMETRY, BLUE, width=3),
                "star": band(canvas, LINE_GEOMETRY, BLUE, width=1),
                "look-alikes": band(canvas, POLYGON_GEOMETRY, AMBER),
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
