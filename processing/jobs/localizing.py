"""What “Localize images” and “Localize flight” share: parameters, reading, and the localization of one image."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Union

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingFeedback,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFile,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
)

from ...core.errors import DatabaseError, ParameterError, SemRefError
from ...core.labels.class_table import ClassTable
from ...core.localization import LEAST_RISK, RISK, Localization, Method
from ..base import parameters
from ..base.algorithm import LOCALIZATION, SemRefAlgorithm, cancelable, check_canceled
from ..base.parameters import with_help
from ..base.scheduler import with_progress, workers
from ..base.values import Values
from ..compat import DOUBLE, SOURCE_FILE, SOURCE_POINT, SOURCE_POLYGON
from ..layers.localized_image import LocalizedImage
from ..messages.camera_messages import camera_read, camera_remark
from ..messages.sentences import worded
from ..translation import tr
from . import priors
from .image_results import has_photos
from .photo_labels import PhotoLabelReader

if TYPE_CHECKING:
    import numpy as np

    from ...core.database.model import ReferenceDatabase
    from ...core.geometry.camera import Camera
    from ...core.localizer.localizer import Localizer
    from ...core.localizer.reach import Reach
    from ...core.localizer.search import Search
    from ...core.pipeline import Pipeline
    from ...storage.label_images import LabelImageReader

    LabelReader = Union[PhotoLabelReader, LabelImageReader]


class LocalizeAlgorithm(SemRefAlgorithm):
    GROUP = LOCALIZATION

    METHOD = "METHOD"
    ATTITUDE = "ATTITUDE"
    MAXIMUM_SPEED = "MAXIMUM_SPEED"
    RISK = "RISK"
    FOOTPRINTS = "FOOTPRINTS"
    MATCHES = "MATCHES"
    FIX_COUNT = "FIX_COUNT"
    SUN_DIRECTION = "SUN_DIRECTION"

    def image_parameters(self, optional: bool) -> tuple[QgsProcessingParameterDefinition, ...]:
        """Return images, model and method; ``optional``: whether the images may be left out."""
        return (
            with_help(
                QgsProcessingParameterMultipleLayers(self.IMAGES, "Images", layerType=SOURCE_FILE, optional=optional),
                "Label images, photos, or folders with such files. Label images have one band of class values, or "
                "colors of the database’s class table. Photos need a model. A georeference is not needed.",
            ),
            parameters.model(
                "Segmentation model for photos. Its classes are matched with the classes of the database by name. "
                "Classes that the database does not have count as unlabeled.",
                optional=True,
            ),
            with_help(
                QgsProcessingParameterEnum(
                    self.METHOD,
                    "Method",
                    options=[worded(method.title) for method in Method],
                    defaultValue=Method.AUTOMATIC.number,
                ),
                "“Automatic” uses the constellation of landmarks first, and map correlation where the "
                "constellation finds no position. Each method checks the other. “Map correlation” compares class "
                "areas and suits poor labels, but needs seconds for each image. “Published method” finds the "
                "nearest topology vector of all windows and accepts distances up to 2.",
            ),
        )

    def risk_parameter(self, text: str) -> QgsProcessingParameterDefinition:
        """Return the maximum error probability of a position."""
        title = tr("Maximum error probability")
        number = QgsProcessingParameterNumber(self.RISK, title, DOUBLE, RISK, minValue=LEAST_RISK, maxValue=0.5)
        return with_help(number, text, advanced=True)

    def sun_parameter(self) -> QgsProcessingParameterDefinition:
        return parameters.sun_direction(
            "Azimuth of the sun when the images were taken, in degrees clockwise from grid north. SemRef turns "
            "the class offset that shadows cause with it. If not set, this offset only increases the 95 % radius."
        )

    def speed_parameter(self) -> QgsProcessingParameterDefinition:
        return with_help(
            QgsProcessingParameterNumber(
                self.MAXIMUM_SPEED, "Maximum speed (m/s)", DOUBLE, optional=True, minValue=0.001
            ),
            "Highest ground speed of the flight, for example 20. Images without a position are searched again on "
            "the ground that the aircraft can reach at this speed from the nearest position in time. Positions "
            "that cannot be reached from the positions before and after are marked as jumps. They still count as "
            "positions. The times of the images must be known.",
            advanced=True,
        )

    def camera_parameter(self) -> QgsProcessingParameterDefinition:
        return with_help(
            QgsProcessingParameterFile(
                self.ATTITUDE, "Camera table", fileFilter=tr("CSV (*.csv *.txt)"), optional=True
            ),
            "CSV file with the column image and any of roll, pitch, heading (degrees), height (m above ground), "
            "time, and focal_length_px, focal_length_35mm or field_of_view. Missing values are read from EXIF and "
            "XMP of the photos. SemRef levels the images to nadir; height and lens give the pixel size. "
            "“Published method” uses the images without leveling.",
            advanced=True,
        )

    def footprints_parameter(self, text: str) -> QgsProcessingParameterDefinition:
        return with_help(
            QgsProcessingParameterFeatureSink(
                self.FOOTPRINTS, "Footprints", type=SOURCE_POLYGON, optional=True, createByDefault=False
            ),
            text,
        )

    def shown_parameters(self) -> tuple[QgsProcessingParameterDefinition, ...]:
        """Return the outputs that show why a position was found: matching landmarks and label images."""
        return (
            with_help(
                QgsProcessingParameterFeatureSink(
                    self.MATCHES, "Matches", type=SOURCE_POINT, optional=True, createByDefault=False
                ),
                "One point for each landmark of the map that matches a landmark of an image: its position in the "
                "image, its position by the computed position of the image, and the residual.",
            ),
            with_help(
                QgsProcessingParameterFolderDestination(
                    self.LABELS, "Folder for label images", optional=True, createByDefault=False
                ),
                "A new or empty folder. The labels of each image are saved as a GeoTIFF with the class table.",
            ),
        )

    def method(self, values: Values) -> Method:
        return list(Method)[values.choice(self.METHOD)]

    def read_database(self, values: Values, method: Method, feedback: QgsProcessingFeedback) -> ReferenceDatabase:
        """Return the database with the parts that the method needs."""
        from ...storage.database.reader import read_database

        feedback.setProgressText(tr("Reading the database"))
        path = values.file(self.DATABASE)
        database = cancelable(read_database, path, method == Method.MAP_CORRELATION, feedback=feedback)
        warning = tr("“Automatic” uses only the constellation of landmarks, not map correlation: {reason}")
        return with_overview(database, path, warning, feedback) if method == Method.AUTOMATIC else database

    def read_images(
        self, values: Values, method: Method, feedback: QgsProcessingFeedback, needed: bool = True
    ) -> tuple[list[str], list[Camera]]:
        """Return the paths of the images and their cameras. Raises ParameterError if images are ``needed`` and there
        are none."""
        from ...core.flight.cameras import read_cameras
        from ...storage.rasters import image_files

        paths = image_files(values.files(self.IMAGES))
        if needed:
            require_images(paths)
        if not values.file(self.MODEL) and has_photos(paths):
            feedback.pushWarning(
                tr("The images are photos, but no model is selected.")
                + " "
                + tr("Their colors are read as class colors.")
            )
        cameras = cancelable(read_cameras, paths, values.file(self.ATTITUDE), feedback=feedback)
        if method == Method.TOPOLOGY_VECTOR:
            # The published method uses images without leveling.
            cameras = [camera.without_leveling() for camera in cameras]
        return paths, cameras

    def make_localizer(
        self, values: Values, method: Method, database: ReferenceDatabase, crs: QgsCoordinateReferenceSystem
    ) -> tuple[Localizer, Search]:
        """Return the localizer and what it searches; ``crs``: the CRS of the database."""
        from ...core.localizer.localizer import Localizer
        from ...core.localizer.search import Search
        from ...core.localizer.settings import LOCALIZER

        settings = replace(LOCALIZER, allowed_risk=values.number(self.RISK))
        localizer = Localizer(database, settings, values.optional_number(self.SUN_DIRECTION))
        prior, scales = priors.prior(values, crs), priors.scales(values, method)
        localizer.check(method, prior)
        return localizer, Search(method, prior, scales, values.has(self.MATCHES))

    def label_reader(self, values: Values, table: ClassTable, feedback: QgsProcessingFeedback) -> LabelReader:
        """Return the reader of label images or, with a model, of photos."""
        from ...storage.label_images import LabelImageReader

        model_path = values.file(self.MODEL)
        if model_path:
            feedback.setProgressText(tr("Loading the model"))
            return PhotoLabelReader(model_path, table, feedback)
        return LabelImageReader(table)


def require_images(paths: Sequence[str]) -> None:
    if not paths:
        raise ParameterError("“Images” is empty. Select at least one image or a folder with images.")


def with_overview(
    database: ReferenceDatabase, path: str, warning: str, feedback: QgsProcessingFeedback
) -> ReferenceDatabase:
    """Return the database with its overview; without one, log a warning, which may contain {reason}."""
    from ...storage.database.connection import DatabaseChangedError
    from ...storage.database.reader import read_overview

    try:
        return replace(database, overview=cancelable(read_overview, path, database.parameters, feedback=feedback))
    except DatabaseChangedError:
        raise
    except DatabaseError as error:
        feedback.pushWarning(warning.format(reason=worded(error)))
        return database


def localize_image(path: str, pipeline: Pipeline, camera: Camera) -> tuple[LocalizedImage, np.ndarray | None]:
    """Localize an image; return its row and (H, W) labels, None for an image that can't be read.

    An error of one image must not stop the others: it becomes the reason of its row.
    """
    try:
        result = pipeline.run(path, camera)
        return _localized(path, result.localization, camera, result.shape_hw), result.labels_hw
    except SemRefError as error:
        return LocalizedImage(path, error=worded(error), time_s=camera.time_s), None


def found_within_reach(
    paths: Sequence[str],
    results: Sequence[Localization | None],
    times_s: Sequence[float | None],
    limits: tuple[float, float],
    search: Callable[[int, Reach], Localization | None],
    feedback: QgsProcessingFeedback,
) -> dict[int, Localization]:
    """Search images without a position on the ground within reach of others, and log what is found.

    Args:
        limits: Maximum speed, map units per second, and maximum error probability.
        search: As in ``search_within_reach``; can be canceled.
    """
    from ...core.localizer.reach import search_within_reach

    def asked(n: int, reach: Reach) -> Localization | None:
        check_canceled(feedback)
        feedback.setProgressText(os.path.basename(paths[n]))
        found = cancelable(search, n, reach, feedback=feedback)
        if found is not None and found.is_fix:
            text = tr("{image}: found within {radius:.0f} m of {other}.")
            names = {"image": os.path.basename(paths[n]), "other": os.path.basename(paths[reach.start])}
            feedback.pushInfo(text.format(radius=reach.radius, **names))
        return found

    return search_within_reach(results, times_s, *limits, asked)


def _localized(path: str, found: Localization, camera: Camera, shape_hw: tuple[int, int]) -> LocalizedImage:
    remark, read = camera_remark(camera, shape_hw), camera_read(camera, shape_hw)
    return LocalizedImage(path, found, "", shape_hw, remark, camera=read, time_s=camera.time_s)


def localize_scheduled(
    values: Values,
    database: ReferenceDatabase,
    before: dict[str, tuple[int, float]],
    search: Search,
    paths: Sequence[str],
    cameras: Sequence[Camera],
    feedback: QgsProcessingFeedback,
) -> list[LocalizedImage]:
    """Localize images with the workers of SCHEDULER; ``before``: state of the database's file."""
    from ...cluster.task_names import IMAGES
    from ...core.localizer.search import AskedImage, ImagesJob
    from ..layers.layer_inputs import stated_pixel_size_m

    model, sun = values.file(LocalizeAlgorithm.MODEL), values.optional_number(LocalizeAlgorithm.SUN_DIRECTION)
    risk = values.number(LocalizeAlgorithm.RISK)
    job = ImagesJob(database.source, database.overview is not None, model, risk, sun, search)
    asked = []
    for path, camera in zip(paths, cameras):
        size = cancelable(stated_pixel_size_m, path, feedback=feedback) if model else None
        asked.append(AskedImage(path, camera, size))
    localized = []
    with workers(values, feedback, before) as run:
        answers = run.answers(IMAGES, job, asked, database)
        for image, found in zip(asked, with_progress(answers, len(asked), feedback, 0, 100)):
            if found.result is None:
                localized.append(LocalizedImage(image.path, error=worded(found.fault), time_s=image.camera.time_s))
            else:
                localized.append(_localized(image.path, found.result, image.camera, found.shape_hw))
    return localized
