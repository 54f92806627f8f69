"""What every mark on the canvas shares: rubber bands that follow the canvas's CRS, can be hidden and be taken away."""

from __future__ import annotations

from collections.abc import Mapping

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsGeometry,
    QgsProject,
    QgsRectangle,
)
from qgis.gui import QgsMapCanvas, QgsRubberBand
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtGui import QColor

from ...processing.compat import POLYGON_GEOMETRY

# Red with a white rim stands out on land-cover colors, aerial images, white and black alike.
RED = QColor("#e8344e")
BLUE = QColor("#1f6fd6")
ORANGE = QColor("#e69f00")
RIM = QColor("#ffffff")

_PLACE_MARGIN = 3.0
_CLOSEST_SCALE = 500
"""Specks are shown with some ground around them: not nearer than 1:500."""

POINTS_A_SIDE = 16
"""Straight sides are curves in another CRS: so many points are put on each."""


class Marks(QObject):
    """Shapes on the canvas, each drawn by a rubber band of its own. ``remove`` takes them off the canvas for good."""

    def __init__(self, canvas: QgsMapCanvas, bands: Mapping[str, QgsRubberBand]) -> None:
        """Draws nothing yet.

        Args:
            canvas: The map canvas to draw on.
            bands: The rubber bands by the names of the shapes they will draw.
        """
        super().__init__()
        self._canvas = canvas
        self._bands = dict(bands)
        self._shapes: dict[str, QgsGeometry] = {}
        self._crs = QgsCoordinateReferenceSystem()
        self._visible = True
        canvas.destinationCrsChanged.connect(self._place)

    def draw(self, shapes: Mapping[str, QgsGeometry], crs: QgsCoordinateReferenceSystem) -> bool:
        """Draws these shapes instead of those drawn before.

        Args:
            shapes: Geometries by the names of their bands; bands without one are emptied.
            crs: What the geometries are in.

        Returns:
            False where the canvas's CRS has no such place.
        """
        self._shapes, self._crs = dict(shapes), crs
        return self._place()

    def clear(self) -> None:
        """Draws nothing any more."""
        self.draw({}, self._crs)

    def set_visible(self, visible: bool) -> None:
        """Hides the marks, or brings them back."""
        self._visible = visible
        self._place()

    def drawn(self, name: str) -> QgsGeometry:
        """What a band shows now, in the canvas's CRS; an empty geometry where it shows nothing."""
        return self._bands[name].asGeometry()

    def zoom_to(self, name: str, factor: float) -> None:
        """Moves the canvas to a drawn shape, so that it shows ``factor`` times its extent; not for an empty one."""
        extent = self.drawn(name).boundingBox()
        if not extent.isEmpty():
            show_extent(self._canvas, extent, factor)

    def remove(self) -> None:
        """Takes everything off the canvas for good."""
        self._canvas.destinationCrsChanged.disconnect(self._place)
        for band in self._bands.values():
            self._canvas.scene().removeItem(band)
        self._bands.clear()

    def _place(self) -> bool:
        placed = self._on_canvas() if self._visible else {}
        for name, band in self._bands.items():
            # An empty geometry empties the band.
            band.setToGeometry((placed or {}).get(name) or QgsGeometry())
        return placed is not None

    def _on_canvas(self) -> dict[str, QgsGeometry] | None:
        """The shapes in the canvas's CRS; None where that has no such place."""
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
    """An empty rubber band.

    Args:
        kind: ``POLYGON_GEOMETRY`` or ``LINE_GEOMETRY`` of ``processing.compat``.
        color: Of its line; the rim is as opaque as it.
        width: Of its line, in pixels.
        filled: Opacity of its inside, of 255; by default the map's colors inside stay what they are.
        rim: Whether a white rim sets it off.
    """
    made = QgsRubberBand(canvas, kind)
    made.setStrokeColor(color)
    if rim:
        made.setSecondaryStrokeColor(with_opacity(RIM, color.alpha()))
    made.setFillColor(with_opacity(color, filled))
    made.setWidth(width)
    return made


def with_opacity(color: QColor, opacity: int) -> QColor:
    """The color with another opacity, of 255."""
    return QColor(color.red(), color.green(), color.blue(), opacity)


def to_canvas(canvas: QgsMapCanvas, crs: QgsCoordinateReferenceSystem) -> QgsCoordinateTransform:
    """From a CRS to the canvas's."""
    return QgsCoordinateTransform(crs, canvas.mapSettings().destinationCrs(), QgsProject.instance())


def show_extent(canvas: QgsMapCanvas, extent: QgsRectangle, factor: float) -> None:
    """Moves the canvas so that it shows ``factor`` times an extent in its CRS."""
    extent.scale(factor)
    canvas.setExtent(extent)
    canvas.refresh()


def square(x: float, y: float, size: float) -> QgsGeometry:
    """A square around (x, y) with edges of ``size``, ready to be drawn in any CRS."""
    half = size / 2
    outline = QgsGeometry.fromRect(QgsRectangle(x - half, y - half, x + half, y + half))
    return outline.densifyByCount(POINTS_A_SIDE)


class PlaceMark(Marks):
    """A polygon of a check's findings."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas, {"place": band(canvas, POLYGON_GEOMETRY, RED, filled=40, rim=False)})

    def show(self, place: QgsGeometry, crs: QgsCoordinateReferenceSystem) -> None:
        self.draw({"place": place}, crs)

    def zoom(self, least_extent: float) -> None:
        """Moves the canvas to the place; ``least_extent``, in its units, is added, as points and lines have none."""
        extent = self.drawn("place").boundingBox()
        if self.drawn("place").isEmpty():
            return
        extent.grow(least_extent)
        show_extent(self._canvas, extent, _PLACE_MARGIN)
        if self._canvas.scale() < _CLOSEST_SCALE:
            self._canvas.zoomScale(_CLOSEST_SCALE)
            self._canvas.refresh()
