"""Read ArduPilot's onboard log (``.bin``, “DataFlash”), a format with self-describing messages.

Format: https://ardupilot.org/dev/docs/code-overview-adding-a-new-log-message.html. The reader uses attitude (ATT), the
filter's velocity (XKF1, NKF1), height above home (POS) and, only for the clock, satellite time (GPS).
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Callable

from ..telemetry import Telemetry
from .entries import GPS_EPOCH_S, LEAP_SECONDS, LOOK_EVERY, Data, Entries, Pace, never

MAGIC = b"\xa3\x95"
_FORMAT_TYPE, _FORMAT = 128, struct.Struct("<BB4s16s64s")
_KINDS = {
    **dict(zip("bBhHiIfdqQ", "bBhHiIfdqQ")),
    **dict(zip("anNZMLcCeE", ("64s", "4s", "16s", "64s", "B", "i", "h", "H", "i", "I"))),
}
_HUNDREDTHS = "cCeE"
_WANTED = {"ATT", "XKF1", "NKF1", "POS", "GPS"}
_WEEK_S = 604_800


@dataclass(frozen=True)
class _Message:
    name: str
    packed: struct.Struct
    kinds: str
    labels: tuple[str, ...]

    def values(self, data: Data, place: int) -> dict[str, float]:
        numbers = zip(self.labels, self.kinds, self.packed.unpack_from(data, place))
        return {
            label: value / 100 if kind in _HUNDREDTHS else value
            for label, kind, value in numbers
            if isinstance(value, (int, float))
        }


def read_dataflash(data: Data, canceled: Callable[[], bool] = never) -> Telemetry:
    """Return the entries of a log, in UTC if it contains satellite time.

    Args:
        data: Of the file; damaged parts are skipped.
    """
    lengths: dict[int, int] = {_FORMAT_TYPE: 3 + _FORMAT.size}
    wanted: dict[int, _Message] = {}
    entries, pace, place = Entries(), Pace(canceled), 0
    while place + 3 <= len(data) and not pace.stops_at(place):
        kind = data[place + 2]
        length = lengths.get(kind)
        if data[place : place + 2] != MAGIC or length is None:
            found = data.find(MAGIC, place + 1, place + LOOK_EVERY)
            place = found if found >= 0 else place + LOOK_EVERY - 1
            continue
        if place + length > len(data):
            break
        if kind == _FORMAT_TYPE:
            _describe(data, place + 3, lengths, wanted)
        elif kind in wanted:
            _take(entries, wanted[kind].name, wanted[kind].values(data, place + 3))
        place += length
    return entries.telemetry()


def _describe(data: Data, place: int, lengths: dict[int, int], wanted: dict[int, _Message]) -> None:
    """Store the layout of a kind of message; an inconsistent one is only skipped."""
    kind, length, name, kinds, labels = _FORMAT.unpack_from(data, place)
    if length < 3 or kind == _FORMAT_TYPE:
        return
    lengths[kind] = length
    texts = [part.split(b"\0")[0].decode("ascii", "replace") for part in (name, kinds, labels)]
    if texts[0] in _WANTED and set(texts[1]) <= set(_KINDS):
        packed = struct.Struct("<" + "".join(_KINDS[letter] for letter in texts[1]))
        if packed.size == length - 3:
            wanted[kind] = _Message(texts[0], packed, texts[1], tuple(texts[2].split(",")))


def _take(entries: Entries, name: str, values: dict[str, float]) -> None:
    time_s = values.get("TimeUS", -1.0) / 1e6
    if time_s < 0 or values.get("C", 0) != 0:
        # The first of several filters counts.
        return
    if name == "ATT" and {"Roll", "Pitch", "Yaw"} <= set(values):
        entries.add(time_s, roll=values["Roll"], pitch=values["Pitch"], heading=values["Yaw"])
    elif name in ("XKF1", "NKF1") and {"VN", "VE"} <= set(values):
        entries.add(time_s, east=values["VE"], north=values["VN"])
    elif name == "POS" and "RelHomeAlt" in values:
        entries.add(time_s, height=values["RelHomeAlt"])
    elif name == "GPS" and entries.start_s is None and values.get("GWk", 0) > 0 and values.get("Status", 3) >= 3:
        seconds = values["GWk"] * _WEEK_S + values.get("GMS", 0) / 1000
        entries.start_s = GPS_EPOCH_S + seconds - LEAP_SECONDS - time_s
