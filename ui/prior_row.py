"""Where images are known to be, roughly: a circle drawn on the canvas, or nowhere."""

from __future__ import annotations

from typing import Optional

from qgis.core import (
    QgsApplication,
    QgsCoordinateReferenceSystem,
    QgsDistanceArea,
    QgsPointXY,
    QgsProject,
)
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtWidgets import QHBoxLayout, QLabel, QToolButton, QWidget

from ..processing.translation import tr
from .prior_tool import PriorTool


class PriorRow(QWidget):
    """``shut_down`` before it is deleted."""

    def __init__(self, canvas: QgsMapCanvas, parent=None) -> None:
        super().__init__(parent)
        self.setObjectName("SemRefPrior")
        self._canvas = canvas
        self._middle: Optional[QgsPointXY] = None
        self._crs: Optional[QgsCoordinateReferenceSystem] = None
        self._radius_m = 0.0
        self.tool = PriorTool(canvas)
        self.text = QLabel()
        self.draw = QToolButton()
        self.draw.setIcon(QgsApplication.getThemeIcon("/mActionCircle2Points.svg"))
        self.draw.setCheckable(True)
        self.draw.setToolTip(tr("Draw on the map where the images are known to be: press at the middle and drag"))
        self.draw.setAccessibleName(tr("Draw where to search"))
        self.clear = QToolButton()
        self.clear.setIcon(QgsApplication.getThemeIcon("/mActionDeleteSelected.svg"))
        self.clear.setToolTip(tr("Search the whole database"))
        self.clear.setAccessibleName(self.clear.toolTip())
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.text, 1)
        layout.addWidget(self.draw)
        layout.addWidget(self.clear)
        self.draw.toggled.connect(self._draw)
        self.clear.clicked.connect(self.forget)
        self.tool.drawn.connect(self.set_circle)
        self.tool.deactivated.connect(self._stop_drawing)
        self.forget()

    def parameters(self) -> dict:
        """PRIOR_POINT and PRIOR_RADIUS of semref:localizeimages; empty without a circle."""
        if self._middle is None:
            return {}
        point = f"{self._middle.x()!r},{self._middle.y()!r} [{self._crs.authid()}]"
        return {"PRIOR_POINT": point, "PRIOR_RADIUS": self._radius_m}

    def set_circle(self, middle: QgsPointXY, edge: QgsPointXY) -> None:
        """Both in the canvas's CRS; the radius is measured on the ground."""
        self._middle, self._crs = middle, self._canvas.mapSettings().destinationCrs()
        measure = QgsDistanceArea()
        measure.setSourceCrs(self._crs, QgsProject.instance().transformContext())
        measure.setEllipsoid(QgsProject.instance().ellipsoid() or "WGS84")
        self._radius_m = measure.measureLine(middle, edge)
        self.tool.show_circle(middle, edge)
        self.text.setText(tr("Search: within {radius:.0f} m").format(radius=self._radius_m))
        self.clear.setEnabled(True)
        self._canvas.unsetMapTool(self.tool)

    def forget(self) -> None:
        self._middle = None
        self.tool.show_circle(None, None)
        self.text.setText(tr("Search: the whole database"))
        self.clear.setEnabled(False)

    def shut_down(self) -> None:
        self.tool.deactivated.disconnect(self._stop_drawing)
        self._canvas.unsetMapTool(self.tool)
        self.tool.remove()

    def _draw(self, on: bool) -> None:
        if on:
            self._canvas.setMapTool(self.tool)
        else:
            self._canvas.unsetMapTool(self.tool)

    def _stop_drawing(self) -> None:
        self.draw.setChecked(False)
