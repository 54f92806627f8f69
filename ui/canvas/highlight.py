"""Results on the canvas: footprint, heading and 95 % circle of the selected one, and the tracks of flights."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, radians, sin, sqrt

from qgis.core import QgsGeometry, QgsPointXY
from qgis.gui import QgsMapCanvas, QgsRubberBand
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtGui import QColor

from ...processing.compat import LINE_GEOMETRY, POLYGON_GEOMETRY
from ..findings import Finding
from .marks import AMBER, BLUE, POINTS_A_SIDE, RED, RIM, Marks, band, dots, with_opacity

_ZOOM_MARGIN = 2.0
"""Factor by which the visible extent exceeds the footprint."""

_CENTER_PX, _DOT_PX, _TRACK_PX = 10, 9, 2
_ARROW_HEAD = 0.12
"""Length of the barbs of the heading arrow, as a share of its shaft."""


class HitHighlight(Marks):
    """Footprint, heading arrow, 95 % circle and center of a position; without one, its possible places.

    A position is red; a likely position and possible places are amber.
    """

    def __init__(self, canvas: QgsMapCanvas, parent: QObject) -> None:
        super().__init__(
            canvas,
            parent,
            {
                "outline": band(canvas, POLYGON_GEOMETRY, RED),
                "heading": band(canvas, LINE_GEOMETRY, RED),
                "error": band(canvas, POLYGON_GEOMETRY, RED),
                "possible": band(canvas, POLYGON_GEOMETRY, AMBER),
                "center": _center(canvas),
            },
        )

    def show(self, finding: Finding | None) -> bool:
        """Show a finding's position or possible places; nothing for None. False if the canvas's CRS can't show it."""
        if finding is None or (finding.center is None and not finding.possible):
            self.clear()
            return True
        color = AMBER if finding.is_likely else RED
        for name in ("outline", "heading", "error"):
            self._bands[name].setStrokeColor(color)
        self._bands["center"].setFillColor(color)
        return self.draw(_shapes(finding), finding.crs)

    def zoom(self) -> None:
        """Move the canvas to the shown position or places, if any."""
        # An image has a position or possible places, never both.
        self.zoom_to("possible" if self.drawn("outline").isEmpty() else "outline", _ZOOM_MARGIN)


class TrackMarks(Marks):
    """Tracks of flights; nothing for single images."""

    def __init__(self, canvas: QgsMapCanvas, parent: QObject) -> None:
        super().__init__(
            canvas,
            parent,
            {
                "track": band(canvas, LINE_GEOMETRY, with_opacity(BLUE, 180), _TRACK_PX),
                "own": dots(canvas, BLUE, _DOT_PX),
                "flight": dots(canvas, AMBER, _DOT_PX),
                "outvoted": dots(canvas, RED, _DOT_PX),
            },
        )

    def show(self, findings: Sequence[Finding]) -> None:
        """Show the tracks of these findings, in their order."""
        placed = [finding for finding in findings if finding.track and finding.center is not None]
        if not placed:
            self.clear()
            return
        tracks = [[f.center for f in placed if f.track == track] for track in sorted({f.track for f in placed})]
        shapes = {"track": QgsGeometry.fromMultiPolylineXY([points for points in tracks if len(points) > 1])}
        for kind in ("own", "flight", "outvoted"):
            shapes[kind] = QgsGeometry.fromMultiPointXY([f.center for f in placed if _kind(f) == kind])
        self.draw(shapes, placed[0].crs)


def _center(canvas: QgsMapCanvas) -> QgsRubberBand:
    """Return a small white disk. ``show`` fills it."""
    center = dots(canvas, RIM, _CENTER_PX)
    center.setSecondaryStrokeColor(QColor())
    return center


def _shapes(hit: Finding) -> dict[str, QgsGeometry]:
    """Return the shapes of a finding in its CRS, by the names of their bands."""
    outline = QgsGeometry() if hit.outline is None else hit.outline.densifyByCount(POINTS_A_SIDE)
    possible = [geometry.densifyByCount(POINTS_A_SIDE) for geometry in hit.possible]
    return {
        "outline": outline,
        "heading": _arrow(hit),
        "error": _error_circle(hit),
        "possible": QgsGeometry.collectGeometry(possible),
        "center": QgsGeometry() if hit.center is None else QgsGeometry.fromPointXY(hit.center),
    }


def _arrow(hit: Finding) -> QgsGeometry:
    """Return an arrow from the center to the image's top edge; empty without a heading."""
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
    """Return the circle of the 95 % radius; empty without a radius."""
    if hit.error_95 is None:
        return QgsGeometry()
    return QgsGeometry.fromPointXY(hit.center).buffer(hit.error_95, POINTS_A_SIDE)


def _kind(finding: Finding) -> str:
    return "outvoted" if finding.outvoted else str(finding.source)
