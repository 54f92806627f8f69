"""semref:describeimage – the landmarks and the topology vector of one label image."""

from __future__ import annotations

import json
from math import hypot

from qgis.core import (
    QgsGeometry,
    QgsPointXY,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterString,
)

from ...core.errors import ParameterError
from ...core.labels.class_table import split_list
from ..compat import POINT, SOURCE_POINT
from ..framework.base import LOCALIZATION, SemRefAlgorithm, check_canceled
from ..framework.sinks import Sink
from ..translation import tr

FIELDS = (
    ("class", "integer"),
    ("class_name", "text"),
    ("area", "real"),
    ("touches_edge", "integer"),
    ("column", "real"),
    ("row", "real"),
    ("center_distance", "real"),
)


class DescribeImage(SemRefAlgorithm):
    ID = "describeimage"
    GROUP = LOCALIZATION
    TAGS = ("landmarks", "topology vector", "center of gravity")

    INPUT = "INPUT"
    DATABASE = "DATABASE"
    CLASS_TABLE = "CLASS_TABLE"
    REFERENCE_CLASSES = "REFERENCE_CLASSES"
    MINIMUM_AREA = "MINIMUM_AREA"
    REFERENCES_PER_VECTOR = "REFERENCES_PER_VECTOR"
    REFERENCES = "REFERENCES"
    VECTOR = "VECTOR"
    REFERENCE_COUNT = "REFERENCE_COUNT"

    def title(self):
        return tr("Describe image")

    def summary(self):
        return tr(
            "Shows what localization sees in a label image: its landmarks as points and its topology vector.\n\n"
            "The image is described in its largest centered square, exactly as the windows of a database are. With a "
            "database its classes, minimum area and vector length are used; without one, give them here."
        )

    def initAlgorithm(self, config=None):
        self.offer(
            QgsProcessingParameterRasterLayer(self.INPUT, tr("Label image")),
            tr("Single-band class values, or colors decoded by the class table. It needs no georeference."),
        )
        self.offer(
            QgsProcessingParameterFile(
                self.DATABASE, tr("Reference database"), fileFilter=tr("GeoPackage (*.gpkg)"), optional=True
            ),
            tr("The image is described as this database’s windows are; the settings below are then not used."),
        )
        self.offer(
            QgsProcessingParameterFile(
                self.CLASS_TABLE, tr("Class table"), fileFilter=tr("CSV files (*.csv)"), optional=True
            ),
            tr("Without a database: the classes. If left out, those that the label image itself carries."),
        )
        self.offer(
            QgsProcessingParameterString(self.REFERENCE_CLASSES, tr("Reference classes"), optional=True),
            tr(
                "Without a database: names or values separated by “;”. If left out, the role in the class table counts."
            ),
        )
        self.offer(
            QgsProcessingParameterNumber(
                self.MINIMUM_AREA, tr("Minimum area"), QgsProcessingParameterNumber.Double, 100.0, minValue=0.0
            ),
            tr("Without a database: smallest landmark in square map units, in pixels without georeference."),
        )
        self.offer(
            QgsProcessingParameterNumber(
                self.REFERENCES_PER_VECTOR,
                tr("Landmarks per vector"),
                QgsProcessingParameterNumber.Integer,
                10,
                minValue=3,
            ),
            tr("Without a database: how many of the landmarks nearest to the center the vector holds."),
            advanced=True,
        )
        self.offer(
            QgsProcessingParameterFeatureSink(self.REFERENCES, tr("Landmarks"), SOURCE_POINT),
            tr("Points with class, area and pixel position; in pixels (y up, negative) without georeference."),
        )
        self.offer(
            QgsProcessingParameterFileDestination(
                self.VECTOR, tr("Topology vector"), tr("JSON files (*.json)"), optional=True, createByDefault=False
            ),
            tr("Distance ratios, angle differences and class ranks, with the classes used."),
        )
        self.addOutput(QgsProcessingOutputNumber(self.REFERENCE_COUNT, tr("Number of landmarks")))

    def read_layers(self, parameters, context, feedback):
        from ..exchange.layers import label_map_layer

        self._layer = label_map_layer(self.parameterAsRasterLayer(parameters, self.INPUT, context), self.INPUT)

    def work(self, parameters, context, feedback):
        from ...core.localizer.localizer import describe_image
        from ...storage.rasters import open_raster, read_label_image

        transform = open_raster(self._layer.path, "Image").GetGeoTransform(can_return_null=True) or (0, 1, 0, 0, 0, -1)
        table, fraction_of, length = self._settings(parameters, context, transform)
        labels = read_label_image(self._layer.path, table)
        check_canceled(feedback)
        described = describe_image(labels, table.reference_values, fraction_of(min(labels.shape)), length)
        check_canceled(feedback)
        objects = described.objects
        result = {self.REFERENCE_COUNT: len(objects)}
        result[self.REFERENCES] = self._write_points(parameters, context, described, transform, table)
        vector_path = self.parameterAsFileOutput(parameters, self.VECTOR, context)
        if vector_path:
            self._write_vector(vector_path, described, table, length)
            result[self.VECTOR] = vector_path
        feedback.pushInfo(
            tr("{count} landmarks in the centered square of {size} pixels.").format(
                count=len(objects), size=described.size
            )
        )
        if described.vector is None:
            feedback.pushWarning(tr("Fewer than three landmarks: the image has no topology vector."))
        return result

    def _settings(self, parameters, context, transform):
        """(class table, function square size → area fraction, vector length), from the database or the parameters."""
        from ...storage.database.reader import read_database
        from ...storage.rasters import open_raster, read_class_table, stored_class_table

        database_path = self.parameterAsFile(parameters, self.DATABASE, context)
        if database_path:
            database = read_database(database_path)
            fraction = database.parameters.minimum_area / database.parameters.window_size**2
            return database.class_table, lambda size: fraction, database.parameters.references_per_vector
        table_path = self.parameterAsFile(parameters, self.CLASS_TABLE, context)
        if table_path:
            table = read_class_table(table_path)
        else:
            table = stored_class_table(open_raster(self._layer.path, "Image"), self._layer.path)
        if table is None:
            raise ParameterError("Give DATABASE or CLASS_TABLE: the label image brings no class table of its own.")
        chosen = self.parameterAsString(parameters, self.REFERENCE_CLASSES, context)
        table = (table.with_references(split_list(chosen)) if split_list(chosen) else table).require_references()
        area = self.parameterAsDouble(parameters, self.MINIMUM_AREA, context)
        pixel_area = abs(transform[1] * transform[5] - transform[2] * transform[4])
        length = self.parameterAsInt(parameters, self.REFERENCES_PER_VECTOR, context)
        return table, lambda size: area / pixel_area / max(size, 1) ** 2, length

    def _write_points(self, parameters, context, described, transform, table):
        sink = Sink(self, parameters, self.REFERENCES, context, FIELDS, POINT, self._layer.crs)
        names = {c.value: c.name for c in table}
        x0, dx_column, dx_row, y0, dy_column, dy_row = transform
        pixel_area = abs(dx_column * dy_row - dx_row * dy_column)
        objects, half = described.objects, described.size / 2
        for i in range(len(objects)):
            column, row = objects.centers_xy[i].tolist()
            distance = hypot(column - half, row - half)
            column, row = column + described.first_xy[0], row + described.first_xy[1]
            x, y = x0 + column * dx_column + row * dx_row, y0 + column * dy_column + row * dy_row
            value = int(objects.classes[i])
            values = {
                "class": value,
                "class_name": names[value],
                "area": float(objects.areas_px[i]) * pixel_area,
                "touches_edge": int(objects.touches_edge[i]),
                "column": column,
                "row": row,
                "center_distance": distance,
            }
            sink.add(QgsGeometry.fromPointXY(QgsPointXY(x, y)), values)
        return sink.close()

    def _write_vector(self, path, described, table, length):
        from ...storage.files import written_beside

        vector = None if described.vector is None else [round(float(v), 7) for v in described.vector]
        content = {
            "references_per_vector": length,
            "reference_classes": [{"value": c.value, "name": c.name} for c in table.references],
            "reference_count": len(described.objects),
            "image_center": [described.first_xy[0] + described.size / 2, described.first_xy[1] + described.size / 2],
            "vector": vector,
            "distance_ratios": vector and vector[:length],
            "angle_differences": vector and vector[length : 2 * length],
            "class_ranks": vector and vector[2 * length :],
        }
        with written_beside(path) as temporary, open(temporary, "w", encoding="utf-8") as file:
            json.dump(content, file, indent=1)
