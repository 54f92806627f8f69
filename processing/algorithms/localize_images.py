"""semref:localizeimages – images to positions."""

from __future__ import annotations

import os
from dataclasses import replace
from math import isnan

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingOutputNumber,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFile,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterPoint,
)

from ...core.errors import DatabaseError, ParameterError, SemRefError
from ...core.labels.class_table import LIST_SEPARATOR
from ...core.localization import Method, Prior
from ..compat import POINT, POLYGON, SOURCE_FILE, SOURCE_POINT, SOURCE_POLYGON
from ..framework.base import LOCALIZATION, SemRefAlgorithm, cancelable, check_canceled
from ..framework.localized_image import (
    ALTERNATIVE_FIELDS,
    FIELDS,
    FOOTPRINT_FIELDS,
    MATCH_FIELDS,
    LabelImages,
    LocalizedImage,
    alternatives,
    footprint_rows,
    match_rows,
    row,
    say,
    with_jumps,
)
from ..framework.sinks import Sink
from ..translation import tr
from ..wording.camera_messages import camera_remark
from ..wording.sentences import worded


class LocalizeImages(SemRefAlgorithm):
    ID = "localizeimages"
    BY_VALUES = False
    GROUP = LOCALIZATION
    TAGS = ("position", "match", "uav", "drone", "navigation", "gnss", "geolocation", "fix")

    DATABASE = "DATABASE"
    IMAGES = "IMAGES"
    MODEL = "MODEL"
    METHOD = "METHOD"
    OUTPUT = "OUTPUT"
    PRIOR_POINT = "PRIOR_POINT"
    PRIOR_RADIUS = "PRIOR_RADIUS"
    SCALE_MINIMUM = "SCALE_MINIMUM"
    SCALE_MAXIMUM = "SCALE_MAXIMUM"
    PRIOR_HEADING = "PRIOR_HEADING"
    PRIOR_HEADING_RANGE = "PRIOR_HEADING_RANGE"
    ATTITUDE = "ATTITUDE"
    MAXIMUM_SPEED = "MAXIMUM_SPEED"
    FOOTPRINTS = "FOOTPRINTS"
    ALTERNATIVES = "ALTERNATIVES"
    MATCHES = "MATCHES"
    LABELS = "LABELS"
    FIX_COUNT = "FIX_COUNT"

    def title(self):
        return tr("Localize images")

    def summary(self):
        return tr(
            "Finds where images were taken: each label image is described by its landmarks and matched with a "
            "reference database.\n\n"
            "Every image gives one point; without a fix it has no geometry and its reason says why. Automatic and the "
            "constellation find images anywhere on the map, at any heading, and verify what they find. The topology "
            "vector method finds images centered on a window and accepts images from elsewhere: check what it finds."
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
                "table; with a model, photos. They need no georeference."
            ),
        )
        self.offer(
            QgsProcessingParameterFile(self.MODEL, tr("Model"), fileFilter=tr("ONNX models (*.onnx)"), optional=True),
            tr(
                "A segmentation network: the images are then photos. Its classes are those of the database by name; "
                "classes that the database does not have count as unlabeled."
            ),
        )
        self.offer(
            QgsProcessingParameterEnum(
                self.METHOD,
                tr("Method"),
                [tr("Automatic"), tr("Topology vector (He & Wu 2025)"), tr("Constellation"), tr("Map correlation")],
                defaultValue=Method.AUTOMATIC.number,
            ),
            tr(
                "Automatic takes the constellation of landmarks and, where that finds no place, map correlation; each "
                "checks what the other finds. Map correlation compares areas instead of landmarks, for poor labels; it "
                "takes seconds an image, and so does automatic where the constellation finds no place. Topology vector "
                "is the published method: the nearest vector of all windows, accepted up to distance 2."
            ),
        )
        self.offer(
            QgsProcessingParameterPoint(self.PRIOR_POINT, tr("Approximate position"), optional=True),
            tr("Where the images are known to be, roughly. It speeds up the search and is never needed."),
            advanced=True,
        )
        number = QgsProcessingParameterNumber
        self.offer(
            number(self.PRIOR_RADIUS, tr("Radius around it (map units)"), number.Double, 1000.0, minValue=0.01),
            tr("Only with an approximate position: places farther away are not searched."),
            advanced=True,
        )
        self.offer(
            number(self.PRIOR_HEADING, tr("Approximate heading (°)"), number.Double, None, True, -360, 360),
            tr("Where the images’ top points to, roughly, in degrees clockwise from grid north."),
            advanced=True,
        )
        self.offer(
            number(self.PRIOR_HEADING_RANGE, tr("Range around it (± °)"), number.Double, 20.0, False, 1, 180),
            tr("Only with an approximate heading: other headings are not searched."),
            advanced=True,
        )
        for key, title in ((self.SCALE_MINIMUM, tr("Smallest scale")), (self.SCALE_MAXIMUM, tr("Largest scale"))):
            self.offer(
                number(key, title, number.Double, None, optional=True, minValue=0.01, maxValue=100),
                tr(
                    "Ground that the shorter edge of an image shows, as a multiple of the database’s window size. "
                    "If both are left out: 0.4 to 2.5 for the constellation, 0.7 to 1.4 for map correlation, "
                    "also when automatic uses them. A narrow range is searched faster."
                ),
                advanced=True,
            )
        self.offer(
            QgsProcessingParameterFile(
                self.ATTITUDE,
                tr("Camera table (roll, pitch, focal length, time)"),
                optional=True,
                fileFilter=tr("CSV (*.csv *.txt)"),
            ),
            tr(
                "A CSV with the columns image (file name), roll, pitch (degrees; 0 and 0 is straight down, pitch above "
                "0 looks towards the image’s top, roll above 0 towards its right), one of focal_length_px, "
                "focal_length_35mm or field_of_view (degrees across the width), and time (seconds, or date and time). "
                "Images are leveled before they are localized. What the table does not tell is taken from EXIF and XMP "
                "of the image, or of the photo of the same name beside it. The topology vector takes images as they "
                "are."
            ),
            advanced=True,
        )
        self.offer(
            number(self.MAXIMUM_SPEED, tr("Maximum speed (map units per second)"), number.Double, None, True, 0.001),
            tr(
                "For images of one flight whose times are known: a fix that can’t be reached in time from the fixes "
                "before and after it is marked as jump, with the reason. It stays a fix and is counted."
            ),
            advanced=True,
        )
        self.offer(
            QgsProcessingParameterFeatureSink(self.OUTPUT, tr("Positions"), SOURCE_POINT),
            tr("One point an image: status, position, confidence, distance, window and, without a fix, the reason."),
        )
        self.offer(
            QgsProcessingParameterFeatureSink(
                self.FOOTPRINTS, tr("Footprints"), SOURCE_POLYGON, optional=True, createByDefault=False
            ),
            tr("One polygon a fix: the ground the image shows, or the matched window of the topology vector method."),
        )
        self.offer(
            QgsProcessingParameterFeatureSink(
                self.ALTERNATIVES, tr("Possible places"), SOURCE_POLYGON, optional=True, createByDefault=False
            ),
            tr("For ambiguous images: the ground of each place that fits, the best one first."),
        )
        self.offer(
            QgsProcessingParameterFeatureSink(
                self.MATCHES, tr("Matches"), SOURCE_POINT, optional=True, createByDefault=False
            ),
            tr(
                "One point a landmark of the map that agrees with one of an image, for fixes with a heading: where the "
                "image has it, where the fix puts it, and how far that is off."
            ),
            advanced=True,
        )
        self.offer(
            QgsProcessingParameterFolderDestination(
                self.LABELS, tr("Folder for the label images"), optional=True, createByDefault=False
            ),
            tr("A new or empty folder: each image’s labels as they were localized, a GeoTIFF with the class table."),
            advanced=True,
        )
        self.addOutput(QgsProcessingOutputNumber(self.FIX_COUNT, tr("Number of fixes")))

    def checkParameterValues(self, parameters, context):
        possible, reason = super().checkParameterValues(parameters, context)
        if not possible:
            return False, reason
        smallest, largest = self._scales(parameters, context) or (0.0, 0.0)
        if smallest > largest:
            return False, tr(
                "The smallest scale ({smallest:g}) is above the largest ({largest:g}); give both, the smaller first."
            ).format(smallest=smallest, largest=largest)
        return True, ""

    def _scales(self, parameters, context):
        """(smallest, largest) as given, the other one by default; None, each method's own, when neither is given."""
        from ...core.localizer.localizer import default_scales

        keys = (self.SCALE_MINIMUM, self.SCALE_MAXIMUM)
        if all(parameters.get(key) in (None, "") for key in keys):
            return None
        defaults = default_scales(Method.of_number(self.parameterAsEnum(parameters, self.METHOD, context)))
        return tuple(
            default if parameters.get(key) in (None, "") else self.parameterAsDouble(parameters, key, context)
            for key, default in zip(keys, defaults)
        )

    def work(self, parameters, context, feedback):
        from ...core.localizer.localizer import Localizer
        from ...storage.camera_files import read_cameras
        from ...storage.database.reader import read_database
        from ...storage.rasters import image_files

        feedback.setProgressText(tr("Reading the database"))
        method = Method.of_number(self.parameterAsEnum(parameters, self.METHOD, context))
        path = self.parameterAsFile(parameters, self.DATABASE, context)
        database = read_database(path, with_overview=method == Method.MAP_CORRELATION)
        if method == Method.AUTOMATIC:
            database = _with_overview(database, path, feedback)
        crs = QgsCoordinateReferenceSystem.fromWkt(database.parameters.crs)
        if not crs.isValid():
            raise DatabaseError(f"{database.source} has no readable parameter crs; build it again.")
        localize = self._localizing(parameters, context, method, Localizer(database), crs)
        read_labels = self._label_reader(parameters, context, database.class_table, feedback)
        paths = image_files(self._paths(parameters, context))
        if not paths:
            raise ParameterError("IMAGES is empty; choose at least one image or a folder with images.")
        table = self.parameterAsFile(parameters, self.ATTITUDE, context)
        cameras = cancelable(read_cameras, paths, table, feedback=feedback)
        if method == Method.TOPOLOGY_VECTOR:
            # The published method, exactly: images as they are.
            cameras = [replace(camera, attitude=None, problem=None) for camera in cameras]
        folder = self.parameterAsString(parameters, self.LABELS, context)
        with LabelImages.written_to(folder, paths, database.class_table) as keep:
            localized = []
            for n, path in enumerate(paths):
                check_canceled(feedback)
                feedback.setProgressText(os.path.basename(path))
                arguments = path, localize, read_labels, cameras[n], keep
                localized.append(cancelable(_localize, *arguments, feedback=feedback))
                say(localized[-1], feedback)
                feedback.setProgress(95 * (n + 1) / len(paths))
            if parameters.get(self.MAXIMUM_SPEED) not in (None, ""):
                speed = self.parameterAsDouble(parameters, self.MAXIMUM_SPEED, context)
                times_s = [camera.time_s for camera in cameras]
                localized = with_jumps(localized, times_s, database.windows, speed, feedback)
            # Sinks are made last: a cancel before leaves nothing behind.
            check_canceled(feedback)
            results = self._write(parameters, context, localized, database, crs)
        if folder:
            results[self.LABELS] = folder
        fixes = sum(1 for item in localized if item.result is not None and item.result.is_fix)
        feedback.pushInfo(tr("{fixes} of {images} images have a fix.").format(fixes=fixes, images=len(localized)))
        results[self.FIX_COUNT] = fixes
        return results

    def _write(self, parameters, context, localized, database, crs):
        """Writes the layers that are wanted; their destinations by key."""
        results = {self.OUTPUT: self._write_positions(parameters, context, localized, crs)}
        polygons = (
            (self.FOOTPRINTS, FOOTPRINT_FIELDS, footprint_rows),
            (self.ALTERNATIVES, ALTERNATIVE_FIELDS, alternatives),
        )
        for key, fields, rows_of in polygons:
            sink = Sink(self, parameters, key, context, fields, POLYGON, crs)
            if sink.is_wanted:
                for item in localized:
                    for ground, values in rows_of(item):
                        sink.add(_polygon(ground), values)
                results[key] = sink.close()
        sink = Sink(self, parameters, self.MATCHES, context, MATCH_FIELDS, POINT, crs)
        if sink.is_wanted:
            for item in localized:
                for position, values in match_rows(item, database):
                    sink.add(QgsGeometry.fromPointXY(QgsPointXY(*position)), values)
            results[self.MATCHES] = sink.close()
        return results

    def _localizing(self, parameters, context, method, localizer, crs):
        """The function (labels, Leveling or None) → Localization that is asked for."""
        from ...core.localizer.leveled import localize_leveled
        from ...core.localizer.localizer import default_scales

        localizer.check(method)
        with_matches = parameters.get(self.MATCHES) not in (None, "")
        scales = self._scales(parameters, context)
        position = radius = None
        if parameters.get(self.PRIOR_POINT) not in (None, ""):
            point = self.parameterAsPoint(parameters, self.PRIOR_POINT, context, crs)
            position, radius = (point.x(), point.y()), self.parameterAsDouble(parameters, self.PRIOR_RADIUS, context)
        heading, heading_range = None, self.parameterAsDouble(parameters, self.PRIOR_HEADING_RANGE, context)
        if parameters.get(self.PRIOR_HEADING) not in (None, ""):
            heading = self.parameterAsDouble(parameters, self.PRIOR_HEADING, context)

        def localize(labels_hw, way):
            # A leveled image has another shape: its pixel sizes are those of the image as it is, for all methods.
            ground = scales or (way and default_scales(method))
            sizes = ground and localizer.pixel_sizes(labels_hw.shape, ground)
            prior = Prior(position, radius, heading, heading_range, sizes)
            if way is None:
                return localizer.localize(labels_hw, method, prior, with_matches)
            return localize_leveled(localizer, labels_hw, method, prior, way, with_matches)

        return localize

    def _label_reader(self, parameters, context, table, feedback):
        """The function path → labels: of label images, or with a model of photos."""
        from ...storage.rasters import read_label_image
        from ..framework.photo_labels import PhotoLabels

        model_path = self.parameterAsFile(parameters, self.MODEL, context)
        if model_path:
            feedback.setProgressText(tr("Loading the model"))
            return PhotoLabels(model_path, table, feedback)
        return lambda path: read_label_image(path, table)

    def _paths(self, parameters, context):
        """Files as a list, one path, or several separated by “;” as text."""
        value = parameters[self.IMAGES]
        if isinstance(value, str) and not os.path.exists(value):
            return [part.strip() for part in value.split(LIST_SEPARATOR) if part.strip()]
        return [path for path in self.parameterAsFileList(parameters, self.IMAGES, context) if path]

    def _write_positions(self, parameters, context, localized, crs):
        from ..exchange.reference_systems import longitudes_latitudes

        sink = Sink(self, parameters, self.OUTPUT, context, FIELDS, POINT, crs)
        for item in localized:
            values, geometry = row(item), None
            if item.result and item.result.position:
                geometry = QgsGeometry.fromPointXY(QgsPointXY(*item.result.position))
                degrees = longitudes_latitudes([item.result.position], crs, context.transformContext())
                values["longitude"], values["latitude"] = (None if isnan(v[0]) else float(v[0]) for v in degrees)
            sink.add(geometry, values)
        return sink.close()


def _polygon(corners_xy) -> QgsGeometry:
    return QgsGeometry.fromPolygonXY([[QgsPointXY(x, y) for x, y in corners_xy]])


def _with_overview(database, path, feedback):
    """The database with its overview; without one automatic has the constellation alone, and says so."""
    from ...storage.database.reader import read_overview

    try:
        return replace(database, overview=read_overview(path))
    except DatabaseError as error:
        warning = tr("Automatic uses the constellation alone, without map correlation: {reason}").format(reason=error)
        feedback.pushWarning(warning)
        return database


def _localize(path, localize, read_labels, camera, keep) -> LocalizedImage:
    """One bad image must not stop a batch: its sentence becomes its row's reason."""
    try:
        labels_hw = read_labels(path)
        found = localize(labels_hw, camera.leveling(labels_hw.shape))
        remark = camera_remark(camera, labels_hw.shape)
    except SemRefError as error:
        return LocalizedImage(path, error=worded(error))
    keep(path, labels_hw)
    return LocalizedImage(path, found, "", labels_hw.shape, remark)
