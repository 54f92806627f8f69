"""``python -m core watch --flight``: each image gets what its flight so far says of it; the state outlives a restart.

A state file is numpy's ``.npz`` without pickles: the arrays of ``FlightTracker.state``, what the next image is linked
by, and a header in JSON. It is written beside its place and moved there, so that a power cut leaves the one before.
"""

from __future__ import annotations

import contextlib
import json
import logging
import math
import os
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..errors import ParameterError
from ..flight.memory import checked_array
from ..flight.model import FlightImage
from ..flight.motion import Link
from ..flight.pixel_features import Features, features_of
from ..flight.pixel_motion import motion_between
from ..flight.settings import FLIGHT, FlightSettings
from ..flight.table import stem_of
from ..flight.tracker import FlightTracker
from ..geometry.leveling import Leveling
from ..localizer.leveled import as_taken, level_labels, of_leveled
from ..values import checked, read_json
from .arrays import UNREADABLE, number_arrays
from .finder import Finding, time_of
from .format import MAXIMUM_HEADER_BYTES
from .log import say
from .tables import OdometryTable

FORMAT, VERSION = "semref flight state", 1

MOST_STATE_BYTES = 256_000_000
"""A state has some ten images at a few hundred pixels an edge; a larger file is none."""

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
    """

    tracker: FlightTracker | None = None
    features: Features | None = None
    after: Taken | None = None
    taken_s: float | None = None


@dataclass(frozen=True)
class FlightFinding(Finding):
    """Localizes the images of one flight, in order; what is said of each is the best estimate of all up to it.

    Attributes:
        state_path: File that keeps the state; empty for none.
        settings: Of flights.
        odometry: Table of the motion from image to image; None without one.
        memory: See there.
    """

    state_path: str = ""
    settings: FlightSettings = FLIGHT
    odometry: OdometryTable | None = None
    memory: _Memory = field(default_factory=_Memory)

    def start(self) -> Taken | None:
        """Goes on where a state file left it, else begins; the image that was taken last, None for none.

        A file that can't be used is told in the log: an aircraft must not stay on the ground, or without a position,
        for it.
        """
        try:
            if self.state_path and os.path.exists(self.state_path):
                tracker = self._resume()
                say(logging.INFO, "flight_resumed", state=self.state_path, track=tracker.track)
                return self.memory.after
        except (ParameterError, OSError) as error:
            say(logging.ERROR, "flight_state_not_used", state=self.state_path, reason=str(error))
        return None

    def localized(self, path: str) -> dict[str, Any]:
        """A record's columns for the next image of the flight. Raises SemRefError."""
        camera = self.camera_of(path)
        seen = self.read_labels(path, camera)
        height, width = seen.labels_hw.shape
        way, prior = camera.leveling((height, width)), self.prior_of(camera, (height, width))
        if way is not None:
            seen, prior = level_labels(seen, way), of_leveled(prior, way)
        own = self.localizer.localize(seen.labels_hw, self.method, prior, shares=seen.shares)
        taken_s = self.cameras.time_s(path, camera)
        link = self._link(path, taken_s, seen.labels_hw, way)
        image = FlightImage(os.path.basename(path), seen.labels_hw, own, time_of(path).timestamp(), prior)
        pose = self._tracker.add(image, link)
        placed = pose.localization()
        found = self.told(placed if way is None else as_taken(placed, way))
        source = str(pose.source) if pose.is_fix else None
        found.update(source=source, track=pose.track or None, outvoted=pose.is_outvoted)
        self.memory.after = os.stat(path).st_mtime_ns, os.path.basename(path)
        self.memory.taken_s = taken_s
        self._keep()
        return found

    @property
    def _tracker(self) -> FlightTracker:
        if self.memory.tracker is None:
            self.memory.tracker = FlightTracker(self.localizer, self.settings)
        return self.memory.tracker

    def _link(self, path: str, taken_s: float | None, level_hw: np.ndarray, way: Leveling | None) -> Link | None:
        """From the image before to this one: by the odometry table, else by what both show, else by the log."""
        memory, photo = self.memory, self.read_labels.photo
        pixels = None if photo is None else photo.read(0, 0, photo.shape_hw[1], photo.shape_hw[0])
        features = features_of(level_hw, pixels, way)
        seen_before, memory.features = memory.features, features
        if memory.after is None:
            return None
        before, now = stem_of(memory.after[1]), stem_of(path)
        link = None if self.odometry is None else self.odometry.link(before, now)
        if link is None and seen_before is not None:
            motion = motion_between(seen_before, features)
            link = motion.link
            if link is None:
                say(logging.INFO, "no_link", reason=None if motion.reason is None else str(motion.reason))
        return link or self.cameras.link((before, memory.taken_s), (now, taken_s))

    # --- the state ---

    def _keep(self) -> None:
        """Writes the state; a disk that can't take it is told, and the flight goes on."""
        if not self.state_path:
            return
        arrays = {f"tracker_{name}": value for name, value in self._tracker.state().items()}
        features = self.memory.features
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
            "after": self.memory.after,
            "times_s": [self.cameras.first_s, self.memory.taken_s],
        }
        text = json.dumps(header).encode("utf-8", "backslashreplace")
        beside = f"{self.state_path}.part"
        try:
            with open(beside, "wb") as file:
                np.savez(file, header=np.frombuffer(text, np.uint8), **arrays)
                file.flush()
                os.fsync(file.fileno())
            os.replace(beside, self.state_path)
        except OSError as error:
            # A full disk must not be filled with half a state.
            with contextlib.suppress(OSError):
                os.remove(beside)
            say(logging.ERROR, "state_not_kept", state=self.state_path, reason=error.strerror or str(error))

    def _resume(self) -> FlightTracker:
        """Reads the state. Raises ParameterError for a file that is none, or of another database."""
        arrays = _read_state(self.state_path)
        try:
            header = read_json(arrays["header"].tobytes().decode("utf-8"), MAXIMUM_HEADER_BYTES)
            is_ours = header["format"] == FORMAT and header["version"] == VERSION
            known_hash, after = header["content_hash"], header["after"]
            if after is not None:
                after = checked(after[0], int, "a time"), checked(after[1], str, "a name")
            # States of versions without it have no times.
            first_s, taken_s = (_time(value) for value in header.get("times_s", (None, None)))
        except (KeyError, TypeError, ValueError, IndexError, RecursionError, AttributeError) as error:
            raise ParameterError("onboard.no_flight_state", path=self.state_path) from error
        if not is_ours:
            raise ParameterError("onboard.no_flight_state", path=self.state_path)
        if known_hash != self.onboard.content_hash:
            raise ParameterError("onboard.state_of_other_database", path=self.state_path)
        state = {name[len("tracker_") :]: value for name, value in arrays.items() if name.startswith("tracker_")}
        memory, tracker = self.memory, FlightTracker.from_state(self.localizer, state, self.settings)
        memory.tracker, memory.features, memory.after = tracker, _features(arrays), after
        self.cameras.first_s, memory.taken_s = first_s, taken_s
        return tracker


def _read_state(path: str) -> dict[str, np.ndarray]:
    """The arrays of a state file. Raises ParameterError."""
    if not os.path.isfile(path) or os.path.getsize(path) > MOST_STATE_BYTES:
        raise ParameterError("onboard.no_flight_state", path=path)
    try:
        return number_arrays(path, MOST_STATE_BYTES)
    except UNREADABLE as error:
        raise ParameterError("onboard.no_flight_state", path=path) from error


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
