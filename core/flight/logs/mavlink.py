"""Read telemetry logs of ground stations (``.tlog``): MAVLink packets of versions 1 and 2, each after its time.

Format: https://mavlink.io/en/guide/serialization.html. The reader uses ATTITUDE, GLOBAL_POSITION_INT (height above home
and velocity, not the position) and the velocity of LOCAL_POSITION_NED, from the first system with an attitude.
"""

from __future__ import annotations

import binascii
import math
import re
import struct
from typing import Callable

from ..telemetry import Telemetry
from .entries import LOOK_EVERY, Data, Entries, Pace, never

_ATTITUDE, _LOCAL, _GLOBAL = 30, 32, 33
_PACKED = {
    _ATTITUDE: (struct.Struct("<I6f"), 39),
    _LOCAL: (struct.Struct("<I6f"), 185),
    _GLOBAL: (struct.Struct("<Iiiii3hH"), 104),
}
"""Layout of a message's content, and the extra byte of its checksum."""

_SIGNED, _SIGNATURE = 1, 13
_TIME = 8
_STARTS = re.compile(rb"[\xfd\xfe]")
_REVERSED = bytes(int(f"{byte:08b}"[::-1], 2) for byte in range(256))
"""Each byte with its bits in reverse order."""


def is_tlog(data: Data) -> bool:
    """Return whether the first packet is complete and the next one begins as a packet; data may end after the first."""
    size = _size(data, _TIME)
    after = 2 * _TIME + size
    return size > 0 and (len(data) <= after or _wanted_size(data, after) > 0)


def read_tlog(data: Data, canceled: Callable[[], bool] = never) -> Telemetry:
    """Return the entries of a log, in UTC.

    Args:
        data: Of the file; damaged parts are skipped.
    """
    reader = TlogReader()
    reader.take(data, is_ended=True, canceled=canceled)
    return reader.telemetry()


class TlogReader:
    """Reads a log in pieces while it grows."""

    def __init__(self) -> None:
        self._entries = Entries(start_s=0.0)
        self._system: int | None = None

    def take(self, data: Data, is_ended: bool = False, canceled: Callable[[], bool] = never) -> int:
        """Read one more piece.

        Args:
            data: The piece; damaged parts are skipped.
            is_ended: No piece comes after it.

        Returns:
            Offset of the first incomplete packet, at which the next piece must begin.
        """
        pace, place = Pace(canceled), 0
        while place + _TIME < len(data) and not pace.stops_at(place):
            size = _size(data, place + _TIME)
            if size == 0:
                if not is_ended and _wanted_size(data, place + _TIME) > 0:
                    return place
                place = _next_start(data, place)
                continue
            sender, kind, content, is_whole = _packet(data, place + _TIME, size)
            if kind in _PACKED and not is_whole:
                place += 1
                continue
            if kind in _PACKED:
                self._take_packet(struct.unpack_from(">Q", data, place)[0] / 1e6, sender, kind, content)
            place += _TIME + size
        return place

    def _take_packet(self, time_s: float, sender: int, kind: int, content: bytes) -> None:
        if self._system is None and kind == _ATTITUDE:
            self._system = sender
        if self._system == sender:
            packed = _PACKED[kind][0]
            _take(self._entries, time_s, kind, packed.unpack(content[: packed.size].ljust(packed.size, b"\0")))

    def telemetry(self) -> Telemetry:
        """Return the entries so far."""
        return self._entries.telemetry()


def _next_start(data: Data, place: int) -> int:
    """Return the place after ``place`` at which the next packet may begin; at most LOOK_EVERY bytes are searched."""
    first = place + _TIME + 1
    found = _STARTS.search(data, first, first + LOOK_EVERY)
    return (min(first + LOOK_EVERY, len(data)) if found is None else found.start()) - _TIME


def _size(data: Data, place: int) -> int:
    """Return the bytes of the packet at a place; 0 without a complete packet."""
    size = _wanted_size(data, place)
    return size if place + size <= len(data) else 0


def _wanted_size(data: Data, place: int) -> int:
    """Return the bytes of the packet at a place, according to its beginning; 0 without a packet."""
    if place >= len(data) or data[place] not in (0xFE, 0xFD):
        return 0
    if place + 3 > len(data):
        return 3
    if data[place] == 0xFE:
        return 8 + data[place + 1]
    return 12 + data[place + 1] + (_SIGNATURE if data[place + 2] & _SIGNED else 0)


def _packet(data: Data, place: int, size: int) -> tuple[int, int, bytes, bool]:
    """Return system, kind and content of a packet, and whether its checksum is right."""
    length = data[place + 1]
    if data[place] == 0xFE:
        system, kind, start = data[place + 3], data[place + 5], place + 6
    else:
        system, kind, start = data[place + 5], int.from_bytes(data[place + 7 : place + 10], "little"), place + 10
    content = data[start : start + length]
    if kind not in _PACKED:
        return system, kind, content, True
    found = int.from_bytes(data[start + length : start + length + 2], "little")
    return system, kind, content, found == checksum(data[place + 1 : start + length] + bytes([_PACKED[kind][1]]))


def checksum(content: bytes) -> int:
    """Return MAVLink's checksum: CRC-16/MCRF4XX."""
    # Python's CRC-16 uses the same bits in reverse order.
    total = binascii.crc_hqx(content.translate(_REVERSED), 0xFFFF)
    return _REVERSED[total & 0xFF] << 8 | _REVERSED[total >> 8]


def _take(entries: Entries, time_s: float, kind: int, values: tuple[float, ...]) -> None:
    if kind == _ATTITUDE:
        roll, pitch, yaw = (math.degrees(angle) for angle in values[1:4])
        entries.add(time_s, roll=roll, pitch=pitch, heading=yaw)
    elif kind == _LOCAL:
        entries.add(time_s, north=values[4], east=values[5])
    else:
        entries.add(time_s, height=values[4] / 1000, north=values[5] / 100, east=values[6] / 100)
