"""The selected hit on the canvas: the ground it shows, where its top points to, and how sure its position is."""

from __future__ import annotations

from math import cos, radians, sin, sqrt
from typing import List, Optional

from qgis.core import QgsCoordinateTransform, QgsCsException, QgsGeometry, QgsPointXY, QgsProject, QgsRectangle
from qgis.gui import QgsMapCanvas, QgsRubberBand, QgsVertexMarker
from qgis.PyQt.QtGui import QColor

from ...processing.compat import LINE_GEOMETRY, POLYGON_GEOMETRY
from ..tabs.findings import Finding
from ..tabs.image_picture import RUNNERS_UP, RunnersUp

# Red with a white rim stands out on land-cover colors, aerial images, white and black alike.
_LINE = QColor("#e8344e")
_POSSIBLE = QColor("#e69f00")
_RIM = QColor("#ffffff")
_PALEST, _PALE = 90, 180
"""Opacity of the last and the first runner-up's outline, of 255."""

_ZOOM_MARGIN = 2.0
"""The canvas shows this many times the window's size, so that its surroundings can be seen."""

_POINTS_A_SIDE = 16
"""A window's straight sides are curves in another CRS."""

_ARROW_HEAD = 0.12
"""Length of the heading arrow's barbs, as a share of its shaft."""


class HitHighlight:
    """Follows the canvas's CRS. ``remove`` takes it off the canvas for good."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        self._canvas = canvas
        self._hit: Optional[Finding] = None
        self._outline = _band(canvas, POLYGON_GEOMETRY)
        self._heading = _band(canvas, LINE_GEOMETRY)
        self._error = _band(canvas, POLYGON_GEOMETRY)
        self._possible = _band(canvas, POLYGON_GEOMETRY, _POSSIBLE)
        self._runners_up = [_pale_band(canvas, rank) for rank in range(RUNNERS_UP)]
        self._runners_up_shown: Optional[RunnersUp] = None
        self._center = QgsVertexMarker(canvas)
        self._center.setIconType(QgsVertexMarker.IconType.ICON_CIRCLE)
        self._center.setIconSize(11)
        self._center.setPenWidth(2)
        self._center.setColor(_RIM)
        self._center.setFillColor(_LINE)
        self._visible = True
        self._center.hide()
        canvas.destinationCrsChanged.connect(self._place)

    def show(self, finding: Optional[Finding]) -> bool:
        """Shows the finding's hit, or the places it may be at; nothing for None. False where the CRS can't show it."""
        shown = finding is not None and (finding.center is not None or finding.possible)
        self._hit = finding if shown else None
        self._runners_up_shown = None
        return self._place()

    def show_runners_up(self, windows: Optional[RunnersUp]) -> None:
        """Outlines the windows that come after the shown one, the paler the farther behind."""
        self._runners_up_shown = windows
        self._place()

    def set_visible(self, visible: bool) -> None:
        self._visible = visible
        self._place()

    def zoom(self) -> None:
        """Moves the canvas to the hit, if one is shown."""
        # An image has a fix or possible places, never both.
        extents = [band.asGeometry().boundingBox() for band in (self._outline, self._possible)]
        extent = next((extent for extent in extents if not extent.isEmpty()), QgsRectangle())
        if self._hit is None or extent.isEmpty():
            return
        extent.scale(_ZOOM_MARGIN)
        self._canvas.setExtent(extent)
        self._canvas.refresh()

    def remove(self) -> None:
        self._canvas.destinationCrsChanged.disconnect(self._place)
        for item in (self._outline, self._heading, self._error, self._possible, *self._runners_up, self._center):
            self._canvas.scene().removeItem(item)
        self._runners_up = []
        self._outline = self._heading = self._error = self._possible = self._center = None

    def _place(self) -> bool:
        placed = self._on_canvas() if self._hit is not None and self._visible else None
        self._outline.reset(POLYGON_GEOMETRY)
        self._heading.reset(LINE_GEOMETRY)
        self._error.reset(POLYGON_GEOMETRY)
        for band in (self._possible, *self._runners_up):
            band.reset(POLYGON_GEOMETRY)
        self._center.setVisible(placed is not None and self._hit.center is not None)
        if placed is None:
            return self._hit is None or not self._visible
        *shapes, center = placed
        for band, shape in zip((self._outline, self._heading, self._error, self._possible), shapes):
            if not shape.isEmpty():
                band.setToGeometry(shape)
        if center is not None:
            self._center.setCenter(center)
        for band, square in zip(self._runners_up, self._squares()):
            band.setToGeometry(square)
        return True

    def _squares(self) -> List[QgsGeometry]:
        """The runners-up in the canvas's CRS; none where it can't show one of them."""
        windows = self._runners_up_shown
        if windows is None:
            return []
        target = self._canvas.mapSettings().destinationCrs()
        transform = QgsCoordinateTransform(self._hit.crs, target, QgsProject.instance())
        squares = []
        for (x, y), size in zip(windows.centers.tolist(), windows.sizes.tolist()):
            half = size / 2
            square = QgsGeometry.fromRect(QgsRectangle(x - half, y - half, x + half, y + half))
            squares.append(square.densifyByCount(_POINTS_A_SIDE))
        try:
            for square in squares:
                square.transform(transform)
        except QgsCsException:
            return []
        return squares

    def _on_canvas(self):
        """(outline, heading arrow, error circle, possible places, center) in the canvas's CRS; None where that has no
        such place."""
        hit = self._hit
        outline = QgsGeometry() if hit.outline is None else hit.outline.densifyByCount(_POINTS_A_SIDE)
        possible = [geometry.densifyByCount(_POINTS_A_SIDE) for geometry in hit.possible]
        shapes = [outline, _arrow(hit), _error_circle(hit), QgsGeometry.collectGeometry(possible)]
        target = self._canvas.mapSettings().destinationCrs()
        if not target.isValid() or target == hit.crs:
            return (*shapes, hit.center)
        transform = QgsCoordinateTransform(hit.crs, target, QgsProject.instance())
        try:
            center = None if hit.center is None else QgsPointXY(transform.transform(hit.center))
            for shape in shapes:
                if not shape.isEmpty():
                    shape.transform(transform)
        except QgsCsException:
            return None
        return (*shapes, center)


def _band(canvas: QgsMapCanvas, kind, color: QColor = _LINE) -> QgsRubberBand:
    band = QgsRubberBand(canvas, kind)
    band.setStrokeColor(color)
    band.setSecondaryStrokeColor(_RIM)
    # Unfilled: the map's colors inside the window stay what they are.
    band.setFillColor(QColor(0, 0, 0, 0))
    band.setWidth(2)
    return band


def _pale_band(canvas: QgsMapCanvas, rank: int) -> QgsRubberBand:
    color = QColor(_LINE)
    color.setAlpha(_PALE - (_PALE - _PALEST) * rank // max(RUNNERS_UP - 1, 1))
    band = QgsRubberBand(canvas, POLYGON_GEOMETRY)
    rim = QColor(_RIM)
    rim.setAlpha(color.alpha())
    band.setStrokeColor(color)
    band.setSecondaryStrokeColor(rim)
    band.setFillColor(QColor(0, 0, 0, 0))
    band.setWidth(2)
    # Below the winning window.
    band.setZValue(band.zValue() - 1)
    return band


def _arrow(hit: Finding) -> QgsGeometry:
    """From the center to where the image's top edge is, on the map; empty where the heading is not known."""
    if hit.heading is None or hit.outline is None:
        return QgsGeometry()
    length, center = sqrt(hit.outline.area()) / 2, hit.center
    tip = _away(center, hit.heading, length)
    barbs = [_away(tip, hit.heading + 180 + side, _ARROW_HEAD * length) for side in (-30, 30)]
    return QgsGeometry.fromMultiPolylineXY([[center, tip], [barbs[0], tip, barbs[1]]])


def _away(point: QgsPointXY, heading_deg: float, distance: float) -> QgsPointXY:
    turn = radians(heading_deg)
    return QgsPointXY(point.x() + distance * sin(turn), point.y() + distance * cos(turn))


def _error_circle(hit: Finding) -> QgsGeometry:
    """Holds the position in 95 % of fixes; empty where the method tells no error."""
    if hit.error_95 is None:
        return QgsGeometry()
    return QgsGeometry.fromPointXY(hit.center).buffer(hit.error_95, _POINTS_A_SIDE)
