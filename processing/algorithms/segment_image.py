"""semref:segmentimage: make a label map from a photo or orthophoto with a network."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from contextlib import closing
from functools import partial
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterRasterLayer,
)

from ..base import parameters
from ..base.algorithm import ANNOTATION, Declared, SemRefAlgorithm, check_canceled
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.scheduler import SCHEDULER, require_scheduler, scheduler, workers
from ..base.values import Values
from ..compat import DOUBLE, SOURCE_POLYGON, wkt_for_gdal
from ..jobs.photo_labels import describe, log_pace, open_model, pace_results
from ..jobs.photo_source import PhotoSource, SourceImage
from ..jobs.segmented_files import segmented_files, write_polygons
from ..packages.components import NEEDED, ONNXRUNTIME, SHAPELY, require
from ..translation import tr

if TYPE_CHECKING:
    from ...core.labels.image_source import ImageSource
    from ...core.segmentation.certainty import Certainty, Sureness
    from ...core.segmentation.model import SegmentationModel
    from ...core.segmentation.tiling import SegmentedRows


class SegmentImage(SemRefAlgorithm):
    ID = "segmentimage"
    TITLE = "Segment image"
    GROUP = ANNOTATION
    TAGS = ("segmentation", "network", "onnx", "deepness", "land cover", "label map", "orthophoto", "photo")
    PACKAGES = (*NEEDED, ONNXRUNTIME)
    SUMMARY = (
        "Makes a label map from a photo or orthophoto with a segmentation model (ONNX).\n\nThe image is resampled "
        "to the resolution of the model if both are known, and processed in overlapping tiles. The label map has "
        "the georeference of the image and the classes of the model. QGIS draws map tiles and web maps within the "
        "given extent."
    )

    OVERLAP = "OVERLAP"
    POLYGONS = "POLYGONS"
    TOLERANCE = "TOLERANCE"
    CONFIDENCE = "CONFIDENCE"
    PROBABILITIES = "PROBABILITIES"
    CERTAINTY = "CERTAINTY"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterRasterLayer(self.INPUT, "Photo or orthophoto"),
                "Raster with or without georeference, or map tiles. Red, green and blue are found by color "
                "interpretation or wavelength; otherwise the first three bands are used. A single band is read as "
                "gray. Bands with more than 8 bits are stretched from their 2nd to their 98th percentile.",
            ),
            parameters.model(
                "Segmentation model (ONNX) with class names in its metadata. Models for Deepness can be used."
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.OVERLAP, "Tile overlap (%)", DOUBLE, optional=True, minValue=0, maxValue=75
                ),
                "Overlap of neighboring tiles, typically 20. If not set, the value in the metadata of the model "
                "is used, or 20. A larger overlap takes longer and hides seams better.",
                advanced=True,
            ),
            parameters.resolution(
                "Pixel size that the network was trained on. If not set, the value in the metadata of the model "
                "is used. Images without a georeference are not resampled."
            ),
            parameters.class_table(
                "Class values and colors for the classes of the model, matched by name. For a model without class "
                "names, the table needs one row for each output of the network, in order of value.",
                advanced=True,
            ),
            parameters.extent(),
            with_help(
                QgsProcessingParameterRasterDestination(self.OUTPUT, "Label map"),
                "8-bit GeoTIFF with the classes of the model. Pixels without data are 0.",
            ),
            with_help(
                QgsProcessingParameterFeatureSink(
                    self.POLYGONS, "Polygons", type=SOURCE_POLYGON, optional=True, createByDefault=False
                ),
                "Label map as polygons with class, name and area, without gaps and overlaps.",
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.MINIMUM_AREA, "Minimum area of polygons (square map units)", DOUBLE, optional=True, minValue=0
                ),
                "Smaller regions are merged with their largest neighbor. The unit is square pixels for images "
                "without a georeference.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.TOLERANCE,
                    "Simplification tolerance of polygons (map units)",
                    DOUBLE,
                    optional=True,
                    minValue=0,
                ),
                "Borders are simplified by about this distance, identically on both sides. If not set, 1.5 "
                "pixels. 0 keeps the edges of the pixels.",
                advanced=True,
            ),
            parameters.mask(),
            with_help(
                QgsProcessingParameterRasterDestination(
                    self.CONFIDENCE, "Confidence", optional=True, createByDefault=False
                ),
                "GeoTIFF with the probability of the label of each pixel, in percent; 255 where there is no "
                "label. Networks often overestimate this probability.",
            ),
            with_help(
                QgsProcessingParameterRasterDestination(
                    self.PROBABILITIES, "Probabilities", optional=True, createByDefault=False
                ),
                "GeoTIFF with one band for each class of the model: its probability in percent; 255 where there "
                "is no label.",
            ),
            *pace_results(),
            QgsProcessingOutputNumber(self.CERTAINTY, "Mean confidence of the labels (%)"),
            scheduler(),
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
        from ...core.geometry.frame import MapFrame
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
        wanted = Certainty(values.has(self.CONFIDENCE), values.has(self.PROBABILITIES))
        classes = model.classes
        frame = MapFrame(wkt_for_gdal(photo.crs), transform or (), image.shape_hw)
        feedback.setProgressText(tr("Segmenting"))
        begun, sure = time.perf_counter(), Sureness()
        keys = self.OUTPUT, self.CONFIDENCE, self.PROBABILITIES
        with (
            segmented_files(outputs, frame, model, keys, wanted) as (label_map, write),
            closing(self._segment(values, model, (photo, image), resolution_m, overlap, wanted, feedback)) as steps,
        ):
            # Close the steps first: their threads end before the files are removed.
            write(_finished_rows(steps, sure, feedback))
        if values.has(SCHEDULER):
            return self._certainty_result(sure, feedback)
        pace = log_pace(model, time.perf_counter() - begun, feedback)
        write_polygons(values, outputs, self.POLYGONS, label_map, photo.crs, classes.table, feedback)
        return {**pace, **self._certainty_result(sure, feedback)}

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
        """Segment with ``tiling.segment`` or the workers of SCHEDULER; ``images``: the photo, and as the network sees
        it."""
        from ...core.segmentation.tiling import segment, tiles_of

        photo, image = images
        if not values.has(SCHEDULER):
            yield from segment(model, image, model.classes.values, overlap, wanted)
            return
        from ...cluster.task_names import SEGMENT
        from ...core.segmentation.tiling import segment_blocks
        from ...storage.file_states import state
        from ..layers.layer_inputs import pixel_size_m

        path, table = self._source.path(), values.class_table(self.CLASS_TABLE)
        tiles = tiles_of(model, image.shape_hw, overlap)
        size_m = pixel_size_m(photo.file, photo.crs)
        opening = path, model.path, table.to_csv() if table else "", size_m, resolution_m, overlap
        with workers(values, feedback, {file: state(file) for file in (path, model.path)}) as run:
            yield from segment_blocks(tiles, model.tile_hw, partial(run, SEGMENT, shared=opening))

    def _certainty_result(self, sure: Sureness, feedback: QgsProcessingFeedback) -> dict[str, Any]:
        """Return the mean confidence; empty if the network outputs class numbers only, or the image has no data."""
        if sure.mean is None:
            return {}
        text = tr(
            "Mean confidence of the labels: {percent:.0f} %. A value far below that of the training area shows that "
            "the network does not know this ground. A high value is no proof that the labels are correct."
        )
        feedback.pushInfo(text.format(percent=100 * sure.mean))
        return {self.CERTAINTY: 100 * sure.mean}

    def _at_resolution(
        self, photo: SourceImage, resolution_m: float | None, model: SegmentationModel, feedback: QgsProcessingFeedback
    ) -> ImageSource:
        """Return the photo at that resolution, and log how it is read."""
        from ...core.segmentation.resampling import at_resolution
        from ..layers.layer_inputs import pixel_size_m

        image = at_resolution(photo.image, pixel_size_m(photo.file, photo.crs), resolution_m)
        describe(model, photo.file, feedback)
        if image is not photo.image:
            height, width = image.shape_hw
            text = tr("Resampled to {resolution:g} cm per pixel: {width} × {height} pixels.")
            feedback.pushInfo(text.format(resolution=100 * resolution_m, width=width, height=height))
        elif resolution_m is None:
            feedback.pushWarning(tr("The metadata of the model contain no resolution. The image is not resampled."))
        return image


def _finished_rows(steps: Iterable[tuple], sure: Sureness, feedback: QgsProcessingFeedback) -> Iterator[SegmentedRows]:
    """Yield the finished rows and add up their confidence; show progress and check for a cancel at each tile."""
    for share, rows in steps:
        check_canceled(feedback)
        feedback.setProgress(100 * share)
        if rows is not None:
            sure.add(rows.sure)
            yield rows
