"""Read logs that are text: DJI's subtitles (``.SRT``) of a video, and OpenDroneMap's ``geo.txt``.

The subtitles have one entry for each time of the video, ``geo.txt`` one line for each image. Their positions are not
used.
"""

from __future__ import annotations

import re
from array import array
from typing import Callable

import numpy as np

from ...tables import stem_of
from ..telemetry import FIELDS, Telemetry, telemetry
from .entries import Entries, Pace, never

_ARROW, _LONGEST_TIME, _LONGEST_BLOCK = "-->", 32, 4000
_TIME = re.compile(r"(\d{1,3}):(\d{2}):(\d{2})[,.](\d{1,3})\s{0,9}$")
# Bounded, and no two parts take the same character: the search is linear in the text.
_NUMBER = r"\s{0,9}(?:[:(]\s{0,9})?([-+]?\d{1,6}(?:\.\d{0,9})?)"
_KEYS = {
    "heading": re.compile(r"\bgb_yaw" + _NUMBER, re.IGNORECASE),
    "roll": re.compile(r"\bgb_roll" + _NUMBER, re.IGNORECASE),
    "pitch": re.compile(r"\bgb_pitch" + _NUMBER, re.IGNORECASE),
    "height": re.compile(r"(?:\brel_alt|\bBAROMETER|,\s{0,9}H(?=\s))" + _NUMBER, re.IGNORECASE),
}


def is_srt(text: str) -> bool:
    """Return whether a text begins as subtitles do."""
    arrow = text.find(_ARROW, 0, 200)
    return arrow >= 0 and _time_before(text, arrow) is not None


def read_srt(text: str, canceled: Callable[[], bool] = never) -> Telemetry:
    """Return entries by the video's time.

    Args:
        text: Of the file; unreadable values count as missing.
    """
    entries, pace, arrow = Entries(), Pace(canceled), text.find(_ARROW)
    while arrow >= 0 and not pace.stops_at(arrow):
        start, time_s = arrow + len(_ARROW), _time_before(text, arrow)
        arrow = text.find(_ARROW, start)
        if time_s is not None:
            # A subtitle has 500 characters.
            block = text[start : min(arrow if arrow >= 0 else len(text), start + _LONGEST_BLOCK)]
            found = {name: key.search(block) for name, key in _KEYS.items()}
            entries.add(time_s, **{name: float(match[1]) for name, match in found.items() if match})
    return entries.telemetry(is_gimbal=True)


def _time_before(text: str, arrow: int) -> float | None:
    """Return the seconds of the time that ends at an arrow; None without one."""
    found = _TIME.search(text, max(0, arrow - _LONGEST_TIME), arrow)
    if found is None:
        return None
    hours, minutes, seconds, fraction = found.groups()
    return int(hours) * 3600 + int(minutes) * 60 + int(seconds) + float(f"0.{fraction}")


_CRS = re.compile(r"EPSG:\d+|\+proj|WGS84|PROJCS|GEOGCS", re.IGNORECASE)


def is_geo(text: str) -> bool:
    """Return whether a text begins with a coordinate reference system, as ``geo.txt`` does."""
    return _CRS.match(text.lstrip("\ufeff \t\r\n")) is not None


def read_geo(text: str, canceled: Callable[[], bool] = never) -> Telemetry:
    """Return headings by image name, from lines with image, x, y, z and yaw.

    Args:
        text: Of the file; lines without a yaw are ignored.
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
