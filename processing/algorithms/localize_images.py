"""semref:localizeimages – images to positions."""

from __future__ import annotations

import os
from dataclasses import replace
from typing import TYPE_CHECKING, Callable, Union

from ...core.errors import DatabaseError, ParameterError, SemRefError
from ...core.localization import LEAST_RISK, RISK, Method
from ..framework import offers, priors
from ..framework.base import LOCALIZATION, Declared, SemRefAlgorithm, cancelable, check_canceled
from ..framework.declarations import (
    Choice,
    File,
    Files,
    FolderOutput,
    MapExtent,
    Number,
    NumberResult,
    PointOutput,
    PolygonOutput,
    RasterLayer,
)
from ..framework.localized_image import LabelImages, LocalizedImage, say, with_jumps
from ..framework.localized_layers import write_grounds, write_matches, write_positions
from ..framework.photo_source import PhotoSource
from ..translation import tr
from ..wording.camera_messages import camera_remark
from ..wording.sentences import worded

if TYPE_CHECKING:
    import numpy as np
    from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingFeedback

    from ...core.database.model import ReferenceDatabase
    from ...core.geometry.camera import Camera
    from ...core.labels.class_table import ClassTable
    from ...core.localization import Localization
    from ...core.localizer.localizer import Localizer
    from ..framework.outputs import Outputs
    from ..framework.photo_labels import LabelImageReader, PhotoLabels
    from ..framework.values import Values

    LabelReader = Union[PhotoLabels, LabelImageReader]
    Localize = Callable[[np.ndarray, Camera], Localization]


class LocalizeImages(SemRefAlgorithm):
    ID = "localizeimages"
    GROUP = LOCALIZATION
    TAGS = ("position", "match", "uav", "drone", "navigation", "gnss", "geolocation", "fix")

    DATABASE = "DATABASE"
    IMAGES = "IMAGES"
    MODEL = "MODEL"
    METHOD = "METHOD"
    OUTPUT = "OUTPUT"
    ATTITUDE = "ATTITUDE"
    MAXIMUM_SPEED = "MAXIMUM_SPEED"
    FOOTPRINTS = "FOOTPRINTS"
    ALTERNATIVES = "ALTERNATIVES"
    MATCHES = "MATCHES"
    LABELS = "LABELS"
    RISK = "RISK"
    LAYER = "LAYER"
    EXTENT = "EXTENT"
    SUN_DIRECTION = "SUN_DIRECTION"
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

    def parameters(self) -> tuple[Declared, ...]:
        return (
            offers.database(),
            *self._image_parameters(),
            *priors.parameters(),
            *self._flight_parameters(),
            *self._output_parameters(),
            Number(
                self.RISK,
                tr("Allowed risk of a wrong fix"),
                tr(
                    "A place is a fix when the probability that it is wrong is at most this: 0.0001 is once in 10,000 "
                    "fixes. A smaller risk gives fewer fixes. The topology vector, as published, knows no such "
                    "probability."
                ),
                advanced=True,
                default=RISK,
                minimum=LEAST_RISK,
                maximum=0.5,
                decimals=12,
            ),
            *self._layer_parameters(),
            offers.sun_direction(
                tr(
                    "Where the sun stood when the images were taken, in degrees clockwise from grid north: what the "
                    "model states that shadows shift turns with it. Without it such a shift is only added to the error."
                )
            ),
        )

    def _image_parameters(self) -> tuple[Declared, ...]:
        return (
            Files(
                self.IMAGES,
                tr("Images"),
                tr(
                    "Label images, or folders of them: single-band class values, or colors decoded by the database’s "
                    "class table; with a model, photos. They need no georeference."
                ),
                optional=True,
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
        )

    def _layer_parameters(self) -> tuple[Declared, ...]:
        """What is localized instead of images, or with them."""
        return (
            RasterLayer(
                self.LAYER,
                tr("Layer to try"),
                tr(
                    "A raster or a map of tiles, of which the extent is localized as if it were an image, at the "
                    "model’s resolution (label colors: at the database’s): would this place be found?"
                ),
                optional=True,
                advanced=True,
            ),
            MapExtent(
                self.EXTENT,
                tr("Extent of the layer to try"),
                tr("Needed for maps of tiles, else all of the layer."),
                optional=True,
                advanced=True,
            ),
        )

    def _flight_parameters(self) -> tuple[Declared, ...]:
        """How the images were taken."""
        return (
            File(
                self.ATTITUDE,
                tr("Camera table (roll, pitch, focal length, time, height, heading)"),
                tr(
                    "A CSV with the columns image (file name), roll, pitch (degrees; 0 and 0 is straight down, pitch "
                    "above 0 looks towards the image’s top, roll above 0 towards its right), one of focal_length_px, "
                    "focal_length_35mm or field_of_view (degrees across the width), time (seconds, or date and time), "
                    "height (m above the ground) and heading (degrees clockwise from north). Images are leveled before "
                    "they are localized; height and lens together tell how large their pixels are. What the table "
                    "does not tell is taken from EXIF and XMP of the image, or of the photo of the same name beside "
                    "it. The topology vector takes images as they are."
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

    def _output_parameters(self) -> tuple[Declared, ...]:
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
        priors.scales(values, self._method(values))
        if not values.has(self.LAYER) and not values.files(self.IMAGES):
            raise ParameterError("algorithms.no_images")

    def read_layers(self, values: Values) -> None:
        self._layer = PhotoSource(values, self.LAYER, self.EXTENT) if values.has(self.LAYER) else None

    def _method(self, values: Values) -> Method:
        return Method.of_number(values.choice(self.METHOD))

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...core.geometry.camera import Camera
        from ...core.localizer.localizer import Localizer
        from ...core.localizer.settings import LOCALIZER
        from ..exchange.reference_systems import database_crs

        method = self._method(values)
        database = self._database(values, method, feedback)
        crs = database_crs(database)
        settings = replace(LOCALIZER, allowed_risk=values.number(self.RISK))
        localizer = Localizer(database, settings, values.optional_number(self.SUN_DIRECTION))
        localize = self._localizing(values, method, localizer, crs)
        read_labels = self._label_reader(values, database.class_table, feedback)
        paths, cameras = self._images(values, method, feedback)
        if self._layer is not None:
            size_m = getattr(read_labels, "resolution_m", None) or database.parameters.pixel_size
            paths, cameras = [*paths, self._layer.file(size_m, feedback)], [*cameras, Camera()]
        with outputs.folder(self.LABELS) as folder:
            keep = LabelImages(folder, paths, database.class_table, read_labels.stated_biases)
            localized = []
            for n, path in enumerate(paths):
                check_canceled(feedback)
                feedback.setProgressText(os.path.basename(path))
                arguments = path, localizer, localize, read_labels, cameras[n], keep
                localized.append(cancelable(_localize, *arguments, feedback=feedback))
                say(localized[-1], feedback)
                feedback.setProgress(95 * (n + 1) / len(paths))
            speed = values.optional_number(self.MAXIMUM_SPEED)
            if speed is not None:
                times_s = [camera.time_s for camera in cameras]
                localized = with_jumps(localized, times_s, database.windows, speed, feedback)
            # Layers are made last: a cancel before leaves nothing behind.
            check_canceled(feedback)
            write_positions(outputs, self.OUTPUT, localized, crs, values.transform_context)
            write_grounds(outputs, (self.FOOTPRINTS, self.ALTERNATIVES), localized, crs)
            write_matches(outputs, self.MATCHES, localized, database, crs)
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
    ) -> tuple[list[str], list[Camera]]:
        """Paths of the images and how their cameras were held."""
        from ...storage.camera_files import read_cameras
        from ...storage.rasters import image_files

        paths = image_files(values.files(self.IMAGES))
        if not paths and self._layer is None:
            raise ParameterError("algorithms.no_images")
        cameras = cancelable(read_cameras, paths, values.file(self.ATTITUDE), feedback=feedback)
        if method == Method.TOPOLOGY_VECTOR:
            # The published method, exactly: images as they are.
            cameras = [replace(camera, attitude=None, problem=None) for camera in cameras]
        return paths, cameras

    def _localizing(
        self, values: Values, method: Method, localizer: Localizer, crs: QgsCoordinateReferenceSystem
    ) -> Localize:
        """The function (labels, Camera) → Localization that is asked for."""
        from ...core.localizer.leveled import localize_leveled, with_camera
        from ...core.localizer.localizer import default_scales

        localizer.check(method)
        with_matches = values.has(self.MATCHES)
        scales = priors.scales(values, method)
        known = priors.prior(values, crs)

        def localize(labels_hw: np.ndarray, camera: Camera) -> Localization:
            sizes = scales and localizer.pixel_sizes(labels_hw.shape, scales)
            way = camera.leveling(labels_hw.shape)
            prior = with_camera(replace(known, pixel_size_range=sizes), camera, labels_hw.shape)
            if way is not None and prior.pixel_size_range is None:
                # A leveled image has another shape: its pixel sizes are those of the image as it is, for all methods.
                sizes = localizer.pixel_sizes(labels_hw.shape, default_scales(method))
                prior = replace(prior, pixel_size_range=sizes)
            if way is None:
                return localizer.localize(labels_hw, method, prior, with_matches)
            return localize_leveled(localizer, labels_hw, method, prior, way, with_matches)

        return localize

    def _label_reader(self, values: Values, table: ClassTable, feedback: QgsProcessingFeedback) -> LabelReader:
        """The function path → labels: of label images, or with a model of photos."""
        from ..framework.photo_labels import LabelImageReader, PhotoLabels

        model_path = values.file(self.MODEL)
        if model_path:
            feedback.setProgressText(tr("Loading the model"))
            return PhotoLabels(model_path, table, feedback)
        return LabelImageReader(table)


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
    path: str, localizer: Localizer, localize: Localize, read_labels: LabelReader, camera: Camera, keep: LabelImages
) -> LocalizedImage:
    """One bad image must not stop a batch: its sentence becomes its row's reason."""
    try:
        labels_hw, known = read_labels(path), read_labels.biases(path)
        localizer.heed_biases(known.class_biases, known.class_spread)
        found = localize(labels_hw, camera)
        remark = camera_remark(camera, labels_hw.shape)
    except SemRefError as error:
        return LocalizedImage(path, error=worded(error))
    keep(path, labels_hw)
    return LocalizedImage(path, found, "", labels_hw.shape, remark)
