"""semref:updatedatabase: update a database from a corrected label map."""

from __future__ import annotations

from math import ceil, floor
from typing import TYPE_CHECKING

from qgis.core import (
    QgsCoordinateTransform,
    QgsProcessingFeedback,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterRasterLayer,
    QgsRectangle,
)

from ...core.errors import ClassTableError, LabelMapError, ParameterError
from ...core.labels.class_table import ClassTable
from ..base import parameters
from ..base.algorithm import REFERENCE_DATABASE, Declared, SemRefAlgorithm, check_canceled, follow
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import SOURCE_POLYGON, wkt_for_gdal
from ..threads import worker_threads
from ..translation import tr
from ..version import plugin_version

if TYPE_CHECKING:
    from ...core.database.model import ReferenceDatabase
    from ...core.database.update import DatabaseChanges
    from ...core.geometry.frame import MapFrame
    from ...storage.label_maps import GdalLabels


class UpdateDatabase(SemRefAlgorithm):
    ID = "updatedatabase"
    TITLE = "Update reference database"
    MAY_REPLACE = {"OUTPUT": "DATABASE"}
    GROUP = REFERENCE_DATABASE
    TAGS = ("incremental", "correction", "label map", "landmarks", "geopackage")
    SUMMARY = (
        "Updates a reference database after its label map was corrected. The result is the same as a new build, but "
        "only windows and landmarks near the changes are computed.\n\nAll settings come from the database. Unchanged "
        "rows keep their fid. The label map must have the same pixels, CRS and classes as the old label map."
    )

    DATABASE = "DATABASE"
    LABELS = "LABELS"
    CHANGED = "CHANGED"
    OUTPUT = "OUTPUT"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            parameters.database("GeoPackage from “Build reference database” or from this algorithm."),
            with_help(
                QgsProcessingParameterRasterLayer(self.LABELS, "Corrected label map"),
                "Label map of the whole area, with the pixel size and extent of the old label map.",
            ),
            with_help(
                QgsProcessingParameterFeatureSource(
                    self.CHANGED, "Changed areas", types=[SOURCE_POLYGON], optional=True
                ),
                "Polygons that contain all changes. Only blocks of 512 × 512 pixels that these polygons touch are "
                "compared, so changes outside are missed. If not set, the whole map is compared with the "
                "database, which takes longer.",
            ),
            with_help(
                QgsProcessingParameterFileDestination(
                    self.OUTPUT, "Updated database", fileFilter=tr("GeoPackage (*.gpkg)")
                ),
                "The output may be the input database. It is replaced when the update is complete.",
            ),
            parameters.open_output(),
        )

    def read_layers(self, values: Values) -> None:
        self._layer = values.label_map(self.LABELS)
        self._changed = values.source(self.CHANGED)

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> None:
        from ...core.database.tasks import Threads
        from ...core.database.update import update_by_tasks
        from ...storage.database.editor import write_changes
        from ...storage.database.reader import read_stored_database
        from ...storage.label_maps import GdalLabels
        from ..layers.layer_inputs import map_frame

        stored = read_stored_database(values.file(self.DATABASE))
        labels = GdalLabels(self._layer.path, keeps_blocks=True)
        frame = map_frame(labels, self._layer)
        self._check_crs(stored.database)
        self._check_classes(stored.database.class_table, labels)
        run = Threads(labels, worker_threads(), lambda: check_canceled(feedback))
        areas = self._areas(frame, values, feedback)
        with outputs.database(self.OUTPUT) as path:
            steps = update_by_tasks(labels, frame, stored.database, areas, plugin_version(), run)
            changes = follow(steps, feedback, 0, 80)
            follow(write_changes(path, stored, changes), feedback, 80, 100)
        # If the update replaces the database, it must not undo what others have written in the meantime.
        outputs.require(stored.require_as_read)
        self._log_result(stored.database, changes, feedback)

    def _check_crs(self, database: ReferenceDatabase) -> None:
        from ..layers.reference_systems import database_crs, describe_crs

        crs = database_crs(database)
        if wkt_for_gdal(self._layer.crs) != database.parameters.crs and self._layer.crs != crs:
            raise LabelMapError(
                "The CRS of the label map ({crs}) differs from the CRS of the database ({database_crs}). Rasterize "
                "the layer in the CRS of the database, or build a new database.",
                crs=describe_crs(self._layer.crs),
                database_crs=describe_crs(crs),
            )

    def _check_classes(self, table: ClassTable, labels: GdalLabels) -> None:
        """Require the class table of the map, if there is one, to be that of the database."""
        from ...storage.label_maps import named_classes, stored_class_table

        found = stored_class_table(labels.dataset, self._layer.path) or named_classes(labels.dataset)
        differing = {(c.value, c.name) for c in found} ^ {(c.value, c.name) for c in table}
        for value, name in sorted(differing if found else ()):
            raise ClassTableError(
                "The classes of the label map and of the database differ: {value} {name} is in one of them only. "
                "Rasterize the layer with the class table of the database, or build a new database.",
                value=value,
                name=name,
            )

    def _areas(
        self, frame: MapFrame, values: Values, feedback: QgsProcessingFeedback
    ) -> list[tuple[int, int, int, int]] | None:
        """Return (left, top, right, bottom) in pixels around each changed polygon; None without CHANGED."""
        from ..layers.reference_systems import transformed_box

        if self._changed is None:
            return None
        transform = QgsCoordinateTransform(self._changed.sourceCrs(), self._layer.crs, values.transform_context)
        areas = []
        for feature in self._changed.getFeatures():
            check_canceled(feedback)
            for part in feature.geometry().asGeometryCollection():
                box = transformed_box(transform, part.boundingBox())
                if box.isNull():
                    raise ParameterError(
                        "“{key}”: feature {feature} cannot be transformed to the CRS of the label map. Check the CRS "
                        "of the layer.",
                        key=values.title(self.CHANGED),
                        feature=feature.id(),
                    )
                areas.append(_pixels_around(box, frame))
        if not areas:
            raise ParameterError(
                "“{key}” contains no polygon. Leave it empty to compare the whole map.", key=values.title(self.CHANGED)
            )
        return areas

    def _log_result(
        self, database: ReferenceDatabase, changes: DatabaseChanges, feedback: QgsProcessingFeedback
    ) -> None:
        feedback.pushInfo(
            tr("{touched} of {windows} windows changed. Landmarks: {removed} removed, {added} added.").format(
                touched=len(changes.touched),
                windows=len(database.windows),
                removed=len(changes.removed),
                added=len(changes.added),
            )
        )


def _pixels_around(box: QgsRectangle, frame: MapFrame) -> tuple[int, int, int, int]:
    """Return (left, top, right, bottom) of all pixels that a rectangle in map units touches, plus one pixel on each
    side."""
    corners = (box.xMinimum(), box.yMaximum()), (box.xMaximum(), box.yMinimum())
    (left, top), (right, bottom) = frame.to_pixels(corners).tolist()
    return floor(left) - 1, floor(top) - 1, ceil(right) + 1, ceil(bottom) + 1
