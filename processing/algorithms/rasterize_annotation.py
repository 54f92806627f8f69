"""semref:rasterizeannotation – land-cover polygons to a label map."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsProcessingOutputNumber,
    QgsProcessingParameterCrs,
    QgsProcessingParameterExtent,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterDestination,
)

from ...core.errors import ParameterError
from ..compat import wkt_for_gdal
from ..framework.annotation import AnnotationAlgorithm
from ..framework.base import check_canceled, follow
from ..translation import tr

if TYPE_CHECKING:
    from ...core.geometry.frame import MapFrame

MAXIMUM_PIXELS = 1_000_000_000_000
"""Beyond this a pixel size is taken for a mistake (a country at 1 cm)."""

READING_SHARE = 30.0
"""Percent of the progress that reading the polygons takes."""


class RasterizeAnnotation(AnnotationAlgorithm):
    ID = "rasterizeannotation"
    TAGS = ("rasterize", "burn", "land cover", "label map", "polygons", "shapefile")

    PIXEL_SIZE = "PIXEL_SIZE"
    EXTENT = "EXTENT"
    TARGET_CRS = "TARGET_CRS"
    OUTPUT = "OUTPUT"
    CLASS_COUNT = "CLASS_COUNT"
    LABELED_FRACTION = "LABELED_FRACTION"

    def title(self):
        return tr("Rasterize annotation")

    def summary(self):
        return tr(
            "Burns land-cover polygons into a label map: a single-band GeoTIFF whose pixels hold class values, "
            "0 where no polygon lies.\n\n"
            "Classes come from the class table, else from the layer’s categorized style, else from the values of "
            "the class field. Invalid polygons are repaired, empty ones skipped; the log says how many."
        )

    def initAlgorithm(self, config=None):
        self.offer_annotation()
        self.offer(
            QgsProcessingParameterNumber(
                self.PIXEL_SIZE, tr("Pixel size (m)"), QgsProcessingParameterNumber.Double, 1.0, minValue=0.001
            ),
            tr("Edge length of a pixel in meters. The smallest landmark should cover some 50 pixels."),
        )
        self.offer(
            QgsProcessingParameterExtent(self.EXTENT, tr("Extent"), optional=True),
            tr("Area to rasterize, widened to whole pixels; the extent of the polygons if left out."),
        )
        self.offer(
            QgsProcessingParameterCrs(self.TARGET_CRS, tr("Target CRS"), optional=True),
            tr("Projected CRS in meters. If left out: the layer’s own if it is metric, else a UTM zone."),
        )
        self.offer(
            QgsProcessingParameterRasterDestination(self.OUTPUT, tr("Label map")),
            tr("GeoTIFF, 8 bits a pixel, with the class table, colors and class names."),
        )
        self.addOutput(QgsProcessingOutputNumber(self.CLASS_COUNT, tr("Number of classes on the map")))
        self.addOutput(QgsProcessingOutputNumber(self.LABELED_FRACTION, tr("Fraction of the map that is labeled")))

    def work(self, parameters, context, feedback):
        from ...storage.burning import LabelMapBurning
        from ...storage.files import written_beside
        from ..exchange.reference_systems import describe_crs, metric_crs
        from ..exchange.styles import write_label_map_style

        source = self._source
        pixel_size = self.parameterAsDouble(parameters, self.PIXEL_SIZE, context)
        asked_crs = self.parameterAsCrs(parameters, self.TARGET_CRS, context)
        crs = metric_crs(source.crs, asked_crs, source.extent, context.transformContext())
        if crs != source.crs and not asked_crs.isValid():
            feedback.pushWarning(
                tr("{source} does not measure in meters; the label map is made in {target}.").format(
                    source=describe_crs(source.crs), target=describe_crs(crs)
                )
            )
        polygons, table = self._polygons(parameters, context, feedback, crs)
        extent = self.parameterAsExtent(parameters, self.EXTENT, context, crs)
        bounds = (extent.xMinimum(), extent.yMinimum(), extent.xMaximum(), extent.yMaximum())
        if extent.isEmpty():
            bounds = union_of_bounds([p.bounds for p in polygons])
        frame = pixel_grid(bounds, pixel_size, wkt_for_gdal(crs))
        height, width = frame.shape_hw
        output = self.parameterAsOutputLayer(parameters, self.OUTPUT, context)
        feedback.pushInfo(
            tr("Burning {count} polygons into {width} × {height} pixels").format(
                count=len(polygons), width=width, height=height
            )
        )
        with written_beside(output) as temporary:
            burning = LabelMapBurning(temporary, frame, table, polygons)
            follow(burning.steps(), feedback, READING_SHARE, 100)
        counts = burning.counts
        write_label_map_style(output, table)
        labeled = int(counts[1:].sum())
        present = [c for c in table if c.value and counts[c.value]]
        feedback.pushInfo(
            tr("Label map of {width} × {height} pixels, {share:.1%} labeled: {classes}").format(
                width=width,
                height=height,
                share=labeled / (width * height),
                classes=", ".join(f"{c.value} {c.name} {counts[c.value] / (width * height):.2%}" for c in present),
            )
        )
        if not labeled:
            feedback.pushWarning(tr("No polygon lies in the extent: the label map is empty."))
        return {
            self.OUTPUT: output,
            self.CLASS_COUNT: len(present),
            self.LABELED_FRACTION: labeled / (width * height),
        }

    def _polygons(self, parameters, context, feedback, crs: QgsCoordinateReferenceSystem):
        """Polygons to burn and the class table; says what was repaired and skipped."""
        from ..exchange.annotation import AnnotationCounts, burn_polygons, require_known_classes

        source = self._source
        lookup = self.classes(parameters, context, feedback)
        transform = None
        if crs != source.crs:
            transform = QgsCoordinateTransform(source.crs, crs, context.transformContext())
        counts, polygons = AnnotationCounts(), []
        for n, found in enumerate(burn_polygons(source, lookup, transform, counts)):
            polygons += found
            if n % 256 == 0:
                check_canceled(feedback)
                feedback.setProgress(READING_SHARE * n / max(source.count, 1))
        for warns, sentence in counts.sentences():
            (feedback.pushWarning if warns else feedback.pushInfo)(sentence)
        require_known_classes(counts, source, lookup.table)
        if not polygons:
            raise ParameterError(f"“{source.name}” has no polygon with area and class; there is nothing to rasterize.")
        return polygons, lookup.table


def pixel_grid(bounds, pixel_size: float, crs_wkt: str) -> MapFrame:
    """The frame of the whole pixels around ``bounds``, aligned to multiples of the pixel size.

    Maps of one pixel size then share their pixel corners, whatever their extents. Raises ParameterError.
    """
    from ...core.geometry.frame import MapFrame

    if not pixel_size > 0 or not math.isfinite(pixel_size):
        raise ParameterError(f"The pixel size is {pixel_size:g} m; it must be more than 0.")
    # A bound that is a multiple but for rounding must not add a row of pixels.
    slack = 1e-6
    left, bottom = (math.floor(v / pixel_size + slack) for v in bounds[:2])
    right, top = (math.ceil(v / pixel_size - slack) for v in bounds[2:])
    width, height = max(right - left, 1), max(top - bottom, 1)
    if width * height > MAXIMUM_PIXELS or max(width, height) > 2**31 - 1:
        raise ParameterError(
            f"The label map would have {width} × {height} pixels; choose a larger PIXEL_SIZE or a smaller EXTENT."
        )
    return MapFrame.at((left * pixel_size, top * pixel_size), pixel_size, (height, width), crs_wkt)


def union_of_bounds(bounds):
    """(left, bottom, right, top) around all of such bounds."""
    lefts, bottoms, rights, tops = zip(*bounds)
    return min(lefts), min(bottoms), max(rights), max(tops)
