"""OpenDroneMap's ``geo.txt``: a line for each image. Its yaw is taken; its positions are left alone."""

from __future__ import annotations

import re

from ..table import stem_of
from ..telemetry import FIELDS, Telemetry, telemetry

_CRS = re.compile(r"EPSG:\d+|\+proj|WGS84|PROJCS|GEOGCS", re.IGNORECASE)


def is_geo(text: str) -> bool:
    """Whether a text begins with a reference system, as ``geo.txt`` does."""
    return _CRS.match(text.lstrip("\ufeff \t\r\n")) is not None


def read_geo(text: str) -> Telemetry:
    """Headings by the image's name: of lines with image, x, y, z and yaw.

    Args:
        text: Of the file; lines without a yaw tell nothing.
    """
    names: list[str] = []
    rows = []
    for line in text.splitlines()[1:]:
        cells = line.split()
        if len(cells) < 5 or line.lstrip().startswith("#") or stem_of(cells[0]) in names[-1:]:
            continue
        try:
            yaw = float(cells[4])
        except ValueError:
            yaw = float("nan")
        names.append(stem_of(cells[0]))
        rows.append([yaw] + [float("nan")] * (len(FIELDS) - 1))
    return telemetry(range(len(names)), rows, images=names)
