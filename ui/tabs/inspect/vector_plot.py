"""A topology vector to look at: a star of rays whose lengths are the distance ratios, in the classes' colors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Sequence

import numpy as np
from qgis.PyQt.QtCore import QPointF, QSize, Qt
from qgis.PyQt.QtGui import QColor, QPainter, QPalette, QPen
from qgis.PyQt.QtWidgets import QWidget

from ....core.database.look_alikes import vector_rows
from ...widgets.placeholder import paint_placeholder

_MARGIN_PX = 12
_DOT_PX = 4.5
_RINGS = (0.25, 0.5, 0.75, 1.0)


@dataclass(frozen=True)
class Star:
    """A vector as rays; angles from the first, farthest landmark, which points up.

    lengths: (K,) 0–1; angles: (K,) radians clockwise from up; ranks: (K,) 1-based places of the classes.
    """

    lengths: np.ndarray
    angles: np.ndarray
    ranks: np.ndarray


def star_of(vector: np.ndarray, class_count: int) -> Star:
    """The rays of a (3·X,) vector. The differences are known but for their largest: they sum up to a whole turn."""
    lengths, differences, ranks = vector_rows(vector)
    total = float(differences.sum())
    turns = np.zeros(0) if total <= 0 else 2 * np.pi * np.concatenate([[0], np.cumsum(differences)[:-1]]) / total
    return Star(lengths, turns, np.rint(ranks * class_count).astype(int))


class VectorPlot(QWidget):
    """One star, and perhaps a second, paler one to compare it with."""

    def __init__(self, parent: Optional[QWidget] = None) -> None:
        super().__init__(parent)
        self._colors: Sequence[QColor] = ()
        self._star: Optional[Star] = None
        self._other: Optional[Star] = None
        self._text = ""

    def show_vectors(self, vector: np.ndarray, colors: Sequence[str], other: Optional[np.ndarray] = None) -> None:
        """``colors``: '#rrggbb' of the reference classes in order of value."""
        self._colors = [QColor(color) for color in colors]
        self._star = star_of(vector, len(colors))
        self._other = None if other is None else star_of(other, len(colors))
        self._text = ""
        self.update()

    def clear(self, text: str) -> None:
        self._star = self._other = None
        self._text = text
        self.update()

    def sizeHint(self):
        return QSize(200, 200)

    def minimumSizeHint(self):
        return QSize(120, 120)

    def paintEvent(self, event):
        if self._star is None:
            paint_placeholder(self, self._text)
            return
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        radius = min(self.width(), self.height()) / 2 - _MARGIN_PX
        center = QPointF(self.width() / 2, self.height() / 2)
        grid = self.palette().color(QPalette.ColorRole.Mid)
        painter.setPen(QPen(grid, 1))
        for ring in _RINGS:
            painter.drawEllipse(center, ring * radius, ring * radius)
        if self._other is not None:
            self._draw(painter, center, radius, self._other, Qt.PenStyle.DashLine)
        self._draw(painter, center, radius, self._star, Qt.PenStyle.SolidLine)
        painter.end()

    def _draw(self, painter: QPainter, center: QPointF, radius: float, star: Star, style) -> None:
        line = self.palette().color(QPalette.ColorRole.WindowText)
        for length, angle, rank in zip(star.lengths, star.angles, star.ranks):
            end = center + QPointF(np.sin(angle), -np.cos(angle)) * float(radius * length)
            painter.setPen(QPen(line, 1.2, style))
            painter.drawLine(center, end)
            color = self._colors[min(max(rank, 1), len(self._colors)) - 1]
            painter.setPen(QPen(line, 1))
            painter.setBrush(color if style == Qt.PenStyle.SolidLine else Qt.BrushStyle.NoBrush)
            painter.drawEllipse(end, _DOT_PX, _DOT_PX)
            painter.setBrush(Qt.BrushStyle.NoBrush)
