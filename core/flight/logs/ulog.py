"""Read PX4's log (``.ulg``), a format with self-describing topics.

Format: https://docs.px4.io/main/en/dev_log/ulog_file_format.html. The reader uses ``vehicle_attitude``, velocity and
height of ``vehicle_local_position`` and, only for the clock, satellite time.
"""

from __future__ import annotations

import math
import struct
from typing import Callable

from ..telemetry import Telemetry
from .entries import Data, Entries, Pace, never

MAGIC = b"ULog\x01\x12\x35"
_HEADER, _MESSAGE = 16, struct.Struct("<HB")
_KINDS = {
    "int8_t": "b",
    "uint8_t": "B",
    "int16_t": "h",
    "uint16_t": "H",
    "int32_t": "i",
    "uint32_t": "I",
    "int64_t": "q",
    "uint64_t": "Q",
    "float": "f",
    "double": "d",
    "bool": "?",
    "char": "c",
}
_CLOCKS = ("vehicle_gps_position", "sensor_gps")
_WANTED = {"vehicle_attitude", "vehicle_local_position", *_CLOCKS}
_READ = {"timestamp", "q", "vx", "vy", "z", "time_utc_usec"}
_MOST_FIELDS = 300
_MOST_BYTES = 0xFFFF
"""Largest size of a message, which has 16 bits. A larger topic can't be logged."""

Topic = tuple[struct.Struct, dict[str, int]]
"""Layout of an entry, and the position of the first number of each field in _READ."""


def read_ulog(data: Data, canceled: Callable[[], bool] = never) -> Telemetry:
    """Return the entries of a log, in UTC if it contains satellite time.

    Args:
        data: Of the file; damaged parts are skipped.
    """
    topics: dict[str, Topic] = {}
    wanted: dict[int, str] = {}
    entries, pace, place = Entries(), Pace(canceled), _HEADER
    while place + _MESSAGE.size <= len(data) and not pace.stops_at(place):
        size, kind = _MESSAGE.unpack_from(data, place)
        content = data[place + _MESSAGE.size : place + _MESSAGE.size + size]
        place += _MESSAGE.size + size
        if kind == ord("F"):
            _describe(content, topics)
        elif kind == ord("A") and len(content) > 3 and content[0] == 0:
            name = content[3:].decode("ascii", "replace")
            if name in topics:
                wanted[int.from_bytes(content[1:3], "little")] = name
        elif kind == ord("D") and len(content) > 2:
            name = wanted.get(int.from_bytes(content[:2], "little"), "")
            packed, fields = topics.get(name, (struct.Struct(""), {}))
            if name and len(content) - 2 >= packed.size:
                values = packed.unpack_from(content, 2)
                _take(entries, name, {field: values[at : at + 4] for field, at in fields.items()})
    return entries.telemetry()


def _describe(content: bytes, topics: dict[str, Topic]) -> None:
    """Store the layout of a needed topic; a topic with fields of other topics is skipped."""
    name, _, fields = content.decode("ascii", "replace").partition(":")
    parts = [part.rsplit(" ", 1) for part in fields.split(";") if part]
    if name not in _WANTED or len(parts) > _MOST_FIELDS:
        return
    letters, places, count = [], {}, 0
    # The last field's padding is not written.
    while parts and parts[-1][-1].startswith("_padding"):
        parts.pop()
    for kind, *label in parts:
        base, _, many = kind.partition("[")
        number = many.rstrip("]") or "1"
        if base not in _KINDS or not label or not (number.isascii() and number.isdigit() and 0 < int(number) < 10_000):
            return
        if label[0] in _READ:
            places[label[0]] = count
        letters.append(f"{int(number)}{_KINDS[base]}")
        count += int(number)
    packed = struct.Struct("<" + "".join(letters))
    if packed.size <= _MOST_BYTES:
        topics[name] = packed, places


def _take(entries: Entries, name: str, values: dict[str, tuple[float, ...]]) -> None:
    if "timestamp" not in values:
        return
    time_s = values["timestamp"][0] / 1e6
    if name == "vehicle_attitude" and "q" in values:
        roll, pitch, heading = angles_of(*values["q"])
        entries.add(time_s, roll=roll, pitch=pitch, heading=heading)
    elif name == "vehicle_local_position" and {"vx", "vy", "z"} <= set(values):
        entries.add(time_s, north=values["vx"][0], east=values["vy"][0], height=-values["z"][0])
    elif name in _CLOCKS and entries.start_s is None and values.get("time_utc_usec", (0,))[0] > 0:
        entries.start_s = values["time_utc_usec"][0] / 1e6 - time_s


def angles_of(w: float, x: float, y: float, z: float) -> tuple[float, float, float]:
    """Return roll, pitch and heading in degrees of a quaternion from the aircraft's axes to north, east, down."""
    roll = math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
    pitch = math.asin(min(1.0, max(-1.0, 2 * (w * y - z * x))))
    heading = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    return math.degrees(roll), math.degrees(pitch), math.degrees(heading)
