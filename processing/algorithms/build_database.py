"""semref:builddatabase: build a reference database from a label map."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from qgis.core import (
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
    QgsRectangle,
)

from ...core.errors import ParameterError
from ...core.labels.class_table import ClassTable
from ..base import parameters
from ..base.algorithm import REFERENCE_DATABASE, Declared, SemRefAlgorithm, check_canceled, follow
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.scheduler import SCHEDULER, require_scheduler, scheduler, workers
from ..base.values import Values
from ..compat import DOUBLE, INTEGER
from ..threads import worker_threads
from ..translation import tr
from ..version import plugin_version

if TYPE_CHECKING:
    from ...core.database.build import BuildSettings
    from ...core.database.model import ReferenceDatabase
    from ...core.geometry.frame import MapFrame
    from ...core.labels.overview import OverviewSink
    from ...core.windows.grid import WindowGrid
    from ...storage.label_maps import GdalLabels


class BuildDatabase(SemRefAlgorithm):
    ID = "builddatabase"
    TITLE = "Build reference database"
    GROUP = REFERENCE_DATABASE
    TAGS = ("topology vector", "sliding window", "landmarks", "geopackage", "reference map")
    SUMMARY = (
        "Builds a reference database from a label map: its landmarks, and windows that are described by topology "
        "vectors.\n\nThe GeoPackage contains windows, landmarks, a reduced map (overview), classes and "
        "parameters. The method is that of He & Wu, Remote Sensing 2025, 17, 1671. Windows with fewer than three "
        "landmarks have no vector."
    )

    WINDOW_SIZE = "WINDOW_SIZE"
    STRIDE = "STRIDE"
    LEVELS = "LEVELS"
    REFERENCES_PER_VECTOR = "REFERENCES_PER_VECTOR"
    MAP_ACCURACY = "MAP_ACCURACY"
    WINDOW_COUNT = "WINDOW_COUNT"
    REFERENCE_COUNT = "REFERENCE_COUNT"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            parameters.label_map(
                "Single-band raster of class values in a projected CRS with meters, for example from “Rasterize "
                "land-cover layer”."
            ),
            parameters.reference_classes(
                "Classes that are landmarks: names or values separated by “;”, for example building;bare_land;water. "
                "If not set, the classes with the role “reference” in the class table of the map are used. If there "
                "are none, buildings, water, bare land and orchards are used."
            ),
            with_help(
                QgsProcessingParameterNumber(self.WINDOW_SIZE, "Window size (m)", DOUBLE, 1280.0, minValue=0.001),
                "Edge length of a window on the ground, about the footprint width of an image.",
            ),
            with_help(
                QgsProcessingParameterNumber(self.STRIDE, "Stride (m)", DOUBLE, 350.0, minValue=0.001),
                "Distance between neighboring windows. It must not be larger than the window size.",
            ),
            with_help(
                QgsProcessingParameterString(self.LEVELS, "Levels", defaultValue="1", optional=True),
                "Multipliers of window size and stride, separated by “;”. For example, 1;2 adds windows of twice "
                "the size for flights at twice the height.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.REFERENCES_PER_VECTOR, "Landmarks per vector", INTEGER, 10, minValue=3, maxValue=1000
                ),
                "Number of landmarks in a vector: those nearest to the center of the window.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterNumber(self.MINIMUM_AREA, "Minimum area (m²)", DOUBLE, 100.0, minValue=0.0),
                "Regions smaller than this area are not used as landmarks.",
            ),
            with_help(
                QgsProcessingParameterFileDestination(
                    self.DATABASE, "Reference database", fileFilter=tr("GeoPackage (*.gpkg)")
                ),
                "GeoPackage with the layers windows, references, overview, classes and parameters.",
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.MAP_ACCURACY, "Map accuracy (m)", DOUBLE, 1.2, optional=True, minValue=0.0, maxValue=10000.0
                ),
                "Standard deviation of landmark positions on the map, along each axis. It increases the 95 % "
                "radius, because neighboring landmarks are displaced together. The default of 1.2 m was measured "
                "between maps of two dates in two countries. “Compare label maps” measures it for your maps.",
                advanced=True,
            ),
            parameters.open_output(),
            QgsProcessingOutputNumber(self.WINDOW_COUNT, "Number of windows"),
            QgsProcessingOutputNumber(self.REFERENCE_COUNT, "Number of landmarks"),
            scheduler(),
        )

    def check(self, values: Values) -> None:
        size, stride = values.number(self.WINDOW_SIZE), values.number(self.STRIDE)
        if stride > size:
            raise ParameterError(
                "The stride ({stride:g}) is larger than the window size ({size:g}), so the windows would leave gaps. "
                "Enter a stride that is not larger than the window size.",
                stride=stride,
                size=size,
            )
        require_scheduler(values)

    def read_layers(self, values: Values) -> None:
        self._layer = values.label_map(self.LABELS)

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...storage.database.overview_file import overview_beside
        from ...storage.database.writer import write_database
        from ...storage.file_states import state
        from ...storage.label_maps import GdalLabels
        from ..layers.class_styles import database_styles
        from ..layers.layer_inputs import map_frame
        from ..layers.reference_systems import TRUE_TO_SCALE, describe_crs, ground_scale, longitudes_latitudes

        self._before = {self._layer.path: state(self._layer.path)}
        labels = GdalLabels(self._layer.path)
        frame = map_frame(labels, self._layer)
        scale = ground_scale(self._layer.crs, QgsRectangle(*frame.extent).center(), values.transform_context)
        if scale is not None and abs(scale - 1) > TRUE_TO_SCALE:
            text = tr(
                "In {crs}, 1 m on the map is {scale:.2f} m on the ground. Sizes and radii differ by this factor, and "
                "heights of cameras do not fit. Warp the label map to its UTM zone."
            )
            feedback.pushWarning(text.format(crs=describe_crs(self._layer.crs), scale=scale))
        table = self._table(values, labels, feedback)
        settings = self._settings(values)
        shape_hw = frame.reduced(settings.overview_factor).shape_hw
        with outputs.database(self.DATABASE) as path, overview_beside(path, shape_hw) as overview:
            with overview:
                database = self._build(values, labels, (frame, table, settings), overview.put, feedback)
            degrees = longitudes_latitudes(database.windows.centers, self._layer.crs, values.transform_context)
            styles = database_styles(database.class_table)
            follow(write_database(path, database, *degrees, overview, styles), feedback, 85, 100)
        windows, references = database.windows, len(database.references)
        self._log_result(len(windows), references, int((~windows.described).sum()), feedback)
        return {self.WINDOW_COUNT: len(windows), self.REFERENCE_COUNT: references}

    def _build(
        self,
        values: Values,
        labels: GdalLabels,
        build: tuple[MapFrame, ClassTable, BuildSettings],
        put: OverviewSink,
        feedback: QgsProcessingFeedback,
    ) -> ReferenceDatabase:
        """Build with the workers of SCHEDULER, or with threads of this process."""
        from ...core.database.build import build_by_tasks, level_grids
        from ...core.database.tasks import Threads
        from ...storage.label_maps import hold_labels

        frame, _, settings = build
        self._log_rounding(level_grids(frame.shape_hw, frame.pixel_size, settings), frame, settings, feedback)
        if values.has(SCHEDULER):
            with workers(values, feedback, self._before, self._layer.path) as run:
                return follow(build_by_tasks(*build, plugin_version(), run, put), feedback, 0, 85)
        source = follow(hold_labels(labels), feedback, 0, 10)
        run = Threads(source, worker_threads(), lambda: check_canceled(feedback))
        return follow(build_by_tasks(*build, plugin_version(), run, put), feedback, 10, 85)

    def _table(self, values: Values, labels: GdalLabels, feedback: QgsProcessingFeedback) -> ClassTable:
        from ...storage.label_maps import class_table_of_map, class_table_of_values, count_values

        table = class_table_of_map(labels, self._layer.file)
        if table is None:
            table = class_table_of_values(count_values(labels, feedback.isCanceled))
            check_canceled(feedback)
            feedback.pushInfo(tr("The label map contains no class names. The class values are used as names."))
        table = values.with_references(self.REFERENCE_CLASSES, table)
        names = ", ".join(one.name for one in table.references)
        feedback.pushInfo(tr("Reference classes: {classes}.").format(classes=names))
        return table

    def _settings(self, values: Values) -> BuildSettings:
        from ...core.database.build import BuildSettings
        from ...core.geometry.error_settings import MAP_ACCURACY

        accuracy = values.optional_number(self.MAP_ACCURACY)
        return BuildSettings(
            values.number(self.WINDOW_SIZE),
            values.number(self.STRIDE),
            values.number(self.MINIMUM_AREA),
            tuple(values.numbers(self.LEVELS)) or (1.0,),
            values.integer(self.REFERENCES_PER_VECTOR),
            map_accuracy=MAP_ACCURACY if accuracy is None else accuracy,
        )

    def _log_rounding(
        self, grids: Sequence[WindowGrid], frame: MapFrame, settings: BuildSettings, feedback: QgsProcessingFeedback
    ) -> None:
        for level, grid in zip(settings.levels, grids):
            size, stride = grid.size * frame.pixel_size, grid.stride * frame.pixel_size
            asked = settings.window_size * level, settings.stride * level
            if abs(size - asked[0]) > 1e-9 * size or abs(stride - asked[1]) > 1e-9 * stride:
                feedback.pushWarning(
                    tr(
                        "Window size and stride were rounded to whole pixels: window size {size:g} m, stride "
                        "{stride:g} m."
                    ).format(size=size, stride=stride)
                )

    def _log_result(self, windows: int, references: int, lacking: int, feedback: QgsProcessingFeedback) -> None:
        text = tr("{windows} windows, {references} landmarks.")
        feedback.pushInfo(text.format(windows=windows, references=references))
        if lacking:
            feedback.pushWarning(
                tr("{lacking} windows ({share:.0%}) contain fewer than three landmarks and have no vector.").format(
                    lacking=lacking, share=lacking / windows
                )
            )
