"""NMEA 0183 sentences of positions."""

from __future__ import annotations

from datetime import datetime

ESTIMATED, INVALID = 6, 0
"""GGA's fix quality: an estimated position, and no position."""


def gga_sentence(
    time_utc: datetime, longitude: float | None = None, latitude: float | None = None, landmarks: int = 0
) -> str:
    """Return NMEA 0183's GGA, without line end: quality 6 (estimated) with a position in degrees, 0 (invalid) without.

    The field for satellites has the number of landmarks that agree with the map, 99 at most; dilution of precision and
    heights stay empty. Minutes have five decimals: 2 cm.
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
    """Return dddmm.mmmmm; rounded before it is split, so that the minutes never become 60."""
    whole, minutes = divmod(round(abs(degrees) * 60 * 100_000), 60 * 100_000)
    return f"{whole:0{digits}d}{minutes // 100_000:02d}.{minutes % 100_000:05d}"
