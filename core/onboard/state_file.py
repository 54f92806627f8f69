"""The file that stores a flight: authenticated as a whole before reading, and replaced as a whole.

It is numpy's ``.npz`` without pickles, followed by 32 bytes: HMAC-SHA256 of a purpose and of all bytes before. The key
is that of the onboard file (``--require-signature``), otherwise a secret of this user on this machine.
"""

from __future__ import annotations

import contextlib
import hashlib
import hmac
import io
import os
import stat
import zipfile
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from .. import limits
from ..cache import user_secret, write_atomically
from ..errors import ParameterError
from ..labels.image_files import open_at_once
from .format import read_key

_PURPOSE = b"semref flight state 2\0"
"""Separates these codes from others with the same key."""

_CODE_BYTES = hashlib.sha256().digest_size


_FIRST_BYTES = 64
_ZIP, _FIRST_NAME = b"PK\x03\x04", b"header.npy"


def _looks_like_a_state(path: str) -> bool:
    """Return whether a file begins as states do, or is empty as after a power failure. Others belong to the user."""
    with contextlib.suppress(OSError), open(path, "rb", opener=open_at_once) as file:
        first = file.read(_FIRST_BYTES)
        return not first.strip(b"\0") or first.startswith(_ZIP) and _FIRST_NAME in first
    return False


@dataclass(frozen=True)
class StateFile:
    """Path of a state, and the key that authenticates it.

    Attributes:
        key: Of ``read_key``, or the user's secret.
    """

    path: str
    key: bytes = field(repr=False)

    @classmethod
    def at(cls, path: str, key_file: str | None) -> StateFile:
        """Return the state file at a path, which need not exist.

        Args:
            key_file: Key of the onboard file; None for the user's secret.

        Raises:
            ParameterError: The key can't be used, or the path can't store a state.
        """
        folder = os.path.dirname(path) or "."
        if not os.path.isdir(folder):
            raise ParameterError(
                "The folder {folder} of --state {path} does not exist. Create it or choose another one.",
                path=path,
                folder=folder,
            )
        # Replacing a device or a pipe would remove it.
        if os.path.exists(path) and not os.path.isfile(path):
            raise ParameterError("--state {path} is not a regular file. Choose another name.", path=path)
        if os.path.exists(path) and not _looks_like_a_state(path):
            raise ParameterError(
                "--state {path} is a file of another kind and would be replaced. Choose another name.", path=path
            )
        key = read_key(key_file) if key_file else user_secret()
        if key is None:
            raise ParameterError(
                "This user has no private folder for the secret that authenticates --state. Create a home folder for "
                "the user, or add --require-signature."
            )
        return cls(path, key)

    def pack(self, arrays: dict[str, np.ndarray]) -> bytes:
        """Return the authenticated content of a state from its numbers by name."""
        packed = io.BytesIO()
        np.savez(packed, **arrays)
        data = packed.getvalue()
        return data + self.code(data)

    def write(self, content: bytes) -> None:
        """Replace the state atomically; raises OSError if it can't be written, and keeps the old one.

        Args:
            content: Result of ``pack``.
        """
        write_atomically(Path(self.path), [content])

    def read(self) -> dict[str, np.ndarray]:
        """Return the arrays of the state by name.

        Raises:
            OSError: The file can't be read.
            ParameterError: The file has another key, was changed, or is not a state.
        """
        with open(self.path, "rb", opener=open_at_once) as file:
            status = os.fstat(file.fileno())
            if not stat.S_ISREG(status.st_mode) or status.st_size > limits.STATE_BYTES:
                raise self.not_ours()
            data = file.read(status.st_size)
        data, code = data[:-_CODE_BYTES], data[-_CODE_BYTES:]
        if not hmac.compare_digest(self.code(data), code):
            raise ParameterError(
                "{path} has another key than this flight (that of --require-signature, otherwise the secret of this "
                "user), or was changed since.",
                path=self.path,
            )
        try:
            with np.load(io.BytesIO(data), allow_pickle=False) as arrays:
                return dict(arrays)
        except (OSError, ValueError, MemoryError, zipfile.BadZipFile) as error:
            raise self.not_ours() from error

    def not_ours(self) -> ParameterError:
        """Return the error for content that is not a state."""
        return ParameterError(
            "{path} is not the state of a flight of this SemRef version, or is damaged.", path=self.path
        )

    def code(self, data: bytes) -> bytes:
        """Return the code that authenticates the bytes of a state; ``data``: the ``.npz``."""
        return hmac.new(self.key, _PURPOSE + data, hashlib.sha256).digest()
