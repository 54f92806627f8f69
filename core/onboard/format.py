"""Format of the onboard file: a reference database as one small ``.npz`` (docs/reference/file_formats.md).

It is a zip of arrays in numpy's own format, without pickles, for a computer without QGIS. A signature proves that the
holder of a key made it.
"""

from __future__ import annotations

import hashlib
import hmac
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from enum import Enum

from ..database.model import ReferenceDatabase
from ..errors import ParameterError, reason_of
from ..geometry.lon_lat import LonLatPolynomial
from ..values import checked

FORMAT = "semref onboard"
ONBOARD_VERSION = 1

PRECISION_PX = 0.05
"""Default of the largest rounding error of a landmark's x and y, in pixels of the label map."""

AREA_STEPS = 400
"""Steps of the logarithm of areas, from the smallest to the largest landmark. An area is rounded by at most 1.5 %."""

VECTOR_STEPS = 255

HEADER, HASH, SIGNATURE = "header", "content_hash", "signature"
KINDS = {
    HEADER: ("|u1", 1),
    HASH: ("|u1", 1),
    SIGNATURE: ("|u1", 1),
    "windows_columns": ("<u4", 1),
    "windows_rows": ("<u4", 1),
    "windows_levels": ("|u1", 1),
    "windows_counts": ("<u4", 1),
    "windows_vectors": ("|u1", 2),
    "references_positions": ("<u4", 2),
    "references_areas": ("<u2", 1),
    "references_classes": ("|u1", 1),
    "references_touches_edge": ("|u1", 1),
    "overview_labels": ("|u1", 2),
}
"""Type and number of axes of every member; overview and signature are optional."""

NOT_ON_BOARD = "block_hashes"
"""Build parameter that only database updates need."""


class SignatureStatus(str, Enum):
    """Status of an onboard file's signature, as text."""

    NONE = "not signed"
    NOT_CHECKED = "signed, not checked: no key was given"
    VERIFIED = "signed with the key"


@dataclass(frozen=True)
class OnboardDatabase:
    """Contents of an onboard file: the database, its map coordinates as degrees, and its rounding errors.

    Attributes:
        lon_lat: None if the file does not contain longitude and latitude.
        position_error: Largest error of a landmark's x and y, m.
        area_error: Largest error of a landmark's area, as a share.
        vector_error: Largest error of an element of a topology vector; its class ranks are exact.
        content_hash: SHA-256 of the file's arrays.
        exported: Date of the export; None in files of versions without it.
    """

    database: ReferenceDatabase
    lon_lat: LonLatPolynomial | None
    position_error: float
    area_error: float
    vector_error: float
    content_hash: str
    size_bytes: int
    exported: datetime | None = None
    signature: SignatureStatus = SignatureStatus.NONE


def export_date(text: object) -> datetime:
    """Return the time of an ISO 8601 text with time zone; raises ValueError for anything else."""
    moment = datetime.fromisoformat(checked(text, str, "exported"))
    if moment.utcoffset() is None:
        raise ValueError(f"exported is {text}, without a time zone")
    return moment


def is_onboard_file(path: str) -> bool:
    """Return whether a file, damaged or not, has the members of an onboard file."""
    try:
        with zipfile.ZipFile(path) as archive:
            return f"{HASH}.npy" in archive.namelist()
    except (zipfile.BadZipFile, OSError):
        return False


def digest(files: Mapping[str, bytes]) -> bytes:
    """Return SHA-256 of all .npy files except hash and signature, in the order of their names."""
    found = hashlib.sha256()
    for name in sorted(files):
        if name not in (HASH, SIGNATURE):
            found.update(files[name])
    return found.digest()


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
