"""An index kept in a file: opened by memory mapping, not built anew at every start.

The file is whole or not used: its header tells what landmarks and settings it is of, the place, kind and checksum of
each array, and carries a code (HMAC) made with a secret of this user on this machine. So an index that came along with
somebody else's database, or one of other landmarks, is built anew and never believed. Told in
docs/file-formats.md#stored-index.
"""

from __future__ import annotations

import contextlib
import hashlib
import hmac
import json
import logging
import math
import mmap
import os
import secrets
import tempfile
import time
import zlib
from collections.abc import Iterable, Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from ..database.checks import digest
from ..database.model import MapLandmarks
from .index import ConstellationIndex, IndexParts, build_index, index_of_parts, index_parts, part_shapes
from .settings import ConstellationSettings

SUFFIX = ".semref-index"
"""Behind the database's name, with its own suffix."""

VERSION = 1
"""Raised whenever the same landmarks give another index, and so another answer."""

FEWEST = 20_000
"""Landmarks below which an index is built in a fraction of a second and not kept."""

_LEFT_AFTER_S = 600
"""An unfinished file that nobody wrote to for so long was left by a writer that was killed."""

_LOG = logging.getLogger("semref")

_MAGIC = b"SemRef index\n\x00\x01\x00"
_ALIGNED = 64
_LARGEST_HEADER = 1 << 16
_MAC_BYTES = 32
_SECRET_BYTES = 32


def index_path(database: str) -> Path:
    """Where the index of a database lies: beside it."""
    return Path(f"{database}{SUFFIX}")


def key_of(references: MapLandmarks, pixel_size_m: float, settings: ConstellationSettings) -> str:
    """What tells an index from others: SHA-256 of the landmarks and all that it is built with, hexadecimal."""
    told = json.dumps([VERSION, pixel_size_m, asdict(settings)], sort_keys=True)
    columns = references.positions, references.classes, references.areas_m2, references.touches_edge
    kinds = "<f8", "u1", "<f8", "u1"
    return digest([told.encode(), *(np.asarray(column).astype(kind) for column, kind in zip(columns, kinds))])


def stored_index(
    references: MapLandmarks, pixel_size_m: float, settings: ConstellationSettings, database: str | None
) -> ConstellationIndex:
    """The index of a database's landmarks: opened where it is kept, else built and, of many landmarks, kept.

    Args:
        references: The landmarks.
        pixel_size_m: Of the label map that they are of.
        settings: The index is built with.
        database: The file that they were read from; None for none, and nothing is kept.
    """
    if database is None or len(references) < FEWEST:
        return build_index(references, pixel_size_m, settings)
    path, key, secret = index_path(database), key_of(references, pixel_size_m, settings), _secret()
    parts = None if secret is None else read_parts(path, key, secret)
    if parts is None or not _fit(parts, references, settings):
        parts = index_parts(references, pixel_size_m, settings)
        if secret is None or not write_parts(path, key, secret, parts):
            _LOG.log(logging.WARNING, "index_not_kept", extra={"details": {"database": database}})
    return index_of_parts(references, pixel_size_m, settings, parts)


def write_parts(path: Path, key: str, secret: bytes, parts: IndexParts) -> bool:
    """Keeps an index; whether that was possible.

    Args:
        path: Its file; an older one is replaced at once and whole.
        key: Of ``key_of``.
        secret: Of this user on this machine.
        parts: The index.
    """
    arrays = {name: np.ascontiguousarray(array) for name, array in parts.items()}
    layout: dict[str, list] = {}
    offset = 0
    for name, array in arrays.items():
        layout[name] = [array.dtype.str, list(array.shape), offset, zlib.crc32(_bytes(array))]
        offset += _padded(array.nbytes)
    header = json.dumps({"key": key, "arrays": layout, "bytes": offset}).encode("ascii")
    head = _MAGIC + len(header).to_bytes(4, "little") + _mac(header, secret) + header
    try:
        _write_whole(path, _aligned([head, *map(_bytes, arrays.values())]))
    except OSError:
        return False
    return True


def _write_whole(path: Path, pieces: Iterable[bytes | memoryview]) -> None:
    """Writes a file that only this user may read; an older one stays until it is whole.

    Raises:
        OSError: It can't be written; nothing is left of it.
    """
    prefix, suffix = f".{path.stem[:40]}.", f"{SUFFIX}.new"
    _clear_left(path.parent, prefix, suffix)
    descriptor, made = tempfile.mkstemp(prefix=prefix, suffix=suffix, dir=path.parent)
    try:
        with os.fdopen(descriptor, "wb") as file:
            for piece in pieces:
                file.write(piece)
            file.flush()
            os.fsync(file.fileno())
        os.replace(made, path)
    except OSError:
        with contextlib.suppress(OSError):
            os.unlink(made)
        raise


def _clear_left(folder: Path, prefix: str, suffix: str) -> None:
    """Removes what writers that were killed left unfinished; one that writes still touches its file all the time."""
    with contextlib.suppress(OSError):
        for entry in list(os.scandir(folder)):
            if entry.name.startswith(prefix) and entry.name.endswith(suffix):
                with contextlib.suppress(OSError):
                    if entry.stat().st_mtime < time.time() - _LEFT_AFTER_S:
                        os.unlink(entry.path)


def read_parts(path: Path, key: str, secret: bytes) -> IndexParts | None:
    """A kept index, mapped into memory; None where there is none, or not this one, or not whole.

    Args:
        path: Its file.
        key: Of ``key_of``.
        secret: Of this user on this machine.
    """
    try:
        with open(path, "rb") as file:
            mapped = memoryview(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ))
    except (OSError, ValueError):
        return None
    header = _header(mapped, key, secret)
    if header is None:
        return None
    first = _padded(len(_MAGIC) + 4 + _MAC_BYTES + header["length"])
    if len(mapped) != first + header["bytes"]:
        return None
    parts = {}
    for name, (kind, shape, offset, checksum) in header["arrays"].items():
        array = np.frombuffer(mapped, kind, math.prod(shape), first + offset).reshape(shape)
        if zlib.crc32(_bytes(array)) != checksum:
            return None
        parts[name] = array
    return parts


def _header(mapped: memoryview, key: str, secret: bytes) -> dict[str, Any] | None:
    """What the file says of itself; None unless this user wrote it on this machine, of these landmarks."""
    start = len(_MAGIC) + 4 + _MAC_BYTES
    if len(mapped) < start or bytes(mapped[: len(_MAGIC)]) != _MAGIC:
        return None
    length = int.from_bytes(mapped[len(_MAGIC) : len(_MAGIC) + 4], "little")
    if length > _LARGEST_HEADER or len(mapped) < start + length:
        return None
    told, stated = bytes(mapped[start : start + length]), bytes(mapped[len(_MAGIC) + 4 : start])
    # Only what has the code is read at all: it was written by write_parts.
    if not hmac.compare_digest(_mac(told, secret), stated):
        return None
    header = json.loads(told)
    return {**header, "length": length} if header["key"] == key else None


def _fit(parts: IndexParts, references: MapLandmarks, settings: ConstellationSettings) -> bool:
    """Whether the arrays have the shapes and kinds of an index of these landmarks."""
    expected = part_shapes(len(references), settings)
    if set(parts) != set(expected):
        return False
    triangles = len(parts["keys"])
    return all(
        array.dtype.str == kind and array.shape == tuple(triangles if n is None else n for n in shape)
        for array, (kind, shape) in ((parts[name], expected[name]) for name in expected)
    )


def _secret() -> bytes | None:
    """This user's on this machine, made at the first use; None where none can be kept."""
    try:
        folder = Path(os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA") or Path.home() / ".cache")
        path = folder / "semref" / "index.secret"
        path.parent.mkdir(parents=True, exist_ok=True)
        # One that was cut short is none.
        if not path.exists() or path.stat().st_size != _SECRET_BYTES:
            _write_whole(path, [secrets.token_bytes(_SECRET_BYTES)])
        found = path.read_bytes()
    except (OSError, RuntimeError):
        # RuntimeError: a user without a home.
        return None
    return found if len(found) == _SECRET_BYTES else None


def _mac(header: bytes, secret: bytes) -> bytes:
    return hmac.new(secret, _MAGIC + header, hashlib.sha256).digest()


def _bytes(array: np.ndarray) -> memoryview:
    return array.reshape(-1).view(np.uint8).data


def _aligned(pieces: Iterable[bytes | memoryview]) -> Iterator[bytes | memoryview]:
    """The pieces, with zeros behind each."""
    for piece in pieces:
        yield piece
        yield b"\0" * (_padded(len(piece)) - len(piece))


def _padded(count: int) -> int:
    return -(-count // _ALIGNED) * _ALIGNED
