"""DJI's subtitles (``.SRT``), one entry for each moment of a video, as drones of several generations write them."""

from __future__ import annotations

import re

from ..telemetry import FIELDS, Telemetry, telemetry

_TIMES = re.compile(r"(\d{1,3}):(\d{2}):(\d{2})[,.](\d{1,3})\s*-->")
_NUMBER = r"\s*[:(]?\s*([-+]?\d{1,6}(?:\.\d{0,9})?)"
_KEYS = {
    "heading": re.compile(r"\bgb_yaw" + _NUMBER, re.IGNORECASE),
    "roll": re.compile(r"\bgb_roll" + _NUMBER, re.IGNORECASE),
    "pitch": re.compile(r"\bgb_pitch" + _NUMBER, re.IGNORECASE),
    "height": re.compile(r"(?:\brel_alt|\bBAROMETER|,\s*H(?=\s))" + _NUMBER, re.IGNORECASE),
}


def is_srt(text: str) -> bool:
    """Whether a text begins as subtitles do."""
    return _TIMES.search(text[:200]) is not None


def read_srt(text: str) -> Telemetry:
    """Entries by the video's time.

    Args:
        text: Of the file; what can't be read in it counts as not told.
    """
    starts = list(_TIMES.finditer(text))
    times, rows = [], []
    for number, start in enumerate(starts):
        hours, minutes, seconds, fraction = start.groups()
        end = starts[number + 1].start() if number + 1 < len(starts) else len(text)
        # A subtitle has 500 characters.
        block = text[start.end() : min(end, start.end() + 4000)]
        times.append(int(hours) * 3600 + int(minutes) * 60 + int(seconds) + float(f"0.{fraction}"))
        found = {name: key.search(block) for name, key in _KEYS.items()}
        rows.append([float(match.group(1)) if (match := found.get(name)) else float("nan") for name in FIELDS])
    return telemetry(times, rows, is_gimbal=True)
