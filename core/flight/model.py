"""A flight: what goes in of each image, and what comes out.

Told in docs/explanation/method.md#flights.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from enum import Enum

import numpy as np

from ..errors import ParameterError
from ..geometry.error_settings import UNBIASED, KnownBiases
from ..geometry.footprint import image_corners
from ..geometry.pose import PoseCovariance
from ..localization import Localization, Method, Place, Prior, Status
from ..sentences import Sentence


class PoseSource(str, Enum):
    """What a pose rests on; each equals its key, the text of the column ``source``."""

    OWN = "own"
    FLIGHT = "flight"

    __str__ = str.__str__
    __format__ = str.__format__  # type: ignore[assignment] # by position, as str has it


@dataclass(frozen=True)
class FlightImage:
    """One image of a flight.

    Attributes:
        name: Of its file.
        labels_hw: (H, W) uint8 labels of the database's class table, 0 = unknown; of a camera that looks straight down,
            or leveled. No part of a comparison.
        own: What was found for the image alone; None where nobody looked.
        time_s: When it was taken, seconds from any fixed moment; None where unknown.
        prior: What is known of it alone: heading with its range, range of pixel sizes, position with its radius.
        biases: How its labels are shifted.
    """

    name: str
    labels_hw: np.ndarray = field(compare=False, repr=False)
    own: Localization | None = None
    time_s: float | None = None
    prior: Prior = Prior()
    biases: KnownBiases = UNBIASED

    def __post_init__(self) -> None:
        """Checks the labels.

        Raises:
            ParameterError: They are no label image.
        """
        if self.labels_hw.ndim != 2 or not self.labels_hw.size:
            raise ParameterError("{name} is no label image: it has no pixels, or several bands.", name=self.name)

    @property
    def size_wh(self) -> tuple[int, int]:
        """(width, height), pixels."""
        return self.labels_hw.shape[1], self.labels_hw.shape[0]


@dataclass(frozen=True)
class FlightPose:
    """What the whole flight says of one image.

    Attributes:
        number: Of the image in the flight, from 0.
        status: ``FIX`` where the flight places it.
        reason: Why it doesn't; None of a fix.
        place: Where the image lies; None without a fix.
        covariance: Of its pose, 95 % ellipse and radius included; None without a fix.
        risk: Probability that the place is wrong; None where nothing was tried.
        source: Whether the image has a fix of its own that agrees with the flight.
        track: Number of its track, from 1; 0 without one.
        is_outvoted: The image's own fix disagrees with the flight; the place is the flight's.
        own: What was found for the image alone.
        size_wh: (width, height) of the image, pixels.
    """

    name: str
    number: int
    status: Status
    reason: Sentence | None = None
    place: Place | None = None
    covariance: PoseCovariance | None = None
    risk: float | None = None
    source: PoseSource = PoseSource.FLIGHT
    track: int = 0
    is_outvoted: bool = False
    own: Localization | None = field(default=None, compare=False, repr=False)
    time_s: float | None = None
    size_wh: tuple[int, int] = (0, 0)

    @property
    def is_fix(self) -> bool:
        """Whether the flight places the image."""
        return self.status is Status.FIX

    @property
    def confidence(self) -> float | None:
        """Probability that the place is right; None without a fix."""
        return None if self.risk is None or not self.is_fix else 1 - self.risk

    @property
    def error_95_m(self) -> float | None:
        """Radius around the position that holds the true one in 95 % of fixes, map units; None without a fix."""
        return None if self.covariance is None else self.covariance.radius_95

    def localization(self) -> Localization:
        """The same as the result of an image, for all that shows one: rows, JSON, NMEA, the dock."""
        own = self.own or Localization(self.status, Method.AUTOMATIC)
        if self.place is None:
            return replace(own, status=self.status, reason=self.reason, confidence=None, alternatives=())
        ground = image_corners(self.place.position, *self.place.oriented, *self.size_wh)
        # What was matched at another place is not evidence of this one.
        is_own = self.source is PoseSource.OWN
        return Localization(
            self.status,
            own.method,
            own.references,
            self.reason,
            best=self.place,
            confidence=self.confidence,
            risk=self.risk,
            error_95_m=self.error_95_m,
            covariance=self.covariance,
            matches=own.matches if is_own else None,
            peaks=own.peaks if is_own else None,
            footprint=ground,
        )


@dataclass(frozen=True)
class Gap:
    """Images between two tracks, or at an end, that the flight could not place.

    Attributes:
        first: Number of the first one.
        last: Number of the last one.
    """

    first: int
    last: int
    reason: Sentence | None


@dataclass(frozen=True)
class FlightResult:
    """What came of a flight.

    Attributes:
        poses: One for each image, in order.
    """

    poses: tuple[FlightPose, ...]

    @property
    def tracks(self) -> tuple[tuple[FlightPose, ...], ...]:
        """The placed images of each track, in order."""
        numbers = sorted({pose.track for pose in self.poses if pose.is_fix})
        return tuple(tuple(p for p in self.poses if p.is_fix and p.track == number) for number in numbers)

    @property
    def gaps(self) -> tuple[Gap, ...]:
        """Runs of images that have no place."""
        found: list[Gap] = []
        for pose in self.poses:
            if pose.is_fix:
                continue
            if found and found[-1].last == pose.number - 1:
                found[-1] = replace(found[-1], last=pose.number)
            else:
                found.append(Gap(pose.number, pose.number, pose.reason))
        return tuple(found)
