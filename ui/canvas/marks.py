"""Marks on the canvas: rubber bands that follow the CRS of the canvas and can be hidden and removed."""

from __future__ import annotations

from collections.abc import Mapping

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsGeometry,
    QgsPointXY,
    QgsProject,
    QgsRectangle,
)
from qgis.gui import QgsMapCanvas, QgsRubberBand
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtGui import QColor

from ...processing.compat import LINE_GEOMETRY, POINT_GEOMETRY, POLYGON_GEOMETRY
from ...processing.inspection.window import InspectedWindow
from ...processing.layers.palette import WARNING
from ...processing.layers.reference_systems import transformed_point

# Red with a white rim is visible on land-cover colors, aerial images, white and black.
RED = QColor("#e8344e")
BLUE = QColor("#1f6fd6")
AMBER = QColor(WARNING)
RIM = QColor("#ffffff")

_PLACE_MARGIN = 3.0
_CLOSEST_SCALE = 500
"""Largest scale (1:500), so that small places are shown with their surroundings."""

POINTS_A_SIDE = 16
"""Number of points on each side, because straight sides are curves in another CRS."""


class Marks(QObject):
    """Shapes on the canvas, each drawn by its own rubber band."""

    def __init__(self, canvas: QgsMapCanvas, parent: QObject, bands: Mapping[str, QgsRubberBand]) -> None:
        """``bands``: rubber bands on the canvas by the names of their shapes."""
        super().__init__(parent)
        self._canvas = canvas
        self._bands = dict(bands)
        self._shapes: dict[str, QgsGeometry] = {}
        self._crs = QgsCoordinateReferenceSystem()
        self._visible = True
        canvas.destinationCrsChanged.connect(self._place)

    def draw(self, shapes: Mapping[str, QgsGeometry], crs: QgsCoordinateReferenceSystem) -> bool:
        """Replace the drawn shapes.

        Args:
            shapes: Geometries by the names of their bands; other bands become empty.

        Returns:
            False if the shapes can't be transformed to the canvas's CRS.
        """
        self._shapes, self._crs = dict(shapes), crs
        return self._place()

    def clear(self) -> None:
        self.draw({}, self._crs)

    def set_visible(self, visible: bool) -> None:
        self._visible = visible
        self._place()

    def drawn(self, name: str) -> QgsGeometry:
        """Return the shape that a band shows in the canvas's CRS; an empty geometry if it is empty."""
        return self._bands[name].asGeometry()

    def zoom_to(self, name: str, factor: float) -> None:
        """Move the canvas to a drawn shape and show ``factor`` times its extent; nothing for an empty shape."""
        extent = self.drawn(name).boundingBox()
        if not extent.isEmpty():
            show_extent(self._canvas, extent, factor)

    def shut_down(self) -> None:
        """Remove the bands from the canvas for good."""
        self._canvas.destinationCrsChanged.disconnect(self._place)
        for band in self._bands.values():
            self._canvas.scene().removeItem(band)
        self._bands.clear()

    def _place(self) -> bool:
        placed = self._on_canvas() if self._visible else {}
        for name, band in self._bands.items():
            # An empty geometry clears the band.
            band.setToGeometry((placed or {}).get(name) or QgsGeometry())
        return placed is not None

    def _on_canvas(self) -> dict[str, QgsGeometry] | None:
        """Return the shapes in the canvas's CRS; None if they can't be transformed."""
        transform = to_canvas(self._canvas, self._crs)
        placed = {name: QgsGeometry(shape) for name, shape in self._shapes.items() if not shape.isEmpty()}
        try:
            for shape in placed.values():
                shape.transform(transform)
        except QgsCsException:
            return None
        return placed


def band(
    canvas: QgsMapCanvas, kind: int, color: QColor, width: int = 2, filled: int = 0, rim: bool = True
) -> QgsRubberBand:
    """Return an empty rubber band.

    Args:
        kind: ``POLYGON_GEOMETRY`` or ``LINE_GEOMETRY`` of ``processing.compat``.
        color: Color of the line; the rim has the same opacity.
        width: Width of the line in pixels.
        filled: Opacity (0–255) of the interior.
        rim: Whether the line has a white rim.
    """
    made = QgsRubberBand(canvas, kind)
    made.setStrokeColor(color)
    if rim:
        made.setSecondaryStrokeColor(with_opacity(RIM, color.alpha()))
    made.setFillColor(with_opacity(color, filled))
    made.setWidth(width)
    return made


def with_opacity(color: QColor, opacity: int) -> QColor:
    """Return the color with another opacity (0–255)."""
    return QColor(color.red(), color.green(), color.blue(), opacity)


def to_canvas(canvas: QgsMapCanvas, crs: QgsCoordinateReferenceSystem) -> QgsCoordinateTransform:
    """Return the transformation from a CRS to that of the canvas."""
    return QgsCoordinateTransform(crs, canvas.mapSettings().destinationCrs(), QgsProject.instance())


def show_extent(canvas: QgsMapCanvas, extent: QgsRectangle, factor: float) -> None:
    """Move the canvas to ``factor`` times an extent in its CRS."""
    extent.scale(factor)
    canvas.setExtent(extent)
    canvas.refresh()


def square(x: float, y: float, size: float) -> QgsGeometry:
    """Return a square around (x, y) with edges of ``size``, with points on its sides for other CRSs."""
    half = size / 2
    outline = QgsGeometry.fromRect(QgsRectangle(x - half, y - half, x + half, y + half))
    return outline.densifyByCount(POINTS_A_SIDE)


def dots(canvas: QgsMapCanvas, color: QColor, size_px: int) -> QgsRubberBand:
    """Return an empty rubber band for points, drawn as disks with a white rim."""
    made = band(canvas, POINT_GEOMETRY, color)
    made.setIcon(made.IconType.ICON_CIRCLE)
    made.setIconSize(size_px)
    made.setFillColor(color)
    return made


class CircleMark(Marks):
    """Circle that is round on the ground."""

    def __init__(self, canvas: QgsMapCanvas, parent: QObject) -> None:
        super().__init__(canvas, parent, {"circle": band(canvas, POLYGON_GEOMETRY, BLUE, filled=30, rim=False)})

    def show(self, middle: QgsPointXY, radius_m: float, crs: QgsCoordinateReferenceSystem) -> None:
        """Draw a circle around ``middle``, a point in ``crs``; without a valid CRS, coordinates are meters."""
        if crs.isValid():
            wgs84 = QgsCoordinateReferenceSystem("EPSG:4326")
            center = transformed_point(QgsCoordinateTransform(crs, wgs84, QgsProject.instance()), middle)
            if center is None:
                self.clear()
                return
            # Distances from the center are true.
            local = f"+proj=aeqd +lat_0={center.y()!r} +lon_0={center.x()!r} +datum=WGS84"
            middle, crs = QgsPointXY(0, 0), QgsCoordinateReferenceSystem.fromProj(local)
        self.draw({"circle": QgsGeometry.fromPointXY(middle).buffer(radius_m, POINTS_A_SIDE)}, crs)


class PlaceMark(Marks):
    """Polygon of a place to check."""

    def __init__(self, canvas: QgsMapCanvas, parent: QObject) -> None:
        super().__init__(canvas, parent, {"place": band(canvas, POLYGON_GEOMETRY, RED, filled=40, rim=False)})

    def show(self, place: QgsGeometry, crs: QgsCoordinateReferenceSystem) -> None:
        self.draw({"place": place}, crs)

    def zoom(self, least_extent: float) -> None:
        """Move the canvas to the place, enlarged by ``least_extent`` in CRS units because points have no extent."""
        extent = self.drawn("place").boundingBox()
        if self.drawn("place").isEmpty():
            return
        extent.grow(least_extent)
        show_extent(self._canvas, extent, _PLACE_MARGIN)
        if self._canvas.scale() < _CLOSEST_SCALE:
            self._canvas.zoomScale(_CLOSEST_SCALE)
            self._canvas.refresh()


_ZOOM_MARGIN = 1.6


class WindowMarks(Marks):
    """A window of the database, lines to the landmarks of its vector, and similar windows."""

    def __init__(self, canvas: QgsMapCanvas, parent: QObject) -> None:
        super().__init__(
            canvas,
            parent,
            {
                "window": band(canvas, POLYGON_GEOMETRY, BLUE, width=3),
                "star": band(canvas, LINE_GEOMETRY, BLUE, width=1),
                "look-alikes": band(canvas, POLYGON_GEOMETRY, AMBER),
            },
        )

    def show(self, window: InspectedWindow, crs: QgsCoordinateReferenceSystem) -> None:
        """Draw a window with coordinates in ``crs``."""
        center = QgsPointXY(*window.center_xy)
        star = [[center, QgsPointXY(*end)] for end in window.ends_xy]
        look_alikes = [square(*other.center_xy, other.size) for other in window.look_alikes]
        shapes = {
            "window": square(*window.center_xy, window.size),
            "star": QgsGeometry.fromMultiPolylineXY(star),
            "look-alikes": QgsGeometry.collectGeometry(look_alikes),
        }
        self.draw(shapes, crs)

    def zoom(self) -> None:
        """Move the canvas to the window unless all of it is visible."""
        if not self._canvas.extent().contains(self.drawn("window").boundingBox()):
            self.zoom_to("window", _ZOOM_MARGIN)
