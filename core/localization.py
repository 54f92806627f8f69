"""The result type of all localization methods, and the prior that they take."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from enum import Enum
from typing import TYPE_CHECKING

from .sentences import Sentence

if TYPE_CHECKING:  # The toolbox lists methods before NumPy is loaded.
    import numpy as np

    from .geometry.pose import PoseCovariance


RISK = 1e-4
"""Default maximum error probability of a fix: at most one wrong fix in 10,000."""

SHOWN_RISK = 0.01
"""Maximum error probability where a person looks at each position: in the dock and in *Set up an area*."""

LEAST_RISK = 1e-12
"""Smallest error probability that is reported; a confidence of 1 − a smaller one would round to 1."""


LIKELY_RISK = 0.2
"""Largest error probability of a likely position, which is shown although it is not certain enough for a fix."""

MORE_LIKELY_WRONG = 0.5
"""Error probability above which positions are no candidates: ``ambiguous`` means that two positions are plausible."""


def risk_of(log_odds: float) -> float:
    """Return the error probability of a position from ln of the odds that it is right; ``LEAST_RISK`` at least."""
    return max(LEAST_RISK, 1 / (1 + math.exp(min(log_odds, 700.0))))


def log_odds_of(risk: float) -> float:
    """Return ln of the odds that a position is right, from its error probability: the inverse of ``risk_of``."""
    return math.log1p(-risk) - math.log(risk) if 0 < risk < 1 else math.copysign(math.inf, 0.5 - risk)


def only_likely(risk: float, allowed: float) -> Sentence:
    """Return the reason of a likely position."""
    return Sentence(
        "This position is only likely: its error probability is {risk:.2g}; at most {allowed:.2g} is allowed.",
        risk=risk,
        allowed=allowed,
    )


class _Keyed(str, Enum):
    """Members that equal their keys."""

    title: Sentence  # type: ignore[assignment] # not the method of str

    def __new__(cls, key: str, title: Sentence) -> _Keyed:
        member = str.__new__(cls, key)
        member._value_ = key
        member.title = title
        return member

    @property
    def key(self) -> str:
        """The text in files."""
        return self.value

    __str__ = str.__str__
    __format__ = str.__format__  # type: ignore[assignment] # by position, as str has it


class Status(_Keyed):
    """Outcome of localizing an image; each member equals its key, the text of the column ``status``."""

    FIX = "fix", Sentence("Position")
    LIKELY = "likely", Sentence("Likely position")
    AMBIGUOUS = "ambiguous", Sentence("Ambiguous")
    NO_MATCH = "no_match", Sentence("No match")
    TOO_FEW_REFERENCES = "too_few_references", Sentence("Too few landmarks")


IMAGE_PARTS = {
    "left": Sentence("left part"),
    "right": Sentence("right part"),
    "upper": Sentence("upper part"),
    "lower": Sentence("lower part"),
}
"""Names of the parts of an image, for sentences."""


def shown_landmarks(count: int, whole: bool = False) -> Sentence:
    """Return how many landmarks an image shows; with ``whole``, landmarks that the image border does not cut."""
    if whole:
        return Sentence(
            "The image shows {count} whole landmark" if count == 1 else "The image shows {count} whole landmarks",
            count=count,
        )
    return Sentence(
        "The image shows {count} landmark" if count == 1 else "The image shows {count} landmarks", count=count
    )


def too_few_landmarks(count: int, missing: int, whole: bool = False) -> Sentence:
    """Return the reason for no position: the image shows ``count`` landmarks, and ``missing`` more are needed."""
    needed = Sentence(
        "at least {count} more is needed" if missing == 1 else "at least {count} more are needed", count=missing
    )
    return Sentence("{shown}; {needed}.", shown=shown_landmarks(count, whole), needed=needed)


class Method(_Keyed):
    """A localization method; each member equals its key, the text of the column ``method``.

    The order is that of the parameter METHOD: ``list(Method)[number]``.
    """

    AUTOMATIC = "automatic", Sentence("Automatic")
    TOPOLOGY_VECTOR = "topology vector", Sentence("Published method (He & Wu 2025)")
    CONSTELLATION = "constellation", Sentence("Constellation")
    MAP_CORRELATION = "map correlation", Sentence("Map correlation")

    @property
    def number(self) -> int:
        """Value of the parameter METHOD."""
        return list(Method).index(self)


@dataclass(frozen=True)
class Prior:
    """What is known of an image before the search; every value narrows it. None means unknown.

    Attributes:
        position: Map (x, y) of the image's center; used only with a radius.
        radius: Radius of the search area around ``position``, map units.
        heading_deg: Direction of the image's top, clockwise from grid north.
        heading_range_deg: Largest error of the heading to either side.
        pixel_size_range: Smallest and largest ground sampling distance, map units.
    """

    position: tuple[float, float] | None = None
    radius: float | None = None
    heading_deg: float | None = None
    heading_range_deg: float = 180.0
    pixel_size_range: tuple[float, float] | None = None


@dataclass(frozen=True)
class Place:
    """A candidate position of an image.

    Attributes:
        position: Map (x, y) of the image's center.
        heading_deg: Direction of the image's top, clockwise from grid north; None if the method does not find it.
        pixel_size_m: Ground sampling distance; None if the method does not find it.
        log_odds: Natural logarithm of the odds against chance; constellation only.
        inliers: Landmarks that agree with the map; constellation only.
        score: Correlation of class areas, −1 to 1; map correlation only.
    """

    position: tuple[float, float]
    heading_deg: float | None = None
    pixel_size_m: float | None = None
    log_odds: float | None = None
    inliers: int | None = None
    score: float | None = None

    @property
    def oriented(self) -> tuple[float, float]:
        """Heading in degrees and pixel size in map units.

        Raises:
            ValueError: The method finds neither (topology vectors).
        """
        if self.heading_deg is None or self.pixel_size_m is None:
            raise ValueError("the place has no heading and pixel size")
        return self.heading_deg, self.pixel_size_m


@dataclass(frozen=True)
class Matches:
    """The m landmarks of an image that agree with landmarks of the map.

    Attributes:
        on_map: (m,) int64 indices of the database's landmarks.
        pixels_xy: (m, 2) float64 pixel coordinates (column, row) of the image's landmarks.
        seen_xy: (m, 2) float64 map coordinates (x, y) of ``pixels_xy`` under the fix.
        residuals: (m,) float64 distances of ``seen_xy`` from the map's landmarks, map units.
    """

    on_map: np.ndarray
    pixels_xy: np.ndarray
    seen_xy: np.ndarray
    residuals: np.ndarray

    def __len__(self) -> int:
        return len(self.on_map)


@dataclass(frozen=True)
class CorrelationPeaks:
    """How well class areas agree with the map, correlations −1 to 1.

    Attributes:
        score: At the best position.
        runner_up: Highest at any other position.
        mirror: Highest of the mirrored image, which has no right position.
        detail: How much better details finer than the search pixels agree at the best position than at all others,
            including those of the mirrored image: −ln of a density, 0 where it is as usual.
        runner_up_detail: Highest at any other position.
        outlines: The same as ``detail`` for the edges of a photo and the outlines of the map's classes; None for an
            image of labels.
        runner_up_outlines: Highest at any other position.
    """

    score: float
    runner_up: float
    mirror: float
    detail: float = 0.0
    runner_up_detail: float = 0.0
    outlines: float | None = None
    runner_up_outlines: float | None = None


@dataclass(frozen=True)
class Localization:
    """Result of localizing an image; None where the method does not find a value.

    Attributes:
        method: The method that found the fix, or was tried first.
        references: Number of landmarks described.
        reason: Why there is no fix, also for a likely position; for a fix, the part of the image that it is not valid
            for, if any.
        best: The best candidate, also if it is not good enough for a fix.
        confidence: Of a fix or likely position: probability that it is right, 1 − ``risk``. For topology vectors
            1 − d/T, as published, which is not a probability.
        risk: Error probability of the best candidate, from all evidence, calibrated on trials; also without a fix.
            None for topology vectors.
        is_doubted: Only the error probability prevents a fix: more evidence could make it one.
        alternatives: Without a fix, the candidates, most likely first (``best`` among them).
        error_95_m: 95 % radius around ``best``, or the longer semi-axis of the 95 % ellipse.
        covariance: Covariance of the best candidate's position, heading and pixel size.
        matches: Landmarks that agree with the map at the best candidate; ignored when results are compared.
        search_capped: The search omitted the most common patterns, as it does in very large databases.
        mirror_log_odds: Of the best candidate of the mirrored image, which has no right position; constellation only.
        runner_up_log_odds: Of the second candidate, −inf without one; constellation only.
        peaks: Of map correlation, also if it was only the second method.
        distance: Distance between topology vectors.
        window: Name of the matched window.
        window_index: Its number in the database.
        footprint: (4, 2) map coordinates of the ground at the image's corners of a fix, upper left first, clockwise;
            the window's corners where only these are known. A likely position has it too. Ignored when results are
            compared.
        nadir: Map (x, y) straight below the camera of a leveled image.
    """

    status: Status
    method: Method
    references: int = 0
    reason: Sentence | None = None
    best: Place | None = None
    confidence: float | None = None
    risk: float | None = None
    is_doubted: bool = False
    alternatives: tuple[Place, ...] = ()
    error_95_m: float | None = None
    covariance: PoseCovariance | None = None
    matches: Matches | None = field(default=None, compare=False)
    search_capped: bool = False
    mirror_log_odds: float | None = None
    runner_up_log_odds: float | None = None
    peaks: CorrelationPeaks | None = None
    distance: float | None = None
    window: str | None = None
    window_index: int | None = None
    footprint: np.ndarray | None = field(default=None, compare=False)
    nadir: tuple[float, float] | None = None

    @property
    def is_fix(self) -> bool:
        """Whether the best candidate is accepted."""
        return self.status is Status.FIX

    @property
    def is_likely(self) -> bool:
        """Whether the best candidate is shown as a likely position; flights and autopilots never use one."""
        return self.status is Status.LIKELY

    @property
    def fix(self) -> Place | None:
        """The accepted candidate; None without a fix."""
        return self.best if self.is_fix else None

    @property
    def place(self) -> Place | None:
        """The candidate that is shown: of a fix or a likely position."""
        return self.best if self.is_fix or self.is_likely else None

    @property
    def position(self) -> tuple[float, float] | None:
        """Map (x, y) of the image's center, of a fix or a likely position."""
        return None if self.place is None else self.place.position

    @property
    def heading_deg(self) -> float | None:
        """Direction of the image's top, clockwise from grid north; None for topology vectors."""
        return None if self.place is None else self.place.heading_deg

    @property
    def pixel_size_m(self) -> float | None:
        """Ground sampling distance; None for topology vectors."""
        return None if self.place is None else self.place.pixel_size_m
