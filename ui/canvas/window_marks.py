"""The inspected window on the canvas: its outline, its star of landmarks, and its look-alikes in another color."""

from __future__ import annotations

from typing import Iterable

from qgis.core import QgsCoordinateReferenceSystem, QgsGeometry, QgsPointXY
from qgis.gui import QgsMapCanvas

from ...core.database.look_alikes import DescribedWindow
from ...core.database.model import ReferenceDatabase
from ...processing.compat import LINE_GEOMETRY, POLYGON_GEOMETRY
from .marks import BLUE, ORANGE, Marks, band, square

_ZOOM_MARGIN = 1.6


class WindowMarks(Marks):
    """A window of a database, joined with the landmarks of its vector, and what looks like it elsewhere."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(
            canvas,
            {
                "window": band(canvas, POLYGON_GEOMETRY, BLUE, width=3),
                "star": band(canvas, LINE_GEOMETRY, BLUE, width=1),
                "look-alikes": band(canvas, POLYGON_GEOMETRY, ORANGE),
            },
        )

    def show(self, database: ReferenceDatabase, crs: QgsCoordinateReferenceSystem, window: DescribedWindow) -> None:
        """Draws a window of ``database``, whose coordinates are in ``crs``."""
        shapes = {
            "window": _outlines(database, [window.index]),
            "star": _star(database, window),
            "look-alikes": _outlines(database, window.look_alikes),
        }
        self.draw(shapes, crs)

    def zoom(self) -> None:
        """Moves the canvas to the window when it is not in view as a whole."""
        if not self._canvas.extent().contains(self.drawn("window").boundingBox()):
            self.zoom_to("window", _ZOOM_MARGIN)


def _outlines(database: ReferenceDatabase, indices: Iterable[int]) -> QgsGeometry:
    """The windows' squares as one geometry."""
    windows = database.windows
    squares = [square(*windows.centers[index].tolist(), float(windows.sizes[index])) for index in indices]
    return QgsGeometry.collectGeometry(squares)


def _star(database: ReferenceDatabase, window: DescribedWindow) -> QgsGeometry:
    center = QgsPointXY(*database.windows.centers[window.index].tolist())
    ends = database.references.positions[window.objects].tolist()
    return QgsGeometry.fromMultiPolylineXY([[center, QgsPointXY(*end)] for end in ends])
