"""One place on the canvas that somebody should look at."""

from __future__ import annotations

from qgis.core import QgsCoordinateReferenceSystem, QgsGeometry
from qgis.gui import QgsMapCanvas

from ...processing.compat import POLYGON_GEOMETRY
from .marks import RED, Marks, band, show_extent

_ZOOM_MARGIN = 3.0
_CLOSEST_SCALE = 500
"""Specks are shown with some ground around them: not nearer than 1:500."""


class PlaceMark(Marks):
    """A polygon of a check's findings."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas, {"place": band(canvas, POLYGON_GEOMETRY, RED, filled=40, rim=False)})

    def show(self, place: QgsGeometry, crs: QgsCoordinateReferenceSystem) -> None:
        """Marks a place."""
        self.draw({"place": place}, crs)

    def zoom(self, least_extent: float) -> None:
        """Moves the canvas to the place; ``least_extent``, in its units, is added, as points and lines have none."""
        extent = self.drawn("place").boundingBox()
        if self.drawn("place").isEmpty():
            return
        extent.grow(least_extent)
        show_extent(self._canvas, extent, _ZOOM_MARGIN)
        if self._canvas.scale() < _CLOSEST_SCALE:
            self._canvas.zoomScale(_CLOSEST_SCALE)
            self._canvas.refresh()
