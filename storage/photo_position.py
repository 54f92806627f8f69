"""Read the satellite position in a photo's EXIF data. Localization does not use it."""

from __future__ import annotations

import math
import os
import re

from ..core.errors import ImageError
from ..core.labels.photo_camera import PHOTO_EXTENSIONS
from .rasters import open_raster

_AXES = (("Longitude", "EW", 180.0), ("Latitude", "NS", 90.0))
"""EXIF's name, the letters for positive and negative degrees, and the largest value."""

_VOID = "V"
"""Status of a receiver without a position."""


def photo_lon_lat(path: str) -> tuple[float, float] | None:
    """Return (longitude, latitude) in degrees from a photo, or from the photo beside an image with the same stem.

    Returns None without a valid position, and for 0, 0, which cameras write without a position.
    """
    stem = os.path.splitext(path)[0]
    beside = [stem + extension for extension in PHOTO_EXTENSIONS]
    for photo in (path, *(name for name in beside if name != path and os.path.isfile(name))):
        found = _read_position(photo)
        if found is not None:
            return found
    return None


def _read_position(path: str) -> tuple[float, float] | None:
    try:
        file = open_raster(path)
    except ImageError:
        return None
    # A JPEG has EXIF data among its own metadata, a TIFF in a domain.
    tags = {**file.GetMetadata(), **(file.GetMetadata("EXIF") or {})}
    if tags.get("EXIF_GPSStatus", "").strip() == _VOID:
        return None
    longitude, latitude = (
        _degrees(tags.get(f"EXIF_GPS{name}", ""), tags.get(f"EXIF_GPS{name}Ref", ""), letters, most)
        for name, letters, most in _AXES
    )
    if longitude is None or latitude is None or longitude == latitude == 0:
        return None
    return longitude, latitude


def _degrees(text: str, letter: str, letters: str, most: float) -> float | None:
    """Parse “(degrees) (minutes) (seconds)” and the letter of the hemisphere. Returns None for other texts."""
    side = letter.strip()[:1].upper()
    parts = re.findall(r"\(([^()]*)\)", text)
    if len(parts) != 3 or not side or side not in letters:
        return None
    try:
        degrees = sum(float(part) / 60**power for power, part in enumerate(parts))
    except ValueError:
        return None
    if not (math.isfinite(degrees) and 0 <= degrees <= most):
        return None
    return degrees if side == letters[0] else -degrees
