"""A localization as a row of a table, a line of JSON, a sentence of NMEA 0183."""

from __future__ import annotations

from datetime import datetime
from typing import Any, Dict, Optional

from ..localization import Localization

ESTIMATED, INVALID = 6, 0
"""GGA's fix quality: an estimated position, and none."""


def record(result: Localization) -> Dict[str, Any]:
    """Columns of *Localize images* by name, as docs/file-formats.md tells them; None where a method doesn't tell."""
    x, y = result.position or (None, None)
    found = {
        "status": result.status,
        "x": x,
        "y": y,
        "heading": result.heading_deg,
        "pixel_size": result.pixel_size_m,
        "confidence": result.confidence,
        "distance": result.distance,
        "inliers": result.inliers,
        "references": result.references,
        "log_odds": result.log_odds,
        "error_95": result.error_95_m,
        "window": result.window,
        "method": result.method,
        "reason": result.reason,
    }
    return {**found, **_deviations(result)}


def _deviations(result: Localization) -> Dict[str, Any]:
    """What the constellation tells of a fix's accuracy beside ``error_95``, the longer half axis of its ellipse."""
    if result.position is None or result.uncertainty is None:
        return {}
    found = result.uncertainty
    return {
        "error_95_minor": found.semi_minor,
        "error_95_direction": found.orientation_deg,
        "heading_deviation": found.heading_deviation_deg,
        "pixel_size_deviation": found.pixel_size_deviation,
    }


def gga_sentence(
    time_utc: datetime, longitude: Optional[float] = None, latitude: Optional[float] = None, landmarks: int = 0
) -> str:
    """NMEA 0183's GGA, without line end: quality 6 (estimated) with a position in degrees, 0 (invalid) without.

    Where a receiver counts satellites stand the landmarks that agree with the map, 99 at most; dilution of precision
    and heights stay empty. Minutes have five decimals: 2 cm.
    """
    time = f"{time_utc:%H%M%S}.{time_utc.microsecond // 10_000:02d}"
    place, quality = ",,,", INVALID
    if longitude is not None and latitude is not None:
        quality = ESTIMATED
        place = f"{_angle(latitude, 2)},{'SN'[latitude >= 0]},{_angle(longitude, 3)},{'WE'[longitude >= 0]}"
    text = f"GPGGA,{time},{place},{quality},{min(landmarks, 99):02d},,,M,,M,,"
    checksum = 0
    for character in text.encode("ascii"):
        checksum ^= character
    return f"${text}*{checksum:02X}"


def _angle(degrees: float, digits: int) -> str:
    """dddmm.mmmmm; rounded before it is taken apart, so that the minutes never become 60."""
    whole, minutes = divmod(round(abs(degrees) * 60 * 100_000), 60 * 100_000)
    return f"{whole:0{digits}d}{minutes // 100_000:02d}.{minutes % 100_000:05d}"
