"""semref:exporttrainingtiles: cut an image and its label map into training tiles."""

from __future__ import annotations

from pathlib import Path

from qgis.core import (
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
)

from ..base import parameters
from ..base.algorithm import ANNOTATION, Declared, SemRefAlgorithm, follow
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import INTEGER
from ..translation import tr


class ExportTrainingTiles(SemRefAlgorithm):
    ID = "exporttrainingtiles"
    TITLE = "Export training tiles"
    GROUP = ANNOTATION
    TAGS = ("training", "tiles", "chips", "patches", "segmentation", "deep learning", "neural network", "data set")
    SUMMARY = (
        "Cuts an image and its label map into tiles for training a segmentation network, with a class table, "
        "statistics and a manifest.\n\nWhole blocks of ground are set aside for validation, and no pixel is in "
        "both sets. Tiles without labels are left out. Labels with other pixels are resampled to the image "
        "(nearest neighbor)."
    )

    IMAGE = "IMAGE"
    TILE_SIZE = "TILE_SIZE"
    STRIDE = "STRIDE"
    TILE_COUNT = "TILE_COUNT"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterRasterLayer(self.IMAGE, "Image"),
                "Aerial image with 8 or 16 bits. SemRef’s networks use three bands; further bands are exported too.",
            ),
            parameters.label_map(
                "Single-band raster of class values for the same ground; 0 where the class is unknown."
            ),
            with_help(
                QgsProcessingParameterNumber(self.TILE_SIZE, "Tile size (pixels)", INTEGER, 512, minValue=32),
                "Edge length of a tile, for example 512. Multiples of 32 suit most networks.",
            ),
            with_help(
                QgsProcessingParameterNumber(self.STRIDE, "Stride (pixels)", INTEGER, 512, minValue=1),
                "Distance between neighboring tiles. A stride smaller than the tile size makes tiles overlap.",
            ),
            parameters.validation_fraction(optional=True),
            parameters.class_table(
                "CSV file with the columns value, name, color, role. It is used if the label map contains no classes.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterFolderDestination(self.OUTPUT, "Folder for tiles"),
                "A new or empty folder. Files in an existing folder are not changed.",
            ),
            QgsProcessingOutputNumber(self.TILE_COUNT, "Number of tiles"),
        )

    def read_layers(self, values: Values) -> None:
        self._image, self._labels = values.image(self.IMAGE), values.label_map(self.LABELS)

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...core.labels.training_tiles import TRAIN, VALIDATION
        from ...storage.training_tiles import TileExport

        table = values.class_table(self.CLASS_TABLE)
        export = TileExport(
            self._image.file,
            self._labels.file,
            values.integer(self.TILE_SIZE),
            values.integer(self.STRIDE),
            values.number(self.VALIDATION_FRACTION),
        )
        with outputs.folder(self.OUTPUT) as folder:
            counts = follow(export.write(Path(folder), table), feedback)
        feedback.pushInfo(
            tr("{training} training tiles, {validation} validation tiles").format(
                training=counts[TRAIN], validation=counts[VALIDATION]
            )
        )
        return {self.TILE_COUNT: sum(counts.values())}
