"""Read label images and photos without GDAL, for computers without QGIS.

Pillow reads PNG and TIFF: it returns the indices of a palette, which are the class values; OpenCV returns colors.
OpenCV reads JPEG: Pillow would search segments byte by byte in Python, in files of any length.
"""

from __future__ import annotations

import io
import os
import stat
from math import inf

import cv2
import numpy as np
from PIL import Image
from PIL.PngImagePlugin import PngImageFile
from PIL.TiffImagePlugin import TiffImageFile

from .. import limits
from ..errors import ImageError, SemRefError, reason_of
from .class_table import ClassTable
from .color_labels import decode_colors
from .image_source import ArrayImage, Photo
from .photo_tags import photo_tags
from .tiff import ORIENTATION, STARTS, BoundedFile, Tags, nodata_of, pixel_size_m, value_of

IMAGE_EXTENSIONS = (".png", ".tif", ".tiff", ".jpg", ".jpeg")

_PNG = b"\x89PNG\r\n\x1a\n"
_KINDS = {
    "PNG": ((_PNG,), (".png",)),
    "TIFF": (STARTS, (".tif", ".tiff")),
    "JPEG": ((b"\xff\xd8\xff",), (".jpg", ".jpeg")),
}
"""First bytes of files of each kind, and the suffixes of their names."""

_JPEG = b"\xff\xd8"
_PIXELS_A_BYTE = 8 * 1032
"""Pixels of one bit; deflate compresses at most 1,032 bytes to one, and JPEG less."""

_READS_A_BYTE = 2
"""Maximum bytes read for each byte of a PNG: files of very small chunks would take long."""

_UPRIGHT = {
    2: Image.Transpose.FLIP_LEFT_RIGHT,
    3: Image.Transpose.ROTATE_180,
    4: Image.Transpose.FLIP_TOP_BOTTOM,
    5: Image.Transpose.TRANSPOSE,
    6: Image.Transpose.ROTATE_90,
    7: Image.Transpose.TRANSVERSE,
    8: Image.Transpose.ROTATE_270,
}
"""Undoes Pillow's rotation of a TIFF by its orientation, which GDAL, used in the plugin, ignores."""

_STRETCHED = {"L;2": 85, "L;4": 17}
"""Factor by which Pillow stretches gray of fewer than 8 bits to 0 … 255, by Pillow's raw mode."""

_BITS = 258


def read_label_image(path: str, table: ClassTable) -> np.ndarray:
    """Read a label image as labels (H, W) uint8: single-band or paletted values, or three bands decoded by color.

    Reads PNG, TIFF and JPEG. Colors are decoded by the table's HSV ranges if it has any, otherwise by nearest color; a
    TIFF's nodata value becomes unlabeled. Raises ImageError.
    """
    data = _read(path)
    if data.startswith(_JPEG):
        values = _jpeg_values(data, path)
        return decode_colors(values, table) if values.ndim == 3 else values
    if not data.startswith((_PNG, *STARTS)):
        raise ImageError("{path} is not a PNG, TIFF or JPEG file; save the label image as PNG.", path=path)
    image, raw_mode, tags = _decoded(data, path)
    if image.mode in ("LA", "PA"):
        raise ImageError("{path} has 2 bands, but a label image has one; save it without transparency.", path=path)
    values = np.array(image, np.uint8 if image.mode == "1" else None)
    if values.ndim == 3:
        if _has_16_bits(raw_mode, tags):
            raise ImageError(
                "{path} has {kind} values, but a color label image has 8 bits per band; convert it to 8 bits.",
                path=path,
                kind="uint16",
            )
        return decode_colors(values[..., 2::-1], table)
    if values.dtype.kind not in "iu":
        raise ImageError(
            "{path} has {kind} values; class values must be whole numbers from 0 to 255.", path=path, kind=values.dtype
        )
    if raw_mode in _STRETCHED:
        values //= _STRETCHED[raw_mode]
    nodata = nodata_of(tags)
    if nodata is not None:
        values[values == nodata] = 0
    if values.min() < 0 or values.max() > 255:
        found = int(values.max() if values.max() > 255 else values.min())
        raise ImageError("{path} has the value {found}; class values must be from 0 to 255.", path=path, found=found)
    return values.astype(np.uint8)


def read_photo(path: str) -> Photo:
    """Read a photo of 8 bits per band, unrotated; transparent and nodata pixels have no data.

    Only the file itself counts, not side-car files next to it. Raises ImageError.
    """
    data = _read(path)
    if not data.startswith((_PNG, *STARTS)):
        values = _jpeg_values(data, path)
        order = cv2.COLOR_GRAY2RGB if values.ndim == 2 else cv2.COLOR_BGR2RGB
        return Photo(ArrayImage(cv2.cvtColor(values, order)), None)
    image, raw_mode, tags = _decoded(data, path)
    if image.mode == "P" or "transparency" in image.info:
        image = image.convert("RGBA")
    elif image.mode in ("1", "CMYK", "YCbCr", "LAB"):
        image = image.convert("RGB")
    values, nodata = np.array(image), nodata_of(tags)
    kind = "uint16" if _has_16_bits(raw_mode, tags) else values.dtype
    if kind != np.uint8:
        raise ImageError(
            "{path} has {kind} values, but a photo has 8 bits per band; convert it to 8 bits.", path=path, kind=kind
        )
    bands = values if values.ndim == 3 else values[..., None]
    has_opacity = image.mode in ("LA", "PA", "RGBA")
    count = min(bands.shape[2] - has_opacity, 3)
    has_data = bands[..., -1] > 0 if has_opacity else None
    if nodata is not None:
        # As in GDAL, nodata has priority over opacity.
        has_data = (bands[..., :count] != nodata).any(axis=2)
    colors = np.repeat(bands[..., :1], 3, axis=2) if count < 3 else np.ascontiguousarray(bands[..., :3])
    if has_data is not None:
        colors[~has_data] = 0
    pixels = ArrayImage(colors, has_data)
    return Photo(pixels, pixel_size_m(tags, pixels.shape_hw))


def _has_16_bits(raw_mode: str, tags: Tags) -> bool:
    """Return whether colors had 16 bits; Pillow keeps the upper 8."""
    return "16" in raw_mode or max(tags.get(_BITS) or (8,)) == 16


def image_files(paths: list[str], endings: tuple[str, ...] = IMAGE_EXTENSIONS) -> list[str]:
    """Return the files, with each folder replaced by its images, sorted. Raises ImageError for an empty folder."""
    found: list[str] = []
    for path in paths:
        if not os.path.isdir(path):
            found.append(path)
            continue
        try:
            names = sorted(os.listdir(path))
        except OSError as error:
            raise ImageError("Image {path} can't be read: {reason}.", path=path, reason=reason_of(error)) from None
        images = [os.path.join(path, name) for name in names if is_image_name(name, endings)]
        if not images:
            raise ImageError(
                "The folder {path} contains no image ({endings}). Choose another folder; its subfolders are not read.",
                path=path,
                endings=endings,
            )
        found += images
    return found


def is_image_name(name: str, endings: tuple[str, ...] = IMAGE_EXTENSIONS) -> bool:
    """Return whether a file of a folder counts as an image; hidden files do not."""
    return name.lower().endswith(endings) and not name.startswith(".")


def require_kind_of_name(path: str, start: bytes) -> None:
    """Refuse a file with content of another kind than its suffix: one of the two is a mistake, or an attack.

    Args:
        path: The file; suffixes other than those of PNG, TIFF and JPEG are not checked.
        start: Its first bytes, 8 or more.
    """
    suffix = os.path.splitext(path)[1].lower()
    named = next((name for name, (_, suffixes) in _KINDS.items() if suffix in suffixes), None)
    found = next((name for name, (starts, _) in _KINDS.items() if start.startswith(starts)), None)
    if named and found and named != found:
        raise ImageError(
            "{path} has the suffix of {named}, but its content is {found}. Change the suffix to {suffix}, or "
            "export the file again.",
            path=path,
            found=found,
            named=named,
            suffix=_KINDS[found][1][0],
        )


def _read(path: str) -> bytes:
    try:
        with open(path, "rb", opener=open_at_once) as file:
            state = os.fstat(file.fileno())
            if not stat.S_ISREG(state.st_mode):
                raise _not_a_file(path)
            if state.st_size > limits.IMAGE_BYTES:
                raise ImageError(
                    "Image {path} has {size_mb} MB; a query image may have at most {most_mb} MB. Crop it to the "
                    "area of one photo.",
                    path=path,
                    size_mb=state.st_size // 1_000_000,
                    most_mb=limits.IMAGE_BYTES // 1_000_000,
                )
            # At most the stated size: a file that still grows is read again later by the watching code.
            data = file.read(state.st_size)
    except IsADirectoryError:
        raise _not_a_file(path) from None
    except (OSError, ValueError) as error:
        # ValueError: the path contains a null character.
        raise ImageError("Image {path} can't be read: {reason}.", path=path, reason=reason_of(error)) from None
    require_kind_of_name(path, data)
    return data


def open_at_once(path: str, flags: int) -> int:
    """Open a file without blocking: opening a pipe without a writer would otherwise wait forever.

    Args:
        flags: As ``open`` passes them to its opener.
    """
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


def _decoded(data: bytes, path: str) -> tuple[Image.Image, str, Tags]:
    """Decode a PNG or TIFF, unless it claims more pixels than allowed.

    Returns:
        The image, Pillow's raw mode, and the tags of a TIFF.
    """
    is_png = data.startswith(_PNG)
    file = BoundedFile(io.BytesIO(data))
    try:
        image = PngImageFile(file) if is_png else TiffImageFile(file)
        raw_mode = image.tile[0][3] if is_png else image.tile[0][3][0]
        tags = {} if is_png else {tag: value_of(image.tag_v2, tag) for tag in image.tag_v2}
        # Pieces of a TIFF may be missing or shared.
        require_size((image.height, image.width), len(data) if is_png else None, path)
        file.left = limits.TAG_BYTES + _READS_A_BYTE * len(data) if is_png else inf
        image.load()
    except SemRefError:
        raise
    except Exception:  # Pillow raises many types for damaged files
        raise _not_decoded(path) from None
    turn = _UPRIGHT.get(tags.get(ORIENTATION, 1))
    return image if turn is None else image.transpose(turn), raw_mode, tags


def _jpeg_values(data: bytes, path: str) -> np.ndarray:
    """Decode a JPEG: (H, W) or (H, W, 3) uint8, blue first. Its orientation is ignored, see _UPRIGHT."""
    shape_hw = photo_tags(data).shape_hw
    if shape_hw is not None:
        require_size(shape_hw, len(data), path)
    flags = cv2.IMREAD_UNCHANGED | cv2.IMREAD_IGNORE_ORIENTATION
    try:
        values = cv2.imdecode(np.frombuffer(data, np.uint8), flags) if data else None
    except cv2.error as error:
        raise ImageError("Image {path} can't be read: {reason}.", path=path, reason=error.err) from None
    if values is None:
        raise _not_decoded(path)
    return values


def _not_a_file(path: str) -> ImageError:
    return ImageError("Image {path} is a folder, pipe or device; choose an image file.", path=path)


def _not_decoded(path: str) -> ImageError:
    return ImageError(
        "Image {path} can't be read: it is damaged, incomplete or in a format that OpenCV can't read.", path=path
    )


def require_size(shape_hw: tuple[int, int], file_bytes: int | None, path: str) -> None:
    """Refuse more pixels than allowed, or than a file of this size can contain.

    Args:
        shape_hw: (height, width) stated in the file.
        file_bytes: Size of the file; None for formats with unlimited compression.
    """
    height, width = shape_hw
    if height * width > limits.IMAGE_PIXELS:
        raise ImageError(
            "{path} has {width} × {height} pixels; a query image may have at most {most_million} million. Crop it "
            "to the area of one photo.",
            path=path,
            width=width,
            height=height,
            most_million=limits.IMAGE_PIXELS // 1_000_000,
        )
    if file_bytes is not None and height * width > _PIXELS_A_BYTE * file_bytes:
        raise ImageError("{path} is damaged or incomplete; copy it again.", path=path)
