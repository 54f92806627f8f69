"""semref:builddatabase – label map to reference database."""

from __future__ import annotations

from qgis.core import (
    QgsProcessingOutputNumber,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterString,
)

from ...core.errors import ClassTableError, ParameterError
from ...core.labels.class_table import split_list
from ..framework.base import REFERENCE_DATABASE, SemRefAlgorithm, check_canceled, follow
from ..threads import worker_threads
from ..translation import tr
from ..version import plugin_version


class BuildDatabase(SemRefAlgorithm):
    ID = "builddatabase"
    GROUP = REFERENCE_DATABASE
    TAGS = ("topology vector", "sliding window", "landmarks", "geopackage", "reference map")

    LABELS = "LABELS"
    REFERENCE_CLASSES = "REFERENCE_CLASSES"
    WINDOW_SIZE = "WINDOW_SIZE"
    STRIDE = "STRIDE"
    LEVELS = "LEVELS"
    REFERENCES_PER_VECTOR = "REFERENCES_PER_VECTOR"
    MINIMUM_AREA = "MINIMUM_AREA"
    DATABASE = "DATABASE"
    WINDOW_COUNT = "WINDOW_COUNT"
    REFERENCE_COUNT = "REFERENCE_COUNT"

    def title(self):
        return tr("Build reference database")

    def summary(self):
        return tr(
            "Slides windows over a label map and describes each by the topology vector of its landmarks; saves "
            "windows, landmarks of the whole map, a reduced map, classes and parameters in one GeoPackage.\n\n"
            "The method is that of He & Wu, Remote Sensing 2025, 17, 1671. Windows with fewer than three landmarks "
            "get no vector; the log says how many."
        )

    def initAlgorithm(self, config=None):
        number = QgsProcessingParameterNumber
        self.offer(
            QgsProcessingParameterRasterLayer(self.LABELS, tr("Label map")),
            tr("Single-band raster of class values in a metric CRS, as “Rasterize annotation” makes it."),
        )
        self.offer(
            QgsProcessingParameterString(self.REFERENCE_CLASSES, tr("Reference classes"), optional=True),
            tr(
                "Classes whose regions are landmarks: names or values separated by “;”, for example "
                "building;bare_land;water. If left out, the classes with the role “reference” in the map’s class table."
            ),
        )
        self.offer(
            number(self.WINDOW_SIZE, tr("Window size (map units)"), number.Double, 1280.0, minValue=0.001),
            tr("Edge length of a window on the ground: about what an image shows."),
        )
        self.offer(
            number(self.STRIDE, tr("Stride (map units)"), number.Double, 350.0, minValue=0.001),
            tr("Distance from window to window; at most the window size."),
        )
        self.offer(
            QgsProcessingParameterString(self.LEVELS, tr("Levels"), "1", optional=True),
            tr(
                "Multipliers of window size and stride, separated by “;”: 1;2 adds windows twice as large for "
                "flights twice as high."
            ),
            advanced=True,
        )
        self.offer(
            number(
                self.REFERENCES_PER_VECTOR, tr("Landmarks per vector"), number.Integer, 10, minValue=3, maxValue=1000
            ),
            tr("How many of the landmarks nearest to the center a vector holds."),
            advanced=True,
        )
        self.offer(
            number(self.MINIMUM_AREA, tr("Minimum area (m²)"), number.Double, 100.0, minValue=0.0),
            tr("Smaller regions are no landmarks."),
        )
        self.offer(
            QgsProcessingParameterFileDestination(self.DATABASE, tr("Reference database"), tr("GeoPackage (*.gpkg)")),
            tr("One GeoPackage with the layers windows, references, overview, classes and parameters."),
        )
        self.addOutput(QgsProcessingOutputNumber(self.WINDOW_COUNT, tr("Number of windows")))
        self.addOutput(QgsProcessingOutputNumber(self.REFERENCE_COUNT, tr("Number of landmarks")))

    def checkParameterValues(self, parameters, context):
        possible, reason = super().checkParameterValues(parameters, context)
        if not possible:
            return False, reason
        size = self.parameterAsDouble(parameters, self.WINDOW_SIZE, context)
        stride = self.parameterAsDouble(parameters, self.STRIDE, context)
        if stride > size:
            return False, tr(
                "The stride ({stride:g}) is larger than the window ({size:g}), so ground between the windows would be "
                "missed; make the stride at most the window size."
            ).format(stride=stride, size=size)
        return True, ""

    def read_layers(self, parameters, context, feedback):
        from ..exchange.layers import label_map_layer

        self._layer = label_map_layer(self.parameterAsRasterLayer(parameters, self.LABELS, context), self.LABELS)

    def work(self, parameters, context, feedback):
        from ...core.database.build import DatabaseBuilder
        from ...storage.database.writer import DatabaseWriter
        from ...storage.files import written_beside
        from ...storage.rasters import GdalLabels, HeldLabels
        from ..exchange.layers import map_frame
        from ..exchange.reference_systems import longitudes_latitudes
        from ..exchange.styles import database_styles

        output = self.parameterAsFileOutput(parameters, self.DATABASE, context)
        labels = GdalLabels(self._layer.path)
        frame = map_frame(labels, self._layer)
        table = self._table(parameters, context, feedback, labels)
        settings = self._settings(parameters, context)
        held = HeldLabels(labels)
        builder = DatabaseBuilder(labels, frame, table, settings, plugin_version())
        self._say_rounding(builder, frame, settings, feedback)
        with written_beside(output) as temporary:
            follow(held.steps(), feedback, 0, 10)
            builder.read_from(held.source)
            follow(builder.steps(), feedback, 10, 75)
            follow(builder.compare_windows(), feedback, 75, 85)
            database = builder.database
            degrees = longitudes_latitudes(database.windows.centers, self._layer.crs, context.transformContext())
            styles = database_styles(database.class_table)
            writer = DatabaseWriter(temporary, database, *degrees, builder.overview, styles)
            follow(writer.steps(), feedback, 85, 100)
        self._say_result(database, feedback)
        return {
            self.DATABASE: output,
            self.WINDOW_COUNT: len(database.windows),
            self.REFERENCE_COUNT: len(database.references),
        }

    def _table(self, parameters, context, feedback, labels):
        """The map's class table with the asked reference classes."""
        from ...storage.rasters import class_table_of_map, class_table_of_values, count_values

        table = class_table_of_map(labels, self._layer.file)
        if table is None:
            table = class_table_of_values(count_values(labels, feedback.isCanceled))
            check_canceled(feedback)
            feedback.pushInfo(tr("The label map brings no class names; its classes are named by their values."))
        chosen = split_list(self.parameterAsString(parameters, self.REFERENCE_CLASSES, context))
        try:
            return (table.with_references(chosen) if chosen else table).require_references()
        except ClassTableError as error:
            raise ParameterError(f"{self.REFERENCE_CLASSES}: {error}") from None

    def _settings(self, parameters, context):
        from ...core.database.build import BuildSettings

        texts = split_list(self.parameterAsString(parameters, self.LEVELS, context)) or ["1"]
        try:
            levels = tuple(float(text) for text in texts)
        except ValueError:
            raise ParameterError(f"LEVELS: “{';'.join(texts)}” is not a list of numbers such as 1;2.") from None
        return BuildSettings(
            self.parameterAsDouble(parameters, self.WINDOW_SIZE, context),
            self.parameterAsDouble(parameters, self.STRIDE, context),
            self.parameterAsDouble(parameters, self.MINIMUM_AREA, context),
            levels,
            self.parameterAsInt(parameters, self.REFERENCES_PER_VECTOR, context),
            threads=worker_threads(),
        )

    def _say_rounding(self, builder, frame, settings, feedback):
        for level, grid in zip(settings.levels, builder.grids):
            size, stride = grid.size * frame.pixel_size, grid.stride * frame.pixel_size
            asked = settings.window_size * level, settings.stride * level
            if abs(size - asked[0]) > 1e-9 * size or abs(stride - asked[1]) > 1e-9 * stride:
                feedback.pushWarning(
                    tr("Windows are whole pixels: window size {size:g}, stride {stride:g}.").format(
                        size=size, stride=stride
                    )
                )

    def _say_result(self, database, feedback):
        windows = database.windows
        lacking = int((~windows.described).sum())
        feedback.pushInfo(
            tr("{windows} windows, {references} landmarks.").format(
                windows=len(windows), references=len(database.references)
            )
        )
        if lacking:
            feedback.pushWarning(
                tr("{lacking} windows ({share:.0%}) show fewer than three landmarks and have no vector.").format(
                    lacking=lacking, share=lacking / len(windows)
                )
            )
