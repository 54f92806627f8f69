"""semref:exportonboard: export a reference database as one small file for the aircraft."""

from __future__ import annotations

import os
from dataclasses import replace
from datetime import datetime, timezone
from typing import TYPE_CHECKING

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
)

from ...core.errors import ParameterError
from ..base import parameters
from ..base.algorithm import REFERENCE_DATABASE, Declared, SemRefAlgorithm, cancelable, check_canceled
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import DOUBLE
from ..translation import tr

if TYPE_CHECKING:
    from ...core.database.model import ReferenceDatabase
    from ...core.onboard.format import OnboardDatabase


class ExportOnboard(SemRefAlgorithm):
    ID = "exportonboard"
    TITLE = "Export for onboard use"
    GROUP = REFERENCE_DATABASE
    TAGS = ("aircraft", "uav", "drone", "npz", "companion computer", "flight", "compact", "numpy")
    SUMMARY = (
        "Writes a reference database to one small file (.npz) for a computer without QGIS. Install the Python "
        "package semref on that computer and run “semref localize”.\n\nPositions, areas and vectors are rounded; "
        "the log shows the largest error. An existing onboard file is replaced. Other files are never overwritten."
    )

    PRECISION = "PRECISION"
    CLIP = "CLIP"
    DISTANCE = "DISTANCE"
    OVERVIEW = "OVERVIEW"
    KEY_FILE = "KEY_FILE"
    BYTES = "BYTES"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            parameters.database(),
            with_help(
                QgsProcessingParameterFeatureSource(self.CLIP, "Area or route", optional=True),
                "Polygons or lines that limit the export. If not set, the whole map is exported.",
            ),
            with_help(
                QgsProcessingParameterNumber(
                    self.DISTANCE, "Distance around area or route (m)", DOUBLE, 0.0, minValue=0.0
                ),
                "Half the width of the corridor along a route. Use at least the footprint width of the images.",
            ),
            with_help(
                QgsProcessingParameterBoolean(self.OVERVIEW, "Include the overview", defaultValue=True),
                "The overview is the reduced label map that map correlation searches. Without it the file is "
                "several times smaller.",
            ),
            with_help(
                QgsProcessingParameterNumber(self.PRECISION, "Precision (m)", DOUBLE, optional=True, minValue=1e-6),
                "Maximum rounding error of the x and y of a landmark. If not set, 0.05 pixels of the label map.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterFile(self.KEY_FILE, "Key file", fileFilter=tr("All files (*)"), optional=True),
                "File with secret bytes, for example 32 random bytes, that signs the onboard file (HMAC-SHA256). "
                "With “semref … --require-signature KEY” the aircraft rejects files that were changed or made by "
                "others. Keep this file secret: anyone who has it can sign.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterFileDestination(
                    self.OUTPUT, "Onboard file", fileFilter=tr("Onboard files (*.npz)")
                ),
                "Zip file of NumPy arrays. The documentation describes the format for other programming languages.",
            ),
            QgsProcessingOutputNumber(self.BYTES, "Size in bytes"),
        )

    def read_layers(self, values: Values) -> None:
        from ..layers.areas import drawn_area

        self._area = drawn_area(values.source(self.CLIP))

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...core.onboard.read import read_onboard
        from ...core.onboard.write import write_onboard
        from ...storage.database.reader import read_database, read_overview
        from ..layers.reference_systems import database_crs, fitted_lon_lat

        self._check_target(values.target(self.OUTPUT), feedback)
        path, precision = values.file(self.DATABASE), values.optional_number(self.PRECISION)
        key_file = values.file(self.KEY_FILE) or None
        database = cancelable(read_database, path, feedback=feedback)
        crs = database_crs(database)
        if values.switch(self.OVERVIEW):
            overview = cancelable(read_overview, path, database.parameters, feedback=feedback)
            database = replace(database, overview=overview)
        feedback.setProgress(40)
        if self._area is not None:
            database = self._clip(values, database, crs, feedback)
        lon_lat = fitted_lon_lat(database.parameters.extent, crs, values.transform_context)
        feedback.setProgress(60)
        with outputs.file(self.OUTPUT) as temporary:
            now = datetime.now(timezone.utc)
            cancelable(write_onboard, temporary, database, lon_lat, precision, key_file, now, feedback=feedback)
            feedback.setProgress(80)
            # Read the file before it gets its name: the aircraft must be able to read it.
            onboard = cancelable(read_onboard, temporary, key_file, feedback=feedback)
            check_canceled(feedback)
        self._log(onboard, feedback)
        return {self.BYTES: onboard.size_bytes}

    def _check_target(self, output: str, feedback: QgsProcessingFeedback) -> None:
        """Log that an older onboard file is replaced, and refuse to replace any other file."""
        from ...core.onboard.format import is_onboard_file

        if not os.path.isfile(output):
            return
        if not is_onboard_file(output):
            raise ParameterError(
                "{output} exists and is not an onboard file. Choose another name, or remove the file.", output=output
            )
        feedback.pushWarning(tr("{output} is replaced.").format(output=output))

    def _clip(
        self,
        values: Values,
        database: ReferenceDatabase,
        crs: QgsCoordinateReferenceSystem,
        feedback: QgsProcessingFeedback,
    ) -> ReferenceDatabase:
        from ...core.onboard.area import area_mask, clip_database
        from ..layers.areas import area_rings

        distance, extent = values.number(self.DISTANCE), database.parameters.extent
        arguments = self._area, distance, crs, extent, values.transform_context
        rings = cancelable(area_rings, *arguments, feedback=feedback)
        part = clip_database(database, area_mask(rings, database.parameters))
        feedback.pushInfo(
            tr("The area contains {kept} of {landmarks} landmarks and {windows} of {all_windows} windows.").format(
                kept=len(part.references),
                landmarks=len(database.references),
                windows=len(part.windows),
                all_windows=len(database.windows),
            )
        )
        return part

    def _log(self, onboard: OnboardDatabase, feedback: QgsProcessingFeedback) -> None:
        feedback.pushInfo(
            tr(
                "{bytes} bytes. Largest rounding errors: positions {position:g} m, areas {area:.3%}, vector elements "
                "{vector:.4f}."
            ).format(
                bytes=onboard.size_bytes,
                position=onboard.position_error,
                area=onboard.area_error,
                vector=onboard.vector_error,
            )
        )
        if onboard.lon_lat is None:
            feedback.pushWarning(
                tr("The file contains no longitude and latitude, because the map is too large or contains a pole.")
            )
        else:
            feedback.pushInfo(
                tr("Longitude and latitude are accurate to {error:.4f} m.").format(error=onboard.lon_lat.error_m)
            )
