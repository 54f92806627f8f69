"""Matched landmarks on the canvas, numbered as in the image view, with lines to the image's landmarks."""

from __future__ import annotations

from qgis.core import QgsCoordinateReferenceSystem, QgsCsException, QgsPointXY
from qgis.gui import QgsMapCanvas, QgsMapCanvasItem
from qgis.PyQt.QtCore import QPointF, QRectF, pyqtSignal
from qgis.PyQt.QtGui import QPainter, QPen

from ..findings import MatchPoints
from .marks import RED, RIM, Marks, to_canvas
from .numbers import nearest_number, paint_numbers, paint_ring

_RING_PX = 6.0
_POINTED_RING_PX = 11.0
_REACH_PX = 12.0


class MatchMarks(Marks):
    """Pairs of matched landmarks.

    pointed: number of the landmark under the mouse; otherwise 0.
    """

    pointed = pyqtSignal(int)

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas, {})
        self._item: _Item | None = _Item(canvas)
        self._matches: MatchPoints | None = None
        canvas.xyCoordinates.connect(self._look)

    @property
    def pairs(self) -> list[tuple[QgsPointXY, QgsPointXY]]:
        """(image's landmark, map's landmark) of each match, as drawn, in the canvas's CRS."""
        return self._item.pairs

    def show(self, matches: MatchPoints, crs: QgsCoordinateReferenceSystem) -> None:
        """Draw matches with map coordinates in ``crs``."""
        self._matches, self._crs = matches, crs
        self._place()

    def clear(self) -> None:
        self._matches = None
        self._place()

    def point_at(self, number: int) -> None:
        """Highlight one landmark; 0 clears the highlight."""
        self._item.point_at(number)

    def remove(self) -> None:
        super().remove()
        self._canvas.xyCoordinates.disconnect(self._look)
        self._canvas.scene().removeItem(self._item)
        self._item = None

    def _look(self, place: QgsPointXY) -> None:
        if self._item.pairs:
            position = self._item.toCanvasCoordinates(place)
            self.pointed.emit(nearest_number(self._item.places(), QPointF(position), _REACH_PX) or 0)

    def _place(self) -> bool:
        pairs = self._pairs_on_canvas() if self._matches is not None and self._visible else []
        self._item.show_pairs(pairs or [])
        return pairs is not None

    def _pairs_on_canvas(self) -> list[tuple[QgsPointXY, QgsPointXY]] | None:
        transform = to_canvas(self._canvas, self._crs)
        try:
            return [
                (transform.transform(QgsPointXY(*seen)), transform.transform(QgsPointXY(*on_map)))
                for seen, on_map in zip(self._matches.seen, self._matches.on_map)
            ]
        except QgsCsException:
            return None


class _Item(QgsMapCanvasItem):
    """Paints the pairs of ``MatchMarks``."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self.pairs: list[tuple[QgsPointXY, QgsPointXY]] = []
        self._pointed = 0

    def show_pairs(self, pairs: list[tuple[QgsPointXY, QgsPointXY]]) -> None:
        self.pairs, self._pointed = pairs, 0
        self.setVisible(bool(pairs))
        self.updatePosition()

    def point_at(self, number: int) -> None:
        if number != self._pointed:
            self._pointed = number
            self.update()

    def places(self) -> list[tuple[int, QPointF]]:
        """Return numbers and canvas pixels of the map's landmarks."""
        return [(number, self.toCanvasCoordinates(on_map)) for number, (_, on_map) in enumerate(self.pairs, start=1)]

    # --- QgsMapCanvasItem ---

    def updatePosition(self) -> None:
        self.prepareGeometryChange()
        self.update()

    def boundingRect(self) -> QRectF:
        return QRectF(0, 0, self._canvas.width(), self._canvas.height())

    def paint(self, painter: QPainter | None, *_) -> None:
        if painter is None:
            return
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        places = self.places()
        for (seen, _), (number, place) in zip(self.pairs, places):
            for color, width in ((RIM, 4), (RED, 2)):
                painter.setPen(QPen(color, width))
                painter.drawLine(self.toCanvasCoordinates(seen), place)
            paint_ring(painter, place, _POINTED_RING_PX if number == self._pointed else _RING_PX, RED)
        paint_numbers(painter, self._canvas.font(), places, self._pointed)
