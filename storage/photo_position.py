"""Where a photo says it was taken: what satellites told its camera (EXIF), which localization does not ask."""

from __future__ import annotations

import math
import os
import re

from ..core.errors import LabelMapError
from ..core.labels.photo_camera import PHOTO_EXTENSIONS
from .rasters import open_raster

_AXES = (("Longitude", "EW", 180.0), ("Latitude", "NS", 90.0))
"""EXIF's name of each, its letters for positive and negative degrees, and the most of them."""

_VOID = "V"
"""Status of a receiver that had no position."""


def photo_lon_lat(path: str) -> tuple[float, float] | None:
    """(longitude, latitude) in degrees that a photo states, or the photo of an image's name beside it.

    None where nothing is stated, nothing that can be, or 0, 0: what cameras write that know none.
    """
    stem = os.path.splitext(path)[0]
    beside = [stem + extension for extension in PHOTO_EXTENSIONS]
    for photo in (path, *(name for name in beside if name != path and os.path.isfile(name))):
        found = _stated(photo)
        if found is not None:
            return found
    return None


def _stated(path: str) -> tuple[float, float] | None:
    try:
        file = open_raster(path)
    except LabelMapError:
        return None
    # JPEGs have EXIF among their own metadata, TIFFs in a domain.
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
    """Of “(degrees) (minutes) (seconds)” with a letter for the side; None for anything else."""
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
