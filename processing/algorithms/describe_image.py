"""semref:describeimage: the landmarks and the topology vector of one label image."""

from __future__ import annotations

import json
from math import hypot
from typing import TYPE_CHECKING, Callable

from qgis.core import (
    QgsGeometry,
    QgsPointXY,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
)

from ...core.errors import ParameterError
from ...core.labels.class_table import ClassTable
from ...core.values import schema
from ..base import parameters
from ..base.algorithm import LOCALIZATION, Declared, SemRefAlgorithm, check_canceled
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import DOUBLE, INTEGER, POINT, SOURCE_POINT
from ..translation import tr

if TYPE_CHECKING:
    from ...core.localizer.localizer import DescribedImage

FIELDS = schema(
    "class integer, class_name text, area real, touches_edge integer, column real, row real, center_distance real"
)


class DescribeImage(SemRefAlgorithm):
    ID = "describeimage"
    TITLE = "Describe image"
    GROUP = LOCALIZATION
    TAGS = ("landmarks", "topology vector", "center of gravity")
    SUMMARY = (
        "Shows what localization uses of a label image: its landmarks as points, and its topology vector.\n\nThe "
        "image is described in its largest centered square, like the windows of a database. With a database, its "
        "classes, minimum area and vector length are used. Without a database, set them here."
    )

    REFERENCES_PER_VECTOR = "REFERENCES_PER_VECTOR"
    REFERENCES = "REFERENCES"
    VECTOR = "VECTOR"
    REFERENCE_COUNT = "REFERENCE_COUNT"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            with_help(
                QgsProcessingParameterRasterLayer(self.INPUT, "Label image"),
                "Single-band class values, or colors of the class table. A georeference is not needed.",
            ),
            parameters.database(
                "Database with the settings to use. The settings below are then ignored.", optional=True
            ),
            parameters.class_table(
                "Classes of the image, if no database is selected. If not set, the class table of the label image "
                "is used."
            ),
            parameters.reference_classes(
                "Classes that are landmarks, if no database is selected: names or values separated by “;”. If not "
                "set, the roles in the class table are used."
            ),
            with_help(
                QgsProcessingParameterNumber(self.MINIMUM_AREA, "Minimum area", DOUBLE, 100.0, minValue=0.0),
                "Smallest landmark, if no database is selected, in square map units (square pixels without a "
                "georeference).",
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.REFERENCES_PER_VECTOR, "Landmarks per vector", INTEGER, 10, minValue=3
                ),
                "Number of landmarks in the vector, if no database is selected: those nearest to the center.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterFeatureSink(self.REFERENCES, "Landmarks", type=SOURCE_POINT),
                "Points with class, area and pixel position. Without a georeference the coordinates are pixels (y "
                "up, negative).",
            ),
            with_help(
                QgsProcessingParameterFileDestination(
                    self.VECTOR,
                    "Topology vector",
                    fileFilter=tr("JSON files (*.json)"),
                    optional=True,
                    createByDefault=False,
                ),
                "Distance ratios, angle differences, class ranks, and the classes that were used.",
            ),
            QgsProcessingOutputNumber(self.REFERENCE_COUNT, "Number of landmarks"),
        )

    def read_layers(self, values: Values) -> None:
        self._layer = values.label_map(self.INPUT)

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...core.localizer.localizer import describe_image
        from ...storage.label_images import read_label_image
        from ...storage.rasters import open_raster, transform_of

        transform = transform_of(open_raster(self._layer.path))
        table, fraction_of, length = self._settings(values, transform)
        labels = read_label_image(self._layer.path, table)
        check_canceled(feedback)
        described = describe_image(labels, table.reference_values, fraction_of(min(labels.shape)), length)
        check_canceled(feedback)
        count = len(described.objects)
        self._write_points(outputs, described, transform, table)
        if values.has(self.VECTOR):
            outputs.text(self.VECTOR, json.dumps(_vector(described, table, length), indent=1))
        feedback.pushInfo(
            tr("{count} landmarks in the centered square of {size} pixels.").format(count=count, size=described.size)
        )
        if described.vector is None:
            feedback.pushWarning(tr("The image shows fewer than three landmarks, so it has no topology vector."))
        return {self.REFERENCE_COUNT: count}

    def _settings(self, values: Values, transform: tuple[float, ...]) -> tuple[ClassTable, Callable[[int], float], int]:
        """Return (class table, function from square size to area fraction, vector length) of the database or the
        parameters."""
        from ...storage.database.reader import read_database
        from ...storage.label_maps import stored_class_table
        from ...storage.rasters import open_raster, pixel_area

        database_path = values.file(self.DATABASE)
        if database_path:
            database = read_database(database_path)
            fraction = database.parameters.minimum_area / database.parameters.window_size**2
            return database.class_table, lambda size: fraction, database.parameters.references_per_vector
        table = values.class_table(self.CLASS_TABLE)
        if table is None:
            table = stored_class_table(open_raster(self._layer.path), self._layer.path)
        if table is None:
            raise ParameterError(
                "The label image contains no class table. Select a reference database or a class table."
            )
        table = values.with_references(self.REFERENCE_CLASSES, table)
        area = values.number(self.MINIMUM_AREA)
        one_pixel = pixel_area(transform)
        length = values.integer(self.REFERENCES_PER_VECTOR)
        return table, lambda size: area / one_pixel / max(size, 1) ** 2, length

    def _write_points(
        self, outputs: Outputs, described: DescribedImage, transform: tuple[float, ...], table: ClassTable
    ) -> None:
        from ...storage.rasters import pixel_area
        from ..layers.class_styles import references_renderer

        names = {c.value: c.name for c in table}
        x0, dx_column, dx_row, y0, dy_column, dy_row = transform
        objects, half = described.objects, described.size / 2
        renderer = references_renderer(table)
        with outputs.layer(self.REFERENCES, FIELDS, POINT, self._layer.crs, "landmarks", renderer=renderer) as sink:
            for i in range(len(objects)):
                column, row = objects.centers_xy[i].tolist()
                distance = hypot(column - half, row - half)
                column, row = column + described.first_xy[0], row + described.first_xy[1]
                x, y = x0 + column * dx_column + row * dx_row, y0 + column * dy_column + row * dy_row
                value = int(objects.classes[i])
                values = {
                    "class": value,
                    "class_name": names[value],
                    "area": float(objects.areas_px[i]) * pixel_area(transform),
                    "touches_edge": int(objects.touches_edge[i]),
                    "column": column,
                    "row": row,
                    "center_distance": distance,
                }
                sink.add(QgsGeometry.fromPointXY(QgsPointXY(x, y)), values)


def _vector(described: DescribedImage, table: ClassTable, length: int) -> dict:
    vector: list[float] | None = None
    if described.vector is not None:
        vector = [round(float(v), 7) for v in described.vector]
    return {
        "references_per_vector": length,
        "reference_classes": [{"value": c.value, "name": c.name} for c in table.references],
        "reference_count": len(described.objects),
        "image_center": [described.first_xy[0] + described.size / 2, described.first_xy[1] + described.size / 2],
        "vector": vector,
        "distance_ratios": vector and vector[:length],
        "angle_differences": vector and vector[length : 2 * length],
        "class_ranks": vector and vector[2 * length :],
    }
