"""Label images and photos read without GDAL, for computers that have no QGIS.

OpenCV expands the palette of a paletted PNG or TIFF to colors, but the class values are the palette's indices. Such a
file says in one number that its values are to be looked up; with that number set to gray, OpenCV gives the values.
"""

from __future__ import annotations

import os
import stat
import struct
import zlib
from collections.abc import Iterator

import cv2
import numpy as np

from ..errors import ImageError, LabelMapError, SemRefError
from .class_table import ClassTable
from .color_labels import decode_colors
from .image_source import ArrayImage, Photo
from .tiff import BITS, EXTRA_SAMPLES, HEIGHT, ORDERS, PHOTOMETRIC, WIDTH, TiffTags, pixel_size_m

IMAGE_EXTENSIONS = (".png", ".tif", ".tiff", ".jpg", ".jpeg")

MAXIMUM_IMAGE_PIXELS = 400_000_000
"""A query image is held in memory; larger ones are refused."""

MAXIMUM_IMAGE_BYTES = 4 * MAXIMUM_IMAGE_PIXELS
"""What the largest image has uncompressed, in four bands of 8 bits."""

_PNG = b"\x89PNG\r\n\x1a\n"
_KINDS = {
    "PNG": ((_PNG,), (".png",)),
    "TIFF": ((b"II*\0", b"MM\0*", b"II+\0", b"MM\0+"), (".tif", ".tiff")),
    "JPEG": ((b"\xff\xd8\xff",), (".jpg", ".jpeg")),
}
"""How files of each kind begin, and the suffixes of their names."""

_PNG_PALETTE, _PNG_GRAY, _PNG_GRAY_ALPHA = 3, 0, 4
_TIFF_GRAY, _TIFF_PALETTE = 1, 3
_NO_FRAMES = (0xC4, 0xC8, 0xCC)
"""Markers of a JPEG among those of frames that say no size: tables, and one that is reserved."""

_PIXELS_A_BYTE = 8 * 1032
"""Of one bit each, which deflate packs 1,032 bytes of into one; JPEG packs less."""

_TIFF_PREMULTIPLIED, _TIFF_OPACITY = 1, 2
"""Kinds of a TIFF's fourth band: its colors are darkened by it already, or they aren't."""


def read_label_image(path: str, table: ClassTable) -> np.ndarray:
    """A query image's labels (H, W) uint8: single-band or paletted values, or three bands decoded by color.

    PNG, TIFF and JPEG. Colors are decoded by the table's HSV ranges if it has any, else by nearest color; a TIFF's
    nodata value counts as unlabeled. Raises LabelMapError.
    """
    data = _read(path, LabelMapError)
    nodata, levels = None, None
    try:
        if data.startswith(_PNG):
            data, levels = _png_values(data, path)
        elif data[:4] in ORDERS:
            data, nodata = _tiff_values(data, path)
        elif not data.startswith(b"\xff\xd8"):
            raise LabelMapError("labels.unknown_image_format", path=path)
    except struct.error:
        raise LabelMapError("labels.damaged", path=path) from None
    image = _decoded(data, cv2.IMREAD_UNCHANGED, path, LabelMapError)
    if image.ndim == 3:
        if image.dtype != np.uint8:
            raise LabelMapError("labels.color_not_8_bits", path=path, kind=image.dtype)
        return decode_colors(image[..., :3], table)
    if image.dtype.kind not in "iu":
        raise LabelMapError("labels.not_whole_numbers", path=path, kind=image.dtype)
    if nodata is not None:
        image[image == nodata] = 0
    if image.min() < 0 or image.max() > 255:
        found = int(image.max() if image.max() > 255 else image.min())
        raise LabelMapError("labels.value_out_of_range", path=path, found=found)
    labels_hw = image.astype(np.uint8)
    # Gray of fewer than 8 bits was stretched to 0 … 255.
    return labels_hw if levels is None else labels_hw // (255 // levels)


def read_photo(path: str) -> Photo:
    """A photo of 8 bits a band, as its pixels lie in the file; without data where it is transparent or nodata.

    Only what stands in the file itself counts, not what lies in others beside it. Raises ImageError.
    """
    data = _read(path, ImageError)
    try:
        return _photo(data, path)
    except struct.error:
        raise ImageError("labels.damaged", path=path) from None


def _photo(data: bytes, path: str) -> Photo:
    """The photo of a file's content; raises struct.error for a TIFF with damaged tags."""
    tags = TiffTags(data) if data[:4] in ORDERS else None
    image = _decoded(_with_plain_bands(data, tags), cv2.IMREAD_UNCHANGED, path, ImageError)
    if image.dtype != np.uint8:
        raise ImageError("labels.photo_not_8_bits", path=path, kind=image.dtype)
    has_data = _has_data(image, tags)
    colors = cv2.cvtColor(image, cv2.COLOR_GRAY2RGB) if image.ndim == 2 else np.ascontiguousarray(image[..., 2::-1])
    if has_data is not None:
        colors[~has_data] = 0
    pixels = ArrayImage(colors, has_data)
    return Photo(pixels, None if tags is None else pixel_size_m(tags, pixels.shape_hw))


def _with_plain_bands(data: bytes, tags: TiffTags | None) -> bytes:
    """The TIFF with colors that count as darkened by their opacity already: else OpenCV would darken them."""
    if tags is None or tags.values(EXTRA_SAMPLES) != (_TIFF_OPACITY,):
        return data
    patched = bytearray(data)
    struct.pack_into(tags.order + "H", patched, tags.entries[EXTRA_SAMPLES][2], _TIFF_PREMULTIPLIED)
    return bytes(patched)


def _has_data(image: np.ndarray, tags: TiffTags | None) -> np.ndarray | None:
    """(H, W) bool: where a decoded photo has data; None everywhere. As GDAL decides: nodata goes before opacity."""
    nodata = None if tags is None else tags.nodata()
    if nodata is not None:
        bands = image if image.ndim == 3 else image[..., None]
        return (bands[..., :3] != nodata).any(axis=2)
    extra = () if tags is None else tags.values(EXTRA_SAMPLES)
    is_opacity = not extra or extra[0] in (_TIFF_OPACITY, _TIFF_PREMULTIPLIED)
    return image[..., 3] > 0 if image.ndim == 3 and image.shape[2] == 4 and is_opacity else None


def image_files(paths: list[str]) -> list[str]:
    """Files as given; a folder stands for the images in it, by name. Raises LabelMapError for an empty folder."""
    found: list[str] = []
    for path in paths:
        if not os.path.isdir(path):
            found.append(path)
            continue
        try:
            names = sorted(os.listdir(path))
        except OSError as error:
            raise LabelMapError("labels.image_unreadable", path=path, reason=error.strerror) from None
        images = [os.path.join(path, name) for name in names if is_image_name(name)]
        if not images:
            raise LabelMapError("labels.folder_without_images", path=path, endings=IMAGE_EXTENSIONS)
        found += images
    return found


def is_image_name(name: str) -> bool:
    """Whether a file of a folder counts as an image; hidden ones don't."""
    return name.lower().endswith(IMAGE_EXTENSIONS) and not name.startswith(".")


def require_kind_of_name(path: str, start: bytes, kind: type[SemRefError]) -> None:
    """Refuses a file that begins as another kind than its name says: one of the two is a mistake, or a trick.

    Args:
        path: The file; names without a suffix of PNG, TIFF or JPEG promise nothing.
        start: Its first bytes, 8 or more.
        kind: The error to raise.
    """
    suffix = os.path.splitext(path)[1].lower()
    named = next((name for name, (_, suffixes) in _KINDS.items() if suffix in suffixes), None)
    found = next((name for name, (starts, _) in _KINDS.items() if start.startswith(starts)), None)
    if named and found and named != found:
        raise kind("labels.other_kind", path=path, found=found, named=named, suffix=_KINDS[found][1][0])


def _read(path: str, kind: type[SemRefError]) -> bytes:
    try:
        with open(path, "rb", opener=open_at_once) as file:
            state = os.fstat(file.fileno())
            if not stat.S_ISREG(state.st_mode):
                raise kind("labels.no_regular_file", path=path)
            if state.st_size > MAXIMUM_IMAGE_BYTES:
                raise kind(
                    "labels.file_too_large",
                    path=path,
                    size_mb=state.st_size // 1_000_000,
                    most_mb=MAXIMUM_IMAGE_BYTES // 1_000_000,
                )
            # No more than was there: a file that grows meanwhile is read again by whoever watches it.
            data = file.read(state.st_size)
    except IsADirectoryError:
        raise kind("labels.no_regular_file", path=path) from None
    except (OSError, ValueError) as error:
        # ValueError: a path with a null character.
        reason = getattr(error, "strerror", None) or str(error)
        raise kind("labels.image_unreadable", path=path, reason=reason) from None
    require_kind_of_name(path, data, kind)
    return data


def open_at_once(path: str, flags: int) -> int:
    """Opens a file without waiting: a pipe that nobody writes into would be waited for without end.

    Args:
        path: Of the file.
        flags: As ``open`` passes them to its opener.
    """
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


def _decoded(data: bytes, flags: int, path: str, kind: type[SemRefError]) -> np.ndarray:
    _require_decodable(data, path, kind)
    # The orientation of EXIF is left alone: GDAL, which the plugin reads with, doesn't know it.
    try:
        image = cv2.imdecode(np.frombuffer(data, np.uint8), flags | cv2.IMREAD_IGNORE_ORIENTATION) if data else None
    except cv2.error as error:
        raise kind("labels.image_unreadable", path=path, reason=error.err) from None
    if image is None:
        raise kind("labels.image_not_decoded", path=path)
    return image


def _require_decodable(data: bytes, path: str, kind: type[SemRefError]) -> None:
    """Refuses what claims more pixels than an image may have or a file of its size can hold, before it is decoded."""
    if data.startswith(_PNG) and not _has_whole_chunks(data):
        # OpenCV would make room for what a chunk claims, and fill it: seconds, and gigabytes.
        raise kind("labels.damaged", path=path)
    found = stated_size(data)
    if found is None:
        return
    width, height = found
    if height * width > MAXIMUM_IMAGE_PIXELS:
        raise kind(
            "labels.image_too_large",
            path=path,
            width=width,
            height=height,
            most_million=MAXIMUM_IMAGE_PIXELS // 1_000_000,
        )
    # Pieces of a TIFF may be left out or shared.
    if height * width > _PIXELS_A_BYTE * len(data) and data[:4] not in ORDERS:
        raise kind("labels.damaged", path=path)


def stated_size(data: bytes) -> tuple[int, int] | None:
    """(width, height) that a PNG, TIFF or JPEG says it has; None where it says none that can be read."""
    try:
        if data.startswith(_PNG):
            width, height = struct.unpack_from(">II", data, len(_PNG) + 8)
            return width, height
        if data[:4] in ORDERS:
            tags = TiffTags(data)
            (width,), (height,) = tags.values(WIDTH), tags.values(HEIGHT)
            return (width, height) if isinstance(width, int) and isinstance(height, int) else None
        return _jpeg_size(data)
    except (struct.error, ValueError, TypeError):
        return None


def _jpeg_size(data: bytes) -> tuple[int, int] | None:
    place = 2
    while data[place : place + 1] == b"\xff":
        marker, length = struct.unpack_from(">xBH", data, place)
        if 0xC0 <= marker <= 0xCF and marker not in _NO_FRAMES:
            height, width = struct.unpack_from(">HH", data, place + 5)
            return width, height
        place += 2 + length
    return None


def _png_values(data: bytes, path: str) -> tuple[bytes, int | None]:
    """The PNG with a palette's indices as gray values, and its highest value when it has fewer than 8 bits."""
    _, kind, header = struct.unpack_from(">I4s13s", data, len(_PNG))
    bits, color = header[8], header[9]
    if kind != b"IHDR":
        raise struct.error
    if color == _PNG_GRAY_ALPHA:
        raise LabelMapError("labels.two_bands", path=path)
    if color == _PNG_PALETTE:
        header = header[:9] + bytes([_PNG_GRAY]) + header[10:]
        # A palette or its transparency in a gray image would be an error.
        chunks = (chunk for name, chunk in _png_chunks(data) if name not in (b"IHDR", b"PLTE", b"tRNS"))
        data = _PNG + _png_chunk(b"IHDR", header) + b"".join(chunks)
    return data, 2**bits - 1 if color in (_PNG_PALETTE, _PNG_GRAY) and bits < 8 else None


def _png_chunks(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    place = len(_PNG)
    while place + 12 <= len(data):
        length, name = struct.unpack_from(">I4s", data, place)
        yield name, data[place : place + 12 + length]
        place += 12 + length


def _has_whole_chunks(data: bytes) -> bool:
    """Whether no chunk of a PNG claims to be longer than the file, up to the one that ends it."""
    place = len(_PNG)
    while place + 8 <= len(data):
        length, name = struct.unpack_from(">I4s", data, place)
        if place + 12 + length > len(data):
            return False
        if name == b"IEND":
            return True
        place += 12 + length
    return True


def _png_chunk(name: bytes, content: bytes) -> bytes:
    return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))


def _tiff_values(data: bytes, path: str) -> tuple[bytes, float | None]:
    """The TIFF with a palette's indices as gray values, and its nodata value (GDAL's tag), None without one."""
    tags = TiffTags(data)
    if tags.values(PHOTOMETRIC) == (_TIFF_PALETTE,):
        bits = (tags.values(BITS) or (1,))[0]
        if bits != 8:
            raise LabelMapError("labels.palette_bits", path=path, bits=bits)
        patched = bytearray(data)
        struct.pack_into(tags.order + "H", patched, tags.entries[PHOTOMETRIC][2], _TIFF_GRAY)
        data = bytes(patched)
    return data, tags.nodata()
