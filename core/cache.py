"""Cache of arrays that take long to build: files in a private folder of the user, never next to the user's data.

The name of a file is a hash of everything that its arrays were built from. A secret of this user authenticates the
content. A damaged or foreign file is not used, and the arrays are built again (docs/reference/file_formats.md#cache).
"""

from __future__ import annotations

import contextlib
import errno
import hashlib
import hmac
import json
import logging
import math
import mmap
import os
import secrets
import stat
import sys
import tempfile
import time
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import BinaryIO

import numpy as np

from . import limits

Arrays = dict[str, np.ndarray]
"""Arrays by name."""

_ABANDONED_AFTER_S = 600
"""A temporary file without a change for this long belongs to a writer that was killed."""

_LOG = logging.getLogger("semref")

_SUFFIX = ".semref-cache"
_TEMPORARY = ".semref-tmp"
_ALIGNMENT = 64
_MAC_BYTES = 32
_SECRET_BYTES = 32
_OPEN_FLAGS = os.O_RDONLY | sum(getattr(os, flag, 0) for flag in ("O_NOFOLLOW", "O_NONBLOCK", "O_BINARY"))
"""Flags to not follow a link and not wait for a pipe, on systems that have these flags."""


def digest(columns: Iterable[np.ndarray | bytes]) -> str:
    """Return the SHA-256 of the columns of a table, each preceded by its length in bytes; hexadecimal."""
    found = hashlib.sha256()
    for column in columns:
        # No copy: a column can have gigabytes.
        data = column if isinstance(column, bytes) else _bytes(np.ascontiguousarray(column))
        found.update(len(data).to_bytes(8, "little"))
        found.update(data)
    return found.hexdigest()


def load_or_build(kind: str, key: str, build: Callable[[], Arrays]) -> Arrays:
    """Return arrays from the cache; if they are missing, build and store them.

    Args:
        kind: Kind of the arrays: the first part of the file name.
        key: ``digest`` of everything that the arrays are built from, and of the version of the code that builds them.
    """
    name = f"{kind}-{key}{_SUFFIX}"
    secret = user_secret()
    arrays = None if secret is None else _load(name, secret)
    if arrays is None:
        arrays = build()
        try:
            if secret is None:
                raise _os_error(errno.EACCES)
            _store(name, secret, arrays)
        except OSError as error:
            _LOG.log(logging.WARNING, "not_cached", extra={"details": {"kind": kind, "reason": error.strerror}})
    return arrays


def cache_folder() -> Path:
    """Return the user's cache folder for SemRef; the environment variable SEMREF_CACHE overrides it.

    Raises:
        RuntimeError: The user has no home folder.
    """
    if chosen := os.environ.get("SEMREF_CACHE"):
        return Path(chosen)
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "semref"
    base = os.environ.get("LOCALAPPDATA" if os.name == "nt" else "XDG_CACHE_HOME", "")
    return (Path(base) if os.path.isabs(base) else Path.home() / ".cache") / "semref"


def user_secret() -> bytes | None:
    """Return the secret of this user on this machine, created at first use; None without a private cache folder."""
    try:
        folder = cache_folder()
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        status = os.lstat(folder)
        if not stat.S_ISDIR(status.st_mode) or not _is_own(status):
            return None
        path = folder / "secret"
        with contextlib.suppress(OSError), _open(path) as file:
            if len(found := file.read(_SECRET_BYTES + 1)) == _SECRET_BYTES:
                return found
        write_atomically(path, [secrets.token_bytes(_SECRET_BYTES)])
        with _open(path) as file:
            return file.read()
    except (OSError, RuntimeError):
        return None


def _is_own(status: os.stat_result) -> bool:
    """Return whether only this user can write to it. On Windows the access list of the folder protects it."""
    return os.name == "nt" or (status.st_uid == os.geteuid() and not status.st_mode & 0o022)


def _open(path: Path) -> BinaryIO:
    """Open a regular file of this user; raises OSError for everything else."""
    descriptor = os.open(path, _OPEN_FLAGS)
    status = os.fstat(descriptor)
    if stat.S_ISREG(status.st_mode) and _is_own(status):
        return os.fdopen(descriptor, "rb")
    os.close(descriptor)
    raise _os_error(errno.EACCES)


def _load(name: str, secret: bytes) -> Arrays | None:
    """Return the arrays of a file, mapped into memory; None if the file is missing or was changed.

    Reading 10⁷ landmarks instead takes 3 to 5 times as long, and 2 GB in each process. Other users can't truncate the
    file under the mapping, and SemRef only replaces or removes it as a whole.
    """
    path = cache_folder() / name
    try:
        with _open(path) as file:
            mapped = memoryview(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ))
    except (OSError, ValueError):
        return None
    if not hmac.compare_digest(_mac(name, secret, [mapped[_MAC_BYTES:]]), bytes(mapped[:_MAC_BYTES])):
        return None
    with contextlib.suppress(OSError):
        os.utime(path)
    first = _MAC_BYTES + 4 + int.from_bytes(mapped[_MAC_BYTES : _MAC_BYTES + 4], "little")
    layout = json.loads(bytes(mapped[_MAC_BYTES + 4 : first]))
    return {
        array: np.frombuffer(mapped, kind, math.prod(shape), first + offset).reshape(shape)
        for array, (kind, shape, offset) in layout.items()
    }


def _store(name: str, secret: bytes, arrays: Arrays) -> None:
    """Write arrays as a file: MAC, length of the header, header (JSON), arrays. Raises OSError."""
    layout, pieces, offset = {}, [], 0
    for array, values in arrays.items():
        layout[array] = values.dtype.str, values.shape, offset
        padding = -values.nbytes % _ALIGNMENT
        pieces += [_bytes(np.ascontiguousarray(values)), bytes(padding)]
        offset += values.nbytes + padding
    header = json.dumps(layout).encode("ascii")
    header += b" " * (-(_MAC_BYTES + 4 + len(header)) % _ALIGNMENT)
    pieces = [len(header).to_bytes(4, "little"), header, *pieces]
    folder = cache_folder()
    if offset > limits.CACHE_BYTES:
        raise _os_error(errno.EFBIG)
    write_atomically(folder / name, [_mac(name, secret, pieces), *pieces])
    _remove_oldest(folder)


def write_atomically(path: Path, pieces: Iterable[bytes | memoryview]) -> None:
    """Write a file that only this user can read, atomically. If it fails, raise OSError and leave no file."""
    descriptor, temporary = tempfile.mkstemp(prefix=".", suffix=_TEMPORARY, dir=path.parent)
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.writelines(pieces)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except OSError:
        with contextlib.suppress(OSError):
            os.unlink(temporary)
        raise


def _remove_oldest(folder: Path) -> None:
    """Remove abandoned temporary files, and the least recently used files until the rest is within the limit."""
    with contextlib.suppress(OSError):
        files = [(file, file.stat(follow_symlinks=False)) for file in os.scandir(folder)]
        total = 0
        for file, status in sorted(files, key=lambda found: -found[1].st_mtime):
            is_cache = file.name.endswith(_SUFFIX) and stat.S_ISREG(status.st_mode)
            total += status.st_size if is_cache else 0
            is_abandoned = file.name.endswith(_TEMPORARY) and status.st_mtime < time.time() - _ABANDONED_AFTER_S
            if is_abandoned or (is_cache and total > limits.CACHE_BYTES):
                with contextlib.suppress(OSError):
                    os.unlink(file.path)


def _os_error(number: int) -> OSError:
    return OSError(number, os.strerror(number))


def _mac(name: str, secret: bytes, pieces: Iterable[bytes | memoryview]) -> bytes:
    found = hmac.new(secret, name.encode("ascii"), hashlib.sha256)
    for piece in pieces:
        found.update(piece)
    return found.digest()


def _bytes(array: np.ndarray) -> memoryview:
    return array.reshape(-1).view(np.uint8).data
