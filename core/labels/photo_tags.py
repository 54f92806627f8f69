"""EXIF and XMP of photos, read without GDAL from a limited part of the file, in QGIS and on board.

Photos are untrusted: tags that are damaged, missing or of another type than in the standard count as missing, without
an error.
"""

from __future__ import annotations

import io
import math
import os
import re
import stat
import struct
from dataclasses import dataclass, replace
from typing import BinaryIO

from .. import limits
from .tiff import ORIENTATION, STARTS, BoundedFile, Tags, read_directory, value_of

_EXIF, _XMP = b"Exif\0\0", b"http://ns.adobe.com/xap/1.0/\0"
_APP1, _SCAN, _END = 0xE1, 0xDA, 0xD9
_FRAMES = {*range(0xC0, 0xD0)} - {0xC4, 0xC8, 0xCC}
"""Markers of segments with the image's size."""

_HEIC_STARTS = b"ftypheic", b"ftypheix", b"ftypmif1"
_HEIC_EXIF = re.compile(rb"Exif\0\0(MM\0\*|II\*\0)")
_HEIC_SIZE = re.compile(rb"ispe\0{4}(.{8})", re.DOTALL)
"""The property with width and height of an image (ISO/IEC 23008-12)."""

_WIDTH, _HEIGHT, _MODEL, _TIFF_XMP, _EXIF_DIRECTORY = 256, 257, 272, 700, 34665
_TAKEN, _FRACTION, _FOCAL_LENGTH, _ZOOM, _FOCAL_LENGTH_35MM = 36867, 37521, 37386, 41988, 41989


@dataclass(frozen=True)
class PhotoTags:
    """Tags of a photo; empty or None if missing.

    Attributes:
        shape_hw: (height, width) of the photo, pixels.
        model: Of the camera, from EXIF.
        orientation: EXIF's; 1 for a photo that is shown unrotated.
        focal_length_mm: Of the lens itself.
        focal_length_35mm: On 35 mm film, mm.
        zoom: Digital zoom as a ratio; 1 without zoom.
        taken: EXIF's date and time of exposure, ``YYYY:MM:DD hh:mm:ss``.
        fraction: Digits of its seconds after the decimal point.
    """

    shape_hw: tuple[int, int] | None = None
    model: str = ""
    orientation: int = 1
    focal_length_mm: float | None = None
    focal_length_35mm: float | None = None
    zoom: float = 1.0
    taken: str = ""
    fraction: str = ""
    xmp: str = ""

    def number(self, name: str) -> float | None:
        """Return a number of the XMP packet, from an attribute or an element; None if missing or not a number.

        Args:
            name: Name of the property, with or without the prefix of its namespace.
        """
        found = re.search(rf"\b{re.escape(name)}\s*(?:=\s*[\"']|>)\s*([-+]?\d{{1,12}}(?:\.\d{{0,12}})?)", self.xmp)
        return float(found.group(1)) if found else None

    def text(self, name: str) -> str:
        """Return a text of the XMP packet, from an attribute or an element; empty if missing.

        Args:
            name: Name of the property, with or without the prefix of its namespace.
        """
        found = re.search(rf"\b{re.escape(name)}\s*(?:=\s*([\"'])([^\"'<>]{{0,1000}})\1|>([^<>]{{0,1000}})<)", self.xmp)
        return (found.group(2) or found.group(3) or "").strip() if found else ""


def read_tags(path: str) -> PhotoTags:
    """Return the tags of a JPEG, TIFF or HEIC file; empty for other and unreadable files.

    Args:
        path: Path of the file. Only regular files are opened.
    """
    try:
        if not stat.S_ISREG(os.stat(path).st_mode):
            return PhotoTags()
        with open(path, "rb") as file:
            head = file.read(limits.TAG_BYTES)
            # A TIFF's directories may be after its pixels.
            return _tiff_tags(file) if head.startswith(STARTS) else photo_tags(head)
    except OSError:
        return PhotoTags()


def photo_tags(data: bytes) -> PhotoTags:
    """Return the tags of a JPEG's, TIFF's or HEIC's content; the beginning of a JPEG or HEIC is enough."""
    if data.startswith(STARTS):
        return _tiff_tags(io.BytesIO(data))
    if data[4:12] in _HEIC_STARTS:
        return _heic_tags(data)
    return _jpeg_tags(data) if data[:2] == b"\xff\xd8" else PhotoTags()


def _jpeg_tags(data: bytes) -> PhotoTags:
    exif, xmp, shape = PhotoTags(), "", None
    place = 2
    for _ in range(limits.JPEG_SEGMENTS):
        if place + 4 > len(data) or data[place] != 0xFF or data[place + 1] in (_SCAN, _END):
            break
        marker, (length,) = data[place + 1], struct.unpack_from(">H", data, place + 2)
        content = data[place + 4 : place + 2 + length]
        if marker == _APP1 and content.startswith(_EXIF):
            exif = _tiff_tags(io.BytesIO(content[len(_EXIF) :]))
        elif marker == _APP1 and content.startswith(_XMP):
            xmp = xmp or _text(content[len(_XMP) :])
        elif marker in _FRAMES and len(content) >= 5:
            shape = struct.unpack_from(">HH", content, 1)
        place += 2 + max(length, 2)
    values = {**vars(exif), "xmp": xmp, "shape_hw": shape}
    return PhotoTags(**values)


def _heic_tags(data: bytes) -> PhotoTags:
    """Return the EXIF tags, and the size of the largest image in the file: the others are its tiles and previews."""
    found = _HEIC_EXIF.search(data)
    if found is None:
        return PhotoTags()
    exif = _tiff_tags(io.BytesIO(data[found.start(1) :]))
    sizes = [struct.unpack(">II", size) for size in _HEIC_SIZE.findall(data[: found.start()])]
    width, height = max(sizes, key=math.prod, default=(0, 0))
    # Programs show a HEIC rotated, and do not leave that to the viewer.
    shape = (width, height) if exif.orientation > 4 else (height, width)
    return replace(exif, shape_hw=shape if width and height else None)


def _tiff_tags(file: BinaryIO) -> PhotoTags:
    """Return the tags of a TIFF or an EXIF block; empty if it is damaged (the photo's XMP may still be readable)."""
    bounded = BoundedFile(file)
    try:
        tags = read_directory(bounded)
        first = value_of(tags, _EXIF_DIRECTORY)
        exif = read_directory(bounded, first) if isinstance(first, int) else tags
    except Exception:  # Pillow raises many types for damaged files
        return PhotoTags()
    height, width = _number(tags, _HEIGHT), _number(tags, _WIDTH)
    xmp = value_of(tags, _TIFF_XMP)
    return PhotoTags(
        shape_hw=(int(height), int(width)) if height and width else None,
        model=_string(tags, _MODEL),
        orientation=int(_number(tags, ORIENTATION) or 1),
        focal_length_mm=_number(exif, _FOCAL_LENGTH),
        focal_length_35mm=_number(exif, _FOCAL_LENGTH_35MM),
        zoom=_number(exif, _ZOOM) or 1.0,
        taken=_string(exif, _TAKEN),
        fraction=_string(exif, _FRACTION),
        xmp=_text(xmp) if isinstance(xmp, bytes) else "",
    )


def _number(tags: Tags, tag: int) -> float | None:
    """Return a positive number; None for any other, which means unknown in EXIF."""
    found = value_of(tags, tag)
    try:
        value = float(found[0] if isinstance(found, tuple) else found)
    except (TypeError, ValueError, ArithmeticError, IndexError):
        return None
    return value if 0 < value < math.inf else None


def _string(tags: Tags, tag: int) -> str:
    found = value_of(tags, tag)
    return found.partition("\0")[0].strip()[: limits.XMP_BYTES] if isinstance(found, str) else ""


def _text(content: bytes) -> str:
    return content[: limits.XMP_BYTES].split(b"\0")[0].decode("utf-8", "replace").strip()
