"""Cameras of images on board: from a table, photos and a flight log, as in QGIS."""

from __future__ import annotations

import logging
import os
from dataclasses import dataclass

from ..errors import ParameterError
from ..flight.cameras import check_cameras, complete_camera, merge_camera, row_camera
from ..flight.logs.files import read_log
from ..flight.motion import Link
from ..flight.telemetry import Telemetry, log_cameras, log_links
from ..geometry.camera import Camera
from ..labels.photo_camera import photo_camera
from ..tables import stem_of
from .growing_log import GrowingLog, is_growing_log
from .log import log_event
from .tables import TableOfImages


@dataclass
class Cameras:
    """Provides the camera of each image.

    Attributes:
        table: The camera table; None without one.
        log: The flight log; None without one, or if it grows.
        growing: A flight log that grows during the flight; None without one.
        first_s: Time of the first image on the cameras' clock, which determines the log's time zone; None before it.
    """

    table: TableOfImages[Camera] | None = None
    log: Telemetry | None = None
    growing: GrowingLog | None = None
    first_s: float | None = None

    def of(self, path: str) -> Camera:
        """Return the camera of an image."""
        name, photo = stem_of(path), photo_camera(path)
        row = None if self.table is None else self.table.of(name)
        camera = photo if row is None else merge_camera(row, photo, row.time_s is not None)
        moment = name, self.time_s(path, camera)
        log = self._log(moment[1])
        if log is None:
            return camera
        logged = log_cameras(log, *self._from_first([moment]))[-1]
        return complete_camera(camera, logged, with_attitude=True)

    def time_s(self, path: str, camera: Camera) -> float | None:
        """Return the time of capture: from the camera, otherwise the file's time of change; None if unknown."""
        if camera.time_s is not None:
            return camera.time_s
        try:
            return os.stat(path).st_mtime
        except OSError:
            return None

    def link(self, before: tuple[str, float | None], now: tuple[str, float | None]) -> Link | None:
        """Return the motion between two images, each a name without extension and a time; None if the log lacks it."""
        log = self._log(now[1])
        if log is None:
            return None
        links = log_links(log, *self._from_first([before, now]))
        return next((link for link in links if link.second == 2), None)

    def _log(self, time_s: float | None) -> Telemetry | None:
        return self.log if self.growing is None else self.growing.until(time_s)

    def _from_first(self, images: list[tuple[str, float | None]]) -> tuple[list[str], list[float | None]]:
        """Return names and times after those of the flight's first image: the time zone is that of the whole flight."""
        if self.first_s is None:
            self.first_s = images[0][1]
        return ["", *(name for name, _ in images)], [self.first_s, *(time_s for _, time_s in images)]


def open_cameras(table: str | None, log: str | None, is_ended: bool, is_strict: bool) -> Cameras:
    """Return the cameras of the command line's table and log.

    Args:
        table: Path of a camera table; None without one.
        log: Path of a flight log; None without one.
        is_ended: No program writes to table and log any more.
        is_strict: Refuse unusable files. Otherwise log the problem and continue without them.

    Raises:
        ParameterError: A file can't be used.
    """
    cameras = Cameras()
    try:
        if table:
            name = os.path.basename(table)
            cameras.table = TableOfImages(table, check_cameras, lambda row, _: row_camera(row, name), is_ended)
            if is_strict:
                cameras.table.check()
        if log:
            if not is_ended and is_growing_log(log):
                cameras.growing = GrowingLog(log)
            else:
                cameras.log = read_log(log)
    except ParameterError as error:
        if is_strict:
            raise
        log_event(logging.ERROR, "log_not_used", reason=str(error))
    return cameras
