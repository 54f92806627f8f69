"""Telemetry logs of ground stations (``.tlog``): MAVLink packets of version 1 and 2, each after its time.

Format: https://mavlink.io/en/guide/serialization.html. Read are ATTITUDE, GLOBAL_POSITION_INT (height above home and
velocity, not the position) and the velocity of LOCAL_POSITION_NED, of the first system that tells an attitude.
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
"""How a message's content is packed, and the byte that its checksum ends with."""

_SIGNED, _SIGNATURE = 1, 13
_TIME = 8
_STARTS = re.compile(rb"[\xfd\xfe]")
_REVERSED = bytes(int(f"{byte:08b}"[::-1], 2) for byte in range(256))
"""Each byte with its bits in reverse order."""


def is_tlog(data: Data) -> bool:
    """Whether the first packet is whole, and what comes next begins as one; data may end anywhere after the first."""
    size = _size(data, _TIME)
    after = 2 * _TIME + size
    return size > 0 and (len(data) <= after or _wanted_size(data, after) > 0)


def read_tlog(data: Data, canceled: Callable[[], bool] = never) -> Telemetry:
    """Entries of a log, in UTC.

    Args:
        data: Of the file; what is damaged is passed over.
        canceled: Asked now and then; once it returns True, reading ends early.
    """
    reader = TlogReader()
    reader.take(data, is_ended=True, canceled=canceled)
    return reader.telemetry()


class TlogReader:
    """Reads a log piece by piece, as it grows."""

    def __init__(self) -> None:
        self._entries = Entries(start_s=0.0)
        self._system: int | None = None

    def take(self, data: Data, is_ended: bool = False, canceled: Callable[[], bool] = never) -> int:
        """Reads one more piece.

        Args:
            data: It; what is damaged is passed over.
            is_ended: Nothing comes after it.
            canceled: Asked now and then; once it returns True, reading ends early.

        Returns:
            Where in it the first packet begins that is not whole; the next piece begins there.
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
        """What was read so far."""
        return self._entries.telemetry()


def _next_start(data: Data, place: int) -> int:
    """Return the place after ``place`` at which the next packet may begin; at most LOOK_EVERY bytes are searched."""
    first = place + _TIME + 1
    found = _STARTS.search(data, first, first + LOOK_EVERY)
    return (min(first + LOOK_EVERY, len(data)) if found is None else found.start()) - _TIME


def _size(data: Data, place: int) -> int:
    """Bytes of the packet that begins there; 0 where none does, or not all of it is there."""
    size = _wanted_size(data, place)
    return size if place + size <= len(data) else 0


def _wanted_size(data: Data, place: int) -> int:
    """Bytes of the packet that begins there, as far as its beginning tells; 0 where none does."""
    if place >= len(data) or data[place] not in (0xFE, 0xFD):
        return 0
    if place + 3 > len(data):
        return 3
    if data[place] == 0xFE:
        return 8 + data[place + 1]
    return 12 + data[place + 1] + (_SIGNATURE if data[place + 2] & _SIGNED else 0)


def _packet(data: Data, place: int, size: int) -> tuple[int, int, bytes, bool]:
    """System, kind and content of a packet, and whether its checksum holds."""
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
    """MAVLink's checksum: CRC-16/MCRF4XX."""
    # Python's CRC-16 takes the same bits in the other order.
    total = binascii.crc_hqx(content.translate(_REVERSED), 0xFFFF)
    return _REVERSED[total & 0xFF] << 8 | _REVERSED[total >> 8]


def _take(entries: Entries, time_s: float, kind: int, told: tuple[float, ...]) -> None:
    if kind == _ATTITUDE:
        roll, pitch, yaw = (math.degrees(angle) for angle in told[1:4])
        entries.add(time_s, roll=roll, pitch=pitch, heading=yaw)
    elif kind == _LOCAL:
        entries.add(time_s, north=told[4], east=told[5])
    else:
        entries.add(time_s, height=told[4] / 1000, north=told[5] / 100, east=told[6] / 100)
