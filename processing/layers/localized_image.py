"""An image with its localization, as layers and reports show it."""

from __future__ import annotations

import os
from dataclasses import dataclass
from datetime import datetime, timezone
from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QDateTime, Qt

from ...core.localization import Localization
from ..messages.numbers import shown
from ..messages.sentences import worded
from ..translation import tr

if TYPE_CHECKING:
    from ...core.flight.model import FlightPose
    from ...core.geometry.pose import Ellipse

ERROR = "error"
"""Status of an image that cannot be read; the localizer gives the others."""


@dataclass(frozen=True)
class LocalizedImage:
    """One image and its result, or ``error`` if it cannot be read.

    Attributes:
        result: Of a flight, its result for this image.
        remark: Sentence about its leveling.
        jump: Whether it could not have been reached in time; None if this was not checked.
        camera: Camera data that were read.
        gps_distance_m: Distance from the database's ground by the GPS position of the photo, if it is far.
        time_s: When it was taken, in seconds since 1970 (UTC) or since any moment; None if unknown.
        pose: Pose that the flight gives it; None for a single image, and for an image that cannot be read.
    """

    path: str
    result: Localization | None = None
    error: str = ""
    shape_hw: tuple[int, int] = (0, 0)
    remark: str = ""
    jump: bool | None = None
    camera: str = ""
    gps_distance_m: float | None = None
    time_s: float | None = None
    pose: FlightPose | None = None

    @property
    def name(self) -> str:
        return os.path.basename(self.path)

    @property
    def position(self) -> tuple[float, float] | None:
        """Map (x, y); None without a position."""
        return self.result and self.result.position

    @property
    def ellipse(self) -> Ellipse | None:
        """95 % ellipse of the position; None if it is unknown."""
        known = self.result and self.result.covariance
        return known and known.ellipse_95

    @property
    def is_placed(self) -> bool:
        """Whether the flight places it."""
        return self.pose is not None and self.pose.is_fix

    @property
    def source(self) -> str | None:
        """Key of the source of its position or likely position in the flight; None without one."""
        return str(self.pose.source) if self.pose is not None and self.pose.is_shown else None

    @property
    def is_outvoted(self) -> bool:
        """Whether its own position contradicts the flight."""
        return self.pose is not None and self.pose.is_outvoted

    @property
    def reason(self) -> str:
        """Why it has no position, or for what a position is not valid, and its error budget."""
        from ...core.localizer.record import record

        if self.result is None:
            return self.error
        far = "" if self.gps_distance_m is None else far_sentence(self.gps_distance_m)
        return " ".join(filter(None, (far, record(self.result, worded)["reason"])))


def far_sentence(meters: float) -> str:
    """Return a sentence about a photo that was taken far from the database's ground.

    Args:
        meters: Distance from the border of the ground.
    """
    kilometers = shown(meters / 1000, ".1f" if meters < 10_000 else ",.0f")
    text = tr("The GPS position of this photo is {distance} km from the ground of the database.")
    return text.format(distance=kilometers)


def moment(time_s: float | None) -> QDateTime | None:
    """Return a time in UTC for layers. Seconds that are not a date count from 1970, so that they can be played."""
    if time_s is None:
        return None
    try:
        text = datetime.fromtimestamp(time_s, timezone.utc).strftime("%Y-%m-%dT%H:%M:%S.%f")[:-3]
    except (OverflowError, OSError, ValueError):
        # Years outside the calendar.
        return None
    found = QDateTime.fromString(text, Qt.DateFormat.ISODateWithMs)
    found.setTimeSpec(Qt.TimeSpec.UTC)
    return found
