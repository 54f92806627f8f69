"""semref:localizeimages – images to positions."""

from __future__ import annotations

import os
from dataclasses import replace
from math import isnan
from typing import TYPE_CHECKING, Callable, Dict, List, Optional, Sequence, Tuple

from qgis.core import QgsGeometry, QgsPointXY

from ...core.errors import DatabaseError, ParameterError, SemRefError
from ...core.localization import Method, Prior
from ..compat import POINT, POLYGON
from ..framework import offers
from ..framework.base import LOCALIZATION, Declared, SemRefAlgorithm, cancelable, check_canceled
from ..framework.declarations import (
    Choice,
    File,
    Files,
    FolderOutput,
    MapPoint,
    Number,
    NumberResult,
    PointOutput,
    PolygonOutput,
)
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
from ..translation import tr
from ..wording.camera_messages import camera_remark
from ..wording.sentences import worded

if TYPE_CHECKING:
    import numpy as np
    from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingFeedback

    from ...core.database.model import ReferenceDatabase
    from ...core.geometry.leveling import Leveling
    from ...core.labels.class_table import ClassTable
    from ...core.localization import Localization
    from ...core.localizer.localizer import Localizer
    from ...storage.camera_files import Camera
    from ..framework.outputs import Outputs
    from ..framework.values import Values

    LabelReader = Callable[[str], np.ndarray]
    Localize = Callable[[np.ndarray, Optional[Leveling]], Localization]


class LocalizeImages(SemRefAlgorithm):
    ID = "localizeimages"
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

    def title(self) -> str:
        return tr("Localize images")

    def summary(self) -> str:
        return tr(
            "Finds where images were taken: each label image is described by its landmarks and matched with a "
            "reference database.\n\n"
            "Every image gives one point; without a fix it has no geometry and its reason says why. Automatic and the "
            "constellation find images anywhere on the map, at any heading, and verify what they find. The topology "
            "vector method finds images centered on a window and accepts images from elsewhere: check what it finds."
        )

    def parameters(self) -> Tuple[Declared, ...]:
        return (
            offers.database(),
            Files(
                self.IMAGES,
                tr("Images"),
                tr(
                    "Label images, or folders of them: single-band class values, or colors decoded by the database’s "
                    "class table; with a model, photos. They need no georeference."
                ),
            ),
            offers.model(
                tr(
                    "A segmentation network: the images are then photos. Its classes are those of the database by "
                    "name; classes that the database does not have count as unlabeled."
                ),
                optional=True,
            ),
            Choice(
                self.METHOD,
                tr("Method"),
                tr(
                    "Automatic takes the constellation of landmarks and, where that finds no place, map correlation; "
                    "each checks what the other finds. Map correlation compares areas instead of landmarks, for poor "
                    "labels; it takes seconds an image, and so does automatic where the constellation finds no place. "
                    "Topology vector is the published method: the nearest vector of all windows, accepted up to "
                    "distance 2."
                ),
                default=Method.AUTOMATIC.number,
                options=[worded(method.title) for method in Method],
            ),
            *self._prior_parameters(),
            *self._flight_parameters(),
            *self._output_parameters(),
        )

    def _prior_parameters(self) -> Tuple[Declared, ...]:
        """What is known beforehand; never needed."""
        scale = tr(
            "Ground that the shorter edge of an image shows, as a multiple of the database’s window size. "
            "If both are left out: 0.4 to 2.5 for the constellation, 0.7 to 1.4 for map correlation, "
            "also when automatic uses them. A narrow range is searched faster."
        )
        return (
            MapPoint(
                self.PRIOR_POINT,
                tr("Approximate position"),
                tr("Where the images are known to be, roughly. It speeds up the search and is never needed."),
                optional=True,
                advanced=True,
            ),
            Number(
                self.PRIOR_RADIUS,
                tr("Radius around it (map units)"),
                tr("Only with an approximate position: places farther away are not searched."),
                advanced=True,
                default=1000.0,
                minimum=0.01,
            ),
            Number(
                self.PRIOR_HEADING,
                tr("Approximate heading (°)"),
                tr("Where the images’ top points to, roughly, in degrees clockwise from grid north."),
                optional=True,
                advanced=True,
                minimum=-360,
                maximum=360,
            ),
            Number(
                self.PRIOR_HEADING_RANGE,
                tr("Range around it (± °)"),
                tr("Only with an approximate heading: other headings are not searched."),
                advanced=True,
                default=20.0,
                minimum=1,
                maximum=180,
            ),
            *(
                Number(key, title, scale, optional=True, advanced=True, minimum=0.01, maximum=100)
                for key, title in (
                    (self.SCALE_MINIMUM, tr("Smallest scale")),
                    (self.SCALE_MAXIMUM, tr("Largest scale")),
                )
            ),
        )

    def _flight_parameters(self) -> Tuple[Declared, ...]:
        """How the images were taken."""
        return (
            File(
                self.ATTITUDE,
                tr("Camera table (roll, pitch, focal length, time)"),
                tr(
                    "A CSV with the columns image (file name), roll, pitch (degrees; 0 and 0 is straight down, pitch "
                    "above 0 looks towards the image’s top, roll above 0 towards its right), one of focal_length_px, "
                    "focal_length_35mm or field_of_view (degrees across the width), and time (seconds, or date and "
                    "time). Images are leveled before they are localized. What the table does not tell is taken from "
                    "EXIF and XMP of the image, or of the photo of the same name beside it. The topology vector takes "
                    "images as they are."
                ),
                optional=True,
                advanced=True,
                filter=tr("CSV (*.csv *.txt)"),
            ),
            Number(
                self.MAXIMUM_SPEED,
                tr("Maximum speed (map units per second)"),
                tr(
                    "For images of one flight whose times are known: a fix that can’t be reached in time from the "
                    "fixes before and after it is marked as jump, with the reason. It stays a fix and is counted."
                ),
                optional=True,
                advanced=True,
                minimum=0.001,
            ),
        )

    def _output_parameters(self) -> Tuple[Declared, ...]:
        """What is written, and the number that is told."""
        left_out = {"optional": True, "by_default": False}
        return (
            PointOutput(
                self.OUTPUT,
                tr("Positions"),
                tr(
                    "One point an image: status, position, confidence, distance, window and, without a fix, the reason."
                ),
            ),
            PolygonOutput(
                self.FOOTPRINTS,
                tr("Footprints"),
                tr(
                    "One polygon a fix: the ground the image shows, or the matched window of the topology vector "
                    "method."
                ),
                **left_out,
            ),
            PolygonOutput(
                self.ALTERNATIVES,
                tr("Possible places"),
                tr("For ambiguous images: the ground of each place that fits, the best one first."),
                **left_out,
            ),
            PointOutput(
                self.MATCHES,
                tr("Matches"),
                tr(
                    "One point a landmark of the map that agrees with one of an image, for fixes with a heading: where "
                    "the image has it, where the fix puts it, and how far that is off."
                ),
                advanced=True,
                **left_out,
            ),
            FolderOutput(
                self.LABELS,
                tr("Folder for the label images"),
                tr(
                    "A new or empty folder: each image’s labels as they were localized, a GeoTIFF with the class table."
                ),
                advanced=True,
                **left_out,
            ),
            NumberResult(self.FIX_COUNT, tr("Number of fixes")),
        )

    def check(self, values: Values) -> None:
        smallest, largest = self._scales(values) or (0.0, 0.0)
        if smallest > largest:
            raise ParameterError("algorithms.scales", smallest=smallest, largest=largest)

    def _scales(self, values: Values) -> Optional[Tuple[float, float]]:
        """(smallest, largest) as given, the other one by default; None, each method's own, when neither is given."""
        from ...core.localizer.localizer import default_scales

        keys = self.SCALE_MINIMUM, self.SCALE_MAXIMUM
        if not any(values.has(key) for key in keys):
            return None
        smallest, largest = default_scales(Method.of_number(values.choice(self.METHOD)))
        return values.optional_number(keys[0], smallest), values.optional_number(keys[1], largest)

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> Dict[str, int]:
        from ...core.localizer.localizer import Localizer
        from ..exchange.reference_systems import database_crs

        method = Method.of_number(values.choice(self.METHOD))
        database = self._database(values, method, feedback)
        crs = database_crs(database)
        localize = self._localizing(values, method, Localizer(database), crs)
        read_labels = self._label_reader(values, database.class_table, feedback)
        paths, cameras = self._images(values, method, feedback)
        with outputs.folder(self.LABELS) as folder:
            keep = LabelImages(folder, paths, database.class_table)
            localized = []
            for n, path in enumerate(paths):
                check_canceled(feedback)
                feedback.setProgressText(os.path.basename(path))
                arguments = path, localize, read_labels, cameras[n], keep
                localized.append(cancelable(_localize, *arguments, feedback=feedback))
                say(localized[-1], feedback)
                feedback.setProgress(95 * (n + 1) / len(paths))
            speed = values.optional_number(self.MAXIMUM_SPEED)
            if speed is not None:
                times_s = [camera.time_s for camera in cameras]
                localized = with_jumps(localized, times_s, database.windows, speed, feedback)
            # Layers are made last: a cancel before leaves nothing behind.
            check_canceled(feedback)
            self._write_positions(values, outputs, localized, crs)
            self._write_others(outputs, localized, database, crs)
        fixes = sum(1 for item in localized if item.result is not None and item.result.is_fix)
        feedback.pushInfo(tr("{fixes} of {images} images have a fix.").format(fixes=fixes, images=len(localized)))
        return {self.FIX_COUNT: fixes}

    def _database(self, values: Values, method: Method, feedback: QgsProcessingFeedback) -> ReferenceDatabase:
        """The database with what the method needs of it."""
        from ...storage.database.reader import read_database

        feedback.setProgressText(tr("Reading the database"))
        path = values.file(self.DATABASE)
        database = read_database(path, with_overview=method == Method.MAP_CORRELATION)
        return _with_overview(database, path, feedback) if method == Method.AUTOMATIC else database

    def _images(
        self, values: Values, method: Method, feedback: QgsProcessingFeedback
    ) -> Tuple[List[str], List[Camera]]:
        """Paths of the images and how their cameras were held."""
        from ...storage.camera_files import read_cameras
        from ...storage.rasters import image_files

        paths = image_files(values.files(self.IMAGES))
        if not paths:
            raise ParameterError("algorithms.no_images")
        cameras = cancelable(read_cameras, paths, values.file(self.ATTITUDE), feedback=feedback)
        if method == Method.TOPOLOGY_VECTOR:
            # The published method, exactly: images as they are.
            cameras = [replace(camera, attitude=None, problem=None) for camera in cameras]
        return paths, cameras

    def _localizing(
        self, values: Values, method: Method, localizer: Localizer, crs: QgsCoordinateReferenceSystem
    ) -> Localize:
        """The function (labels, Leveling or None) → Localization that is asked for."""
        from ...core.localizer.leveled import localize_leveled
        from ...core.localizer.localizer import default_scales

        localizer.check(method)
        with_matches = values.has(self.MATCHES)
        scales = self._scales(values)
        position = values.point(self.PRIOR_POINT, crs)
        radius = None if position is None else values.number(self.PRIOR_RADIUS)
        heading, heading_range = values.optional_number(self.PRIOR_HEADING), values.number(self.PRIOR_HEADING_RANGE)

        def localize(labels_hw: np.ndarray, way: Optional[Leveling]) -> Localization:
            # A leveled image has another shape: its pixel sizes are those of the image as it is, for all methods.
            ground = scales or (way and default_scales(method))
            sizes = ground and localizer.pixel_sizes(labels_hw.shape, ground)
            prior = Prior(position, radius, heading, heading_range, sizes)
            if way is None:
                return localizer.localize(labels_hw, method, prior, with_matches)
            return localize_leveled(localizer, labels_hw, method, prior, way, with_matches)

        return localize

    def _label_reader(self, values: Values, table: ClassTable, feedback: QgsProcessingFeedback) -> LabelReader:
        """The function path → labels: of label images, or with a model of photos."""
        from ...storage.rasters import read_label_image
        from ..framework.photo_labels import PhotoLabels

        model_path = values.file(self.MODEL)
        if model_path:
            feedback.setProgressText(tr("Loading the model"))
            return PhotoLabels(model_path, table, feedback)
        return lambda path: read_label_image(path, table)

    def _write_positions(
        self,
        values: Values,
        outputs: Outputs,
        localized: Sequence[LocalizedImage],
        crs: QgsCoordinateReferenceSystem,
    ) -> None:
        from ..exchange.reference_systems import longitudes_latitudes

        with outputs.layer(self.OUTPUT, FIELDS, POINT, crs) as sink:
            for item in localized:
                cells, geometry = row(item), None
                if item.result and item.result.position:
                    geometry = QgsGeometry.fromPointXY(QgsPointXY(*item.result.position))
                    degrees = longitudes_latitudes([item.result.position], crs, values.transform_context)
                    cells["longitude"], cells["latitude"] = (None if isnan(v[0]) else float(v[0]) for v in degrees)
                sink.add(geometry, cells)

    def _write_others(
        self,
        outputs: Outputs,
        localized: Sequence[LocalizedImage],
        database: ReferenceDatabase,
        crs: QgsCoordinateReferenceSystem,
    ) -> None:
        """Writes the layers that are wanted beside the positions."""
        polygons = (
            (self.FOOTPRINTS, FOOTPRINT_FIELDS, footprint_rows),
            (self.ALTERNATIVES, ALTERNATIVE_FIELDS, alternatives),
        )
        for key, fields, rows_of in polygons:
            with outputs.layer(key, fields, POLYGON, crs) as sink:
                for item in localized:
                    for ground, cells in rows_of(item):
                        sink.add(_polygon(ground), cells)
        with outputs.layer(self.MATCHES, MATCH_FIELDS, POINT, crs) as sink:
            for item in localized:
                for position, cells in match_rows(item, database):
                    sink.add(QgsGeometry.fromPointXY(QgsPointXY(*position)), cells)


def _polygon(corners_xy: Sequence[Tuple[float, float]]) -> QgsGeometry:
    return QgsGeometry.fromPolygonXY([[QgsPointXY(x, y) for x, y in corners_xy]])


def _with_overview(database: ReferenceDatabase, path: str, feedback: QgsProcessingFeedback) -> ReferenceDatabase:
    """The database with its overview; without one automatic has the constellation alone, and says so."""
    from ...storage.database.connection import DatabaseChangedError
    from ...storage.database.reader import read_overview

    try:
        return replace(database, overview=read_overview(path, database.parameters))
    except DatabaseChangedError:
        raise
    except DatabaseError as error:
        warning = tr("Automatic uses the constellation alone, without map correlation: {reason}").format(
            reason=worded(error)
        )
        feedback.pushWarning(warning)
        return database


def _localize(
    path: str, localize: Localize, read_labels: LabelReader, camera: Camera, keep: LabelImages
) -> LocalizedImage:
    """One bad image must not stop a batch: its sentence becomes its row's reason."""
    try:
        labels_hw = read_labels(path)
        found = localize(labels_hw, camera.leveling(labels_hw.shape))
        remark = camera_remark(camera, labels_hw.shape)
    except SemRefError as error:
        return LocalizedImage(path, error=worded(error))
    keep(path, labels_hw)
    return LocalizedImage(path, found, "", labels_hw.shape, remark)
