"""Search area: a circle that is drawn on the canvas, or the whole database."""

from __future__ import annotations

from qgis.core import QgsCoordinateReferenceSystem, QgsCoordinateTransform, QgsPointXY, QgsProject
from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtWidgets import QWidget

from ....processing.layers.reference_systems import ellipsoidal_measure, transformed_point
from ....processing.messages.numbers import LocalTemplate
from ....processing.translation import tr
from ...canvas.map_tools import CircleTool
from ...canvas.marks import CircleMark
from ...project_state import Prior
from ...widgets.controls import tool_button
from ...widgets.layouts import narrow, row_of
from ...widgets.progress import StatusLine


class PriorRow(QWidget):
    """Row with the search area and its buttons. circle: None for the whole database."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__()
        self.setObjectName("SemRefPrior")
        self._canvas = canvas
        self.circle: Prior | None = None
        self._radius_m = 0.0
        self._mark = CircleMark(canvas, self)
        self.text = StatusLine()
        self.draw = tool_button("/mActionCircle2Points.svg", tr("Draw the search area"), checkable=True)
        self.draw.setToolTip(tr("Draw the search area on the map: press at its center and drag to its edge"))
        self.clear = tool_button("/mActionDeleteSelected.svg", tr("Search the whole database"))
        self.setLayout(narrow(row_of((self.text, 1), self.draw, self.clear), 0))
        self.clear.clicked.connect(self.forget)
        self._tool = CircleTool(canvas, self.draw)
        self._tool.dragged.connect(self._preview)
        self._tool.drawn.connect(self.set_circle)
        self.forget()

    def parameters(self) -> dict:
        """Return PRIOR_POINT and PRIOR_RADIUS of semref:localizeimages; empty without a circle."""
        if self.circle is None:
            return {}
        x, y, *_edge, crs = self.circle
        return {"PRIOR_POINT": f"{x!r},{y!r} [{crs}]", "PRIOR_RADIUS": self._radius_m}

    def set_circle(self, middle: QgsPointXY, edge: QgsPointXY) -> None:
        """Set the circle by center and edge point in the canvas's CRS. Its radius is measured on the ellipsoid."""
        crs = self._canvas.mapSettings().destinationCrs()
        if crs.isValid() and not crs.authid():
            # A custom CRS has no key that a project or a parameter could name.
            wgs84 = QgsCoordinateReferenceSystem("EPSG:4326")
            way = QgsCoordinateTransform(crs, wgs84, QgsProject.instance())
            middle, edge, crs = transformed_point(way, middle), transformed_point(way, edge), wgs84
            if middle is None or edge is None:
                # Drawn outside the area of the CRS, such as beside a globe: there is no such place.
                return
        self.restore((middle.x(), middle.y(), edge.x(), edge.y(), crs.authid()))
        self._tool.shut_down()

    def restore(self, circle: Prior | None) -> None:
        """Search in a circle; in the whole database for None and for a circle in an unknown CRS.

        A circle of a project without CRS has no authid. Its coordinates are those of the database.
        """
        crs = QgsCoordinateReferenceSystem() if circle is None else QgsCoordinateReferenceSystem(circle[4])
        if circle is None or (circle[4] and not crs.isValid()):
            self.forget()
            return
        self.circle = circle
        middle, edge = QgsPointXY(*circle[:2]), QgsPointXY(*circle[2:4])
        self._radius_m = _distance_m(middle, edge, crs)
        self._mark.show(middle, self._radius_m, crs)
        self.text.show_text(LocalTemplate(tr("Search area: radius {radius:.0f} m")).format(radius=self._radius_m))
        self.clear.setEnabled(True)

    def forget(self) -> None:
        """Search the whole database."""
        self.circle = None
        self._mark.clear()
        self.text.show_text(tr("Search area: the whole database"))
        self.clear.setEnabled(False)

    def _preview(self, middle: QgsPointXY, edge: QgsPointXY) -> None:
        crs = self._canvas.mapSettings().destinationCrs()
        self._mark.show(middle, _distance_m(middle, edge, crs), crs)


def _distance_m(first: QgsPointXY, second: QgsPointXY, crs: QgsCoordinateReferenceSystem) -> float:
    return ellipsoidal_measure(crs, QgsProject.instance().transformContext()).measureLine(first, second)
