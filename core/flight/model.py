"""The images of a flight and the poses that the flight gives them (docs/explanation/method.md#flights)."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from enum import Enum
from typing import TYPE_CHECKING

import numpy as np

from ..errors import ParameterError
from ..geometry.error_settings import UNBIASED, KnownBiases
from ..geometry.footprint import image_corners
from ..geometry.leveling import Leveling
from ..geometry.pose import PoseCovariance
from ..labels.class_shares import ClassShares
from ..localization import Localization, Method, Place, Prior, Status
from ..sentences import Sentence

if TYPE_CHECKING:
    from ..pipeline import ImageResult


class PoseSource(str, Enum):
    """Basis of a pose; each member equals its key, the text of the column ``source``."""

    OWN = "own"
    FLIGHT = "flight"
    PREDICTED = "predicted"

    __str__ = str.__str__
    __format__ = str.__format__  # type: ignore[assignment] # by position, as str has it


@dataclass(frozen=True)
class FlightImage:
    """One image of a flight.

    Attributes:
        labels_hw: (H, W) uint8 labels of the database's class table, 0 = unknown; of a camera that looks straight down,
            or leveled. Comparisons ignore them.
        own: Localization of the image by itself; None without one.
        time_s: Time of capture, seconds from any fixed moment; None if unknown.
        prior: Of this image: heading with its range, range of pixel sizes, position with its radius.
        leveling: How the labels were leveled; None for labels as taken.
        is_apart: Its pixels do not show the ground of the image before, so that motion between overlapping images did
            not continue.
        shares: Probable shares of classes of a photo, which replace the labels where class areas are compared; None
            without them. Flights do not use its picture.
    """

    name: str
    labels_hw: np.ndarray = field(compare=False, repr=False)
    own: Localization | None = None
    time_s: float | None = None
    prior: Prior = Prior()
    biases: KnownBiases = UNBIASED
    leveling: Leveling | None = field(default=None, compare=False, repr=False)
    is_apart: bool = False
    shares: ClassShares | None = field(default=None, compare=False, repr=False)

    @classmethod
    def of(cls, name: str, result: ImageResult, time_s: float | None) -> FlightImage:
        """Return an image of a flight from its result by itself."""
        seen = result.seen
        known = result.level, time_s, result.prior, seen.biases, result.leveling
        shares = None if seen.shares is None else replace(seen.shares, picture=None)
        return cls(name, seen.labels_hw, *known, shares=shares)

    def __post_init__(self) -> None:
        """Check the labels. Raises ParameterError: the array is not a label image."""
        if self.labels_hw.ndim != 2 or not self.labels_hw.size:
            raise ParameterError("{name} is not a label image: it has no pixels or several bands.", name=self.name)

    @property
    def size_wh(self) -> tuple[int, int]:
        """(width, height), pixels."""
        return self.labels_hw.shape[1], self.labels_hw.shape[0]


@dataclass(frozen=True)
class FlightPose:
    """The pose that a flight gives one image. Without a fix it has no track, and a place if likely or predicted.

    Attributes:
        status: ``FIX`` if the flight places the image, ``LIKELY`` if only the error probability of the track is too
            large for that.
        reason: Why the image has no fix; None for a fix.
        place: Position, heading and pixel size of the image; of a fix or likely position, or where the motion since the
            last fix leads.
        covariance: Of the pose, with 95 % ellipse and radius.
        risk: Error probability; None if the flight was not compared with the map.
        source: Whether the image has a fix of its own that agrees with the flight, or its place is only predicted.
        track: Number of its track, from 1; 0 without one.
        is_outvoted: The image's own fix contradicts the flight; the place is that of the flight.
        own: Localization of the image by itself.
        size_wh: (width, height) of the image, pixels.
    """

    status: Status
    reason: Sentence | None = None
    place: Place | None = None
    covariance: PoseCovariance | None = None
    risk: float | None = None
    source: PoseSource = PoseSource.FLIGHT
    track: int = 0
    is_outvoted: bool = False
    own: Localization | None = field(default=None, compare=False, repr=False)
    size_wh: tuple[int, int] = (0, 0)

    @property
    def is_fix(self) -> bool:
        """Whether the flight places the image."""
        return self.status is Status.FIX

    @property
    def is_shown(self) -> bool:
        """Whether the image has a fix or a likely position."""
        return self.is_fix or self.status is Status.LIKELY

    @property
    def confidence(self) -> float | None:
        """Probability that the place is right; None without a fix or likely position."""
        return None if self.risk is None or not self.is_shown else 1 - self.risk

    @property
    def error_95_m(self) -> float | None:
        """95 % radius, m; None without a place."""
        return None if self.covariance is None else self.covariance.radius_95

    def localization(self) -> Localization:
        """Return the pose as a localization, for rows, JSON, NMEA and the dock."""
        own = self.own or Localization(self.status, Method.AUTOMATIC)
        if not self.is_shown or self.place is None:
            own = replace(own, status=self.status, reason=self.reason, confidence=None, alternatives=(), footprint=None)
            if self.place is None:
                return own
            own = replace(own, best=self.place, error_95_m=self.error_95_m, covariance=self.covariance)
            return replace(own, risk=None, matches=None, peaks=None)
        # Matches of another place are no evidence for this one.
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
            footprint=image_corners(self.place.position, *self.place.oriented, *self.size_wh),
        )
