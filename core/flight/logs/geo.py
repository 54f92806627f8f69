"""Read OpenDroneMap's ``geo.txt``, one line for each image. The reader uses the yaw and ignores the positions."""

from __future__ import annotations

import re
from array import array
from typing import Callable

import numpy as np

from ...tables import stem_of
from ..telemetry import FIELDS, Telemetry, telemetry
from .entries import Pace, never

_CRS = re.compile(r"EPSG:\d+|\+proj|WGS84|PROJCS|GEOGCS", re.IGNORECASE)


def is_geo(text: str) -> bool:
    """Return whether a text begins with a coordinate reference system, as ``geo.txt`` does."""
    return _CRS.match(text.lstrip("\ufeff \t\r\n")) is not None


def read_geo(text: str, canceled: Callable[[], bool] = never) -> Telemetry:
    """Return headings by image name, from lines with image, x, y, z and yaw.

    Args:
        text: Of the file; lines without a yaw are ignored.
        canceled: Called from time to time; True ends the reading early.
    """
    names: list[str] = []
    yaws, pace = array("d"), Pace(canceled)
    for number, line in enumerate(text.splitlines()[1:]):
        if pace.stops_at(number):
            break
        cells = line.split()
        if len(cells) < 5 or line.lstrip().startswith("#") or stem_of(cells[0]) in names[-1:]:
            continue
        try:
            yaw = float(cells[4])
        except ValueError:
            yaw = float("nan")
        names.append(stem_of(cells[0]))
        yaws.append(yaw)
    values = np.full((len(names), len(FIELDS)), np.nan)
    values[:, FIELDS.index("heading")] = yaws
    return telemetry(np.arange(len(names)), values, images=names)
