"""``semref watch --flight``: localize the images of a flight with all earlier ones, and continue after a restart.

A state contains the arrays of ``FlightTracker.state``, the features of the latest image, and a header in JSON.
"""

from __future__ import annotations

import json
import logging
import os
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any

import numpy as np

from .. import limits
from ..errors import ParameterError, reason_of
from ..flight.model import FlightImage, PoseSource
from ..flight.motion import Link
from ..flight.pixel_features import Features, features_of
from ..flight.pixel_motion import motion_between
from ..flight.settings import FLIGHT, FlightSettings
from ..flight.tracker import FlightTracker
from ..pipeline import ImageResult
from ..tables import stem_of
from ..values import read_json
from .format import export_date
from .image_records import ImageFinder, time_of
from .log import log_event
from .state_file import StateFile
from .tables import OdometryTable

FORMAT, VERSION = "semref flight state", 2

Taken = tuple[int, str]
"""(time of change in ns, name) of an image; images are localized in this order."""


@dataclass
class FlightFinder(ImageFinder):
    """Localizes the images of one flight in order; each fix uses all images up to it.

    Attributes:
        state: File that stores the flight; None without one.
        writer: One thread that writes it, while the next image is localized.
        odometry: Table of the motion from image to image; None without one.
        tracker: Follows the flight; begins with the first image.
        features: Of the latest image, to link the next one.
        after: The latest image; None before the first.
        taken_s: Time of that image on the cameras' clock; None if unknown.
        newest: Latest export date of all onboard files that this flight has used.
        is_stored: Whether the last state could be written.
        writing: Of the last state.
    """

    state: StateFile | None = None
    writer: ThreadPoolExecutor = field(default_factory=lambda: ThreadPoolExecutor(1))
    settings: FlightSettings = FLIGHT
    odometry: OdometryTable | None = None
    tracker: FlightTracker | None = None
    features: Features | None = None
    after: Taken | None = None
    taken_s: float | None = None
    newest: datetime | None = None
    is_stored: bool = True
    writing: Future[None] | None = None

    def start(self) -> Taken | None:
        """Continue the flight of the state file or begin one. Return the latest image of the state; None without one.

        A file that can't be used is logged and ignored: it must not keep an aircraft on the ground.
        """
        self.newest = self.onboard.exported
        if self.state is None or not os.path.exists(self.state.path):
            return None
        try:
            tracker = self._resume(self.state)
            log_event(logging.INFO, "flight_resumed", state=self.state.path, track=tracker.track)
        except (ParameterError, OSError) as error:
            log_event(logging.ERROR, "flight_state_not_used", state=self.state.path, reason=str(error))
        return self.after

    def localize(self, path: str) -> dict[str, Any]:
        """Return the columns of the record of the next image. Raises SemRefError."""
        camera = self.cameras.of(path)
        result = self.pipeline.run(path, camera, with_pixels=True)
        taken_s = self.cameras.time_s(path, camera)
        link = self._link(path, taken_s, result)
        image = FlightImage.of(os.path.basename(path), result, time_of(path).timestamp())
        self.tracker = self.tracker or FlightTracker(self.pipeline.localizer, self.settings)
        try:
            pose = self.tracker.add(image, link)
        except Exception:
            # The same fault must not repeat with every image: the flight begins again.
            self.tracker = self.features = None
            raise
        placed = result.as_taken(pose.localization())
        found = self.as_record(placed)
        source = None if pose.place is None else str(pose.source)
        found.update(source=source, track=pose.track or None, outvoted=pose.is_outvoted)
        if pose.source is PoseSource.PREDICTED and placed.best is not None:
            # Not in the columns of a position, which other programs use as a fix.
            found.update(predicted=[*placed.best.position, pose.error_95_m])
        self.after = os.stat(path).st_mtime_ns, os.path.basename(path)
        self.taken_s = taken_s
        self._store(self.tracker)
        return found

    def _link(self, path: str, taken_s: float | None, result: ImageResult) -> Link | None:
        """Return the motion from the previous image: from the odometry table, the pixels or the flight log."""
        features = features_of(result.seen.labels_hw, result.seen.pixels, result.leveling)
        seen_before, self.features = self.features, features
        if self.after is None:
            return None
        before, now = stem_of(self.after[1]), stem_of(path)
        link = None if self.odometry is None else self.odometry.link(before, now)
        if link is None and seen_before is not None:
            motion = motion_between(seen_before, features)
            link = motion.link
            if link is None:
                log_event(logging.INFO, "no_link", reason=None if motion.reason is None else str(motion.reason))
        return link or self.cameras.link((before, self.taken_s), (now, taken_s))

    # --- the state ---

    def _store(self, tracker: FlightTracker) -> None:
        """Write the state while the next image is localized. A full disk is logged once, and the flight continues."""
        if self.state is None:
            return
        arrays = {f"tracker_{name}": value for name, value in tracker.state().items()}
        features = self.features
        if features is not None:
            arrays.update(
                features_picture=features.picture_hw,
                features_points=features.points,
                features_descriptors=features.descriptors,
                features_scale=np.array(features.scale),
            )
            if features.is_known_hw is not None:
                arrays["features_known"] = features.is_known_hw
        header = {
            "format": FORMAT,
            "version": VERSION,
            "content_hash": self.onboard.content_hash,
            "newest": None if self.newest is None else self.newest.isoformat(),
            "after": self.after,
            "times_s": [self.cameras.first_s, self.taken_s],
        }
        text = json.dumps(header).encode("utf-8", "backslashreplace")
        content = self.state.pack({"header": np.frombuffer(text, np.uint8), **arrays})
        if self.writing is not None:
            # A slow disk must not collect states.
            self.writing.result()
        self.writing = self.writer.submit(self._write, self.state, content)

    def _write(self, state: StateFile, content: bytes) -> None:
        try:
            state.write(content)
            self.is_stored = True
        except OSError as error:
            if self.is_stored:
                log_event(logging.ERROR, "state_not_kept", state=state.path, reason=reason_of(error))
            self.is_stored = False

    def _resume(self, state: StateFile) -> FlightTracker:
        """Read the state file and restore the flight from it.

        Raises:
            OSError: The file can't be read.
            ParameterError: The file is not a state, or belongs to another database.
        """
        arrays = state.read()
        header = read_json(arrays["header"].tobytes().decode("utf-8"), limits.HEADER_BYTES)
        if header["format"] != FORMAT or header["version"] != VERSION:
            raise state.not_ours()
        known_hash, after = header["content_hash"], header["after"]
        newest = None if header["newest"] is None else export_date(header["newest"])
        self._compare_dates(newest)
        if known_hash != self.onboard.content_hash:
            raise ParameterError("{path} is the state of a flight with another database.", path=state.path)
        prefix = "tracker_"
        saved = {name[len(prefix) :]: value for name, value in arrays.items() if name.startswith(prefix)}
        self.tracker = tracker = FlightTracker.from_state(self.pipeline.localizer, saved, self.settings)
        self.features, self.after = _features(arrays), None if after is None else (after[0], after[1])
        self.cameras.first_s, self.taken_s = header["times_s"]
        return tracker

    def _compare_dates(self, newest: datetime | None) -> None:
        """Warn if the flight has used a newer onboard file before: somebody may have installed an older one."""
        used = self.onboard.exported
        if newest is None or (used is not None and used >= newest):
            return
        self.newest = newest
        log_event(
            logging.WARNING,
            "older_database",
            database=self.onboard.database.source,
            exported=None if used is None else used.isoformat(),
            newest=newest.isoformat(),
        )


def _features(arrays: dict[str, np.ndarray]) -> Features | None:
    """Return the features of the latest image; None without any."""
    if "features_picture" not in arrays:
        return None
    picture, points, described = (arrays[f"features_{name}"] for name in ("picture", "points", "descriptors"))
    return Features(picture, points, described, arrays.get("features_known"), float(arrays["features_scale"]))
