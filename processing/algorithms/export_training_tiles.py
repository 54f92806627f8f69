"""semref:exporttrainingtiles – image and label map to tiles that a segmentation network is trained on."""

from __future__ import annotations

from pathlib import Path

from qgis.core import (
    QgsProcessingOutputNumber,
    QgsProcessingParameterFile,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
)

from ...core.labels.training_tiles import SUBSETS, TRAIN, VALIDATION
from ..framework.base import ANNOTATION, SemRefAlgorithm, follow
from ..translation import tr


class ExportTrainingTiles(SemRefAlgorithm):
    ID = "exporttrainingtiles"
    GROUP = ANNOTATION
    TAGS = ("training", "tiles", "chips", "patches", "segmentation", "deep learning", "neural network", "data set")

    IMAGE = "IMAGE"
    LABELS = "LABELS"
    TILE_SIZE = "TILE_SIZE"
    STRIDE = "STRIDE"
    VALIDATION_FRACTION = "VALIDATION_FRACTION"
    CLASS_TABLE = "CLASS_TABLE"
    OUTPUT = "OUTPUT"
    TILE_COUNT = "TILE_COUNT"

    def title(self):
        return tr("Export training tiles")

    def summary(self):
        return tr(
            "Cuts an image and its label map into tiles that a segmentation network is trained on, with a class "
            "table, statistics and a manifest.\n\n"
            "Training and validation tiles are divided by place: whole blocks of ground are set aside for "
            "validation, and no pixel is in both. Tiles without labels are left out. Labels on another grid are "
            "brought onto the image’s, nearest neighbor."
        )

    def initAlgorithm(self, config=None):
        integer, real = QgsProcessingParameterNumber.Integer, QgsProcessingParameterNumber.Double
        self.offer(
            QgsProcessingParameterRasterLayer(self.IMAGE, tr("Image")),
            tr("Aerial image of 8 or 16 bits. Networks of SemRef take three bands; further bands are exported too."),
        )
        self.offer(
            QgsProcessingParameterRasterLayer(self.LABELS, tr("Label map")),
            tr("Single-band raster of class values, 0 where nothing is known, of the same ground."),
        )
        self.offer(
            QgsProcessingParameterNumber(self.TILE_SIZE, tr("Tile size (pixels)"), integer, 512, minValue=32),
            tr("Edge of a tile; a multiple of 32 suits networks."),
        )
        self.offer(
            QgsProcessingParameterNumber(self.STRIDE, tr("Stride (pixels)"), integer, 512, minValue=1),
            tr("Step from tile to tile; less than the tile size makes tiles overlap."),
        )
        self.offer(
            QgsProcessingParameterNumber(
                self.VALIDATION_FRACTION,
                tr("Validation fraction"),
                real,
                0.2,
                optional=True,
                minValue=0.0,
                maxValue=0.9,
            ),
            tr("Share of the labeled ground that is set aside for validation; 0 for none."),
        )
        self.offer(
            QgsProcessingParameterFile(
                self.CLASS_TABLE, tr("Class table"), fileFilter=tr("CSV files (*.csv)"), optional=True
            ),
            tr("CSV with the columns value, name, color, role, for a label map that brings no classes of its own."),
            advanced=True,
        )
        self.offer(
            QgsProcessingParameterFolderDestination(self.OUTPUT, tr("Folder for the tiles")),
            tr("A new or empty folder; one of an earlier export is replaced."),
        )
        self.addOutput(QgsProcessingOutputNumber(self.TILE_COUNT, tr("Number of tiles")))

    def read_layers(self, parameters, context, feedback):
        from ..exchange.layers import label_map_layer

        self._image, self._labels = (
            label_map_layer(self.parameterAsRasterLayer(parameters, key, context), key)
            for key in (self.IMAGE, self.LABELS)
        )

    def work(self, parameters, context, feedback):
        from ...storage.files import folder_written_beside
        from ...storage.rasters import read_class_table
        from ...storage.training_tiles import MANIFEST, TileExport

        table_path = self.parameterAsFile(parameters, self.CLASS_TABLE, context)
        table = read_class_table(table_path) if table_path else None
        export = TileExport(
            self._image.file,
            self._labels.file,
            self.parameterAsInt(parameters, self.TILE_SIZE, context),
            self.parameterAsInt(parameters, self.STRIDE, context),
            self.parameterAsDouble(parameters, self.VALIDATION_FRACTION, context),
        )
        output = self.parameterAsString(parameters, self.OUTPUT, context)
        with folder_written_beside(output, MANIFEST) as temporary:
            follow(export.steps(Path(temporary), table), feedback)
        feedback.pushInfo(
            tr("{training} tiles to train on, {validation} to validate on").format(
                training=export.counts[TRAIN], validation=export.counts[VALIDATION]
            )
        )
        return {self.OUTPUT: output, self.TILE_COUNT: sum(export.counts[subset] for subset in SUBSETS)}
