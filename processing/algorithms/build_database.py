"""semref:builddatabase – label map to reference database."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from qgis.core import (
    QgsProcessingOutputNumber,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterString,
)

from ...core.errors import ClassTableError, ParameterError
from ..base import parameters
from ..base.algorithm import REFERENCE_DATABASE, Declared, SemRefAlgorithm, check_canceled, follow
from ..base.parameters import with_help
from ..base.scheduler import SCHEDULER, require_scheduler, scheduler, workers
from ..compat import DOUBLE, INTEGER
from ..threads import worker_threads
from ..translation import tr
from ..version import plugin_version

if TYPE_CHECKING:
    from qgis.core import QgsProcessingFeedback

    from ...core.database.build import BuildSettings
    from ...core.database.model import ReferenceDatabase
    from ...core.geometry.frame import MapFrame
    from ...core.labels.class_table import ClassTable
    from ...core.labels.overview import OverviewSink
    from ...core.windows.grid import WindowGrid
    from ...storage.label_maps import GdalLabels
    from ..base.outputs import Outputs
    from ..base.values import Values


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
    MAP_ACCURACY = "MAP_ACCURACY"
    DATABASE = "DATABASE"
    WINDOW_COUNT = "WINDOW_COUNT"
    REFERENCE_COUNT = "REFERENCE_COUNT"

    def title(self) -> str:
        return tr("Build reference database")

    def summary(self) -> str:
        return tr(
            "Slides windows over a label map and describes each by the topology vector of its landmarks; saves "
            "windows, landmarks of the whole map, a reduced map, classes and parameters in one GeoPackage.\n\n"
            "The method is that of He & Wu, Remote Sensing 2025, 17, 1671. Windows with fewer than three landmarks "
            "get no vector; the log says how many."
        )

    def parameters(self) -> tuple[Declared, ...]:
        return (
            parameters.label_map(
                tr("Single-band raster of class values in a metric CRS, as “Rasterize annotation” makes it.")
            ),
            parameters.reference_classes(
                tr(
                    "Classes whose regions are landmarks: names or values separated by “;”, for example "
                    "building;bare_land;water. If left out, the classes with the role “reference” in the map’s class "
                    "table."
                )
            ),
            *self._windows(),
            with_help(
                QgsProcessingParameterNumber(
                    self.MINIMUM_AREA, tr("Minimum area (m²)"), type=DOUBLE, defaultValue=100.0, minValue=0.0
                ),
                tr("Smaller regions are no landmarks."),
            ),
            with_help(
                QgsProcessingParameterFileDestination(
                    self.DATABASE, tr("Reference database"), fileFilter=tr("GeoPackage (*.gpkg)")
                ),
                tr("One GeoPackage with the layers windows, references, overview, classes and parameters."),
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.MAP_ACCURACY,
                    tr("Accuracy of the map (map units)"),
                    type=DOUBLE,
                    defaultValue=1.1,
                    optional=True,
                    minValue=0.0,
                    maxValue=10000.0,
                ),
                tr(
                    "Standard deviation along each axis of where landmarks are on the map. Neighbors are displaced "
                    "alike, so that it limits how exactly images are located; the radius of fixes reckons with it. "
                    "1.1 m was measured between maps of two dates."
                ),
                advanced=True,
            ),
            parameters.open_output(),
            QgsProcessingOutputNumber(self.WINDOW_COUNT, tr("Number of windows")),
            QgsProcessingOutputNumber(self.REFERENCE_COUNT, tr("Number of landmarks")),
            scheduler(),
        )

    def _windows(self) -> tuple[Declared, ...]:
        """How windows lie and what describes them."""
        return (
            with_help(
                QgsProcessingParameterNumber(
                    self.WINDOW_SIZE, tr("Window size (map units)"), type=DOUBLE, defaultValue=1280.0, minValue=0.001
                ),
                tr("Edge length of a window on the ground: about what an image shows."),
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.STRIDE, tr("Stride (map units)"), type=DOUBLE, defaultValue=350.0, minValue=0.001
                ),
                tr("Distance from window to window; at most the window size."),
            ),
            with_help(
                QgsProcessingParameterString(self.LEVELS, tr("Levels"), defaultValue="1", optional=True),
                tr(
                    "Multipliers of window size and stride, separated by “;”: 1;2 adds windows twice as large for "
                    "flights twice as high."
                ),
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.REFERENCES_PER_VECTOR,
                    tr("Landmarks per vector"),
                    type=INTEGER,
                    defaultValue=10,
                    minValue=3,
                    maxValue=1000,
                ),
                tr("How many of the landmarks nearest to the center a vector holds."),
                advanced=True,
            ),
        )

    def check(self, values: Values) -> None:
        size, stride = values.number(self.WINDOW_SIZE), values.number(self.STRIDE)
        if stride > size:
            raise ParameterError(
                "The stride ({stride:g}) is larger than the window ({size:g}), so ground between the windows would be "
                "missed; make the stride at most the window size.",
                stride=stride,
                size=size,
            )
        require_scheduler(values)

    def read_layers(self, values: Values) -> None:
        self._layer = values.label_map(self.LABELS)

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...storage.database.overview_file import overview_beside
        from ...storage.database.writer import DatabaseWriter
        from ...storage.file_states import state
        from ...storage.label_maps import GdalLabels
        from ..layers.class_styles import database_styles
        from ..layers.layer_inputs import map_frame
        from ..layers.reference_systems import longitudes_latitudes

        self._before = {self._layer.path: state(self._layer.path)}
        labels = GdalLabels(self._layer.path)
        frame = map_frame(labels, self._layer)
        table = self._table(values, labels, feedback)
        settings = self._settings(values)
        shape_hw = frame.reduced(settings.overview_factor).shape_hw
        with outputs.database(self.DATABASE) as path, overview_beside(path, shape_hw) as overview:
            with overview:
                database = self._build(values, labels, (frame, table, settings), overview.put, feedback)
            degrees = longitudes_latitudes(database.windows.centers, self._layer.crs, values.transform_context)
            styles = database_styles(database.class_table)
            writer = DatabaseWriter(path, database, *degrees, overview, styles)
            follow(writer.steps(), feedback, 85, 100)
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
        """The database, by the workers of SCHEDULER or by threads of this process."""
        from ...core.database.build import DatabaseBuilder, level_grids
        from ...core.database.tasks import Threads
        from ...storage.label_maps import HeldLabels

        frame, _, settings = build
        self._log_rounding(level_grids(frame.shape_hw, frame.pixel_size, settings), frame, settings, feedback)
        if values.has(SCHEDULER):
            with workers(values, feedback, self._before, self._layer.path) as run:
                builder = DatabaseBuilder(*build, plugin_version(), run, put)
                follow(builder.steps(), feedback, 0, 85)
        else:
            held = HeldLabels(labels)
            follow(held.steps(), feedback, 0, 10)
            run = Threads(held.source, worker_threads(), lambda: check_canceled(feedback))
            builder = DatabaseBuilder(*build, plugin_version(), run, put)
            follow(builder.steps(), feedback, 10, 85)
        return builder.database

    def _table(self, values: Values, labels: GdalLabels, feedback: QgsProcessingFeedback) -> ClassTable:
        """The map's class table with the asked reference classes."""
        from ...storage.label_maps import class_table_of_map, class_table_of_values, count_values

        table = class_table_of_map(labels, self._layer.file)
        if table is None:
            table = class_table_of_values(count_values(labels, feedback.isCanceled))
            check_canceled(feedback)
            feedback.pushInfo(tr("The label map brings no class names; its classes are named by their values."))
        chosen = values.parts(self.REFERENCE_CLASSES)
        try:
            return (table.with_references(chosen) if chosen else table).require_references()
        except ClassTableError as error:
            raise ParameterError("{where}: {fault}", where=self.REFERENCE_CLASSES, fault=error.sentence) from None

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
                    tr("Windows are whole pixels: window size {size:g}, stride {stride:g}.").format(
                        size=size, stride=stride
                    )
                )

    def _log_result(self, windows: int, references: int, lacking: int, feedback: QgsProcessingFeedback) -> None:
        text = tr("{windows} windows, {references} landmarks.")
        feedback.pushInfo(text.format(windows=windows, references=references))
        if lacking:
            feedback.pushWarning(
                tr("{lacking} windows ({share:.0%}) show fewer than three landmarks and have no vector.").format(
                    lacking=lacking, share=lacking / windows
                )
            )
