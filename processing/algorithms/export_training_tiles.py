"""semref:exporttrainingtiles – image and label map to tiles that a segmentation network is trained on."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from qgis.core import (
    QgsProcessingOutputNumber,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
)

from ..base import parameters
from ..base.algorithm import ANNOTATION, Declared, SemRefAlgorithm, follow
from ..base.parameters import with_help
from ..compat import INTEGER
from ..translation import tr

if TYPE_CHECKING:
    from qgis.core import QgsProcessingFeedback

    from ..base.outputs import Outputs
    from ..base.values import Values


class ExportTrainingTiles(SemRefAlgorithm):
    ID = "exporttrainingtiles"
    GROUP = ANNOTATION
    TAGS = ("training", "tiles", "chips", "patches", "segmentation", "deep learning", "neural network", "data set")

    IMAGE = "IMAGE"
    LABELS = "LABELS"
    TILE_SIZE = "TILE_SIZE"
    STRIDE = "STRIDE"
    VALIDATION_FRACTION = parameters.VALIDATION_FRACTION
    CLASS_TABLE = "CLASS_TABLE"
    OUTPUT = "OUTPUT"
    TILE_COUNT = "TILE_COUNT"

    def title(self) -> str:
        return tr("Export training tiles")

    def summary(self) -> str:
        return tr(
            "Cuts an image and its label map into tiles that a segmentation network is trained on, with a class "
            "table, statistics and a manifest.\n\n"
            "Training and validation tiles are divided by place: whole blocks of ground are set aside for "
            "validation, and no pixel is in both. Tiles without labels are left out. Labels on another grid are "
            "brought onto the image’s, nearest neighbor."
        )

    def parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterRasterLayer(self.IMAGE, tr("Image")),
                tr(
                    "Aerial image of 8 or 16 bits. Networks of SemRef take three bands; further bands are exported too."
                ),
            ),
            parameters.label_map(
                tr("Single-band raster of class values, 0 where nothing is known, of the same ground.")
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.TILE_SIZE, tr("Tile size (pixels)"), type=INTEGER, defaultValue=512, minValue=32
                ),
                tr("Edge of a tile; a multiple of 32 suits networks."),
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.STRIDE, tr("Stride (pixels)"), type=INTEGER, defaultValue=512, minValue=1
                ),
                tr("Step from tile to tile; less than the tile size makes tiles overlap."),
            ),
            parameters.validation_fraction(optional=True),
            parameters.class_table(
                tr("CSV with the columns value, name, color, role, for a label map that brings no classes of its own."),
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterFolderDestination(self.OUTPUT, tr("Folder for the tiles")),
                tr("A new or empty folder; one that holds files is left alone."),
            ),
            QgsProcessingOutputNumber(self.TILE_COUNT, tr("Number of tiles")),
        )

    def read_layers(self, values: Values) -> None:
        self._image, self._labels = (values.label_map(key) for key in (self.IMAGE, self.LABELS))

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...core.labels.training_tiles import SUBSETS, TRAIN, VALIDATION
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
            follow(export.steps(Path(folder), table), feedback)
        feedback.pushInfo(
            tr("{training} tiles to train on, {validation} to validate on").format(
                training=export.counts[TRAIN], validation=export.counts[VALIDATION]
            )
        )
        return {self.TILE_COUNT: sum(export.counts[subset] for subset in SUBSETS)}
