"""semref:rasterizeannotation: convert land-cover polygons to a label map."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterCrs,
    QgsProcessingParameterExtent,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterDestination,
)

from ...core.labels.class_table import ClassTable
from ...storage.pixel_grid import pixel_grid, union_of_bounds
from ..base import parameters
from ..base.algorithm import Declared, follow
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.scheduler import require_scheduler, scheduler, workers
from ..base.values import Values
from ..compat import DOUBLE, wkt_for_gdal
from ..jobs.annotation import AnnotationAlgorithm, filling_polygon
from ..messages.numbers import shown
from ..translation import tr

if TYPE_CHECKING:
    from ...core.geometry.frame import MapFrame
    from ...storage.rasterize import BurnPolygon

READING_SHARE = 30.0
"""Progress in percent after the polygons are read."""


class RasterizeAnnotation(AnnotationAlgorithm):
    ID = "rasterizeannotation"
    TITLE = "Rasterize land-cover layer"
    TAGS = ("rasterize", "burn", "land cover", "label map", "polygons", "shapefile")
    SUMMARY = (
        "Converts a land-cover layer to a label map: a single-band GeoTIFF of class values. Pixels without a "
        "polygon are 0.\n\nClasses come from the class table, otherwise from the categorized style of the layer, "
        "otherwise from the values of the class field. Invalid polygons are repaired and empty polygons are "
        "skipped; the log shows their number."
    )

    PIXEL_SIZE = "PIXEL_SIZE"
    TARGET_CRS = "TARGET_CRS"
    OTHER_GROUND = "OTHER_GROUND"
    CLASS_COUNT = "CLASS_COUNT"
    LABELED_FRACTION = "LABELED_FRACTION"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            *parameters.annotation(),
            with_help(
                QgsProcessingParameterNumber(self.PIXEL_SIZE, "Pixel size (m)", DOUBLE, 1.0, minValue=0.001),
                "Edge length of a pixel, for example 1. The smallest landmark should cover about 50 pixels.",
            ),
            with_help(
                QgsProcessingParameterExtent(self.EXTENT, "Extent", optional=True),
                "Area to rasterize, extended to whole pixels. If not set, the extent of the polygons is used.",
            ),
            with_help(
                QgsProcessingParameterCrs(self.TARGET_CRS, "Target CRS", optional=True),
                "Projected CRS with meters. If not set, the CRS of the layer is used if its unit is a meter on the "
                "ground, otherwise a UTM zone.",
            ),
            with_help(
                QgsProcessingParameterBoolean(
                    self.OTHER_GROUND, "Treat ground without a polygon as class “other”", defaultValue=False
                ),
                "Applies within the extent of the polygons. Use it if all areas of the classes were drawn. SemRef "
                "always does this for a layer with a single class, such as buildings.",
            ),
            with_help(
                QgsProcessingParameterRasterDestination(self.OUTPUT, "Label map"),
                "8-bit GeoTIFF with class table, colors and class names.",
            ),
            scheduler(),
            QgsProcessingOutputNumber(self.CLASS_COUNT, "Number of classes on the map"),
            QgsProcessingOutputNumber(self.LABELED_FRACTION, "Labeled fraction of the map"),
        )

    def check(self, values: Values) -> None:
        super().check(values)
        values.crs(self.TARGET_CRS)
        require_scheduler(values)

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, float]:
        crs = self.label_map_crs(values, feedback, values.crs(self.TARGET_CRS))
        polygons, table = self.burn_polygons(values, feedback, crs, READING_SHARE)
        drawn, frame = len(polygons), self._frame(values, crs, polygons)
        if sum(bool(one.value) for one in table) == 1:
            feedback.pushInfo(tr("The layer has a single class. Ground without a polygon becomes class “other”."))
            table = table.with_filling()
        table = table.with_filling() if values.switch(self.OTHER_GROUND) else table
        if table.filling is not None:
            polygons.insert(0, filling_polygon(table.filling.value, [polygon.bounds for polygon in polygons]))
        height, width = frame.shape_hw
        feedback.pushInfo(
            tr("Burning {count} polygons into {width} × {height} pixels").format(
                count=drawn, width=width, height=height
            )
        )
        with outputs.label_map(self.OUTPUT, table) as path:
            counts = self._burn(values, path, frame, table, polygons, feedback)
        labeled = sum(counts[1:])
        present = [c for c in table if c.value and counts[c.value]]
        feedback.pushInfo(
            tr("Label map of {width} × {height} pixels, {share:.1%} labeled: {classes}").format(
                width=width,
                height=height,
                share=labeled / (width * height),
                classes=", ".join(
                    f"{c.value} {c.name} {shown(counts[c.value] / (width * height), '.2%')}" for c in present
                ),
            )
        )
        if not labeled:
            feedback.pushWarning(
                tr(
                    "The label map is empty, because no polygon is in the extent. Check the extent and the CRS of the "
                    "layer."
                )
            )
        return {self.CLASS_COUNT: len(present), self.LABELED_FRACTION: labeled / (width * height)}

    def _burn(
        self,
        values: Values,
        path: str,
        frame: MapFrame,
        table: ClassTable,
        polygons: list[BurnPolygon],
        feedback: QgsProcessingFeedback,
    ) -> list[int]:
        """Write the label map and return the pixels of each value. Workers get polygons, so the layer may be of any
        kind."""
        from ...cluster.task_names import BURN
        from ...storage.rasterize import burn_label_map

        with workers(values, feedback, {}) as run:
            burn = None if run is None else partial(run, BURN, shared=(frame.crs,))
            steps = burn_label_map(path, frame, table, polygons, burn)
            return follow(steps, feedback, READING_SHARE, 100).tolist()

    def _frame(self, values: Values, crs: QgsCoordinateReferenceSystem, polygons: list[BurnPolygon]) -> MapFrame:
        """Return the whole pixels of the extent, or of the polygons without an extent."""
        extent = values.extent(self.EXTENT, crs)
        bounds = (extent.xMinimum(), extent.yMinimum(), extent.xMaximum(), extent.yMaximum())
        if extent.isEmpty():
            bounds = union_of_bounds([polygon.bounds for polygon in polygons])
        return pixel_grid(bounds, values.number(self.PIXEL_SIZE), wkt_for_gdal(crs))
