"""Tags of a TIFF or of a photo's EXIF, including GeoTIFF's: read with Pillow, for computers without GDAL."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from math import cos, hypot, radians, sin
from typing import Any, BinaryIO

from PIL.TiffImagePlugin import ImageFileDirectory_v2

from .. import limits

STARTS = (b"II*\0", b"MM\0*", b"II+\0")
"""First bytes of a TIFF: of either byte order, or with 64-bit offsets."""

ORIENTATION, NODATA = 274, 42113
_BYTES_A_READ = 64
"""Bytes that each read counts for in addition, because it takes time."""

_PIXEL_SCALE, _TIE_POINT, _TRANSFORMATION, _GEO_KEYS = 33550, 33922, 34264, 34735
_MODEL_TYPE_KEY, _PROJECTED, _GEOGRAPHIC = 1024, 1, 2
_LINEAR_UNITS_KEY, _ANGULAR_UNITS_KEY, _DEGREE = 3076, 2054, 9102
_METERS_PER_UNIT = {9001: 1.0, 9002: 0.3048, 9003: 1200 / 3937}
"""By the code of a linear unit: meter, foot, US survey foot."""

_EQUATOR_RADIUS_M, _ECCENTRICITY_SQUARED = 6378137.0, 0.0066943799901413165
"""Of the ellipsoid of WGS 84."""

Tags = Mapping[int, Any]
"""The values of a directory by tag: a number, a text, bytes, or a tuple of numbers."""

# A damaged file would log a line for each of its tags; damaged tags count as missing.
warnings.filterwarnings("ignore", module=r"PIL\.TiffImagePlugin")


class BoundedFile:
    """A file for Pillow that ends after a number of read bytes, including repeated ones.

    Attributes:
        left: Bytes that may still be read.
    """

    def __init__(self, file: BinaryIO, left: float = limits.TAG_BYTES) -> None:
        self._file, self.left = file, left

    def read(self, size: int = -1) -> bytes:
        """Read like a file; return nothing once the limit is reached."""
        most = int(min(max(self.left, 0), 1 << 62))
        data = self._file.read(size if 0 <= size <= most else most)
        self.left -= len(data) + _BYTES_A_READ
        return data

    def __getattr__(self, name: str) -> Any:  # noqa: ANN401 – seek, tell, getvalue, fileno
        return getattr(self._file, name)


def read_directory(file: BinaryIO | BoundedFile, first: int | None = None) -> ImageFileDirectory_v2:
    """Read the tags of one directory; a damaged one ends early.

    Args:
        file: A TIFF, or an EXIF block.
        first: Offset of the directory; None for that of the first image.

    Raises:
        Exception: Pillow raises many types for content that is not a TIFF.
    """
    file.seek(0)
    head = file.read(8)
    tags = ImageFileDirectory_v2(head + file.read(8) if head[2:3] == b"+" else head)
    file.seek(tags.next if first is None else first)
    tags.load(file)
    return tags


def value_of(tags: Tags, tag: int) -> Any:  # noqa: ANN401 – as Tags
    """Return the value of a tag; None if it is missing or damaged."""
    try:
        return tags.get(tag)
    except Exception:  # Pillow decodes a value at access, and raises many types for damaged ones
        return None


def _numbers(tags: Tags, tag: int) -> tuple[Any, ...]:
    """Return the values of a tag with several numbers; () if it is missing."""
    found = value_of(tags, tag)
    return found if isinstance(found, tuple) else ()


def nodata_of(tags: Tags) -> float | None:
    """Return GDAL's nodata value, None without one."""
    found = value_of(tags, NODATA)
    try:
        return float(found.rstrip("\0 ")) if isinstance(found, str) else None
    except ValueError:
        return None


def pixel_size_m(tags: Tags, shape_hw: tuple[int, int]) -> tuple[float, float] | None:
    """Return ground meters along a row and along a column of a pixel of a GeoTIFF, as QGIS measures them at its center.

    Degrees are measured on the ellipsoid of WGS 84. None if the file itself has no georeference, does not state its
    CRS, or if the unit of the CRS is not meters, feet or degrees.

    Args:
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


def _geotransform(tags: Tags) -> tuple[float, float, float, float, float] | None:
    """Return the change of x and y per column and per row, map units, and y of the upper left corner; or None."""
    matrix = _numbers(tags, _TRANSFORMATION)
    if len(matrix) == 16:
        return matrix[0], matrix[1], matrix[4], matrix[5], matrix[7]
    scale, tie = _numbers(tags, _PIXEL_SCALE), _numbers(tags, _TIE_POINT)
    if len(scale) < 2 or len(tie) < 6 or not scale[0] or not scale[1]:
        return None
    return scale[0], 0.0, 0.0, -scale[1], tie[4] + tie[1] * scale[1]


def _geo_keys(tags: Tags) -> dict[Any, Any]:
    """Return GeoTIFF's keys with a single number as value."""
    found = _numbers(tags, _GEO_KEYS)
    keys = (found[place : place + 4] for place in range(4, len(found) - 3, 4))
    return {key: value for key, where, _, value in keys if where == 0}


def _meters_per_degree(latitude_deg: float) -> tuple[float, float]:
    flattened = 1 - _ECCENTRICITY_SQUARED * sin(radians(latitude_deg)) ** 2
    east = _EQUATOR_RADIUS_M / flattened**0.5 * cos(radians(latitude_deg))
    north = _EQUATOR_RADIUS_M * (1 - _ECCENTRICITY_SQUARED) / flattened**1.5
    return radians(east), radians(north)
