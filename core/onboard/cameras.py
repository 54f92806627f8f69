"""The cameras of images on board: by a table, by their photos, by a flight's log, as in QGIS."""

from __future__ import annotations

import logging
import os
from dataclasses import dataclass

from ..errors import ParameterError
from ..flight.cameras import check_cameras, complete_camera, merge_camera, row_camera
from ..flight.logs.files import read_log
from ..flight.motion import Link
from ..flight.table import stem_of
from ..flight.telemetry import Telemetry, log_cameras, log_links
from ..geometry.camera import Camera
from ..labels.photo_camera import photo_camera
from .log import log_event
from .logs import GrowingLog, is_growing_log
from .tables import TableOfImages


@dataclass
class Cameras:
    """Tells each image's camera.

    Attributes:
        table: The camera table; None without one.
        log: The flight's log; None without one, or where it grows.
        growing: The flight's log that is written while it flies; None without one.
        first_s: Time of the first image on the cameras' clock, by which the log's is found; None before it.
    """

    table: TableOfImages[Camera] | None = None
    log: Telemetry | None = None
    growing: GrowingLog | None = None
    first_s: float | None = None

    def of(self, path: str) -> Camera:
        """The camera of an image."""
        name, photo = stem_of(path), photo_camera(path)
        row = None if self.table is None else self.table.of(name)
        camera = photo if row is None else merge_camera(row, photo, row.time_s is not None)
        moment = name, self.time_s(path, camera)
        log = self._log(moment[1])
        if log is None:
            return camera
        told = log_cameras(log, *self._asked([moment]))[-1]
        return complete_camera(camera, told, with_attitude=True)

    def time_s(self, path: str, camera: Camera) -> float | None:
        """When an image was taken: as its camera tells, else when it was written; None where nobody can tell."""
        if camera.time_s is not None:
            return camera.time_s
        try:
            return os.stat(path).st_mtime
        except OSError:
            return None

    def link(self, before: tuple[str, float | None], now: tuple[str, float | None]) -> Link | None:
        """Between two images, each by its name without extension and its time; None where the log doesn't tell it."""
        log = self._log(now[1])
        if log is None:
            return None
        links = log_links(log, *self._asked([before, now]))
        return next((link for link in links if link.second == 2), None)

    def _log(self, time_s: float | None) -> Telemetry | None:
        return self.log if self.growing is None else self.growing.until(time_s)

    def _asked(self, images: list[tuple[str, float | None]]) -> tuple[list[str], list[float | None]]:
        """Names and times, the flight's first one before them: a zone is that of the whole flight."""
        if self.first_s is None:
            self.first_s = images[0][1]
        return ["", *(name for name, _ in images)], [self.first_s, *(time_s for _, time_s in images)]


def open_cameras(table: str | None, log: str | None, is_ended: bool, is_strict: bool) -> Cameras:
    """Cameras by what a command line names.

    Args:
        table: Path of a camera table; None for none.
        log: Path of a flight's log; None for none.
        is_ended: Nobody writes table and log any more.
        is_strict: What can't be used is refused; else it is told in the log and done without.

    Raises:
        ParameterError: Something can't be used.
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
