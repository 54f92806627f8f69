"""A ground station's log that grows during the flight: its entries up to the time of an image."""

from __future__ import annotations

import errno
import logging
import math
import os
import stat
import time
from dataclasses import replace

from .. import limits
from ..errors import reason_of
from ..flight.logs.mavlink import TlogReader, is_tlog
from ..flight.telemetry import MOST_GAP_S, Telemetry
from ..labels.image_files import open_at_once
from ..tables import bytes_of
from .log import log_event
from .tables import LOOK_EVERY_S, ROW_WITHIN_S

_PIECE_BYTES = 4 << 20
_HEAD_BYTES = 1024
"""Enough for some packets of any kind."""


class GrowingLog:
    """Reads what was added to a ``.tlog`` since the last call; its memory does not grow with the log."""

    def __init__(self, path: str) -> None:
        self.path = path
        self._reader, self._place, self._fails = TlogReader(), 0, False
        self._keeps_up = True
        self._telemetry = self._reader.telemetry()

    def until(self, time_s: float | None) -> Telemetry:
        """Return the entries so far; waits for them as long as the log keeps up with the images.

        Args:
            time_s: Of an image, on the camera's clock; None if unknown.
        """
        end = time.monotonic() + (ROW_WITHIN_S if self._keeps_up and time_s is not None else 0.0)
        while True:
            self._look()
            now = time.time()
            found = replace(self._telemetry, until_s=now)
            self._keeps_up = time_s is None or self._reaches(found, time_s + found.zone([time_s]))
            if self._keeps_up or time.monotonic() >= end:
                return found
            time.sleep(LOOK_EVERY_S)

    @staticmethod
    def _reaches(found: Telemetry, moment_s: float) -> bool:
        """Return whether later entries can't affect a time any more."""
        last = found.times_s[-1] if len(found.times_s) else -math.inf
        return last >= moment_s or moment_s - last > MOST_GAP_S and found.until_s - moment_s > MOST_GAP_S

    def _look(self) -> None:
        """Read new entries; an unreadable file is logged once."""
        try:
            is_new = False
            status = os.stat(self.path)
            if not stat.S_ISREG(status.st_mode):
                raise OSError(errno.ESPIPE, os.strerror(errno.ESPIPE))
            if status.st_size < self._place:
                # The file was written again.
                self._reader, self._place, is_new = TlogReader(), 0, True
            with open(self.path, "rb", opener=open_at_once) as file:
                while True:
                    file.seek(self._place)
                    piece = file.read(_PIECE_BYTES)
                    taken = self._reader.take(piece)
                    self._place += taken
                    is_new = is_new or taken > 0
                    if len(piece) < _PIECE_BYTES or taken == 0:
                        break
            if is_new:
                self._telemetry = self._reader.telemetry()
            self._fails = False
        except OSError as error:
            if not self._fails:
                log_event(logging.ERROR, "log_fails", path=self.path, reason=reason_of(error))
            self._fails = True


def is_growing_log(path: str) -> bool:
    """Return whether a file is a log that can be read while it grows; raises ParameterError if it can't be read."""
    return is_tlog(bytes_of(path, limits.LOG_BYTES, _HEAD_BYTES))
