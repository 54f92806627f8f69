"""Matched landmarks on the canvas, numbered as in the image view, with lines to the image's landmarks."""

from __future__ import annotations

from qgis.core import QgsCoordinateReferenceSystem, QgsCsException, QgsPointXY
from qgis.gui import QgsMapCanvas, QgsMapCanvasItem
from qgis.PyQt.QtCore import QPointF, QRectF
from qgis.PyQt.QtGui import QPainter, QPen

from ..findings import MatchPoints
from .marks import RED, RIM, Marks, to_canvas
from .numbers import paint_numbers, paint_ring

_RING_PX = 6.0


class MatchMarks(Marks):
    """Pairs of matched landmarks."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas, {})
        self._item: _Item | None = _Item(canvas)
        self._matches: MatchPoints | None = None

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

    def remove(self) -> None:
        super().remove()
        self._canvas.scene().removeItem(self._item)
        self._item = None

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

    def show_pairs(self, pairs: list[tuple[QgsPointXY, QgsPointXY]]) -> None:
        self.pairs = pairs
        self.setVisible(bool(pairs))
        self.updatePosition()

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
        for (seen, _), (_, place) in zip(self.pairs, places):
            for color, width in ((RIM, 4), (RED, 2)):
                painter.setPen(QPen(color, width))
                painter.drawLine(self.toCanvasCoordinates(seen), place)
            paint_ring(painter, place, _RING_PX, RED)
        paint_numbers(painter, self._canvas.font(), places)
