"""What a TIFF says of itself in its tags, GeoTIFF's included: read without GDAL, for computers that have no QGIS."""

from __future__ import annotations

import os
import struct
from math import cos, hypot, radians, sin
from typing import BinaryIO

ORDERS = {b"II*\0": "<", b"MM\0*": ">"}
"""Byte order of a TIFF by its first four bytes."""

_SIZES_AND_CODES = {1: (1, "B"), 2: (1, "s"), 3: (2, "H"), 4: (4, "I"), 5: (8, "I"), 7: (1, "s"), 12: (8, "d")}
"""Bytes and code for ``struct`` of the kinds of values that are read: byte, text, short, long, rational (two longs),
anything, double."""

_RATIONAL, _BYTE_KINDS = 5, (1, 2, 7)

WIDTH, HEIGHT, PHOTOMETRIC, BITS, EXTRA_SAMPLES, NODATA = 256, 257, 262, 258, 338, 42113
_PIXEL_SCALE, _TIE_POINT, _TRANSFORMATION, _GEO_KEYS = 33550, 33922, 34264, 34735
_MODEL_TYPE_KEY, _PROJECTED, _GEOGRAPHIC = 1024, 1, 2
_LINEAR_UNITS_KEY, _ANGULAR_UNITS_KEY, _DEGREE = 3076, 2054, 9102
_METERS_PER_UNIT = {9001: 1.0, 9002: 0.3048, 9003: 1200 / 3937}
"""By the code of a linear unit: meter, foot, US survey foot."""

_EQUATOR_RADIUS_M, _ECCENTRICITY_SQUARED = 6378137.0, 0.0066943799901413165
"""Of WGS 84's ellipsoid."""


class FileSlices:
    """Slices of an open file, each read when it is asked for.

    If another program truncates a mapped file, the process that reads it is killed; here a slice ends early.
    """

    def __init__(self, file: BinaryIO) -> None:
        """Read nothing yet."""
        self._file, self._size = file, os.fstat(file.fileno()).st_size

    def __len__(self) -> int:
        """Return the size of the file, bytes."""
        return self._size

    def __getitem__(self, where: slice) -> bytes:
        """Return a slice between two places."""
        start, stop, _ = where.indices(self._size)
        self._file.seek(start)
        return self._file.read(max(stop - start, 0))


class TiffTags:
    """The tags of one directory of a TIFF, of the first image unless told otherwise.

    Attributes:
        order: ``struct``'s sign of the byte order.
        entries: By tag, (kind, number of values, where its value or the place of its values stands).
    """

    def __init__(self, data: bytes | FileSlices, first: int | None = None) -> None:
        """Reads a directory; raises struct.error where the file is cut short and KeyError for no TIFF.

        Args:
            data: The whole file, or its slices.
            first: Where the directory stands; None for the first image's.
        """
        self._data = data
        self.order = ORDERS[data[:4]]
        if first is None:
            (first,) = self._numbers("I", 4)
        (count,) = self._numbers("H", first)
        self.entries: dict[int, tuple[int, int, int]] = {}
        for place in range(first + 2, first + 2 + 12 * count, 12):
            tag, kind, length = self._numbers("HHI", place)
            self.entries[tag] = kind, length, place + 8

    def values(self, tag: int) -> tuple:
        """The values of a tag, a text as one bytes; () where it is missing or of a kind not known here."""
        kind, length, place = self.entries.get(tag, (0, 0, 0))
        if kind not in _SIZES_AND_CODES:
            return ()
        size, code = _SIZES_AND_CODES[kind]
        if size * length > 4:
            (place,) = self._numbers("I", place)
        if size * length > len(self._data):
            raise struct.error("longer than the file")
        count = 2 * length if kind == _RATIONAL else length
        return self._numbers(f"{count}{code}", place)

    def _numbers(self, codes: str, place: int) -> tuple:
        """Unpack what is stored at a place; raises struct.error behind the end."""
        codes = self.order + codes
        return struct.unpack(codes, self._data[place : place + struct.calcsize(codes)])

    def is_rational(self, tag: int) -> bool:
        """Whether a tag's values come as numerator and denominator, two each."""
        return self.entries.get(tag, (0,))[0] == _RATIONAL

    def bytes_of(self, tag: int, most: int) -> bytes:
        """At most so many bytes of a tag that holds bytes or text; none where it is missing or of another kind."""
        kind, length, place = self.entries.get(tag, (0, 0, 0))
        if kind not in _BYTE_KINDS:
            return b""
        if length > 4:
            (place,) = self._numbers("I", place)
        return self._data[place : place + min(length, most)]

    def nodata(self) -> float | None:
        """GDAL's nodata value, None without one."""
        found = self.values(NODATA)
        try:
            return float(found[0].rstrip(b"\0 ")) if found else None
        except (AttributeError, ValueError):
            return None


def pixel_size_m(tags: TiffTags, shape_hw: tuple[int, int]) -> tuple[float, float] | None:
    """Ground meters along a row and along a column of a pixel of a GeoTIFF, as QGIS measures them in its middle.

    Degrees are measured on WGS 84's ellipsoid. None where the file itself has no georeference, does not say what its
    CRS is, or where that measures in another unit than meters, feet and degrees. Raises struct.error for damaged tags.

    Args:
        tags: Those of the file.
        shape_hw: (height, width) of the image.
    """
    transform, keys = _geotransform(tags), _geo_keys(tags)
    if transform is None:
        return None
    x_column, x_row, y_column, y_row, top = transform
    kind = keys.get(_MODEL_TYPE_KEY)
    if kind == _PROJECTED:
        unit = _METERS_PER_UNIT.get(keys.get(_LINEAR_UNITS_KEY, 9001))
        return None if unit is None else (unit * hypot(x_column, y_column), unit * hypot(x_row, y_row))
    if kind == _GEOGRAPHIC and keys.get(_ANGULAR_UNITS_KEY, _DEGREE) == _DEGREE:
        latitude = top + y_column * shape_hw[1] / 2 + y_row * shape_hw[0] / 2
        east, north = _meters_per_degree(latitude)
        return hypot(east * x_column, north * y_column), hypot(east * x_row, north * y_row)
    return None


def _geotransform(tags: TiffTags) -> tuple[float, float, float, float, float] | None:
    """Map units that x and y grow by a column and by a row, and y of the upper left corner; None without any."""
    matrix = tags.values(_TRANSFORMATION)
    if len(matrix) == 16:
        return matrix[0], matrix[1], matrix[4], matrix[5], matrix[7]
    scale, tie = tags.values(_PIXEL_SCALE), tags.values(_TIE_POINT)
    if len(scale) < 2 or len(tie) < 6 or not scale[0] or not scale[1]:
        return None
    return scale[0], 0.0, 0.0, -scale[1], tie[4] + tie[1] * scale[1]


def _geo_keys(tags: TiffTags) -> dict[int, int]:
    """GeoTIFF's keys whose value is a single number."""
    found = tags.values(_GEO_KEYS)
    keys = (found[place : place + 4] for place in range(4, len(found) - 3, 4))
    return {key: value for key, where, _, value in keys if where == 0}


def _meters_per_degree(latitude_deg: float) -> tuple[float, float]:
    """Of longitude and of latitude."""
    flattened = 1 - _ECCENTRICITY_SQUARED * sin(radians(latitude_deg)) ** 2
    east = _EQUATOR_RADIUS_M / flattened**0.5 * cos(radians(latitude_deg))
    north = _EQUATOR_RADIUS_M * (1 - _ECCENTRICITY_SQUARED) / flattened**1.5
    return radians(east), radians(north)
