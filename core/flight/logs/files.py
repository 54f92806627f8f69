"""Read a flight log of any supported kind, identified by its content and not by its name."""

from __future__ import annotations

import mmap
from typing import Callable

import numpy as np

from ... import limits
from ...errors import ParameterError
from ...tables import bytes_of
from ..telemetry import Telemetry
from .dataflash import MAGIC as DATAFLASH
from .dataflash import read_dataflash
from .entries import never
from .mavlink import is_tlog, read_tlog
from .texts import is_geo, is_srt, read_geo, read_srt
from .ulog import MAGIC as ULOG
from .ulog import read_ulog

KINDS = ("DJI .SRT", "geo.txt", "ArduPilot .bin", ".tlog", "PX4 .ulg")


def read_log(path: str, canceled: Callable[[], bool] = never) -> Telemetry:
    """Return the entries of a flight log.

    Args:
        canceled: Called several times a second; True ends the reading early.

    Raises:
        ParameterError: The file can't be read, is not a supported log, or contains no flight data.
    """
    # A first byte shows whether the file can be read at all.
    if len(bytes_of(path, limits.LOG_BYTES, 1)) == 0:
        found = None
    else:
        with open(path, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
            found = _read(data, canceled)
    if found is None:
        raise ParameterError("{path} is not a supported flight log. Supported are {kinds}.", path=path, kinds=KINDS)
    if not np.isfinite(found.values).any():
        raise ParameterError("{path} contains no heading, height or speed of a flight.", path=path)
    return found


def _read(data: mmap.mmap, canceled: Callable[[], bool]) -> Telemetry | None:
    if data[: len(ULOG)] == ULOG:
        return read_ulog(data, canceled)
    if data[: len(DATAFLASH)] == DATAFLASH:
        return read_dataflash(data, canceled)
    if is_tlog(data):
        return read_tlog(data, canceled)
    if len(data) > limits.TABLE_BYTES:
        return None
    text = data[:].decode("utf-8-sig", "replace")
    if is_srt(text):
        return read_srt(text, canceled)
    return read_geo(text, canceled) if is_geo(text) else None
