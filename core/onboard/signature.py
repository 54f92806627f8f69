"""Sign an onboard file with a key that its makers and its aircraft share: HMAC-SHA256."""

from __future__ import annotations

import hashlib
import hmac
from collections.abc import Mapping

from ..errors import ParameterError, reason_of
from .format import HASH, SIGNATURE

SHORTEST_KEY, LONGEST_KEY = 16, 4096
"""Bytes of a key file; SHA-256 uses at most 32 random ones."""

_PURPOSE = b"semref onboard signature 1\0"
"""Separates these signatures from others with the same key."""


def read_key(path: str) -> bytes:
    """Return the bytes of a key file.

    Raises:
        ParameterError: The file can't be read, or is too short or too long for a key.
    """
    try:
        with open(path, "rb") as file:
            key = file.read(LONGEST_KEY + 1)
    except OSError as error:
        raise ParameterError("The key {path} can't be read: {reason}.", path=path, reason=reason_of(error)) from None
    if not SHORTEST_KEY <= len(key) <= LONGEST_KEY:
        raise ParameterError(
            "The key {path} has {size} bytes; a key needs {least} to {most} random bytes.",
            path=path,
            size=len(key),
            least=SHORTEST_KEY,
            most=LONGEST_KEY,
        )
    return key


def signature(files: Mapping[str, bytes], key: bytes) -> bytes:
    """Return HMAC-SHA256 of all .npy files except hash and signature: name, length and content, in order of names.

    Args:
        files: .npy files by name.
        key: Of ``read_key``.
    """
    found = hmac.new(key, _PURPOSE, hashlib.sha256)
    for name in sorted(files):
        if name not in (HASH, SIGNATURE):
            found.update(f"{name}\0{len(files[name])}\0".encode("ascii"))
            found.update(files[name])
    return found.digest()
