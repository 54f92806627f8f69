"""``semref watch --flight``: each image gets what its flight so far says of it; the state outlives a restart.

A state has the arrays of ``FlightTracker.state``, what the next image is linked by, and a header in JSON.
"""

from __future__ import annotations

import json
import logging
import math
import os
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any

import numpy as np

from .. import limits
from ..errors import ParameterError, reason_of
from ..flight.memory import checked_array
from ..flight.model import FlightImage
from ..flight.motion import Link
from ..flight.pixel_features import Features, features_of
from ..flight.pixel_motion import motion_between
from ..flight.settings import FLIGHT, FlightSettings
from ..flight.table import stem_of
from ..flight.tracker import FlightTracker
from ..pipeline import ImageResult
from ..values import checked, read_json
from .format import export_date
from .image_records import FinderSettings, time_of
from .log import log_event
from .state_file import StateFile
from .tables import OdometryTable

FORMAT, VERSION = "semref flight state", 2

Taken = tuple[int, str]
"""(time of change in ns, name) of an image: images are taken in this order."""


@dataclass
class _Memory:
    """What a flight remembers.

    Attributes:
        tracker: That follows it; None before the start.
        features: Of the latest image, for the link to the next one.
        after: The latest image; None before the first.
        taken_s: When that one was taken, on the cameras' clock; None where unknown.
        newest: Latest export date of the onboard files that this flight and the ones before it in its state used.
        is_kept: Whether the state could be written the last time.
    """

    tracker: FlightTracker | None = None
    features: Features | None = None
    after: Taken | None = None
    taken_s: float | None = None
    newest: datetime | None = None
    is_kept: bool = True


@dataclass(frozen=True)
class FlightFinding(FinderSettings):
    """Localizes the images of one flight, in order; what is said of each is the best estimate of all up to it.

    Attributes:
        state: File that keeps the flight; None for none.
        odometry: Table of the motion from image to image; None without one.
    """

    state: StateFile | None = None
    settings: FlightSettings = FLIGHT
    odometry: OdometryTable | None = None
    memory: _Memory = field(default_factory=_Memory)

    def start(self) -> Taken | None:
        """Goes on where a state file left it, else begins; the image that was taken last, None for none.

        A file that can't be used is told in the log: an aircraft must not stay on the ground, or without a position,
        for it.
        """
        self.memory.newest = self.onboard.exported
        if self.state is None or not os.path.exists(self.state.path):
            return None
        try:
            tracker = self._resume(self.state)
            log_event(logging.INFO, "flight_resumed", state=self.state.path, track=tracker.track)
        except (ParameterError, OSError) as error:
            log_event(logging.ERROR, "flight_state_not_used", state=self.state.path, reason=str(error))
        return self.memory.after

    def localized(self, path: str) -> dict[str, Any]:
        """A record's columns for the next image of the flight. Raises SemRefError."""
        camera = self.camera_of(path)
        result = self.pipeline.run(path, camera, with_pixels=True)
        taken_s = self.cameras.time_s(path, camera)
        link = self._link(path, taken_s, result)
        seen, moment_s = result.seen, time_of(path).timestamp()
        image = FlightImage(os.path.basename(path), seen.labels_hw, result.level, moment_s, result.prior, seen.biases)
        try:
            pose = self._tracker.add(image, link)
        except Exception:
            # What led to a fault must not lead to one with each image to come: the flight begins again.
            self.memory.tracker = self.memory.features = None
            raise
        found = self.told(result.as_taken(pose.localization()))
        source = str(pose.source) if pose.is_fix else None
        found.update(source=source, track=pose.track or None, outvoted=pose.is_outvoted)
        self.memory.after = os.stat(path).st_mtime_ns, os.path.basename(path)
        self.memory.taken_s = taken_s
        self._keep()
        return found

    @property
    def _tracker(self) -> FlightTracker:
        if self.memory.tracker is None:
            self.memory.tracker = FlightTracker(self.pipeline.localizer, self.settings)
        return self.memory.tracker

    def _link(self, path: str, taken_s: float | None, result: ImageResult) -> Link | None:
        """From the image before to this one: by the odometry table, else by what both show, else by the log."""
        memory = self.memory
        features = features_of(result.seen.labels_hw, result.seen.pixels, result.leveling)
        seen_before, memory.features = memory.features, features
        if memory.after is None:
            return None
        before, now = stem_of(memory.after[1]), stem_of(path)
        link = None if self.odometry is None else self.odometry.link(before, now)
        if link is None and seen_before is not None:
            motion = motion_between(seen_before, features)
            link = motion.link
            if link is None:
                log_event(logging.INFO, "no_link", reason=None if motion.reason is None else str(motion.reason))
        return link or self.cameras.link((before, memory.taken_s), (now, taken_s))

    # --- the state ---

    def _keep(self) -> None:
        """Write the state. A full disk is logged once, and the flight goes on."""
        if self.state is None:
            return
        memory = self.memory
        arrays = {f"tracker_{name}": value for name, value in self._tracker.state().items()}
        features = memory.features
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
            "newest": None if memory.newest is None else memory.newest.isoformat(),
            "after": memory.after,
            "times_s": [self.cameras.first_s, memory.taken_s],
        }
        text = json.dumps(header).encode("utf-8", "backslashreplace")
        try:
            self.state.write({"header": np.frombuffer(text, np.uint8), **arrays})
            memory.is_kept = True
        except OSError as error:
            if memory.is_kept:
                log_event(logging.ERROR, "state_not_kept", state=self.state.path, reason=reason_of(error))
            memory.is_kept = False

    def _resume(self, state: StateFile) -> FlightTracker:
        """Reads the state.

        Raises:
            OSError: It can't be read.
            ParameterError: It is none, or of another database.
        """
        arrays = state.read()
        try:
            header = read_json(arrays["header"].tobytes().decode("utf-8"), limits.HEADER_BYTES)
            is_ours = header["format"] == FORMAT and header["version"] == VERSION
            known_hash, after = header["content_hash"], header["after"]
            if after is not None:
                after = checked(after[0], int, "a time"), checked(after[1], str, "a name")
            first_s, taken_s = (_time(value) for value in header["times_s"])
            newest = None if header["newest"] is None else export_date(header["newest"])
        except (KeyError, TypeError, ValueError, IndexError, RecursionError, AttributeError) as error:
            raise state.not_ours() from error
        if not is_ours:
            raise state.not_ours()
        self._compare_dates(newest)
        if known_hash != self.onboard.content_hash:
            raise ParameterError("{path} is the state of a flight in another database.", path=state.path)
        prefix = "tracker_"
        saved = {name[len(prefix) :]: value for name, value in arrays.items() if name.startswith(prefix)}
        memory, tracker = self.memory, FlightTracker.from_state(self.pipeline.localizer, saved, self.settings)
        memory.tracker, memory.features, memory.after = tracker, _features(arrays), after
        self.cameras.first_s, memory.taken_s = first_s, taken_s
        return tracker

    def _compare_dates(self, newest: datetime | None) -> None:
        """Warns where an onboard file that was exported later is known: somebody may have put an older one here."""
        used = self.onboard.exported
        if newest is None or (used is not None and used >= newest):
            return
        self.memory.newest = newest
        log_event(
            logging.WARNING,
            "older_database",
            database=self.onboard.database.source,
            exported=None if used is None else used.isoformat(),
            newest=newest.isoformat(),
        )


def _time(value: object) -> float | None:
    """Seconds, or None; raises ValueError for what is neither."""
    if value is None:
        return None
    seconds = float(checked(value, (int, float), "a time"))
    if not math.isfinite(seconds):
        raise ValueError(seconds)
    return seconds


def _features(arrays: dict[str, np.ndarray]) -> Features | None:
    """Of the image before; None where they are none: then the next image is not linked by pixels, no more."""
    try:
        picture = checked_array(arrays, "features_picture", None, None).astype(np.uint8)
        points = checked_array(arrays, "features_points", None, 2)
        described = checked_array(arrays, "features_descriptors", len(points), 32).astype(np.uint8)
        known = checked_array(arrays, "features_known", *picture.shape) if "features_known" in arrays else None
        scale = float(checked_array(arrays, "features_scale", above=0))
        return Features(picture, points, described, None if known is None else known > 0, scale)
    except (KeyError, ValueError):
        return None
