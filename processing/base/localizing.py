"""What localizing images and localizing flights share: parameters, reading database, images and cameras, one image."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Union

from qgis.core import (
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFile,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
)

from ...core.errors import DatabaseError, ParameterError, SemRefError
from ...core.localization import LEAST_RISK, RISK, Method
from ..compat import DOUBLE, SOURCE_FILE, SOURCE_POINT, SOURCE_POLYGON
from ..messages.camera_messages import camera_read, camera_remark
from ..messages.sentences import worded
from ..translation import tr
from . import parameters, priors
from .algorithm import LOCALIZATION, SemRefAlgorithm, cancelable
from .localized_image import LabelImages, LocalizedImage, is_photo
from .parameters import with_help
from .scheduler import with_progress, workers

if TYPE_CHECKING:
    from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingFeedback

    from ...core.database.model import ReferenceDatabase
    from ...core.geometry.camera import Camera
    from ...core.labels.class_table import ClassTable
    from ...core.localization import Localization
    from ...core.localizer.search import Search
    from ...core.pipeline import Pipeline
    from ...storage.label_images import LabelImageReader
    from .photo_labels import PhotoLabelReader
    from .values import Values

    LabelReader = Union[PhotoLabelReader, LabelImageReader]


class LocalizeAlgorithm(SemRefAlgorithm):
    """An algorithm that localizes images in a database."""

    GROUP = LOCALIZATION

    DATABASE = parameters.DATABASE
    IMAGES = parameters.IMAGES
    MODEL = parameters.MODEL
    METHOD = "METHOD"
    ATTITUDE = "ATTITUDE"
    MAXIMUM_SPEED = "MAXIMUM_SPEED"
    RISK = "RISK"
    OUTPUT = "OUTPUT"
    FOOTPRINTS = "FOOTPRINTS"
    MATCHES = "MATCHES"
    LABELS = "LABELS"
    FIX_COUNT = "FIX_COUNT"
    SUN_DIRECTION = "SUN_DIRECTION"

    def image_parameters(self, optional: bool) -> tuple[QgsProcessingParameterDefinition, ...]:
        """The images, what reads them if they are photos, and how; ``optional``: whether the images may be left out."""
        return (
            with_help(
                QgsProcessingParameterMultipleLayers(
                    self.IMAGES, tr("Images"), layerType=SOURCE_FILE, optional=optional
                ),
                tr(
                    "Label images, or folders of them: single-band class values, or colors decoded by the database’s "
                    "class table; with a model, photos. They need no georeference."
                ),
            ),
            parameters.model(
                tr(
                    "A segmentation network: the images are then photos. Its classes are those of the database by "
                    "name; classes that the database does not have count as unlabeled."
                ),
                optional=True,
            ),
            with_help(
                QgsProcessingParameterEnum(
                    self.METHOD,
                    tr("Method"),
                    options=[worded(method.title) for method in Method],
                    defaultValue=Method.AUTOMATIC.number,
                ),
                tr(
                    "Automatic takes the constellation of landmarks and, where that finds no place, map correlation; "
                    "each checks what the other finds. Map correlation compares areas instead of landmarks, for poor "
                    "labels; it takes seconds an image, and so does automatic where the constellation finds no place. "
                    "Topology vector is the published method: the nearest vector of all windows, accepted up to "
                    "distance 2."
                ),
            ),
        )

    def risk_parameter(self, title: str, text: str) -> QgsProcessingParameterDefinition:
        """How rarely what is told may be wrong."""
        risk = QgsProcessingParameterNumber(
            self.RISK, title, type=DOUBLE, defaultValue=RISK, minValue=LEAST_RISK, maxValue=0.5
        )
        risk.setMetadata({"widget_wrapper": {"decimals": 12}})
        return with_help(risk, text, advanced=True)

    def sun_parameter(self) -> QgsProcessingParameterDefinition:
        """Where the sun stood."""
        return parameters.sun_direction(
            tr(
                "Where the sun stood when the images were taken, in degrees clockwise from grid north: what the "
                "model states that shadows shift turns with it. Without it such a shift is only added to the error."
            )
        )

    def speed_parameter(self) -> QgsProcessingParameterDefinition:
        return with_help(
            QgsProcessingParameterNumber(
                self.MAXIMUM_SPEED, tr("Maximum speed (m/s)"), type=DOUBLE, optional=True, minValue=0.001
            ),
            tr(
                "Highest ground speed of the flight, for example 20. A position that cannot be reached in time from "
                "the positions before and after it is marked as a jump. It is still counted. Needs the times of the "
                "images."
            ),
            advanced=True,
        )

    def camera_parameter(self) -> QgsProcessingParameterDefinition:
        """How the cameras were held, and when."""
        return with_help(
            QgsProcessingParameterFile(
                self.ATTITUDE,
                tr("Camera table (roll, pitch, focal length, time, height, heading)"),
                fileFilter=tr("CSV (*.csv *.txt)"),
                optional=True,
            ),
            tr(
                "A CSV with the columns image (file name), roll, pitch (degrees; 0 and 0 is straight down, pitch "
                "above 0 looks towards the image’s top, roll above 0 towards its right), one of focal_length_px, "
                "focal_length_35mm or field_of_view (degrees across the width), time (seconds, or date and time), "
                "height (m above the ground) and heading (degrees clockwise from north). Images are leveled before "
                "they are localized; height and lens together tell how large their pixels are. What the table "
                "does not tell is taken from EXIF and XMP of the image, or of the photo of the same name beside "
                "it. The topology vector takes images as they are."
            ),
            advanced=True,
        )

    def footprints_parameter(self, text: str) -> QgsProcessingParameterDefinition:
        """The ground that images show."""
        return with_help(
            QgsProcessingParameterFeatureSink(
                self.FOOTPRINTS, tr("Footprints"), type=SOURCE_POLYGON, optional=True, createByDefault=False
            ),
            text,
        )

    def shown_parameters(self) -> tuple[QgsProcessingParameterDefinition, ...]:
        """What shows why a fix is one: landmarks that agree, and the labels."""
        return (
            with_help(
                QgsProcessingParameterFeatureSink(
                    self.MATCHES, tr("Matches"), type=SOURCE_POINT, optional=True, createByDefault=False
                ),
                tr(
                    "One point a landmark of the map that agrees with one of an image, for fixes with a heading: where "
                    "the image has it, where the fix puts it, and how far that is off."
                ),
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterFolderDestination(
                    self.LABELS, tr("Folder for the label images"), optional=True, createByDefault=False
                ),
                tr(
                    "A new or empty folder: each image’s labels as they were localized, a GeoTIFF with the class table."
                ),
                advanced=True,
            ),
        )

    def method(self, values: Values) -> Method:
        """The road to fixes that is asked for."""
        return Method.of_number(values.choice(self.METHOD))

    def read_database(self, values: Values, method: Method, feedback: QgsProcessingFeedback) -> ReferenceDatabase:
        """The database with what the method needs of it."""
        from ...storage.database.reader import read_database

        feedback.setProgressText(tr("Reading the database"))
        path = values.file(self.DATABASE)
        database = read_database(path, with_overview=method == Method.MAP_CORRELATION)
        return _with_overview(database, path, feedback) if method == Method.AUTOMATIC else database

    def read_images(
        self, values: Values, method: Method, feedback: QgsProcessingFeedback, needed: bool = True
    ) -> tuple[list[str], list[Camera]]:
        """Paths of the images and how their cameras were held. Raises ParameterError for none that are ``needed``."""
        from ...core.flight.cameras import read_cameras
        from ...storage.rasters import image_files

        paths = image_files(values.files(self.IMAGES))
        if needed and not paths:
            raise ParameterError("IMAGES is empty; choose at least one image, a folder with images, or a LAYER.")
        if not values.file(self.MODEL) and any(map(is_photo, paths)):
            feedback.pushWarning(
                tr("These are photos: choose a model.") + " " + tr("Otherwise colors are taken for classes.")
            )
        cameras = cancelable(read_cameras, paths, values.file(self.ATTITUDE), feedback=feedback)
        if method == Method.TOPOLOGY_VECTOR:
            # The published method, exactly: images as they are.
            cameras = [camera.without_leveling() for camera in cameras]
        return paths, cameras

    def search(
        self, values: Values, method: Method, crs: QgsCoordinateReferenceSystem, with_matches: bool = False
    ) -> Search:
        """How images are looked for; points are taken to ``crs``, the database's."""
        from ...core.localizer.search import Search

        return Search(method, priors.prior(values, crs), priors.scales(values, method), with_matches)

    def label_reader(self, values: Values, table: ClassTable, feedback: QgsProcessingFeedback) -> LabelReader:
        """What reads label images, or with a model photos."""
        from ...storage.label_images import LabelImageReader
        from .photo_labels import PhotoLabelReader

        model_path = values.file(self.MODEL)
        if model_path:
            feedback.setProgressText(tr("Loading the model"))
            return PhotoLabelReader(model_path, table, feedback)
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


def localize_image(path: str, pipeline: Pipeline, camera: Camera, keep: LabelImages) -> LocalizedImage:
    """One bad image must not stop a batch: its sentence becomes its row's reason."""
    try:
        result = pipeline.run(path, camera)
        item = _localized(path, result.localization, camera, result.shape_hw)
    except SemRefError as error:
        return LocalizedImage(path, error=worded(error))
    keep(path, result.labels_hw)
    return item


def _localized(path: str, found: Localization, camera: Camera, shape_hw: tuple[int, int]) -> LocalizedImage:
    remark, read = camera_remark(camera, shape_hw), camera_read(camera, shape_hw)
    return LocalizedImage(path, found, "", shape_hw, remark, camera=read)


def localize_scheduled(
    values: Values,
    database: ReferenceDatabase,
    before: dict[str, tuple[int, float]],
    search: Search,
    paths: Sequence[str],
    cameras: Sequence[Camera],
    feedback: QgsProcessingFeedback,
) -> list[LocalizedImage]:
    """The images, localized by the workers of SCHEDULER; ``before``: state of the database's file."""
    from ...cluster.task_names import IMAGES
    from ...core.localizer.search import AskedImage, ImagesJob
    from ..layers.images import stated_pixel_size_m

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
                localized.append(LocalizedImage(image.path, error=worded(found.fault)))
            else:
                localized.append(_localized(image.path, found.result, image.camera, found.shape_hw))
    return localized
