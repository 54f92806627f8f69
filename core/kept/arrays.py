"""Arrays that take long to make, kept in a file beside a database: opened by memory mapping, not made at every start.

A file is whole or not used: its header tells what its arrays were made of, the place, kind and checksum of each, and
carries a code (HMAC) made with a secret of this user on this machine. So what came along with somebody else's database,
or was made of something else, is made anew and never believed. Told in docs/file-formats.md#kept-beside-a-database.
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
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

Arrays = dict[str, np.ndarray]
"""By name."""

_LEFT_AFTER_S = 600
"""An unfinished file that nobody wrote to for so long was left by a writer that was killed."""

_LOG = logging.getLogger("semref")

_MAGIC = b"SemRef index\n\x00\x01\x00"
_ALIGNED = 64
_LARGEST_HEADER = 1 << 16
_MAC_BYTES = 32
_SECRET_BYTES = 32


def kept_path(database: str, suffix: str) -> Path:
    """Where something of a database is kept: beside it, ``suffix`` behind its name with its own suffix."""
    return Path(f"{database}{suffix}")


def opened_or_made(
    path: Path, key: str, make: Callable[[], Arrays], fit: Callable[[Arrays], bool], database: str
) -> Arrays:
    """Arrays opened where they are kept, else made and kept.

    Args:
        path: Their file; an older one is replaced at once and whole.
        key: What tells these arrays from others: of all that they are made of.
        make: Makes them.
        fit: Whether arrays that were kept have the kinds and shapes of such.
        database: That they are of, for the log: where they can't be kept a line says so.
    """
    secret = user_secret()
    arrays = None if secret is None else read_arrays(path, key, secret)
    if arrays is None or not fit(arrays):
        arrays = make()
        if secret is None or not write_arrays(path, key, secret, arrays):
            details = {"database": database, "file": path.name}
            _LOG.log(logging.WARNING, "not_kept", extra={"details": details})
    return arrays


def write_arrays(path: Path, key: str, secret: bytes, arrays: Arrays) -> bool:
    """Keeps arrays; whether that was possible.

    Args:
        path: Their file; an older one is replaced at once and whole.
        key: As of ``opened_or_made``.
        secret: Of this user on this machine.
        arrays: What is kept.
    """
    whole = {name: np.ascontiguousarray(array) for name, array in arrays.items()}
    layout: dict[str, list] = {}
    offset = 0
    for name, array in whole.items():
        layout[name] = [array.dtype.str, list(array.shape), offset, zlib.crc32(_bytes(array))]
        offset += _padded(array.nbytes)
    header = json.dumps({"key": key, "arrays": layout, "bytes": offset}).encode("ascii")
    head = _MAGIC + len(header).to_bytes(4, "little") + _mac(header, secret) + header
    try:
        _write_whole(path, _aligned([head, *map(_bytes, whole.values())]))
    except OSError:
        return False
    return True


def _write_whole(path: Path, pieces: Iterable[bytes | memoryview]) -> None:
    """Writes a file that only this user may read; an older one stays until it is whole.

    Raises:
        OSError: It can't be written; nothing is left of it.
    """
    prefix, suffix = f".{path.stem[:40]}.", f"{path.suffix}.new"
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


def read_arrays(path: Path, key: str, secret: bytes) -> Arrays | None:
    """Kept arrays, mapped into memory; None where there are none, or not these, or not whole.

    Args:
        path: Their file.
        key: As of ``opened_or_made``.
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
    arrays = {}
    for name, (kind, shape, offset, checksum) in header["arrays"].items():
        array = np.frombuffer(mapped, kind, math.prod(shape), first + offset).reshape(shape)
        if zlib.crc32(_bytes(array)) != checksum:
            return None
        arrays[name] = array
    return arrays


def _header(mapped: memoryview, key: str, secret: bytes) -> dict[str, Any] | None:
    """What the file says of itself; None unless this user wrote it on this machine, of just this."""
    start = len(_MAGIC) + 4 + _MAC_BYTES
    if len(mapped) < start or bytes(mapped[: len(_MAGIC)]) != _MAGIC:
        return None
    length = int.from_bytes(mapped[len(_MAGIC) : len(_MAGIC) + 4], "little")
    if length > _LARGEST_HEADER or len(mapped) < start + length:
        return None
    told, stated = bytes(mapped[start : start + length]), bytes(mapped[len(_MAGIC) + 4 : start])
    # Only what has the code is read at all: it was written by write_arrays.
    if not hmac.compare_digest(_mac(told, secret), stated):
        return None
    header = json.loads(told)
    return {**header, "length": length} if header["key"] == key else None


def user_secret() -> bytes | None:
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
