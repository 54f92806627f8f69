"""semref:segmentimage – photo or orthophoto to label map, with a network."""

from __future__ import annotations

from contextlib import closing

from qgis.core import (
    QgsProcessingParameterFile,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterRasterLayer,
)

from ..compat import wkt_for_gdal
from ..framework.base import ANNOTATION, SemRefAlgorithm, check_canceled
from ..framework.photo_labels import describe
from ..packages.components import ONNXRUNTIME, OPENCV
from ..threads import worker_threads
from ..translation import tr


class SegmentImage(SemRefAlgorithm):
    ID = "segmentimage"
    BY_VALUES = False
    GROUP = ANNOTATION
    TAGS = ("segmentation", "network", "onnx", "deepness", "land cover", "label map", "orthophoto", "photo")
    PACKAGES = (OPENCV, ONNXRUNTIME)

    INPUT = "INPUT"
    MODEL = "MODEL"
    OVERLAP = "OVERLAP"
    RESOLUTION = "RESOLUTION"
    CLASS_TABLE = "CLASS_TABLE"
    OUTPUT = "OUTPUT"

    def title(self):
        return tr("Segment image")

    def summary(self):
        return tr(
            "Turns a photo or an orthophoto into a label map with a segmentation network (ONNX).\n\n"
            "The image is brought to the resolution of the model where both are known and looked at in overlapping "
            "tiles, so that no seams show. The label map lies where the image lies and has the classes of the model."
        )

    def initAlgorithm(self, config=None):
        number = QgsProcessingParameterNumber
        self.offer(
            QgsProcessingParameterRasterLayer(self.INPUT, tr("Photo or orthophoto")),
            tr(
                "Any raster with or without georeference. Red, green and blue are found by color interpretation or "
                "wavelength, else they are the first three bands; a single band is taken as gray. Bands of more than "
                "8 bits are stretched from their 2nd to their 98th percentile."
            ),
        )
        self.offer(
            QgsProcessingParameterFile(self.MODEL, tr("Model"), fileFilter=tr("ONNX models (*.onnx)")),
            tr("A segmentation network with its classes in its metadata; models made for Deepness will do."),
        )
        self.offer(
            number(self.OVERLAP, tr("Overlap of tiles (%)"), number.Double, None, True, minValue=0, maxValue=75),
            tr("If left out: that of the model’s metadata, else 20. More takes longer and hides seams better."),
            advanced=True,
        )
        self.offer(
            number(self.RESOLUTION, tr("Resolution (cm per pixel)"), number.Double, None, True, minValue=0.1),
            tr(
                "Pixel size the network was trained on; if left out, that of the model’s metadata. Images without "
                "georeference are taken as they are."
            ),
            advanced=True,
        )
        self.offer(
            QgsProcessingParameterFile(
                self.CLASS_TABLE, tr("Class table"), fileFilter=tr("CSV files (*.csv)"), optional=True
            ),
            tr(
                "Values and colors for the model’s classes, found by name; for a model that does not name its "
                "classes: one line an output of the network, in order of value."
            ),
            advanced=True,
        )
        self.offer(
            QgsProcessingParameterRasterDestination(self.OUTPUT, tr("Label map")),
            tr("GeoTIFF, 8 bits a pixel, with the classes of the model; pixels without data are 0."),
        )

    def read_layers(self, parameters, context, feedback):
        from ..exchange.layers import image_layer

        self._layer = image_layer(self.parameterAsRasterLayer(parameters, self.INPUT, context), self.INPUT)

    def work(self, parameters, context, feedback):
        from ...core.segmentation.model import SegmentationModel
        from ...core.segmentation.tiling import segment
        from ...storage.files import written_beside
        from ...storage.images import GdalImage
        from ...storage.label_map_file import LabelMapFile, whole_tile_rows
        from ...storage.rasters import read_class_table
        from ..exchange.styles import write_label_map_style

        table_path = self.parameterAsFile(parameters, self.CLASS_TABLE, context)
        table = read_class_table(table_path) if table_path else None
        feedback.setProgressText(tr("Loading the model"))
        model = SegmentationModel(self.parameterAsFile(parameters, self.MODEL, context), worker_threads(), table)
        check_canceled(feedback)
        photo = GdalImage(self._layer.path)
        image = self._at_resolution(parameters, context, photo, model, feedback)
        overlap = model.settings.overlap
        if parameters.get(self.OVERLAP) not in (None, ""):
            overlap = self.parameterAsDouble(parameters, self.OVERLAP, context) / 100
        output = self.parameterAsOutputLayer(parameters, self.OUTPUT, context)
        height, width = image.shape_hw
        transform = _resized_transform(photo.geotransform, photo.shape_hw, image.shape_hw)
        grid = width, height, transform, wkt_for_gdal(self._layer.crs)
        classes = model.classes
        feedback.setProgressText(tr("Segmenting"))
        with closing(segment(model, image, classes.values, overlap)) as steps, written_beside(output) as temporary:
            with LabelMapFile(temporary, *grid, classes.table) as label_map:
                for first, labels_hw in whole_tile_rows(_followed(steps, feedback)):
                    label_map.write_rows(first, labels_hw)
        write_label_map_style(output, classes.table)
        return {self.OUTPUT: output}

    def _at_resolution(self, parameters, context, photo, model, feedback):
        """The photo at the resolution asked for or the model's; says how it is read."""
        from ...core.segmentation.resampling import at_resolution
        from ..exchange.images import pixel_size_m

        resolution_m = model.settings.resolution_m
        if parameters.get(self.RESOLUTION) not in (None, ""):
            resolution_m = self.parameterAsDouble(parameters, self.RESOLUTION, context) / 100
        image = at_resolution(photo, pixel_size_m(photo, self._layer.crs), resolution_m)
        describe(model, photo, feedback)
        if image is not photo:
            height, width = image.shape_hw
            text = tr("Resampled to {resolution:g} cm a pixel: {width} × {height} pixels.")
            feedback.pushInfo(text.format(resolution=100 * resolution_m, width=width, height=height))
        elif resolution_m is None:
            feedback.pushWarning(tr("The model does not say its resolution: the image is taken as it is."))
        return image


def _resized_transform(transform, old_hw, new_hw):
    """The geotransform of an image that was brought to another (height, width); None for None."""
    if transform is None:
        return None
    x, x_column, x_row, y, y_column, y_row = transform
    down, across = (old / new for old, new in zip(old_hw, new_hw))
    return x, x_column * across, x_row * down, y, y_column * across, y_row * down


def _followed(steps, feedback):
    """The rows that are finished; shows progress and heeds a cancel at every tile."""
    for share, rows in steps:
        check_canceled(feedback)
        feedback.setProgress(100 * share)
        if rows is not None:
            yield rows.first, rows.labels_hw
