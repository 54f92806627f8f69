"""Flight log over time: heading, roll, pitch, height and velocity, interpolated at the times of images.

Satellite positions are not used: SemRef is for flights without reliable ones.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from ..errors import ParameterError
from ..geometry.camera import Camera, above_takeoff
from ..geometry.leveling import attitude_from_gimbal
from .motion import Link, LinkSource

FIELDS = ("heading", "roll", "pitch", "height", "east", "north")
"""Degrees clockwise from north, degrees, degrees, meters above take-off, meters per second to the east and north."""

_ANGLES = 3
_RANGES = ((-720.0, 720.0), (-180.0, 180.0), (-180.0, 180.0), (-500.0, 20_000.0), (-400.0, 400.0), (-400.0, 400.0))
"""Possible values of an aircraft; others count as missing."""

MOST_GAP_S = 2.0
"""Between entries with a larger gap, values are unknown."""

ZONE_S = 900.0
"""Camera clocks use local time: they differ from the log's clock by a multiple of a quarter of an hour."""

SPEED_SPREAD_MS, SPEED_SHARE = 0.3, 0.03
"""Standard deviation of a distance integrated from velocities: meters per second, and a share of the distance."""

HEADING_SPREAD_DEG, TURN_SPREAD_DEG = 5.0, 2.0
"""Standard deviation of the log's heading against grid north, and of the difference of two of its headings."""

LEAST_HEIGHT_M = 2.0


@dataclass(frozen=True, eq=False)
class Telemetry:
    """Entries of a flight log.

    Attributes:
        times_s: (N,) ascending, seconds.
        values: (N, 6) in the order of FIELDS; NaN if missing.
        is_clock: Times are seconds since 1970 (UTC or the camera's zone), not since a start.
        is_gimbal: Roll and pitch are those of the camera's gimbal, −90° looking down; otherwise those of the aircraft.
        images: Image name of each entry, without folder and extension; empty for entries of times.
        until_s: For a log that grows: the time, on its clock, that its writer may not have reached yet.
    """

    times_s: np.ndarray = field(repr=False)
    values: np.ndarray = field(repr=False)
    is_clock: bool = False
    is_gimbal: bool = False
    images: tuple[str, ...] = ()
    until_s: float = -math.inf

    def at(self, times_s: Sequence[float] | np.ndarray) -> np.ndarray:
        """Return (M, 6) in the order of FIELDS at some times; NaN where the log has no entry near enough.

        Args:
            times_s: (M,) seconds, on the log's clock.
        """
        wanted = np.asarray(times_s, np.float64)
        found = np.full((len(wanted), len(FIELDS)), np.nan)
        for column in range(len(FIELDS)):
            known = np.isfinite(self.values[:, column])
            if known.any():
                angles = column < _ANGLES
                found[:, column] = _between(wanted, self.times_s[known], self.values[known, column], angles)
        found[:, 0] %= 360
        return found

    def way(self, start_s: float, end_s: float) -> complex | None:
        """Return the motion between two times, meters to the east + i to the north; None if velocities are missing.

        Args:
            start_s: Seconds, on the log's clock.
        """
        is_known = np.isfinite(self.values[:, 4:]).all(axis=1)
        inside = self.times_s[is_known & (self.times_s > start_s) & (self.times_s < end_s)]
        times = np.concatenate([[start_s], inside, [end_s]])
        speeds = self.at(times)[:, 4:] @ np.array([1.0, 1j])
        if not np.isfinite(speeds).all() or np.diff(times).max() > MOST_GAP_S:
            return None
        return complex(((speeds[1:] + speeds[:-1]) / 2 * np.diff(times)).sum())

    def zone(self, times_s: Sequence[float]) -> float:
        """Return the seconds from a camera's clock to the log's: the fewest quarters of an hour that fit all images.

        Args:
            times_s: Of the images. Without a fit, the result is 0.
        """
        if not self.is_clock or not len(times_s) or not len(self.times_s):
            return 0.0
        first, last = min(times_s), max(times_s)
        start, end = self.times_s[0] - 1, max(self.times_s[-1], self.until_s) + 1
        for quarter in sorted(range(-56, 57), key=abs):
            if start <= first + quarter * ZONE_S and last + quarter * ZONE_S <= end:
                return quarter * ZONE_S
        return 0.0


def telemetry(
    times_s: Sequence[float] | np.ndarray,
    values: Sequence[Sequence[float]] | np.ndarray,
    is_clock: bool = False,
    is_gimbal: bool = False,
    images: Sequence[str] = (),
) -> Telemetry:
    """Return a log's entries in order, without impossible values; arguments as of ``Telemetry``."""
    times = np.asarray(times_s, np.float64).ravel()
    rows = np.array(values, np.float64).reshape(len(times), len(FIELDS))
    for column, (least, most) in enumerate(_RANGES):
        with np.errstate(invalid="ignore"):
            rows[~((rows[:, column] >= least) & (rows[:, column] <= most)), column] = np.nan
    order = np.argsort(times, kind="stable")
    order = order[np.isfinite(times[order])]
    return Telemetry(times[order], rows[order], is_clock, is_gimbal, tuple(images[n] for n in order) if images else ())


def log_cameras(log: Telemetry, names: Sequence[str], times_s: Sequence[float | None]) -> list[Camera]:
    """Return the camera of each image from a log: heading, height above take-off and, of a gimbal, the attitude.

    Args:
        names: Of the images, without folder and extension.
        times_s: Of the images on their own clock; None if unknown.
    """
    cameras = []
    for row in _rows(log, names, times_s):
        heading, roll, pitch, height = row[:4].tolist()
        attitude = None
        if log.is_gimbal and math.isfinite(roll) and math.isfinite(pitch):
            try:
                attitude = attitude_from_gimbal(roll, pitch)
            except ParameterError:
                # An image that looks near the horizon can't be leveled.
                attitude = None
        cameras.append(
            Camera(
                attitude,
                height=above_takeoff(height) if height > LEAST_HEIGHT_M else None,
                heading_deg=heading if math.isfinite(heading) else None,
            )
        )
    return cameras


def log_links(log: Telemetry, names: Sequence[str], times_s: Sequence[float | None]) -> list[Link]:
    """Return links in meters between consecutive images, from velocities and headings.

    Args:
        names: Of the images, without folder and extension.
        times_s: Of the images on their own clock, ascending; None if unknown.
    """
    moments = _moments(log, names, times_s)
    rows = _rows(log, names, times_s)
    links = []
    for first in range(len(moments) - 1):
        start, end = moments[first], moments[first + 1]
        if start is None or end is None or end <= start:
            continue
        way = log.way(start, end)
        before, after = float(rows[first][0]), float(rows[first + 1][0])
        if way is None or not (math.isfinite(before) and math.isfinite(after)):
            continue
        links.append(
            Link.of_odometry(
                first,
                first + 1,
                way.real,
                way.imag,
                (after - before + 180) % 360 - 180,
                math.hypot(SPEED_SPREAD_MS * (end - start), SPEED_SHARE * abs(way)),
                TURN_SPREAD_DEG,
                heading_deg=before,
                sigma_map_heading_deg=HEADING_SPREAD_DEG,
                source=LinkSource.LOG,
            )
        )
    return links


def _moments(log: Telemetry, names: Sequence[str], times_s: Sequence[float | None]) -> list[float | None]:
    """Return the time of each image on the log's clock."""
    if log.images:
        by_name = dict(zip(log.images, log.times_s.tolist()))
        return [by_name.get(name) for name in names]
    offset = log.zone([time for time in times_s if time is not None])
    return [None if time is None else time + offset for time in times_s]


def _rows(log: Telemetry, names: Sequence[str], times_s: Sequence[float | None]) -> np.ndarray:
    """Return (M, 6) in the order of FIELDS for each image."""
    if log.images:
        by_name = {name: number for number, name in enumerate(log.images)}
        nothing = np.full(len(FIELDS), np.nan)
        return np.array([log.values[by_name[name]] if name in by_name else nothing for name in names]).reshape(-1, 6)
    moments = [math.nan if moment is None else moment for moment in _moments(log, names, times_s)]
    return log.at(moments)


def _between(wanted: np.ndarray, times: np.ndarray, values: np.ndarray, are_angles: bool) -> np.ndarray:
    """Return (M,) interpolated values; NaN outside the log, in gaps and without a time."""
    steady = np.degrees(np.unwrap(np.radians(values))) if are_angles else values
    found = np.interp(wanted, times, steady)
    after = np.searchsorted(times, wanted)
    next_times = times[np.minimum(after, len(times) - 1)]
    previous = times[np.maximum(after - 1, 0)]
    exact = next_times == wanted
    with np.errstate(invalid="ignore"):
        is_gap = (next_times - previous > MOST_GAP_S) | (wanted < times[0]) | (wanted > times[-1])
    found[(is_gap & ~exact) | ~np.isfinite(wanted)] = np.nan
    return found
