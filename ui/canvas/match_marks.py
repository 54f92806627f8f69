"""Landmarks on the canvas that agree with the image's: numbered as in the image view, joined with where the fix puts
the image's."""

from __future__ import annotations

from typing import List, Optional, Tuple

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsPointXY,
    QgsProject,
)
from qgis.gui import QgsMapCanvas, QgsMapCanvasItem
from qgis.PyQt.QtCore import QObject, QPointF, QRectF, pyqtSignal
from qgis.PyQt.QtGui import QColor, QPainter, QPen

from ..tabs.image_picture import Matches
from .numbers import nearest_number, paint_numbers, paint_ring

_LINE = QColor("#e8344e")
_RIM = QColor("#ffffff")
_RING_PX = 6.0
_POINTED_RING_PX = 11.0
_REACH_PX = 12.0


class MatchMarks(QObject):
    """Follows the canvas's CRS. ``remove`` takes it off the canvas for good.

    pointed: the number of the landmark under the mouse, 0 for none.
    """

    pointed = pyqtSignal(int)

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__()
        self._canvas = canvas
        self._item = _Item(canvas)
        self._shown: Optional[Tuple[Matches, QgsCoordinateReferenceSystem]] = None
        self._visible = True
        canvas.destinationCrsChanged.connect(self._place)
        canvas.xyCoordinates.connect(self._look)

    @property
    def pairs(self) -> List[Tuple[QgsPointXY, QgsPointXY]]:
        """(where the fix puts it, the map's landmark) of each match in the canvas's CRS, as drawn."""
        return self._item.pairs

    def show(self, matches: Optional[Matches], crs: QgsCoordinateReferenceSystem) -> None:
        self._shown = None if matches is None else (matches, crs)
        self._place()

    def set_visible(self, visible: bool) -> None:
        self._visible = visible
        self._place()

    def point_at(self, number: int) -> None:
        """Stresses one landmark; 0 for none."""
        self._item.point_at(number)

    def remove(self) -> None:
        self._canvas.destinationCrsChanged.disconnect(self._place)
        self._canvas.xyCoordinates.disconnect(self._look)
        self._canvas.scene().removeItem(self._item)
        self._item = None

    def _look(self, place: QgsPointXY) -> None:
        if self._item.pairs:
            position = self._item.toCanvasCoordinates(place)
            self.pointed.emit(nearest_number(self._item.places(), QPointF(position), _REACH_PX) or 0)

    def _place(self) -> None:
        self._item.show_pairs(self._on_canvas() if self._shown is not None and self._visible else [])

    def _on_canvas(self) -> list:
        matches, crs = self._shown
        transform = QgsCoordinateTransform(crs, self._canvas.mapSettings().destinationCrs(), QgsProject.instance())
        try:
            return [
                (transform.transform(QgsPointXY(*seen)), transform.transform(QgsPointXY(*on_map)))
                for seen, on_map in zip(matches.seen.tolist(), matches.on_map.tolist())
            ]
        except QgsCsException:
            return []


class _Item(QgsMapCanvasItem):
    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self.pairs: List[Tuple[QgsPointXY, QgsPointXY]] = []
        self._pointed = 0

    def show_pairs(self, pairs: list) -> None:
        self.pairs, self._pointed = pairs, 0
        self.setVisible(bool(pairs))
        self.updatePosition()

    def point_at(self, number: int) -> None:
        if number != self._pointed:
            self._pointed = number
            self.update()

    def places(self) -> List[Tuple[int, QPointF]]:
        """Numbers and pixels of the map's landmarks."""
        return [(number, self.toCanvasCoordinates(on_map)) for number, (_, on_map) in enumerate(self.pairs, start=1)]

    # --- QgsMapCanvasItem ---

    def updatePosition(self):
        self.prepareGeometryChange()
        self.update()

    def boundingRect(self):
        return QRectF(0, 0, self._canvas.width(), self._canvas.height())

    def paint(self, painter, *_):
        if painter is None:
            return
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        places = self.places()
        for (seen, _), (number, place) in zip(self.pairs, places):
            for color, width in ((_RIM, 4), (_LINE, 2)):
                painter.setPen(QPen(color, width))
                painter.drawLine(self.toCanvasCoordinates(seen), place)
            paint_ring(painter, place, _POINTED_RING_PX if number == self._pointed else _RING_PX, _LINE)
        paint_numbers(painter, self._canvas.font(), places, self._pointed)
