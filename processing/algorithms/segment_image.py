"""semref:segmentimage – photo or orthophoto to label map, with a network."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from contextlib import closing
from functools import partial
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterRasterLayer,
)

from ..base import parameters
from ..base.algorithm import ANNOTATION, Declared, SemRefAlgorithm, check_canceled
from ..base.parameters import with_help
from ..base.photo_labels import NetworkPace, describe, open_model, pace_results
from ..base.photo_source import PhotoSource
from ..base.scheduler import SCHEDULER, require_scheduler, scheduler, workers
from ..base.segmented_files import SeenGrid, SegmentedFiles, write_polygons
from ..compat import DOUBLE, SOURCE_POLYGON, wkt_for_gdal
from ..packages.components import NEEDED, ONNXRUNTIME, SHAPELY, require
from ..translation import tr

if TYPE_CHECKING:
    from qgis.core import QgsProcessingFeedback

    from ...core.labels.image_source import ImageSource
    from ...core.segmentation.certainty import Certainty, Sureness
    from ...core.segmentation.model import SegmentationModel
    from ...core.segmentation.tiling import SegmentedRows
    from ..base.outputs import Outputs
    from ..base.photo_source import SourceImage
    from ..base.values import Values


class SegmentImage(SemRefAlgorithm):
    ID = "segmentimage"
    GROUP = ANNOTATION
    TAGS = ("segmentation", "network", "onnx", "deepness", "land cover", "label map", "orthophoto", "photo")
    PACKAGES = (*NEEDED, ONNXRUNTIME)

    INPUT = "INPUT"
    MODEL = "MODEL"
    OVERLAP = "OVERLAP"
    RESOLUTION = parameters.RESOLUTION
    CLASS_TABLE = "CLASS_TABLE"
    EXTENT = parameters.EXTENT
    OUTPUT = "OUTPUT"
    POLYGONS = "POLYGONS"
    MINIMUM_AREA = "MINIMUM_AREA"
    TOLERANCE = "TOLERANCE"
    MASK = parameters.MASK
    CONFIDENCE = "CONFIDENCE"
    PROBABILITIES = "PROBABILITIES"
    CERTAINTY = "CERTAINTY"

    def title(self) -> str:
        return tr("Segment image")

    def summary(self) -> str:
        return tr(
            "Turns a photo or an orthophoto into a label map with a segmentation network (ONNX).\n\n"
            "The image is brought to the resolution of the model where both are known and looked at in overlapping "
            "tiles, so that no seams show. The label map lies where the image lies and has the classes of the model."
            "\n\nMap tiles and web maps are drawn by QGIS at the model’s resolution in the extent that is given."
        )

    def parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterRasterLayer(self.INPUT, tr("Photo or orthophoto")),
                tr(
                    "Any raster with or without georeference, or any map of tiles. Red, green and blue are found by "
                    "color interpretation or wavelength, else they are the first three bands; a single band is taken "
                    "as gray. Bands of more than 8 bits are stretched from their 2nd to their 98th percentile."
                ),
            ),
            parameters.model(
                tr("A segmentation network with its classes in its metadata; models made for Deepness will do.")
            ),
            *self._tile_parameters(),
            parameters.class_table(
                tr(
                    "Values and colors for the model’s classes, found by name; for a model that does not name its "
                    "classes: one line an output of the network, in order of value."
                ),
                advanced=True,
            ),
            parameters.extent(),
            with_help(
                QgsProcessingParameterRasterDestination(self.OUTPUT, tr("Label map")),
                tr("GeoTIFF, 8 bits a pixel, with the classes of the model; pixels without data are 0."),
            ),
            *self._polygon_parameters(),
            parameters.mask(),
            *self._certainty_parameters(),
            *pace_results(),
            QgsProcessingOutputNumber(self.CERTAINTY, tr("How sure the network is of its labels (%, mean)")),
            scheduler(),
        )

    def _tile_parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterNumber(
                    self.OVERLAP, tr("Overlap of tiles (%)"), type=DOUBLE, optional=True, minValue=0, maxValue=75
                ),
                tr("If left out: that of the model’s metadata, else 20. More takes longer and hides seams better."),
                advanced=True,
            ),
            parameters.resolution(
                tr(
                    "Pixel size the network was trained on; if left out, that of the model’s metadata. Images without "
                    "georeference are taken as they are."
                )
            ),
        )

    def _polygon_parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterFeatureSink(
                    self.POLYGONS, tr("Polygons"), type=SOURCE_POLYGON, optional=True, createByDefault=False
                ),
                tr("The label map as polygons with class, name and area, without gaps and overlaps between them."),
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.MINIMUM_AREA,
                    tr("Minimum area of polygons (square map units)"),
                    type=DOUBLE,
                    optional=True,
                    minValue=0,
                ),
                tr("Smaller regions go to their largest neighbor; square pixels for images without georeference."),
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.TOLERANCE, tr("Tolerance of polygons (map units)"), type=DOUBLE, optional=True, minValue=0
                ),
                tr(
                    "Borders are straightened by about this much, alike on both sides; if left out by 1.5 pixels, 0 "
                    "keeps the pixels’ edges."
                ),
                advanced=True,
            ),
        )

    def _certainty_parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterRasterDestination(
                    self.CONFIDENCE, tr("Confidence"), optional=True, createByDefault=False
                ),
                tr(
                    "GeoTIFF, percent: how probable the network takes the class that a pixel has to be; 255 where it "
                    "did not look. Networks are often surer than they should be."
                ),
            ),
            with_help(
                QgsProcessingParameterRasterDestination(
                    self.PROBABILITIES, tr("Probabilities"), optional=True, createByDefault=False
                ),
                tr("GeoTIFF, percent, one band for each class of the model, by its name; 255 where it did not look."),
            ),
        )

    def check(self, values: Values) -> None:
        if values.has(self.POLYGONS):
            require([SHAPELY])
        only_here = self.EXTENT, self.MASK, self.POLYGONS, self.CONFIDENCE, self.PROBABILITIES
        require_scheduler(values, only_here)

    def read_layers(self, values: Values) -> None:
        from ..layers.areas import drawn_area

        area = drawn_area(values.source(self.MASK))
        self._source = PhotoSource(values, self.INPUT, self.EXTENT, area)

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, Any]:
        from ...core.segmentation.certainty import Certainty, Sureness
        from ...core.segmentation.resampling import resized_transform

        feedback.setProgressText(tr("Loading the model"))
        model = open_model(values.file(self.MODEL), values.class_table(self.CLASS_TABLE))
        check_canceled(feedback)
        resolution_cm = values.optional_number(self.RESOLUTION)
        resolution_m = model.settings.resolution_m if resolution_cm is None else resolution_cm / 100
        photo = self._source.open(resolution_m, feedback)
        image = self._at_resolution(photo, resolution_m, model, feedback)
        transform = resized_transform(photo.geotransform, photo.image.shape_hw, image.shape_hw)
        image = self._source.apply_mask(image, photo, transform)
        overlap = values.optional_number(self.OVERLAP)
        overlap = model.settings.overlap if overlap is None else overlap / 100
        wanted = Certainty(outputs.wants(self.CONFIDENCE), outputs.wants(self.PROBABILITIES))
        classes = model.classes
        grid = SeenGrid(image.shape_hw, transform, wkt_for_gdal(photo.crs))
        feedback.setProgressText(tr("Segmenting"))
        begun, sure = time.perf_counter(), Sureness()
        with (
            SegmentedFiles(outputs, grid, model, (self.OUTPUT, self.CONFIDENCE, self.PROBABILITIES), wanted) as files,
            closing(self._segment(values, model, (photo, image), resolution_m, overlap, wanted, feedback)) as steps,
        ):
            # The steps are closed first: threads they hold are let go before the files are cleared away.
            files.write(_finished_rows(steps, sure, feedback))
        pace = NetworkPace(model, time.perf_counter() - begun)
        if values.has(SCHEDULER):
            return self._certainty_result(sure, feedback)
        feedback.pushInfo(pace.sentence())
        write_polygons(values, outputs, self.POLYGONS, files.label_map, photo.crs, classes.table, feedback)
        return {**pace.results, **self._certainty_result(sure, feedback)}

    def _segment(
        self,
        values: Values,
        model: SegmentationModel,
        images: tuple[SourceImage, ImageSource],
        resolution_m: float | None,
        overlap: float,
        wanted: Certainty,
        feedback: QgsProcessingFeedback,
    ) -> Iterator[tuple[float, SegmentedRows | None]]:
        """As ``tiling.segment``, by SCHEDULER too; ``images``: the photo, and as the network sees it."""
        from ...core.segmentation.tiling import segment, tiles_of

        photo, image = images
        if not values.has(SCHEDULER):
            yield from segment(model, image, model.classes.values, overlap, wanted)
            return
        from ...cluster.task_names import SEGMENT
        from ...core.segmentation.blocks import segment_blocks
        from ...storage.file_states import state
        from ..layers.images import pixel_size_m

        path, table = self._source.path(), values.class_table(self.CLASS_TABLE)
        tiles = tiles_of(model, image.shape_hw, overlap)
        size_m = pixel_size_m(photo.file, photo.crs)
        opening = path, model.path, table.to_csv() if table else "", size_m, resolution_m, overlap
        with workers(values, feedback, {file: state(file) for file in (path, model.path)}) as run:
            yield from segment_blocks(tiles, model.tile_hw, partial(run.in_order, SEGMENT, shared=opening))

    def _certainty_result(self, sure: Sureness, feedback: QgsProcessingFeedback) -> dict[str, Any]:
        """How sure the network is; nothing of one that gives class numbers alone, or of an image without data."""
        if sure.mean is None:
            return {}
        text = tr(
            "The network takes its labels to be right with {percent:.0f} % on average. Where that is much less than on "
            "the ground it was trained on, it does not know this ground; a high number is no proof that it does."
        )
        feedback.pushInfo(text.format(percent=100 * sure.mean))
        return {self.CERTAINTY: 100 * sure.mean}

    def _at_resolution(
        self, photo: SourceImage, resolution_m: float | None, model: SegmentationModel, feedback: QgsProcessingFeedback
    ) -> ImageSource:
        """The photo at that resolution; says how it is read."""
        from ...core.segmentation.resampling import at_resolution
        from ..layers.images import pixel_size_m

        image = at_resolution(photo.image, pixel_size_m(photo.file, photo.crs), resolution_m)
        describe(model, photo.file, feedback)
        if image is not photo.image:
            height, width = image.shape_hw
            text = tr("Resampled to {resolution:g} cm a pixel: {width} × {height} pixels.")
            feedback.pushInfo(text.format(resolution=100 * resolution_m, width=width, height=height))
        elif resolution_m is None:
            feedback.pushWarning(tr("The model does not say its resolution: the image is taken as it is."))
        return image


def _finished_rows(steps: Iterable[tuple], sure: Sureness, feedback: QgsProcessingFeedback) -> Iterator[SegmentedRows]:
    """The rows that are finished, adding up how sure they are; shows progress and heeds a cancel at every tile."""
    for share, rows in steps:
        check_canceled(feedback)
        feedback.setProgress(100 * share)
        if rows is not None:
            sure.add(rows.sure)
            yield rows
