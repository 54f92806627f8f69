"""semref:decodecolorlabels: convert a color label image to a label map."""

from __future__ import annotations

from qgis.core import (
    QgsProcessingFeedback,
    QgsProcessingParameterEnum,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterRasterLayer,
)

from ...core.labels.class_table import UNLABELED
from ..base import parameters
from ..base.algorithm import ANNOTATION, Declared, SemRefAlgorithm, check_canceled
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..translation import tr

ROWS_PIXELS = 4_000_000
"""Pixels that are decoded at once."""


class DecodeColorLabels(SemRefAlgorithm):
    ID = "decodecolorlabels"
    TITLE = "Decode color labels"
    GROUP = ANNOTATION
    TAGS = ("colour", "color", "hsv", "decode", "label image", "label map")
    SUMMARY = (
        "Converts an image that shows classes as colors to a label map. Classes are found by the HSV ranges of "
        "the class table, as in the published method, or by the nearest class color.\n\nPixels outside all ranges "
        "are unlabeled (0). With “Nearest color”, black is unlabeled unless a class is black."
    )

    METHOD = "METHOD"
    HSV_RANGES, NEAREST_COLOR = range(2)

    def parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterRasterLayer(self.INPUT, "Color label image"),
                "Image with at least three 8-bit bands (red, green, blue).",
            ),
            parameters.class_table(
                "CSV file with the columns value, name, color, role and, for HSV ranges, hsv_min and hsv_max (“h "
                "s v”, h from 0 to 180, s and v from 0 to 255; the hue may wrap around).",
                optional=False,
            ),
            with_help(
                QgsProcessingParameterEnum(
                    self.METHOD, "Method", options=(tr("HSV ranges"), tr("Nearest color")), defaultValue=self.HSV_RANGES
                ),
                "“HSV ranges” is the published way. “Nearest color” also labels blended colors at edges.",
            ),
            with_help(
                QgsProcessingParameterRasterDestination(self.OUTPUT, "Label map"),
                "8-bit GeoTIFF with the pixels of the image.",
            ),
        )

    def read_layers(self, values: Values) -> None:
        self._layer = values.label_map(self.INPUT)

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> None:
        from ...core.geometry.frame import MapFrame
        from ...core.labels.color_labels import decode_by_hsv, decode_by_nearest_color
        from ...storage.label_images import read_bgr
        from ...storage.label_map_file import LabelMapFile
        from ...storage.rasters import open_raster

        table = values.class_table(self.CLASS_TABLE)
        nearest = values.choice(self.METHOD) == self.NEAREST_COLOR
        decode = decode_by_nearest_color if nearest else decode_by_hsv
        image = open_raster(self._layer.path)
        width, height = image.RasterXSize, image.RasterYSize
        rows = max(1, ROWS_PIXELS // width)
        unlabeled = 0
        transform = image.GetGeoTransform(can_return_null=True) or ()
        frame = MapFrame(self._layer.file.crs_wkt, transform, (height, width))
        with outputs.label_map(self.OUTPUT, table) as path, LabelMapFile(path, frame, table) as label_map:
            for first in range(0, height, rows):
                check_canceled(feedback)
                decoded = decode(read_bgr(image, self._layer.path, first, min(rows, height - first)), table)
                unlabeled += int((decoded == UNLABELED).sum())
                label_map.write_rows(first, decoded)
                feedback.setProgress(100 * (first + len(decoded)) / height)
        share = unlabeled / (width * height)
        say = feedback.pushWarning if share > 0.5 else feedback.pushInfo
        say(tr("{share:.1%} of the pixels match no class.").format(share=share))
