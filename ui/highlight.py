"""The selected hit on the canvas: outline of its window and a marker at its centre."""

from __future__ import annotations

from typing import Optional

from qgis.core import QgsCoordinateTransform, QgsCsException, QgsGeometry, QgsPointXY, QgsProject
from qgis.gui import QgsMapCanvas, QgsRubberBand, QgsVertexMarker
from qgis.PyQt.QtGui import QColor

from ..processing.compat import POLYGON_GEOMETRY
from .findings import Finding

# Red with a white rim stands out on land-cover colours, aerial images, white and black alike.
_LINE = QColor("#e8344e")
_RIM = QColor("#ffffff")

_ZOOM_MARGIN = 2.0
"""The canvas shows this many times the window's size, so that its surroundings can be seen."""

_POINTS_A_SIDE = 16
"""A window's straight sides are curves in another CRS."""


class HitHighlight:
    """Follows the canvas's CRS. ``remove`` takes it off the canvas for good."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        self._canvas = canvas
        self._hit: Optional[Finding] = None
        self._outline = QgsRubberBand(canvas, POLYGON_GEOMETRY)
        self._outline.setStrokeColor(_LINE)
        self._outline.setSecondaryStrokeColor(_RIM)
        # Unfilled: the map's colours inside the window stay what they are.
        self._outline.setFillColor(QColor(0, 0, 0, 0))
        self._outline.setWidth(2)
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
        """Shows the finding's hit, or nothing for None or no fix. False when the canvas's CRS can't show it."""
        self._hit = finding if finding is not None and finding.center is not None else None
        return self._place()

    def set_visible(self, visible: bool) -> None:
        self._visible = visible
        self._place()

    def zoom(self) -> None:
        """Moves the canvas to the hit, if one is shown."""
        extent = self._outline.asGeometry().boundingBox()
        if self._hit is None or extent.isEmpty():
            return
        extent.scale(_ZOOM_MARGIN)
        self._canvas.setExtent(extent)
        self._canvas.refresh()

    def remove(self) -> None:
        self._canvas.destinationCrsChanged.disconnect(self._place)
        for item in (self._outline, self._center):
            self._canvas.scene().removeItem(item)
        self._outline = self._center = None

    def _place(self) -> bool:
        placed = self._on_canvas() if self._hit is not None and self._visible else None
        self._outline.reset(POLYGON_GEOMETRY)
        self._center.setVisible(placed is not None)
        if placed is None:
            return self._hit is None or not self._visible
        outline, center = placed
        self._outline.setToGeometry(outline)
        self._center.setCenter(center)
        return True

    def _on_canvas(self):
        """(outline, centre) in the canvas's CRS; None where that CRS has no such place."""
        outline = QgsGeometry() if self._hit.outline is None else self._hit.outline.densifyByCount(_POINTS_A_SIDE)
        target = self._canvas.mapSettings().destinationCrs()
        if not target.isValid() or target == self._hit.crs:
            return outline, self._hit.center
        transform = QgsCoordinateTransform(self._hit.crs, target, QgsProject.instance())
        try:
            center = transform.transform(self._hit.center)
            if not outline.isNull():
                outline.transform(transform)
        except QgsCsException:
            return None
        return outline, QgsPointXY(center)
