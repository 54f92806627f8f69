"""Landmarks of an image, over the image."""

from __future__ import annotations

from collections.abc import Sequence

from qgis.PyQt.QtCore import QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QFont, QPainter, QPen
from qgis.PyQt.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem, QWidget

from ...canvas.marks import RED, RIM
from ...canvas.numbers import paint_numbers, paint_ring
from .picture import ImagePicture

_LANDMARK_PX = 7
_RING_PX = 4.0


class LandmarkDots(QGraphicsItem):
    """Dots of constant size in the colors of the classes; hollow for landmarks that the image's edge cuts.

    Matched landmarks have a ring and a number.
    """

    def __init__(self, picture: ImagePicture, matched: Sequence[tuple[float, float]], font: QFont) -> None:
        super().__init__()
        landmarks = picture.seen.landmarks
        self._rect = QRectF(0, 0, *picture.size_wh)
        self._dots = [
            (QPointF(*center), QColor(picture.colors[int(value)]), bool(cut))
            for center, value, cut in zip(landmarks.centers_xy.tolist(), landmarks.classes, landmarks.touches_edge)
        ]
        self.matched = [(number, QPointF(*pixel)) for number, pixel in enumerate(matched, start=1)]
        self._font = font

    def boundingRect(self) -> QRectF:
        return self._rect

    def paint(self, painter: QPainter, option: QStyleOptionGraphicsItem, widget: QWidget | None = None) -> None:
        transform = painter.worldTransform()
        painter.resetTransform()
        for center, color, cut in self._dots:
            painter.setPen(QPen(RIM if not cut else color, 1.5))
            painter.setBrush(Qt.BrushStyle.NoBrush if cut else color)
            painter.drawEllipse(transform.map(center), _LANDMARK_PX / 2, _LANDMARK_PX / 2)
        places = [(number, transform.map(center)) for number, center in self.matched]
        for _, place in places:
            paint_ring(painter, place, _RING_PX, RED)
        paint_numbers(painter, self._font, places)
        painter.setWorldTransform(transform)
