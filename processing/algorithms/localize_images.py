"""semref:localizeimages: compute the positions of images."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from qgis.core import (
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterRasterLayer,
)

from ...core.errors import ParameterError
from ...core.localization import Localization, Status
from ..base import parameters
from ..base.algorithm import Declared, ahead, check_canceled
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.scheduler import SCHEDULER, require_scheduler, scheduler
from ..base.values import Values
from ..compat import SOURCE_POINT, SOURCE_POLYGON
from ..jobs import priors
from ..jobs.image_results import LabelImages, count_sentence, log_result, with_far_photos, with_jumps
from ..jobs.localizing import LocalizeAlgorithm, found_within_reach, localize_image, localize_scheduled, require_images
from ..jobs.photo_labels import pace_results
from ..jobs.photo_source import PhotoSource
from ..layers.localized_image import ERROR, LocalizedImage

if TYPE_CHECKING:
    from ...core.geometry.camera import Camera
    from ...core.localizer.reach import Reach
    from ...core.pipeline import Pipeline


class LocalizeImages(LocalizeAlgorithm):
    ID = "localizeimages"
    TITLE = "Localize images"
    TAGS = ("position", "match", "uav", "drone", "navigation", "gnss", "geolocation", "fix")
    SUMMARY = (
        "Computes the positions of aerial images. The landmarks of each image are matched with a reference "
        "database.\n\nEach image gives one row; without a position it contains the reason. “Automatic” and "
        "“Constellation” verify each position. “Published method” finds only images that are centered on a "
        "window, and does not reject images of other areas."
    )

    ALTERNATIVES = "ALTERNATIVES"
    LAYER = "LAYER"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            parameters.database(),
            *self.image_parameters(optional=True),
            *priors.parameters(),
            self.camera_parameter(),
            self.speed_parameter(),
            with_help(
                QgsProcessingParameterFeatureSink(self.OUTPUT, "Positions", type=SOURCE_POINT),
                "One row for each image with status, position, error probability, 95 % radius and, without a "
                "position, the reason.",
            ),
            self.footprints_parameter(
                "One polygon for each position: the footprint of the image or, for “Published method”, the "
                "matched window."
            ),
            with_help(
                QgsProcessingParameterFeatureSink(
                    self.ALTERNATIVES, "Possible places", type=SOURCE_POLYGON, optional=True, createByDefault=False
                ),
                "Footprints of all places that fit an ambiguous image. The best place has rank 1.",
            ),
            *self.shown_parameters(),
            QgsProcessingOutputNumber(self.FIX_COUNT, "Number of positions"),
            self.risk_parameter(
                "A position is accepted if the probability that it is wrong is not larger than this value, for "
                "example 0.0001 (1 in 10,000). A smaller value gives fewer positions. Above it, up to 0.2, the "
                "result is a likely position. “Published method” does not use it."
            ),
            with_help(
                QgsProcessingParameterRasterLayer(self.LAYER, "Layer to test", optional=True),
                "A raster layer or map tiles. Its extent is localized like an image, at the resolution of the "
                "model (for label colors, at the resolution of the database). Use it to test whether this place "
                "would be found.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterExtent(self.EXTENT, "Extent of the test layer", optional=True),
                "Part of the layer to test. Map tiles need it. If not set, the whole layer is used.",
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterFeatureSource(
                    self.MASK, "Mask of the test layer", types=[SOURCE_POLYGON], optional=True
                ),
                "Polygons that limit the area to test. Pixels outside the polygons get no label. Without an "
                "extent, the extent of the polygons is used.",
                advanced=True,
            ),
            self.sun_parameter(),
            scheduler(),
            *pace_results(),
        )

    def check(self, values: Values) -> None:
        priors.scales(values, self.method(values))
        if not values.has(self.LAYER):
            require_images(values.files(self.IMAGES))
        parts = [key for key in (self.EXTENT, self.MASK) if values.has(key)]
        if parts and not values.has(self.LAYER):
            # They would have no effect, and the result would be mistaken for that of a part.
            raise ParameterError(
                "{keys} are used only with a layer to test. Select the layer, or leave {keys} empty.",
                keys=", ".join(f"“{values.title(key)}”" for key in parts),
            )
        require_scheduler(values, (self.LAYER, self.LABELS))

    def read_layers(self, values: Values) -> None:
        from ..layers.areas import drawn_area

        area = drawn_area(values.source(self.MASK)) if values.has(self.LAYER) else None
        self._layer = PhotoSource(values, self.LAYER, self.EXTENT, area) if values.has(self.LAYER) else None

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...core.geometry.camera import Camera
        from ...core.pipeline import Pipeline
        from ...storage.file_states import state
        from ..jobs.localized_layers import write_footprints, write_matches, write_places, write_positions
        from ..layers.reference_systems import database_crs

        method, path = self.method(values), values.file(self.DATABASE)
        before = {path: state(path)}
        database = self.read_database(values, method, feedback)
        crs = database_crs(database)
        localizer, search = self.make_localizer(values, method, database, crs)
        read_labels = self.label_reader(values, database.class_table, feedback)
        paths, cameras = self.read_images(values, method, feedback, self._layer is None)
        if self._layer is not None:
            size_m = read_labels.resolution_m or database.parameters.pixel_size
            paths, cameras = [*paths, self._layer.file(size_m, feedback)], [*cameras, Camera()]
        is_scheduled = values.has(SCHEDULER)
        with outputs.folder(self.LABELS) as folder:
            pipeline = Pipeline(localizer, search, read_labels)
            if is_scheduled:
                localized = localize_scheduled(values, database, before, search, paths, cameras, feedback)
                for item in localized:
                    log_result(item, feedback)
            else:
                keep = LabelImages(folder, paths, database.class_table, read_labels.stated_biases)
                localized = _in_order(paths, cameras, pipeline, keep, feedback)
            speed = values.optional_number(self.MAXIMUM_SPEED)
            if speed is not None:
                localized = _within_reach(localized, cameras, pipeline, speed, feedback)
            localized = with_far_photos(localized, database, crs, values.transform_context, feedback)
            if speed is not None:
                localized = with_jumps(localized, database.windows, speed, feedback)
            # Layers are written last, so that a cancel leaves nothing behind.
            check_canceled(feedback)
            write_positions(outputs, self.OUTPUT, localized, crs, values.transform_context)
            write_footprints(outputs, self.FOOTPRINTS, localized, crs)
            write_places(outputs, self.ALTERNATIVES, localized, crs)
            write_matches(outputs, self.MATCHES, localized, database, crs)
        statuses = [ERROR if item.result is None else item.result.status for item in localized]
        fixes = statuses.count(Status.FIX)
        feedback.pushInfo(count_sentence(statuses))
        return {self.FIX_COUNT: fixes, **({} if is_scheduled else read_labels.log_pace())}


def _in_order(
    paths: Sequence[str],
    cameras: Sequence[Camera],
    pipeline: Pipeline,
    keep: LabelImages,
    feedback: QgsProcessingFeedback,
) -> list[LocalizedImage]:
    localized: list[LocalizedImage] = []
    feedback.setProgressText(os.path.basename(paths[0]))
    for item, labels_hw in ahead(lambda one: localize_image(one[0], pipeline, one[1]), zip(paths, cameras), feedback):
        if labels_hw is not None:
            keep(item.path, labels_hw)
        log_result(item, feedback)
        localized.append(item)
        feedback.setProgress(95 * len(localized) / len(paths))
        if len(localized) < len(paths):
            feedback.setProgressText(os.path.basename(paths[len(localized)]))
    return localized


def _within_reach(
    localized: Sequence[LocalizedImage],
    cameras: Sequence[Camera],
    pipeline: Pipeline,
    speed: float,
    feedback: QgsProcessingFeedback,
) -> list[LocalizedImage]:
    """Search images without a position within reach of the others; they are read again, which saves memory."""
    from ...core.pipeline import Pipeline

    def search(n: int, reach: Reach) -> Localization | None:
        prior = reach.narrow(pipeline.search.known)
        if prior is None:
            return None
        localizer = pipeline.localizer.with_risk(reach.allowed_risk)
        narrowed = Pipeline(localizer, replace(pipeline.search, known=prior), pipeline.read)
        item, _ = localize_image(localized[n].path, narrowed, cameras[n])
        return item.result

    paths, results = [item.path for item in localized], [item.result for item in localized]
    limits = speed, pipeline.localizer.settings.allowed_risk
    found = found_within_reach(paths, results, [item.time_s for item in localized], limits, search, feedback)
    return [replace(item, result=found.get(n, item.result)) for n, item in enumerate(localized)]
