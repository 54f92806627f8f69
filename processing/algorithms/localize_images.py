"""semref:localizeimages – images to positions."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from qgis.core import (
    QgsProcessingOutputNumber,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterRasterLayer,
)

from ...core.errors import ParameterError
from ..base import parameters, priors
from ..base.algorithm import Declared, cancelable, check_canceled
from ..base.localized_image import LabelImages, LocalizedImage, log_result, with_far_photos, with_jumps
from ..base.localized_layers import write_grounds, write_matches, write_positions
from ..base.localizing import LocalizeAlgorithm, localize_image, localize_scheduled
from ..base.parameters import with_help
from ..base.photo_labels import pace_results
from ..base.photo_source import PhotoSource
from ..base.scheduler import SCHEDULER, require_scheduler, scheduler
from ..compat import SOURCE_POINT, SOURCE_POLYGON
from ..translation import tr

if TYPE_CHECKING:
    from qgis.core import QgsProcessingFeedback

    from ...core.geometry.camera import Camera
    from ...core.pipeline import Pipeline
    from ..base.outputs import Outputs
    from ..base.values import Values


class LocalizeImages(LocalizeAlgorithm):
    ID = "localizeimages"
    TAGS = ("position", "match", "uav", "drone", "navigation", "gnss", "geolocation", "fix")

    ALTERNATIVES = "ALTERNATIVES"
    LAYER = "LAYER"
    EXTENT = parameters.EXTENT
    MASK = parameters.MASK

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
            parameters.database(),
            *self.image_parameters(optional=True),
            *priors.parameters(),
            self.camera_parameter(),
            self.speed_parameter(),
            *self._output_parameters(),
            self.risk_parameter(
                tr("Allowed risk of a wrong fix"),
                tr(
                    "A place is a fix when the probability that it is wrong is at most this: 0.0001 is once in 10,000 "
                    "fixes. A smaller risk gives fewer fixes. The topology vector, as published, knows no such "
                    "probability."
                ),
            ),
            *self._layer_parameters(),
            self.sun_parameter(),
            scheduler(),
            *pace_results(),
        )

    def _layer_parameters(self) -> tuple[Declared, ...]:
        """What is localized instead of images, or with them."""
        return (
            with_help(
                QgsProcessingParameterRasterLayer(self.LAYER, tr("Layer to try"), optional=True),
                tr(
                    "A raster or a map of tiles, of which the extent is localized as if it were an image, at the "
                    "model’s resolution (label colors: at the database’s): would this place be found?"
                ),
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterExtent(self.EXTENT, tr("Extent of the layer to try"), optional=True),
                tr("Needed for maps of tiles, else all of the layer."),
                advanced=True,
            ),
            with_help(
                QgsProcessingParameterFeatureSource(
                    self.MASK, tr("Mask of the layer to try"), types=[SOURCE_POLYGON], optional=True
                ),
                tr("Polygons: ground outside of them has no label. Without an extent, what lies around them is tried."),
                advanced=True,
            ),
        )

    def _output_parameters(self) -> tuple[Declared, ...]:
        """What is written, and the number that is told."""
        return (
            with_help(
                QgsProcessingParameterFeatureSink(self.OUTPUT, tr("Positions"), type=SOURCE_POINT),
                tr(
                    "One point an image: status, position, confidence, distance, window and, without a fix, the reason."
                ),
            ),
            self.footprints_parameter(
                tr(
                    "One polygon a fix: the ground the image shows, or the matched window of the topology vector "
                    "method."
                )
            ),
            with_help(
                QgsProcessingParameterFeatureSink(
                    self.ALTERNATIVES, tr("Possible places"), type=SOURCE_POLYGON, optional=True, createByDefault=False
                ),
                tr("For ambiguous images: the ground of each place that fits, the best one first."),
            ),
            *self.shown_parameters(),
            QgsProcessingOutputNumber(self.FIX_COUNT, tr("Number of fixes")),
        )

    def check(self, values: Values) -> None:
        priors.scales(values, self.method(values))
        if not values.has(self.LAYER) and not values.files(self.IMAGES):
            raise ParameterError("IMAGES is empty; choose at least one image, a folder with images, or a LAYER.")
        parts = [key for key in (self.EXTENT, self.MASK) if values.has(key)]
        if parts and not values.has(self.LAYER):
            # They would change nothing, and who gave them took the result for that of a part.
            raise ParameterError(
                "LAYER is empty, so {keys} can't be a part of it; choose a LAYER, or leave {keys} out.",
                keys=", ".join(parts),
            )
        require_scheduler(values, (self.LAYER, self.LABELS))

    def read_layers(self, values: Values) -> None:
        from ..layers.areas import drawn_area

        area = drawn_area(values.source(self.MASK)) if values.has(self.LAYER) else None
        self._layer = PhotoSource(values, self.LAYER, self.EXTENT, area) if values.has(self.LAYER) else None

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, int]:
        from ...core.geometry.camera import Camera
        from ...core.localizer.localizer import Localizer
        from ...core.localizer.settings import LOCALIZER
        from ...core.pipeline import Pipeline
        from ...storage.file_states import state
        from ..layers.reference_systems import database_crs

        method, path = self.method(values), values.file(self.DATABASE)
        before = {path: state(path)}
        database = self.read_database(values, method, feedback)
        crs = database_crs(database)
        settings = replace(LOCALIZER, allowed_risk=values.number(self.RISK))
        localizer = Localizer(database, settings, values.optional_number(self.SUN_DIRECTION))
        localizer.check(method)
        search = self.search(values, method, crs, values.has(self.MATCHES))
        read_labels = self.label_reader(values, database.class_table, feedback)
        paths, cameras = self.read_images(values, method, feedback, self._layer is None)
        if self._layer is not None:
            size_m = getattr(read_labels, "resolution_m", None) or database.parameters.pixel_size
            paths, cameras = [*paths, self._layer.file(size_m, feedback)], [*cameras, Camera()]
        is_scheduled = values.has(SCHEDULER)
        with outputs.folder(self.LABELS) as folder:
            if is_scheduled:
                localized = localize_scheduled(values, database, before, search, paths, cameras, feedback)
                for item in localized:
                    log_result(item, feedback)
            else:
                keep = LabelImages(folder, paths, database.class_table, read_labels.stated_biases)
                pipeline = Pipeline(localizer, search, read_labels)
                localized = _one_by_one(paths, cameras, pipeline, keep, feedback)
            localized = with_far_photos(localized, database, crs, values.transform_context, feedback)
            times_s = [camera.time_s for camera in cameras]
            speed = values.optional_number(self.MAXIMUM_SPEED)
            if speed is not None:
                localized = with_jumps(localized, times_s, database.windows, speed, feedback)
            # Layers are made last: a cancel before leaves nothing behind.
            check_canceled(feedback)
            write_positions(outputs, self.OUTPUT, localized, crs, values.transform_context, times_s)
            write_grounds(outputs, (self.FOOTPRINTS, self.ALTERNATIVES), localized, crs)
            write_matches(outputs, self.MATCHES, localized, database, crs)
        fixes = sum(1 for item in localized if item.result is not None and item.result.is_fix)
        feedback.pushInfo(tr("{fixes} of {images} images have a fix.").format(fixes=fixes, images=len(localized)))
        if read_labels.pace is None or is_scheduled:
            return {self.FIX_COUNT: fixes}
        feedback.pushInfo(read_labels.pace.sentence())
        return {self.FIX_COUNT: fixes, **read_labels.pace.results}


def _one_by_one(
    paths: Sequence[str],
    cameras: Sequence[Camera],
    pipeline: Pipeline,
    keep: LabelImages,
    feedback: QgsProcessingFeedback,
) -> list[LocalizedImage]:
    """The images, localized here."""
    localized = []
    for n, path in enumerate(paths):
        check_canceled(feedback)
        feedback.setProgressText(os.path.basename(path))
        localized.append(cancelable(localize_image, path, pipeline, cameras[n], keep, feedback=feedback))
        log_result(localized[-1], feedback)
        feedback.setProgress(95 * (n + 1) / len(paths))
    return localized
