"""A label map's polygons as an output layer."""

from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.core import QgsGeometry

from ...core.errors import LabelMapError
from ..compat import POLYGON
from ..translation import tr
from .base import check_canceled, interruptible

if TYPE_CHECKING:
    from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingFeedback

    from ...core.labels.class_table import ClassTable
    from .outputs import Outputs
    from .values import Values

FIELDS = (("class", "integer"), ("class_name", "text"), ("area", "real"))

TOLERANCE_PX = 1.5
"""Straightens the stairs of pixels: those of a slanting line are at most 0.71 pixels off it."""

_CHECK_EVERY = 1000


def write_polygons(
    values: Values,
    outputs: Outputs,
    key: str,
    path: str,
    crs: QgsCoordinateReferenceSystem,
    table: ClassTable,
    feedback: QgsProcessingFeedback,
) -> None:
    """Writes the polygons of the label map in ``path`` where they are wanted, by MINIMUM_AREA and TOLERANCE.

    Raises:
        LabelMapError: They can't be made.
        Canceled: The user canceled.
    """
    if not outputs.wants(key):
        return
    from ...core.annotation.coverage import areas_and_wkb, can_simplify
    from ...storage.outlining import LabelPolygons
    from ...storage.rasters import open_raster
    from ..exchange.layer_looks import class_polygons_look

    transform = open_raster(path).GetGeoTransform(can_return_null=True) or (0.0, 1.0, 0.0, 0.0, 0.0, -1.0)
    tolerance = values.optional_number("TOLERANCE", TOLERANCE_PX * abs(transform[1]))
    if tolerance and not can_simplify():
        feedback.pushWarning(tr("Borders keep the pixels’ edges: straightening them takes shapely 2.1 with GEOS 3.12."))
    polygons = LabelPolygons(path, values.optional_number("MINIMUM_AREA", 0.0), tolerance)
    try:
        for what, share in interruptible(polygons.steps(lambda: not feedback.isCanceled()), feedback):
            check_canceled(feedback)
            feedback.setProgressText(tr(what))
            feedback.setProgress(100 * share)
    except LabelMapError:
        check_canceled(feedback)
        raise
    names = {one.value: one.name for one in table}
    areas, wkb = areas_and_wkb(polygons.polygons)
    with outputs.layer(key, FIELDS, POLYGON, crs, class_polygons_look(table)) as sink:
        for n, (value, area, outline) in enumerate(zip(polygons.classes.tolist(), areas.tolist(), wkb)):
            if n % _CHECK_EVERY == 0:
                check_canceled(feedback)
            geometry = QgsGeometry()
            geometry.fromWkb(outline)
            sink.add_row(geometry, (value, names.get(value), area))
