"""semref:localizeflight – all images of a flight to one track."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFile,
)

from ...core.errors import ParameterError
from ...core.localization import Method
from ..base import parameters, priors
from ..base.algorithm import Declared, cancelable, check_canceled, interruptible
from ..base.flight_images import FlightReader, in_order, log_pose, with_log, with_pose
from ..base.localized_image import LabelImages, with_far_photos, with_jumps
from ..base.localized_layers import (
    FlownImage,
    report_points,
    tracks_of,
    write_flight_positions,
    write_grounds,
    write_matches,
    write_tracks,
)
from ..base.localizing import LocalizeAlgorithm
from ..base.parameters import with_help
from ..base.photo_labels import pace_results
from ..compat import SOURCE_LINE, SOURCE_POINT
from ..messages.sentences import worded
from ..translation import tr

if TYPE_CHECKING:
    from qgis.core import QgsProcessingFeedback

    from ...core.database.model import ReferenceDatabase
    from ...core.flight.motion import Link
    from ...core.flight.telemetry import Telemetry
    from ...core.geometry.camera import Camera
    from ...core.localizer.localizer import Localizer
    from ..base.outputs import Outputs
    from ..base.values import Values

READ_PERCENT, JOINED_PERCENT = 60, 97
"""Progress when all images were looked at by themselves and when the flight is placed."""


class LocalizeFlight(LocalizeAlgorithm):
    ID = "localizeflight"
    TAGS = ("track", "trajectory", "path", "sequence", "uav", "drone", "navigation", "gnss", "odometry", "position")

    ODOMETRY = "ODOMETRY"
    LOG = "LOG"
    TRACK = "TRACK"
    REPORT = parameters.REPORT
    TRACK_COUNT = "TRACK_COUNT"

    def title(self) -> str:
        return tr("Localize flight")

    def summary(self) -> str:
        return tr(
            "Finds the track of a flight: all its images together, by what each says of its place and by how they lie "
            "to each other. Images that have no fix of their own are placed, too, and wrong fixes are outvoted.\n\n"
            "The images are taken in the order of their times, else of their names. Motion from image to image is "
            "seen in their pixels where they overlap, or told by an odometry table; without either it is taken to go "
            "on as before, and errors grow. Where nothing decides, an image stays without a position and says why."
        )

    def parameters(self) -> tuple[Declared, ...]:
        return (
            parameters.database(),
            *self.image_parameters(optional=False),
            *priors.parameters(),
            self.camera_parameter(),
            with_help(
                QgsProcessingParameterFile(
                    self.ODOMETRY, tr("Odometry table"), fileFilter=tr("CSV (*.csv *.txt)"), optional=True
                ),
                tr(
                    "A CSV with the columns image, dx_m, dy_m and dheading_deg: how far the camera moved since the "
                    "row before, to the right and towards the top of that image in meters, and how far it turned "
                    "clockwise in degrees; optionally sigma_m, sigma_heading_deg, scale and sigma_scale. A row without "
                    "numbers says that the motion is not known. It counts before what pixels say."
                ),
                advanced=True,
            ),
            self.speed_parameter(),
            *self._output_parameters(),
            self.risk_parameter(
                tr("Allowed risk of a wrong track"),
                tr(
                    "A track is told when the probability that it is wrong is at most this: 0.0001 is once in 10,000. "
                    "A smaller risk needs more images."
                ),
            ),
            self.sun_parameter(),
            with_help(
                QgsProcessingParameterFile(
                    self.LOG,
                    tr("Flight log"),
                    fileFilter=tr("Flight logs (*.bin *.ulg *.tlog *.srt *.SRT *.txt)"),
                    optional=True,
                ),
                tr(
                    "The log of an autopilot (ArduPilot .bin, PX4 .ulg, .tlog), subtitles of DJI (.SRT) or a geo.txt: "
                    "heading, height and attitude that neither camera table nor photos tell, and motion between "
                    "images where neither pixels nor the odometry table tell it. Its positions are left alone."
                ),
                advanced=True,
            ),
        )

    def _output_parameters(self) -> tuple[Declared, ...]:
        """What is written, and the numbers that are told."""
        return (
            with_help(
                QgsProcessingParameterFeatureSink(self.OUTPUT, tr("Positions of the flight"), type=SOURCE_POINT),
                tr(
                    "One point an image, in the order of the flight: as of “Localize images”, with what the position "
                    "rests on (source: own or flight), its track, and whether a fix of its own was outvoted. Images "
                    "whose times are known can be played with QGIS’s temporal controller."
                ),
            ),
            with_help(
                QgsProcessingParameterFeatureSink(self.TRACK, tr("Track"), type=SOURCE_LINE, optional=True),
                tr("One line a track, from image to image."),
            ),
            self.footprints_parameter(tr("One polygon an image with a position: the ground that it shows.")),
            parameters.report(
                tr("The track with its error ellipses, what held where, heading and height, and the gaps, in one file.")
            ),
            *self.shown_parameters(),
            QgsProcessingOutputNumber(self.FIX_COUNT, tr("Number of images with a position")),
            QgsProcessingOutputNumber(self.TRACK_COUNT, tr("Number of tracks")),
            *pace_results(),
        )

    def check(self, values: Values) -> None:
        priors.scales(values, self.method(values))
        if not values.files(self.IMAGES):
            raise ParameterError("IMAGES is empty; choose at least one image, a folder with images, or a LAYER.")

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, Any]:
        from ...core.localizer.localizer import Localizer
        from ...core.localizer.settings import LOCALIZER
        from ...core.pipeline import Pipeline
        from ..layers.reference_systems import database_crs

        method = self.method(values)
        # Tracks are told apart by class areas, whatever finds an image by itself.
        database = self.read_database(values, Method.MAP_CORRELATION, feedback)
        crs = database_crs(database)
        settings = replace(LOCALIZER, allowed_risk=values.number(self.RISK))
        localizer = Localizer(database, settings, values.optional_number(self.SUN_DIRECTION))
        paths, cameras = in_order(*self.read_images(values, method, feedback))
        steps = cancelable(self._odometry, values, paths, feedback=feedback)
        log = self._read_log(values, feedback)
        cameras = with_log(cameras, log, paths, method != Method.TOPOLOGY_VECTOR)
        read_labels = self.label_reader(values, database.class_table, feedback)
        with outputs.folder(self.LABELS) as folder:
            keep = LabelImages(folder, paths, database.class_table, read_labels.stated_biases)
            search = self.search(values, method, crs, values.has(self.MATCHES))
            reader = FlightReader(Pipeline(localizer, search, read_labels), keep)
            for n, (path, camera) in enumerate(zip(paths, cameras)):
                check_canceled(feedback)
                feedback.setProgressText(os.path.basename(path))
                cancelable(reader.take, path, camera, feedback=feedback)
                feedback.setProgress(READ_PERCENT * (n + 1) / len(paths))
            links = cancelable(reader.links_with, steps, log, feedback=feedback)
            flown = self._join(reader, links, localizer, values.number(self.RISK), feedback)
            flown = self._with_jumps(values, flown, cameras, database, feedback)
            localized = [one.localized for one in flown]
            localized = with_far_photos(localized, database, crs, values.transform_context, feedback)
            flown = [replace(one, localized=item) for one, item in zip(flown, localized)]
            for one in flown:
                log_pose(one, feedback)
            # Layers are made last: a cancel before leaves nothing behind.
            check_canceled(feedback)
            write_flight_positions(outputs, self.OUTPUT, flown, crs, values.transform_context)
            write_tracks(outputs, self.TRACK, flown, crs)
            write_grounds(outputs, (self.FOOTPRINTS,), localized, crs)
            write_matches(outputs, self.MATCHES, localized, database, crs)
            if outputs.wants(self.REPORT):
                outputs.text(self.REPORT, self._report(values, database, flown, reader.motion_sentences(links)))
        placed = sum(one.is_placed for one in flown)
        tracks = len(tracks_of(flown))
        text = tr("{placed} of {images} images have a position; tracks: {tracks}.")
        feedback.pushInfo(text.format(placed=placed, images=len(flown), tracks=tracks))
        found = {self.FIX_COUNT: placed, self.TRACK_COUNT: tracks}
        if read_labels.pace is None:
            return found
        feedback.pushInfo(read_labels.pace.sentence())
        return {**found, **read_labels.pace.results}

    def _odometry(self, values: Values, paths: Sequence[str]) -> tuple:
        """Rows of the odometry table; none without one."""
        from ...core.flight.odometry import odometry_links, read_odometry

        if not values.has(self.ODOMETRY):
            return ()
        table = values.file(self.ODOMETRY)
        steps = read_odometry(table)
        if len(paths) > 1 and not odometry_links(steps, paths):
            raise ParameterError(
                "{path} tells no motion between two of these images, such as {image}; give the ODOMETRY of this "
                "flight.",
                path=table,
                image=os.path.basename(paths[0]),
            )
        return steps

    def _read_log(self, values: Values, feedback: QgsProcessingFeedback) -> Telemetry | None:
        """The flight's log; None without one."""
        from ...core.flight.logs.files import read_log

        if not values.has(self.LOG):
            return None
        return cancelable(read_log, values.file(self.LOG), feedback.isCanceled, feedback=feedback)

    def _join(
        self,
        reader: FlightReader,
        links: Sequence[Link],
        localizer: Localizer,
        risk: float,
        feedback: QgsProcessingFeedback,
    ) -> list[FlownImage]:
        """What the flight says of each image."""
        from ...core.flight.flight import FlightSolver
        from ...core.flight.settings import FLIGHT

        feedback.setProgressText(tr("Placing the flight"))
        solver = FlightSolver(localizer, replace(FLIGHT, allowed_risk=risk))
        for done, count in interruptible(solver.steps(reader.flown, links), feedback):
            check_canceled(feedback)
            feedback.setProgress(READ_PERCENT + (JOINED_PERCENT - READ_PERCENT) * done / count)
        found = iter(solver.poses)
        return [with_pose(taken, None if taken.flown is None else next(found)) for taken in reader.taken]

    def _with_jumps(
        self,
        values: Values,
        flown: Sequence[FlownImage],
        cameras: Sequence[Camera],
        database: ReferenceDatabase,
        feedback: QgsProcessingFeedback,
    ) -> list[FlownImage]:
        """The images, positions that can't be reached in time marked, if a speed is given."""
        speed = values.optional_number(self.MAXIMUM_SPEED)
        if speed is None:
            return list(flown)
        localized = [one.localized for one in flown]
        times_s = [camera.time_s for camera in cameras]
        checked = with_jumps(localized, times_s, database.windows, speed, feedback)
        return [replace(one, localized=item) for one, item in zip(flown, checked)]

    def _report(
        self, values: Values, database: ReferenceDatabase, flown: Sequence[FlownImage], links: Sequence[str]
    ) -> str:
        from ..reports.flight_report import flight_html

        settings = [
            (tr("Method"), tr("of each image by itself: {method}").format(method=worded(self.method(values).title))),
            (tr("Allowed risk of a wrong track"), f"{values.number(self.RISK):g}"),
            (tr("Model"), os.path.basename(values.file(self.MODEL)) or tr("none: label images")),
            (tr("Flight log"), os.path.basename(values.file(self.LOG)) or tr("none")),
            (tr("Odometry table"), os.path.basename(values.file(self.ODOMETRY)) or tr("none")),
        ]
        return flight_html(report_points(flown), os.path.basename(database.source), links, settings)
