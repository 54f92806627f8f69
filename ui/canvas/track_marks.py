"""A flight on the canvas: lines between images, and dots colored by the source of the position."""

from __future__ import annotations

from collections.abc import Sequence

from qgis.core import QgsGeometry
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QObject

from ...processing.compat import LINE_GEOMETRY
from ..findings import Finding
from .marks import BLUE, ORANGE, RED, Marks, band, dots, with_opacity

_DOT_PX, _WIDTH_PX = 9, 2


class TrackMarks(Marks):
    """Tracks of flights; nothing for single images."""

    def __init__(self, canvas: QgsMapCanvas, parent: QObject) -> None:
        super().__init__(
            canvas,
            parent,
            {
                "track": band(canvas, LINE_GEOMETRY, with_opacity(BLUE, 180), _WIDTH_PX),
                "own": dots(canvas, BLUE, _DOT_PX),
                "flight": dots(canvas, ORANGE, _DOT_PX),
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


def _kind(finding: Finding) -> str:
    return "outvoted" if finding.outvoted else str(finding.source)
