"""Positions for an autopilot: MAVLink 2 over UDP or a serial line, with pymavlink, which only this file needs.

Autopilots use meters north and east of an origin. Without an option it is the center of the map, so that it is the same
after a restart; an autopilot without an origin takes the one sent. Height, roll and pitch, which an image can't
provide, are 0 with a standard deviation of ``UNKNOWN``. See docs/how-to/on_board.md.
"""

from __future__ import annotations

import math
import socket
import time
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime, timezone
from typing import Any

import numpy as np

from ..errors import ParameterError, reason_of
from ..geometry.lon_lat import LonLatPolynomial, local_axes, meters_from
from ..localization import Status
from .sinks import LOOPBACK, Sink, not_written

MESSAGES = ("odometry", "vision", "external")
"""Messages of a position: ODOMETRY, VISION_POSITION_ESTIMATE, MAV_CMD_EXTERNAL_POSITION_ESTIMATE."""

UDP, SERIAL = "udp:", "serial:"
BAUD = 115_200
"""Default rate of a serial line."""

UNKNOWN = 100.0
"""Standard deviation of unknown values: meters of height, radians of roll and pitch."""

HEARTBEAT_S = 1.0
"""Seconds between heartbeats, as MAVLink requires."""

WRAP_S = 200.0
"""Period of a command's time: its 32 bits then resolve 15 µs."""


class _Udp:
    def __init__(self, host: str, port: int) -> None:
        self._to = host, port
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)

    def write(self, data: bytes) -> None:
        self._socket.sendto(data, self._to)

    def close(self) -> None:
        self._socket.close()


class _Serial:
    """A serial line, which is opened again after an error: its adapter may have been unplugged."""

    def __init__(self, device: str, rate: int) -> None:
        from serial import Serial, SerialTimeoutException

        self._slow = SerialTimeoutException
        self._line = Serial(device, rate, write_timeout=1)

    def write(self, data: bytes) -> None:
        try:
            if not self._line.is_open:
                self._line.open()
            self._line.write(data)
        except self._slow:
            # The device is there, but its receiver does not read.
            raise
        except Exception as error:
            # termios.error, for one, is not an OSError.
            self._line.close()
            raise OSError(reason_of(error)) from None

    def close(self) -> None:
        self._line.close()


class MavlinkSink(Sink):
    """Sends records of images. A record without a position becomes a heartbeat only.

    So does a record without a heading, unless positions are sent as commands.
    """

    def __init__(  # noqa: PLR0913 - how to send positions
        self,
        where: str,
        lon_lat: LonLatPolynomial,
        message: str = MESSAGES[0],
        system: int = 1,
        origin: tuple[float, float] | None = None,
        camera_yaw_deg: float = 0.0,
    ) -> None:
        """Open the line.

        Args:
            where: ``udp:PORT`` of this computer, ``udp:HOST:PORT``, ``serial:DEVICE`` or ``serial:DEVICE:BAUD``.
            message: One of ``MESSAGES``.
            system: System number of the aircraft.
            origin: (latitude, longitude) in degrees of the autopilot's own origin; None for the center of the map.
            camera_yaw_deg: Direction of the image's top, clockwise from the aircraft's nose.

        Raises:
            ParameterError: The address is invalid, can't be opened, or a package is missing.
        """
        super().__init__(where)
        self._lon_lat, self._message, self._system, self._camera_yaw_deg = lon_lat, message, system, camera_yaw_deg
        self._dialect = _dialect()
        self._line = _open_line(where)
        component = self._dialect.MAV_COMP_ID_VISUAL_INERTIAL_ODOMETRY
        self._mavlink = self._dialect.MAVLink(self._line, srcSystem=system, srcComponent=component)
        self._heartbeat_s = -math.inf
        if origin is None:
            longitudes, latitudes = lon_lat(np.array([lon_lat.center]))
            self._origin, self._has_origin = (float(latitudes[0]), float(longitudes[0])), False
        else:
            self._origin, self._has_origin = origin, True

    def close(self) -> None:
        """Close the line."""
        self._line.close()

    def _take(self, found: dict[str, Any]) -> None:
        now = time.monotonic()
        if now - self._heartbeat_s >= HEARTBEAT_S:
            dialect = self._dialect
            kind, pilot = dialect.MAV_TYPE_ONBOARD_CONTROLLER, dialect.MAV_AUTOPILOT_INVALID
            self._mavlink.heartbeat_send(kind, pilot, 0, 0, dialect.MAV_STATE_ACTIVE)
            self._heartbeat_s = now
        if found.get("status") != Status.FIX:
            # An autopilot never gets a likely position.
            return
        is_external = self._message == "external"
        if found.get("longitude") is None or (found.get("heading") is None and not is_external):
            return
        taken = datetime.fromisoformat(found["time"]) if found.get("time") else datetime.now(timezone.utc)
        place = _vehicle_pose(found, self._lon_lat, self._origin, self._camera_yaw_deg)
        if is_external:
            self._send_external(place, taken)
            return
        if not self._has_origin:
            latitude, longitude = self._origin
            where = round(latitude * 1e7), round(longitude * 1e7)
            self._mavlink.set_gps_global_origin_send(self._system, *where, 0, _microseconds(taken))
            self._has_origin = True
        {"odometry": self._send_odometry, "vision": self._send_vision}[self._message](place, taken)

    def _send_odometry(self, place: _VehiclePose, taken: datetime) -> None:
        dialect, unknown = self._dialect, math.nan
        half = place.yaw / 2
        self._mavlink.odometry_send(
            _microseconds(taken),
            dialect.MAV_FRAME_LOCAL_NED,
            dialect.MAV_FRAME_BODY_FRD,
            *(place.north, place.east, 0.0),
            [math.cos(half), 0.0, 0.0, math.sin(half)],
            *[unknown] * 6,
            place.covariance,
            [unknown] * 21,
            place.resets,
            dialect.MAV_ESTIMATOR_TYPE_VISION,
            place.quality,
        )

    def _send_vision(self, place: _VehiclePose, taken: datetime) -> None:
        position, angles = (place.north, place.east, 0.0), (0.0, 0.0, place.yaw)
        self._mavlink.vision_position_estimate_send(
            _microseconds(taken), *position, *angles, place.covariance, place.resets
        )

    def _send_external(self, place: _VehiclePose, taken: datetime) -> None:
        dialect = self._dialect
        now = datetime.now(timezone.utc)
        # An older image has another clock than this computer.
        age = (now - taken).total_seconds()
        worked = age if 0 <= age < WRAP_S else 0.0
        self._mavlink.command_int_send(
            self._system,
            dialect.MAV_COMP_ID_AUTOPILOT1,
            dialect.MAV_FRAME_GLOBAL,
            dialect.MAV_CMD_EXTERNAL_POSITION_ESTIMATE,
            *(0, 0),
            *(now.timestamp() % WRAP_S, worked, place.deviation, math.nan),
            *(round(place.latitude * 1e7), round(place.longitude * 1e7), math.nan),
        )


@dataclass(frozen=True)
class _VehiclePose:
    """A position in the form of autopilots.

    Attributes:
        latitude: Degrees.
        longitude: Degrees.
        north: Meters from the origin.
        east: Meters from the origin.
        yaw: Of the aircraft's nose, radians clockwise from true north, −π to π.
        covariance: 21 numbers: upper right triangle of (north, east, down, roll, pitch, yaw), row by row.
        deviation: Largest standard deviation along an axis, meters; NaN if unknown.
        resets: Number of the track, 0 to 255; a change means that a position does not continue the ones before.
        quality: 1 to 100 %, 0 if unknown.
    """

    latitude: float
    longitude: float
    north: float
    east: float
    yaw: float
    covariance: Sequence[float]
    deviation: float
    resets: int
    quality: int


def _vehicle_pose(
    found: dict[str, Any], lon_lat: LonLatPolynomial, origin: tuple[float, float], camera_yaw_deg: float
) -> _VehiclePose:
    """Return a record's position, converted from the map's grid to true north and meters on the ellipsoid."""
    latitude, longitude = found["latitude"], found["longitude"]
    north, east = meters_from(origin, (latitude, longitude))
    axes = local_axes(lon_lat, (found["x"], found["y"]))
    convergence = math.atan2(axes[1, 0], axes[1, 1])
    heading = math.radians((found.get("heading") or 0.0) - camera_yaw_deg) + convergence
    covariance, deviation = [math.nan] * 21, math.nan
    if found.get("sigma_east") is not None:
        sigma_x, sigma_y, together = found["sigma_east"], found["sigma_north"], found["correlation"]
        on_map = np.array([[sigma_x**2, together * sigma_x * sigma_y], [together * sigma_x * sigma_y, sigma_y**2]])
        # Rows (east, north).
        true = axes.T @ on_map @ axes
        deviation = math.sqrt(float(np.linalg.eigvalsh(true)[-1]))
        turn = math.radians(found["sigma_heading"]) if found.get("sigma_heading") is not None else UNKNOWN
        full = np.diag([true[1, 1], true[0, 0], *[UNKNOWN**2] * 3, turn**2])
        full[0, 1] = full[1, 0] = true[0, 1]
        covariance = full[np.triu_indices(6)].tolist()
    confidence = found.get("confidence")
    return _VehiclePose(
        latitude,
        longitude,
        north,
        east,
        math.atan2(math.sin(heading), math.cos(heading)),
        covariance,
        deviation,
        int(found.get("track") or 0) % 256,
        0 if confidence is None else max(1, min(100, round(100 * confidence))),
    )


def _microseconds(moment: datetime) -> int:
    # MAVLink has no times before 1970.
    return max(0, round(moment.timestamp() * 1e6))


def split_address(where: str) -> tuple[str, str, int]:
    """Return (kind, host or device, port or rate) of a MAVLink address. Raises ParameterError."""
    kind = next((kind for kind in (UDP, SERIAL) if where.startswith(kind)), "")
    first, _, last = where[len(kind) :].rpartition(":")
    if kind == UDP and last.isdecimal() and len(last) <= 5 and 0 < int(last) < 65_536 and _is_host(first):
        return kind, first or LOOPBACK, int(last)
    if kind == SERIAL and first and last.isdecimal() and 0 < len(last) <= 8:
        return kind, first, int(last)
    if kind == SERIAL and last and not last.isdecimal():
        return kind, where[len(kind) :], BAUD
    raise ParameterError(
        "“{where}” is not a MAVLink address. Enter udp:PORT, udp:HOST:PORT, serial:DEVICE or serial:DEVICE:BAUD.",
        where=where,
    )


def _is_host(name: str) -> bool:
    """Return whether a text can be a host name; sending to any other would raise UnicodeError."""
    try:
        name.encode("idna")
    except UnicodeError:
        return False
    return True


def _open_line(where: str) -> _Udp | _Serial:
    kind, name, number = split_address(where)
    try:
        if kind == UDP:
            return _Udp(name, number)
        try:
            return _Serial(name, number)
        except ImportError:
            raise ParameterError(
                "{option} needs the Python package {package}. Install it: pip install {package}.",
                package="pyserial",
                option="--mavlink serial:",
            ) from None
    except (OSError, ValueError) as error:
        raise not_written(where, error) from None


def _dialect() -> Any:  # noqa: ANN401 - a module without types
    """Return pymavlink's messages. Raises ParameterError if pymavlink is missing."""
    try:
        from pymavlink.dialects.v20 import ardupilotmega
    except ImportError:
        raise ParameterError(
            "{option} needs the Python package {package}. Install it: pip install {package}.",
            package="pymavlink",
            option="--mavlink",
        ) from None
    return ardupilotmega
