"""Read arrays from an untrusted zip: numpy's ``.npz`` without pickles.

No memory is allocated beyond what the file's size justifies. Sizes are checked in the zip's directory before unpacking,
shapes and types in the arrays' headers.
"""

from __future__ import annotations

import io
import math
import struct
import zipfile
import zlib
from typing import BinaryIO

import numpy as np
from numpy.lib import format as npy_format

from .. import limits

UNREADABLE = (zipfile.BadZipFile, zlib.error, EOFError, OSError, RuntimeError, ValueError, struct.error)
"""Errors of a damaged or malicious zip."""

_DEFLATE_RATIO = 1032
"""Largest compression ratio of deflate; a member with a larger one is damaged or malicious."""


def require_honest(info: zipfile.ZipInfo, most: int) -> None:
    """Raise BadZipFile for a member with an impossible size or more than ``most`` bytes."""
    if info.flag_bits & 1 or info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise zipfile.BadZipFile(f"{info.filename} is encrypted or compressed in an unknown way")
    if info.file_size > most or info.file_size > _DEFLATE_RATIO * info.compress_size + 64:
        raise zipfile.BadZipFile(f"{info.filename} states {info.file_size} bytes, more than possible")


def npy_header(name: str, start: bytes) -> tuple[tuple[int, ...], np.dtype, bool, int]:
    """Return (shape, type, whether columns come first, first byte of the data) of a .npy file.

    Args:
        start: Its first ``limits.NPY_HEADER_BYTES``, or all of it.

    Raises:
        BadZipFile: The file is not a plain array.
    """
    file = io.BytesIO(start)
    try:
        version = npy_format.read_magic(file)
        shape, is_fortran, dtype = npy_format.read_array_header_1_0(file)
    # numpy evaluates the header as a Python literal: the errors depend on its version.
    except Exception:
        raise zipfile.BadZipFile(f"{name} is not a plain array") from None
    if version != (1, 0) or dtype.hasobject or min(shape, default=0) < 0:
        raise zipfile.BadZipFile(f"{name} is not a plain array")
    return shape, dtype, is_fortran, file.tell()


def number_arrays(source: str | BinaryIO, most: int) -> dict[str, np.ndarray]:
    """Return the arrays of numbers in a ``.npz`` by name.

    Args:
        source: Path of the file, or the opened file.
        most: Largest size of all arrays together, bytes.

    Raises:
        OSError: The file can't be read.
        Exception: One of ``UNREADABLE``: the file is not a valid ``.npz``.
    """
    found = {}
    with zipfile.ZipFile(source) as archive:
        left = most
        for info in archive.infolist():
            require_honest(info, left)
            left -= info.file_size
            name = info.filename[: -len(".npy")]
            data = archive.read(info)
            shape, dtype, is_fortran, first = npy_header(name, data[: limits.NPY_HEADER_BYTES])
            if dtype.kind not in "biuf" or first + math.prod(shape) * dtype.itemsize != len(data):
                raise zipfile.BadZipFile(f"{name} has another size than its shape {shape}")
            found[name] = np.frombuffer(data, dtype, offset=first).reshape(shape, order="F" if is_fortran else "C")
    return found
