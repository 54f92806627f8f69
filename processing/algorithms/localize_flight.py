"""semref:localizeflight: compute one track from all images of a flight."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from qgis.core import (
    QgsProcessingFeedback,
    QgsProcessingOutputNumber,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFile,
)

from ...core.errors import ParameterError
from ...core.localization import Method
from ..base import parameters
from ..base.algorithm import Declared, ahead, cancelable, check_canceled, follow, interruptible
from ..base.outputs import Outputs
from ..base.parameters import with_help
from ..base.values import Values
from ..compat import SOURCE_LINE, SOURCE_POINT
from ..jobs import priors
from ..jobs.image_results import LabelImages, count_sentence, log_result, with_far_photos, with_jumps
from ..jobs.localizing import LocalizeAlgorithm, require_images
from ..jobs.photo_labels import pace_results
from ..layers.localized_image import ERROR, LocalizedImage
from ..messages.sentences import worded
from ..translation import tr

if TYPE_CHECKING:
    from ...core.database.model import ReferenceDatabase
    from ...core.flight.motion import Link
    from ...core.flight.telemetry import Telemetry
    from ...core.localizer.localizer import Localizer
    from ..jobs.flight_images import FlightReader

READ_PERCENT, JOINED_PERCENT = 60, 97
"""Progress after all images are localized separately, and after the flight is placed."""


class LocalizeFlight(LocalizeAlgorithm):
    ID = "localizeflight"
    TITLE = "Localize flight"
    TAGS = ("track", "trajectory", "path", "sequence", "uav", "drone", "navigation", "gnss", "odometry", "position")
    SUMMARY = (
        "Computes the track of a flight from the positions of its images and the motion between them. Images "
        "without a position of their own are placed too, and wrong positions are outvoted.\n\nThe motion is "
        "measured in overlapping images, or read from an odometry table or a flight log. Otherwise it is "
        "extrapolated and the error grows."
    )

    ODOMETRY = "ODOMETRY"
    LOG = "LOG"
    TRACK = "TRACK"
    TRACK_COUNT = "TRACK_COUNT"

    def parameters(self) -> tuple[Declared, ...]:
        return (
            parameters.database(),
            *self.image_parameters(optional=False),
            *priors.parameters(),
            self.camera_parameter(),
            with_help(
                QgsProcessingParameterFile(
                    self.ODOMETRY, "Odometry table", fileFilter=tr("CSV (*.csv *.txt)"), optional=True
                ),
                "CSV file with the columns image, dx_m, dy_m and dheading_deg: the motion since the previous row, "
                "to the right and to the top of that image (m), and the clockwise turn (degrees). Optional "
                "columns are sigma_m, sigma_heading_deg, scale and sigma_scale. A row without numbers means "
                "unknown motion. The table is used before the motion measured in images.",
                advanced=True,
            ),
            self.speed_parameter(),
            with_help(
                QgsProcessingParameterFeatureSink(self.OUTPUT, "Positions of the flight", type=SOURCE_POINT),
                "One row for each image, in flight order. In addition to the columns of “Localize images” it has "
                "the source of the position (own or flight), the track, and whether its own position was "
                "outvoted. If the times are known, the temporal controller of QGIS can play the flight.",
            ),
            with_help(
                QgsProcessingParameterFeatureSink(self.TRACK, "Track", type=SOURCE_LINE, optional=True),
                "One line for each track, from image to image.",
            ),
            self.footprints_parameter("One polygon for each image with a position: its footprint."),
            parameters.report(
                "Page with the track and its error ellipses, the source and heading of each position, and gaps."
            ),
            *self.shown_parameters(),
            QgsProcessingOutputNumber(self.FIX_COUNT, "Number of images with a position"),
            QgsProcessingOutputNumber(self.TRACK_COUNT, "Number of tracks"),
            *pace_results(),
            self.risk_parameter(
                "A track is accepted if the probability that it is wrong is not larger than this value, for "
                "example 0.0001 (1 in 10,000). A smaller value needs more images."
            ),
            self.sun_parameter(),
            with_help(
                QgsProcessingParameterFile(
                    self.LOG,
                    "Flight log",
                    fileFilter=tr("Flight logs (*.bin *.ulg *.tlog *.srt *.SRT *.txt)"),
                    optional=True,
                ),
                "Autopilot log (ArduPilot .bin, PX4 .ulg, .tlog), DJI subtitles (.SRT) or geo.txt. SemRef uses "
                "heading, height and attitude where the camera table and the photos lack them, and motion where "
                "the images and the odometry table lack it. Positions in the log are not used.",
                advanced=True,
            ),
        )

    def check(self, values: Values) -> None:
        priors.scales(values, self.method(values))
        require_images(values.files(self.IMAGES))

    def work(self, values: Values, outputs: Outputs, feedback: QgsProcessingFeedback) -> dict[str, Any]:
        from ...core.pipeline import Pipeline
        from ..jobs.flight_images import FlightReader, in_order, with_log
        from ..jobs.localized_layers import tracks_of, write_footprints, write_matches, write_positions, write_tracks
        from ..layers.reference_systems import database_crs

        method = self.method(values)
        # Class areas decide between tracks, whichever method localizes single images.
        database = self.read_database(values, Method.MAP_CORRELATION, feedback)
        crs = database_crs(database)
        localizer, search = self.make_localizer(values, method, database, crs)
        paths, cameras = in_order(*self.read_images(values, method, feedback))
        steps = cancelable(self._odometry, values, paths, feedback=feedback)
        log = self._read_log(values, feedback)
        cameras = with_log(cameras, log, paths, method != Method.TOPOLOGY_VECTOR)
        read_labels = self.label_reader(values, database.class_table, feedback)
        with outputs.folder(self.LABELS) as folder:
            keep = LabelImages(folder, paths, database.class_table, read_labels.stated_biases)
            reader = FlightReader(Pipeline(localizer, search, read_labels, looks_again=False), keep)
            for read in ahead(lambda one: reader.read(*one), zip(paths, cameras), feedback):
                cancelable(reader.take, *read, feedback=feedback)
                feedback.setProgressText(os.path.basename(read[0].path))
                feedback.setProgress(READ_PERCENT * len(reader.taken) / len(paths))
            speed = values.optional_number(self.MAXIMUM_SPEED)
            if speed is not None:
                reader.search_within_reach(speed, feedback)
            links = cancelable(reader.links_with, steps, log, feedback=feedback)
            flown = self._join(reader, links, localizer, values.number(self.RISK), feedback)
            if speed is not None:
                flown = with_jumps(flown, database.windows, speed, feedback)
            flown = with_far_photos(flown, database, crs, values.transform_context, feedback)
            for item in flown:
                log_result(item, feedback)
            # Layers are written last, so that a cancel leaves nothing behind.
            check_canceled(feedback)
            write_positions(outputs, self.OUTPUT, flown, crs, values.transform_context, is_flight=True)
            write_tracks(outputs, self.TRACK, flown, crs)
            write_footprints(outputs, self.FOOTPRINTS, flown, crs)
            write_matches(outputs, self.MATCHES, flown, database, crs)
            if values.has(self.REPORT):
                outputs.text(self.REPORT, self._report(values, database, flown, reader.motion_sentences(links)))
        placed = sum(item.is_placed for item in flown)
        tracks = len(tracks_of(flown))
        statuses = [ERROR if item.result is None else item.result.status for item in flown]
        feedback.pushInfo(f"{count_sentence(statuses)} {tr('Tracks: {tracks}.').format(tracks=tracks)}")
        return {self.FIX_COUNT: placed, self.TRACK_COUNT: tracks, **read_labels.log_pace()}

    def _odometry(self, values: Values, paths: Sequence[str]) -> tuple:
        """Return the rows of the odometry table; empty without a table."""
        from ...core.flight.odometry import odometry_links, read_odometry

        if not values.has(self.ODOMETRY):
            return ()
        table = values.file(self.ODOMETRY)
        steps = read_odometry(table)
        if len(paths) > 1 and not odometry_links(steps, paths):
            raise ParameterError(
                "The odometry table {path} contains no motion between two of these images, for example {image}. "
                "Select the table of this flight.",
                path=table,
                image=os.path.basename(paths[0]),
            )
        return steps

    def _read_log(self, values: Values, feedback: QgsProcessingFeedback) -> Telemetry | None:
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
    ) -> list[LocalizedImage]:
        from ...core.flight.flight import FlightSolver
        from ...core.flight.settings import FLIGHT
        from ..jobs.flight_images import with_pose

        solver, text = FlightSolver(localizer, replace(FLIGHT, allowed_risk=risk)), tr("Computing the track")
        steps = ((text, done / count) for done, count in solver.steps(reader.flown, links))
        follow(interruptible(steps, feedback), feedback, READ_PERCENT, JOINED_PERCENT)
        found = iter(solver.poses)
        return [with_pose(taken, None if taken.flown is None else next(found)) for taken in reader.taken]

    def _report(
        self, values: Values, database: ReferenceDatabase, flown: Sequence[LocalizedImage], links: Sequence[str]
    ) -> str:
        from ..reports.flight_report import flight_html

        settings = [
            (tr("Method"), tr("{method}, for single images").format(method=worded(self.method(values).title))),
            (tr("Maximum error probability"), f"{values.number(self.RISK):g}"),
            (tr("Model"), os.path.basename(values.file(self.MODEL)) or tr("not used (label images)")),
            (tr("Flight log"), os.path.basename(values.file(self.LOG)) or tr("not used")),
            (tr("Odometry table"), os.path.basename(values.file(self.ODOMETRY)) or tr("not used")),
        ]
        return flight_html(flown, os.path.basename(database.source), links, settings)
