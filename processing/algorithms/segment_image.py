"""semref:segmentimage – photo or orthophoto to label map, with a network."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import closing
from typing import TYPE_CHECKING

from ...core.errors import ParameterError
from ..compat import wkt_for_gdal
from ..framework import offers
from ..framework.base import ANNOTATION, Declared, SemRefAlgorithm, check_canceled
from ..framework.declarations import MapExtent, Number, PolygonOutput, RasterLayer, RasterOutput
from ..framework.label_polygons import write_polygons
from ..framework.photo_labels import describe
from ..framework.photo_source import PhotoSource
from ..packages.components import ONNXRUNTIME, OPENCV, SHAPELY, how_to_install, missing
from ..threads import worker_threads
from ..translation import tr

if TYPE_CHECKING:
    import numpy as np
    from qgis.core import QgsProcessingFeedback

    from ...core.labels.image_source import ImageSource
    from ...core.segmentation.model import SegmentationModel
    from ..framework.outputs import Outputs
    from ..framework.photo_source import Photo
    from ..framework.values import Values


class SegmentImage(SemRefAlgorithm):
    ID = "segmentimage"
    GROUP = ANNOTATION
    TAGS = ("segmentation", "network", "onnx", "deepness", "land cover", "label map", "orthophoto", "photo")
    PACKAGES = (OPENCV, ONNXRUNTIME)

    INPUT = "INPUT"
    MODEL = "MODEL"
    OVERLAP = "OVERLAP"
    RESOLUTION = "RESOLUTION"
    CLASS_TABLE = "CLASS_TABLE"
    EXTENT = "EXTENT"
    OUTPUT = "OUTPUT"
    POLYGONS = "POLYGONS"
    MINIMUM_AREA = "MINIMUM_AREA"
    TOLERANCE = "TOLERANCE"

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
            RasterLayer(
                self.INPUT,
                tr("Photo or orthophoto"),
                tr(
                    "Any raster with or without georeference, or any map of tiles. Red, green and blue are found by "
                    "color interpretation or wavelength, else they are the first three bands; a single band is taken "
                    "as gray. Bands of more than 8 bits are stretched from their 2nd to their 98th percentile."
                ),
            ),
            offers.model(
                tr("A segmentation network with its classes in its metadata; models made for Deepness will do.")
            ),
            *self._tile_parameters(),
            offers.class_table(
                tr(
                    "Values and colors for the model’s classes, found by name; for a model that does not name its "
                    "classes: one line an output of the network, in order of value."
                ),
                advanced=True,
            ),
            MapExtent(
                self.EXTENT,
                tr("Extent"),
                tr("The part of the image that is wanted; needed for maps of tiles, else all of the image."),
                optional=True,
            ),
            RasterOutput(
                self.OUTPUT,
                tr("Label map"),
                tr("GeoTIFF, 8 bits a pixel, with the classes of the model; pixels without data are 0."),
            ),
            *self._polygon_parameters(),
        )

    def _tile_parameters(self) -> tuple[Declared, ...]:
        return (
            Number(
                self.OVERLAP,
                tr("Overlap of tiles (%)"),
                tr("If left out: that of the model’s metadata, else 20. More takes longer and hides seams better."),
                optional=True,
                advanced=True,
                minimum=0,
                maximum=75,
            ),
            Number(
                self.RESOLUTION,
                tr("Resolution (cm per pixel)"),
                tr(
                    "Pixel size the network was trained on; if left out, that of the model’s metadata. Images without "
                    "georeference are taken as they are."
                ),
                optional=True,
                advanced=True,
                minimum=0.1,
            ),
        )

    def _polygon_parameters(self) -> tuple[Declared, ...]:
        return (
            PolygonOutput(
                self.POLYGONS,
                tr("Polygons"),
                tr("The label map as polygons with class, name and area, without gaps and overlaps between them."),
                optional=True,
                by_default=False,
            ),
            Number(
                self.MINIMUM_AREA,
                tr("Minimum area of polygons (square map units)"),
                tr("Smaller regions go to their largest neighbor; square pixels for images without georeference."),
                optional=True,
                advanced=True,
                minimum=0,
            ),
            Number(
                self.TOLERANCE,
                tr("Tolerance of polygons (map units)"),
                tr(
                    "Borders are straightened by about this much, alike on both sides; if left out by 1.5 pixels, 0 "
                    "keeps the pixels’ edges."
                ),
                optional=True,
                advanced=True,
                minimum=0,
            ),
        )

    def check(self, values: Values) -> None:
        lacking = missing([SHAPELY]) if values.has(self.POLYGONS) else []
        if lacking:
            raise ParameterError(how_to_install(lacking))

    def read_layers(self, values: Values) -> None:
        self._source = PhotoSource(values, self.INPUT, self.EXTENT)

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> None:
        from ...core.segmentation.class_bias import class_bias_text
        from ...core.segmentation.model import SegmentationModel
        from ...core.segmentation.tiling import segment
        from ...storage.label_map_file import LabelMapFile, whole_tile_rows

        table = values.class_table(self.CLASS_TABLE)
        feedback.setProgressText(tr("Loading the model"))
        model = SegmentationModel(values.file(self.MODEL), worker_threads(), table)
        check_canceled(feedback)
        resolution_cm = values.optional_number(self.RESOLUTION)
        resolution_m = model.settings.resolution_m if resolution_cm is None else resolution_cm / 100
        photo = self._source.open(resolution_m, feedback)
        image = self._at_resolution(photo, resolution_m, model, feedback)
        overlap = values.optional_number(self.OVERLAP)
        overlap = model.settings.overlap if overlap is None else overlap / 100
        height, width = image.shape_hw
        transform = _resized_transform(photo.geotransform, photo.image.shape_hw, image.shape_hw)
        grid = width, height, transform, wkt_for_gdal(photo.crs)
        classes = model.classes
        feedback.setProgressText(tr("Segmenting"))
        # The steps are closed first: threads they hold are let go before the file is cleared away.
        steps = segment(model, image, classes.values, overlap)
        with (
            outputs.raster(self.OUTPUT, classes.table) as path,
            LabelMapFile(path, *grid, classes.table, class_bias_text(model.class_bias)) as label_map,
            closing(steps),
        ):
            for first, labels_hw in whole_tile_rows(_followed(steps, feedback)):
                label_map.write_rows(first, labels_hw)
        write_polygons(values, outputs, self.POLYGONS, path, photo.crs, classes.table, feedback)

    def _at_resolution(
        self, photo: Photo, resolution_m: float | None, model: SegmentationModel, feedback: QgsProcessingFeedback
    ) -> ImageSource:
        """The photo at that resolution; says how it is read."""
        from ...core.segmentation.resampling import at_resolution
        from ..exchange.images import pixel_size_m

        image = at_resolution(photo.image, pixel_size_m(photo.file, photo.crs), resolution_m)
        describe(model, photo.file, feedback)
        if image is not photo.image:
            height, width = image.shape_hw
            text = tr("Resampled to {resolution:g} cm a pixel: {width} × {height} pixels.")
            feedback.pushInfo(text.format(resolution=100 * resolution_m, width=width, height=height))
        elif resolution_m is None:
            feedback.pushWarning(tr("The model does not say its resolution: the image is taken as it is."))
        return image


def _resized_transform(transform: tuple | None, old_hw: tuple[int, int], new_hw: tuple[int, int]) -> tuple | None:
    """The geotransform of an image that was brought to another (height, width); None for None."""
    if transform is None:
        return None
    x, x_column, x_row, y, y_column, y_row = transform
    down, across = (old / new for old, new in zip(old_hw, new_hw))
    return x, x_column * across, x_row * down, y, y_column * across, y_row * down


def _followed(steps: Iterable[tuple], feedback: QgsProcessingFeedback) -> Iterator[tuple[int, np.ndarray]]:
    """The rows that are finished; shows progress and heeds a cancel at every tile."""
    for share, rows in steps:
        check_canceled(feedback)
        feedback.setProgress(100 * share)
        if rows is not None:
            yield rows.first, rows.labels_hw
