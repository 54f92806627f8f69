"""semref:decodecolorlabels – color label image to label map."""

from __future__ import annotations

from qgis.core import (
    QgsProcessingParameterEnum,
    QgsProcessingParameterFile,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterRasterLayer,
)

from ...core.labels.class_table import UNLABELED
from ..compat import wkt_for_gdal
from ..framework.base import ANNOTATION, SemRefAlgorithm, check_canceled
from ..translation import tr

ROWS_PIXELS = 4_000_000
"""Pixels decoded at a time."""


class DecodeColorLabels(SemRefAlgorithm):
    ID = "decodecolorlabels"
    GROUP = ANNOTATION
    TAGS = ("color", "color", "hsv", "decode", "label image", "label map")

    INPUT = "INPUT"
    CLASS_TABLE = "CLASS_TABLE"
    METHOD = "METHOD"
    OUTPUT = "OUTPUT"
    HSV_RANGES, NEAREST_COLOR = range(2)

    def title(self):
        return tr("Decode color labels")

    def summary(self):
        return tr(
            "Turns an image that shows classes as colors into a label map, by the HSV ranges of the class table as "
            "published or by the nearest class color.\n\n"
            "Pixels that no range covers are unlabeled (0). With nearest color, black is unlabeled unless a class is "
            "black."
        )

    def initAlgorithm(self, config=None):
        self.offer(
            QgsProcessingParameterRasterLayer(self.INPUT, tr("Color label image")),
            tr("Image with at least three bands (red, green, blue) of 8 bits."),
        )
        self.offer(
            QgsProcessingParameterFile(self.CLASS_TABLE, tr("Class table"), fileFilter=tr("CSV files (*.csv)")),
            tr(
                "CSV with the columns value, name, color, role and, for HSV ranges, hsv_min and hsv_max (“h s v”, "
                "h 0–180, s and v 0–255; the hue may wrap)."
            ),
        )
        self.offer(
            QgsProcessingParameterEnum(
                self.METHOD, tr("Method"), [tr("HSV ranges"), tr("Nearest color")], defaultValue=0
            ),
            tr("HSV ranges follow the publication; nearest color forgives blended edges."),
        )
        self.offer(
            QgsProcessingParameterRasterDestination(self.OUTPUT, tr("Label map")),
            tr("GeoTIFF, 8 bits a pixel, on the grid of the image."),
        )

    def read_layers(self, parameters, context, feedback):
        from ..exchange.layers import label_map_layer

        self._layer = label_map_layer(self.parameterAsRasterLayer(parameters, self.INPUT, context), self.INPUT)

    def work(self, parameters, context, feedback):
        from ...core.labels.color_labels import decode_by_hsv, decode_by_nearest_color
        from ...storage.files import written_beside
        from ...storage.label_map_file import LabelMapFile
        from ...storage.rasters import open_raster, read_bgr, read_class_table
        from ..exchange.styles import write_label_map_style

        table = read_class_table(self.parameterAsFile(parameters, self.CLASS_TABLE, context))
        nearest = self.parameterAsEnum(parameters, self.METHOD, context) == self.NEAREST_COLOR
        decode = decode_by_nearest_color if nearest else decode_by_hsv
        output = self.parameterAsOutputLayer(parameters, self.OUTPUT, context)
        image = open_raster(self._layer.path, "Image")
        width, height = image.RasterXSize, image.RasterYSize
        rows = max(1, ROWS_PIXELS // width)
        unlabeled = 0
        grid = width, height, image.GetGeoTransform(can_return_null=True), wkt_for_gdal(self._layer.crs)
        with written_beside(output) as temporary, LabelMapFile(temporary, *grid, table) as label_map:
            for first in range(0, height, rows):
                check_canceled(feedback)
                decoded = decode(read_bgr(image, self._layer.path, first, min(rows, height - first)), table)
                unlabeled += int((decoded == UNLABELED).sum())
                label_map.write_rows(first, decoded)
                feedback.setProgress(100 * (first + len(decoded)) / height)
        write_label_map_style(output, table)
        share = unlabeled / (width * height)
        say = feedback.pushWarning if share > 0.5 else feedback.pushInfo
        say(tr("{share:.1%} of the pixels match no class.").format(share=share))
        return {self.OUTPUT: output}
