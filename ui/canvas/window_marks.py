"""The inspected window on the canvas: its outline, its star of landmarks, and its look-alikes in a paler color."""

from __future__ import annotations

from typing import List, Optional

import numpy as np
from qgis.core import QgsCoordinateTransform, QgsCsException, QgsGeometry, QgsPointXY, QgsProject, QgsRectangle
from qgis.gui import QgsMapCanvas, QgsRubberBand
from qgis.PyQt.QtGui import QColor

from ...core.database.look_alikes import DescribedWindow
from ...core.database.model import ReferenceDatabase
from ...processing.compat import LINE_GEOMETRY, POLYGON_GEOMETRY

_WINDOW = QColor("#1f6fd6")
_LOOK_ALIKE = QColor("#e69f00")
_RIM = QColor("#ffffff")
_POINTS_A_SIDE = 16
_ZOOM_MARGIN = 1.6


class WindowMarks:
    """Follows the canvas's CRS. ``remove`` takes it off the canvas for good."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        self._canvas = canvas
        self._window = _band(canvas, POLYGON_GEOMETRY, _WINDOW, 3)
        self._star = _band(canvas, LINE_GEOMETRY, _WINDOW, 1)
        self._look_alikes = _band(canvas, POLYGON_GEOMETRY, _LOOK_ALIKE, 2)
        self._shown: Optional[tuple] = None
        canvas.destinationCrsChanged.connect(self._place)

    def show(self, database: ReferenceDatabase, crs, window: DescribedWindow) -> None:
        self._shown = database, crs, window
        self._place()

    def clear(self) -> None:
        self._shown = None
        self._place()

    def zoom(self) -> None:
        """Moves the canvas to the window when it is not in view as a whole."""
        extent = self._window.asGeometry().boundingBox()
        if self._shown is None or extent.isEmpty() or self._canvas.extent().contains(extent):
            return
        extent.scale(_ZOOM_MARGIN)
        self._canvas.setExtent(extent)
        self._canvas.refresh()

    def remove(self) -> None:
        self._canvas.destinationCrsChanged.disconnect(self._place)
        for band in (self._window, self._star, self._look_alikes):
            self._canvas.scene().removeItem(band)
        self._window = self._star = self._look_alikes = None

    def _place(self) -> None:
        for band, kind in ((self._window, POLYGON_GEOMETRY), (self._star, LINE_GEOMETRY)):
            band.reset(kind)
        self._look_alikes.reset(POLYGON_GEOMETRY)
        if self._shown is None:
            return
        database, crs, window = self._shown
        transform = QgsCoordinateTransform(crs, self._canvas.mapSettings().destinationCrs(), QgsProject.instance())
        try:
            self._window.setToGeometry(_transformed(_outlines(database, [window.index]), transform))
            if len(window.look_alikes):
                self._look_alikes.setToGeometry(_transformed(_outlines(database, window.look_alikes), transform))
            if len(window.objects):
                self._star.setToGeometry(_transformed(_star(database, window), transform))
        except QgsCsException:
            return


def _band(canvas, kind, color: QColor, width: int) -> QgsRubberBand:
    band = QgsRubberBand(canvas, kind)
    band.setStrokeColor(color)
    band.setSecondaryStrokeColor(_RIM)
    band.setFillColor(QColor(0, 0, 0, 0))
    band.setWidth(width)
    return band


def _outlines(database: ReferenceDatabase, indices) -> QgsGeometry:
    """The windows' squares as one geometry."""
    windows, squares = database.windows, []
    for index in indices:
        (x, y), half = windows.centers[index].tolist(), float(windows.sizes[index]) / 2
        square = QgsGeometry.fromRect(QgsRectangle(x - half, y - half, x + half, y + half))
        squares.append(square.densifyByCount(_POINTS_A_SIDE))
    return QgsGeometry.collectGeometry(squares)


def _star(database: ReferenceDatabase, window: DescribedWindow) -> QgsGeometry:
    center = QgsPointXY(*database.windows.centers[window.index].tolist())
    ends: List[np.ndarray] = database.references.positions[window.objects].tolist()
    return QgsGeometry.fromMultiPolylineXY([[center, QgsPointXY(*end)] for end in ends])


def _transformed(geometry: QgsGeometry, transform: QgsCoordinateTransform) -> QgsGeometry:
    geometry.transform(transform)
    return geometry
