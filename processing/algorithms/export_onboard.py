"""semref:exportonboard – a reference database as one small file for the aircraft's computer."""

from __future__ import annotations

import os
from dataclasses import replace

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingOutputNumber,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
)

from ...core.errors import DatabaseError, ParameterError
from ..framework.base import REFERENCE_DATABASE, SemRefAlgorithm, cancelable, check_canceled
from ..translation import tr


class ExportOnboard(SemRefAlgorithm):
    ID = "exportonboard"
    GROUP = REFERENCE_DATABASE
    TAGS = ("aircraft", "uav", "drone", "npz", "companion computer", "flight", "compact", "numpy")

    DATABASE = "DATABASE"
    PRECISION = "PRECISION"
    CLIP = "CLIP"
    DISTANCE = "DISTANCE"
    OVERVIEW = "OVERVIEW"
    OUTPUT = "OUTPUT"
    BYTES = "BYTES"

    def title(self):
        return tr("Export for onboard use")

    def summary(self):
        return tr(
            "Writes a reference database as one small file (.npz) that a computer without QGIS localizes with: copy "
            "the plugin’s folder “core” beside it and run “python -m core localize”.\n\n"
            "Positions, areas and vectors are rounded; the log says how much. An older onboard file is replaced, which "
            "the log says; a file of any other kind is never overwritten."
        )

    def initAlgorithm(self, config=None):
        number = QgsProcessingParameterNumber
        self.offer(
            QgsProcessingParameterFile(self.DATABASE, tr("Reference database"), fileFilter=tr("GeoPackage (*.gpkg)")),
            tr("A GeoPackage made by “Build reference database”."),
        )
        self.offer(
            QgsProcessingParameterFeatureSource(self.CLIP, tr("Area or route"), optional=True),
            tr("Only what lies in these polygons, or along these lines, is exported; without it the whole map."),
        )
        self.offer(
            number(self.DISTANCE, tr("Distance around it (map units)"), number.Double, 0.0, minValue=0.0),
            tr("Half the width of the corridor along a route; give what an image shows at least."),
        )
        self.offer(
            QgsProcessingParameterBoolean(self.OVERVIEW, tr("With the overview"), True),
            tr("The reduced label map, which map correlation searches; without it the file is several times smaller."),
        )
        self.offer(
            number(self.PRECISION, tr("Precision (map units)"), number.Double, None, optional=True, minValue=1e-6),
            tr("Largest rounding error of a landmark’s x and y; a hundredth of a pixel of the label map if left out."),
            advanced=True,
        )
        self.offer(
            QgsProcessingParameterFileDestination(self.OUTPUT, tr("Onboard file"), tr("Onboard files (*.npz)")),
            tr("Arrays in numpy’s format, zipped; the documentation describes it for readers in other languages."),
        )
        self.addOutput(QgsProcessingOutputNumber(self.BYTES, tr("Size in bytes")))

    def read_layers(self, parameters, context, feedback):
        from ..exchange.areas import drawn_area

        self._area = drawn_area(self.parameterAsSource(parameters, self.CLIP, context))

    def work(self, parameters, context, feedback):
        from ...core.onboard.read import read_onboard
        from ...core.onboard.write import write_onboard
        from ...storage.database.reader import read_database, read_overview
        from ...storage.files import written_beside
        from ..exchange.reference_systems import fitted_lon_lat

        output = self.parameterAsFileOutput(parameters, self.OUTPUT, context)
        self._check_target(output, feedback)
        path = self.parameterAsFile(parameters, self.DATABASE, context)
        precision = None
        if parameters.get(self.PRECISION) not in (None, ""):
            precision = self.parameterAsDouble(parameters, self.PRECISION, context)
        database = cancelable(read_database, path, feedback=feedback)
        crs = QgsCoordinateReferenceSystem.fromWkt(database.parameters.crs)
        if not crs.isValid():
            raise DatabaseError(f"{path} has no readable parameter crs; build it again.")
        if self.parameterAsBool(parameters, self.OVERVIEW, context):
            database = replace(database, overview=cancelable(read_overview, path, feedback=feedback))
        feedback.setProgress(40)
        if self._area is not None:
            distance = self.parameterAsDouble(parameters, self.DISTANCE, context)
            database = self._clipped(database, distance, crs, context.transformContext(), feedback)
        lon_lat = fitted_lon_lat(database.parameters.extent, crs, context.transformContext())
        feedback.setProgress(60)
        with written_beside(output) as temporary:
            cancelable(write_onboard, temporary, database, lon_lat, precision, feedback=feedback)
            feedback.setProgress(80)
            # Read back before it gets its name: what is on board must be readable there.
            onboard = cancelable(read_onboard, temporary, feedback=feedback)
            check_canceled(feedback)
        self._say(onboard, feedback)
        return {self.OUTPUT: output, self.BYTES: onboard.size_bytes}

    def _check_target(self, output, feedback):
        """An older export may be replaced, but not unsaid; anything else that has the name is not ours to delete."""
        from ...core.onboard.format import is_onboard_file

        if not os.path.isfile(output):
            return
        if not is_onboard_file(output):
            raise ParameterError(f"{output} exists and is no onboard file; remove it or choose another name.")
        feedback.pushWarning(tr("{output} is replaced.").format(output=output))

    def _clipped(self, database, distance, crs, transform_context, feedback):
        from ...core.onboard.area import area_mask, clipped
        from ..exchange.areas import area_rings

        arguments = self._area, distance, crs, database.parameters.extent, transform_context
        rings = cancelable(area_rings, *arguments, feedback=feedback)
        part = clipped(database, area_mask(rings, database.parameters))
        feedback.pushInfo(
            tr("{kept} of {landmarks} landmarks and {windows} of {all_windows} windows lie in the area.").format(
                kept=len(part.references),
                landmarks=len(database.references),
                windows=len(part.windows),
                all_windows=len(database.windows),
            )
        )
        return part

    def _say(self, onboard, feedback):
        feedback.pushInfo(
            tr(
                "{bytes} bytes. Rounded: positions by {position:g} map units at most, areas by {area:.3%}, vectors by "
                "{vector:.4f} an element."
            ).format(
                bytes=onboard.size_bytes,
                position=onboard.position_error,
                area=onboard.area_error,
                vector=onboard.vector_error,
            )
        )
        if onboard.lon_lat is None:
            feedback.pushWarning(
                tr("The file can’t tell longitude and latitude: the map is too large for it, or has a pole in it.")
            )
        else:
            feedback.pushInfo(
                tr("Longitudes and latitudes are within {error:.4f} m.").format(error=onboard.lon_lat.error_m)
            )
