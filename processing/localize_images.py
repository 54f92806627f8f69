"""semref:localizeimages – images to positions."""

from __future__ import annotations

import os
from dataclasses import dataclass
from math import isnan
from typing import Optional

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingOutputNumber,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFile,
    QgsProcessingParameterMultipleLayers,
    QgsRectangle,
)

from ..core.class_table import LIST_SEPARATOR
from ..core.errors import DatabaseError, ParameterError, SemRefError
from .base import LOCALIZATION, SemRefAlgorithm, check_canceled
from .compat import POINT, POLYGON, SOURCE_FILE, SOURCE_POINT, SOURCE_POLYGON
from .sinks import Sink
from .translation import tr

ERROR = "error"
"""Status of an image that could not be read; the others come from the localiser."""

FIELDS = (
    ("image", "text"), ("status", "text"), ("x", "real"), ("y", "real"), ("longitude", "real"), ("latitude", "real"),
    ("heading", "real"), ("pixel_size", "real"), ("confidence", "real"), ("distance", "real"), ("inliers", "integer"),
    ("references", "integer"), ("log_odds", "real"), ("error_95", "real"), ("window", "text"), ("method", "text"),
    ("reason", "text"),
)  # fmt: skip
FOOTPRINT_FIELDS = (
    ("image", "text"),
    ("status", "text"),
    ("confidence", "real"),
    ("window", "text"),
    ("method", "text"),
)


@dataclass(frozen=True)
class LocalizedImage:
    """One image and its result; ``error`` instead when it could not be read."""

    path: str
    result: Optional[object] = None
    error: str = ""


class LocalizeImages(SemRefAlgorithm):
    ID = "localizeimages"
    GROUP = LOCALIZATION
    TAGS = ("position", "match", "uav", "drone", "navigation", "gnss", "geolocation", "fix")

    DATABASE = "DATABASE"
    IMAGES = "IMAGES"
    METHOD = "METHOD"
    OUTPUT = "OUTPUT"
    FOOTPRINTS = "FOOTPRINTS"
    FIX_COUNT = "FIX_COUNT"
    AUTOMATIC, TOPOLOGY_VECTOR, CONSTELLATION, MAP_CORRELATION = range(4)

    def title(self):
        return tr("Localize images")

    def summary(self):
        return tr(
            "Finds where images were taken: each label image is described by its landmarks and matched with the "
            "windows of a reference database.\n\n"
            "Every image gives one point; without a fix it has no geometry and its reason says why. The topology "
            "vector method finds images centered on a window of the database and is known to accept images from "
            "elsewhere: check what it finds."
        )

    def initAlgorithm(self, config=None):
        self.offer(
            QgsProcessingParameterFile(self.DATABASE, tr("Reference database"), fileFilter=tr("GeoPackage (*.gpkg)")),
            tr("A GeoPackage made by “Build reference database”."),
        )
        self.offer(
            QgsProcessingParameterMultipleLayers(self.IMAGES, tr("Images"), SOURCE_FILE),
            tr(
                "Label images, or folders of them: single-band class values, or colors decoded by the database’s class "
                "table. They need no georeference."
            ),
        )
        self.offer(
            QgsProcessingParameterEnum(
                self.METHOD,
                tr("Method"),
                [
                    tr("Automatic (not in this version)"),
                    tr("Topology vector (He & Wu 2025)"),
                    tr("Constellation (not in this version)"),
                    tr("Map correlation (not in this version)"),
                ],
                defaultValue=self.TOPOLOGY_VECTOR,
            ),
            tr(
                "Topology vector is the published method: the nearest vector of all windows, accepted up to distance 2."
            ),
        )
        self.offer(
            QgsProcessingParameterFeatureSink(self.OUTPUT, tr("Positions"), SOURCE_POINT),
            tr("One point an image: status, position, confidence, distance, window and, without a fix, the reason."),
        )
        self.offer(
            QgsProcessingParameterFeatureSink(
                self.FOOTPRINTS, tr("Footprints"), SOURCE_POLYGON, optional=True, createByDefault=False
            ),
            tr("One polygon a fix: the matched window."),
        )
        self.addOutput(QgsProcessingOutputNumber(self.FIX_COUNT, tr("Number of fixes")))

    def checkParameterValues(self, parameters, context):
        if self.parameterAsEnum(parameters, self.METHOD, context) != self.TOPOLOGY_VECTOR:
            return False, tr("This version has one method: choose METHOD 1 (topology vector).")
        return super().checkParameterValues(parameters, context)

    def work(self, parameters, context, feedback):
        from ..core.localizer import FIX, Localizer
        from .exchange.geopackage import read_database
        from .exchange.rasters import image_files

        feedback.setProgressText(tr("Reading the database"))
        database = read_database(self.parameterAsFile(parameters, self.DATABASE, context))
        crs = QgsCoordinateReferenceSystem.fromWkt(database.parameters.crs)
        if not crs.isValid():
            raise DatabaseError(f"{database.source} has no readable parameter crs; build it again.")
        localizer = Localizer(database)
        paths = image_files(self._paths(parameters, context))
        if not paths:
            raise ParameterError("IMAGES is empty; choose at least one image or a folder with images.")
        localized = []
        for n, path in enumerate(paths):
            check_canceled(feedback)
            feedback.setProgressText(os.path.basename(path))
            localized.append(_localize(path, localizer, database.class_table))
            _say(localized[-1], feedback)
            feedback.setProgress(95 * (n + 1) / len(paths))
        # Sinks are made last: a cancel before leaves nothing behind.
        check_canceled(feedback)
        results = {self.OUTPUT: self._write_positions(parameters, context, localized, crs)}
        footprints = self._write_footprints(parameters, context, localized, database, crs)
        if footprints:
            results[self.FOOTPRINTS] = footprints
        fixes = sum(1 for item in localized if item.result is not None and item.result.status == FIX)
        feedback.pushInfo(tr("{fixes} of {images} images have a fix.").format(fixes=fixes, images=len(localized)))
        results[self.FIX_COUNT] = fixes
        return results

    def _paths(self, parameters, context):
        """Files as a list, one path, or several separated by “;” as text."""
        value = parameters[self.IMAGES]
        if isinstance(value, str) and not os.path.exists(value):
            return [part.strip() for part in value.split(LIST_SEPARATOR) if part.strip()]
        return [path for path in self.parameterAsFileList(parameters, self.IMAGES, context) if path]

    def _write_positions(self, parameters, context, localized, crs):
        from .exchange.reference_systems import longitudes_latitudes

        sink = Sink(self, parameters, self.OUTPUT, context, FIELDS, POINT, crs)
        for item in localized:
            values, geometry = _row(item), None
            if item.result and item.result.position:
                geometry = QgsGeometry.fromPointXY(QgsPointXY(*item.result.position))
                degrees = longitudes_latitudes([item.result.position], crs, context.transformContext())
                values["longitude"], values["latitude"] = (None if isnan(v[0]) else float(v[0]) for v in degrees)
            sink.add(geometry, values)
        return sink.close()

    def _write_footprints(self, parameters, context, localized, database, crs):
        """The destination, None when footprints are not wanted."""
        sink = Sink(self, parameters, self.FOOTPRINTS, context, FOOTPRINT_FIELDS, POLYGON, crs)
        if not sink.is_wanted:
            return None
        names = [name for name, _ in FOOTPRINT_FIELDS]
        for item in localized:
            if item.result is None or item.result.window_index is None:
                continue
            x, y = database.windows.centers[item.result.window_index].tolist()
            half = float(database.windows.sizes[item.result.window_index]) / 2
            square = QgsGeometry.fromRect(QgsRectangle(x - half, y - half, x + half, y + half))
            sink.add(square, {name: value for name, value in _row(item).items() if name in names})
        return sink.close()


def _localize(path, localizer, table) -> LocalizedImage:
    """One bad image must not stop a batch: its sentence becomes its row's reason."""
    from .exchange.rasters import read_label_image

    try:
        return LocalizedImage(path, localizer.localize_by_topology_vector(read_label_image(path, table)))
    except SemRefError as error:
        return LocalizedImage(path, error=str(error))


def _row(item) -> dict:
    """Values of FIELDS by name, without longitude and latitude."""
    result = item.result
    if result is None:
        return {"image": item.path, "status": ERROR, "reason": item.error}
    return {
        "image": item.path,
        "status": result.status,
        "x": result.position and result.position[0],
        "y": result.position and result.position[1],
        "heading": result.heading_deg,
        "pixel_size": result.pixel_size_m,
        "confidence": result.confidence,
        "distance": result.distance,
        "inliers": result.inliers,
        "references": result.references,
        "log_odds": result.log_odds,
        "error_95": result.error_95_m,
        "window": result.window,
        "method": result.method,
        "reason": result.reason,
    }


def _say(item, feedback) -> None:
    name = os.path.basename(item.path)
    if item.result is None:
        feedback.reportError(f"{name}: {item.error}", False)
        return
    result = item.result
    if result.position is None:
        feedback.pushInfo(f"{name}: {result.status}. {result.reason}")
        return
    feedback.pushInfo(
        tr(
            "{name}: window {window}, position {x:.1f} {y:.1f}, distance {distance:.4f}, confidence {confidence:.2f}"
        ).format(
            name=name,
            window=result.window,
            x=result.position[0],
            y=result.position[1],
            distance=result.distance,
            confidence=result.confidence,
        )
    )
