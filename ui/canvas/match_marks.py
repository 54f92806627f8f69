"""Matched landmarks on the canvas, numbered as in the image view, with lines to the image's landmarks."""

from __future__ import annotations

from collections.abc import Iterable

from qgis.core import QgsCoordinateReferenceSystem, QgsGeometry, QgsPointXY
from qgis.gui import QgsMapCanvas, QgsMapCanvasItem
from qgis.PyQt.QtCore import QObject, QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPainterPath, QPen

from ..findings import MatchPoints
from .marks import RED, RIM, Marks

_RING_PX = 6.0


class MatchMarks(Marks):
    """Pairs of matched landmarks."""

    def __init__(self, canvas: QgsMapCanvas, parent: QObject) -> None:
        super().__init__(canvas, parent, {"pairs": _Pairs(canvas)})

    @property
    def pairs(self) -> list[list[QgsPointXY]]:
        """[image's landmark, map's landmark] of each match, as drawn, in the canvas's CRS."""
        return self._bands["pairs"].pairs

    def show(self, matches: MatchPoints, crs: QgsCoordinateReferenceSystem) -> None:
        """Draw matches with map coordinates in ``crs``."""
        pairs = [[QgsPointXY(*seen), QgsPointXY(*on_map)] for seen, on_map in zip(matches.seen, matches.on_map)]
        self.draw({"pairs": QgsGeometry.fromMultiPolylineXY(pairs)}, crs)


class _Pairs(QgsMapCanvasItem):
    """Lines with rings and numbers at their ends; a rubber band has no text."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self.pairs: list[list[QgsPointXY]] = []

    def setToGeometry(self, lines: QgsGeometry) -> None:
        self.pairs = [] if lines.isEmpty() else lines.asMultiPolyline()
        self.setVisible(bool(self.pairs))
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
            paint_ring(painter, place, _RING_PX)
        paint_numbers(painter, self._canvas.font(), places)


_INK = QColor("#000000")
_AWAY_PX = 6.0
_CELL_PX = 16.0


def paint_numbers(painter: QPainter, font: QFont, places: Iterable[tuple[int, QPointF]]) -> None:
    """Write each number next to its place (pixels of ``painter``); numbers that would overlap are left out."""
    small = QFont(font)
    small.setPointSizeF(max(font.pointSizeF() * 0.85, 6.0))
    metrics = QFontMetricsF(small)
    taken: set[tuple[int, int]] = set()
    for number, place in places:
        text = str(number)
        box = QRectF(
            place.x() + _AWAY_PX, place.y() - metrics.height(), metrics.horizontalAdvance(text), metrics.height()
        )
        cells = _cells(box)
        if not taken.isdisjoint(cells):
            continue
        taken.update(cells)
        path = QPainterPath()
        path.addText(QPointF(box.left(), box.bottom() - metrics.descent()), small, text)
        painter.setPen(QPen(RIM, 3))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawPath(path)
        painter.fillPath(path, _INK)


def paint_ring(painter: QPainter, place: QPointF, radius: float) -> None:
    """Paint a red ring with a rim, in the painter's pixels."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for color, width in ((RIM, 3.5), (RED, 1.5)):
        painter.setPen(QPen(color, width))
        painter.drawEllipse(place, radius, radius)


def _cells(box: QRectF) -> set[tuple[int, int]]:
    """Return the cells of a grid that a box touches."""
    columns = range(int(box.left() // _CELL_PX), int(box.right() // _CELL_PX) + 1)
    rows = range(int(box.top() // _CELL_PX), int(box.bottom() // _CELL_PX) + 1)
    return {(column, row) for column in columns for row in rows}
