"""Signing an onboard file with a key that its makers and its aircraft share: HMAC-SHA256."""

from __future__ import annotations

import hashlib
import hmac
from collections.abc import Mapping

from ..errors import ParameterError, reason_of
from .format import HASH, SIGNATURE

SHORTEST_KEY, LONGEST_KEY = 16, 4096
"""Bytes of a key file; 32 random ones are as many as SHA-256 makes use of."""

_PURPOSE = b"semref onboard signature 1\0"
"""Keeps a signature from being one of something else that is signed with the same key."""


def read_key(path: str) -> bytes:
    """The bytes of a key file, whatever they are.

    Raises:
        ParameterError: It can't be read, or is too short or too long for a key.
    """
    try:
        with open(path, "rb") as file:
            key = file.read(LONGEST_KEY + 1)
    except OSError as error:
        raise ParameterError("The key {path} can't be read: {reason}.", path=path, reason=reason_of(error)) from None
    if not SHORTEST_KEY <= len(key) <= LONGEST_KEY:
        raise ParameterError(
            "The key {path} has {size} bytes; a key has {least} to {most} random ones.",
            path=path,
            size=len(key),
            least=SHORTEST_KEY,
            most=LONGEST_KEY,
        )
    return key


def signature(files: Mapping[str, bytes], key: bytes) -> bytes:
    """HMAC-SHA256 of all .npy files but hash and signature: name, length and content of each, in order of their names.

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


def is_signed_with(files: Mapping[str, bytes], stated: bytes, key: bytes) -> bool:
    """Whether ``stated`` is the signature of the files with this key, found in constant time."""
    return hmac.compare_digest(signature(files, key), stated)
