"""The one result of localizing an image, whatever the road, and what every road is told beforehand."""

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
"""Probability of being wrong below which a place is a fix, unless told otherwise: once in 10,000 fixes at most."""

LEAST_RISK = 1e-12
"""No probability of being wrong is told to be smaller: beyond, a confidence could not be told from 1."""


MORE_LIKELY_WRONG = 0.5
"""Error probability above which places are no candidates: ``ambiguous`` means that two places are both plausible."""


def risk_of(log_odds: float) -> float:
    """Probability that a place is wrong, from ln of the odds that it is right; ``LEAST_RISK`` at least."""
    return max(LEAST_RISK, 1 / (1 + math.exp(min(log_odds, 700.0))))


def log_odds_of(risk: float) -> float:
    """Logarithm of the odds that a place is right, from its risk: the inverse of ``risk_of``."""
    return math.log1p(-risk) - math.log(risk) if 0 < risk < 1 else math.copysign(math.inf, 0.5 - risk)


class _Keyed(str, Enum):
    """Members that equal their keys.

    Attributes:
        title: The member in words.
    """

    title: Sentence  # type: ignore[assignment] # not the method of str

    @property
    def key(self) -> str:
        """The text that files have."""
        return self.value

    __str__ = str.__str__
    __format__ = str.__format__  # type: ignore[assignment] # by position, as str has it


class Status(_Keyed):
    """What came of an image; each equals its key, the text of the column ``status``."""

    FIX = "fix", Sentence("Fix")
    AMBIGUOUS = "ambiguous", Sentence("Ambiguous")
    NO_MATCH = "no_match", Sentence("No match")
    TOO_FEW_REFERENCES = "too_few_references", Sentence("Too few landmarks")

    def __new__(cls, key: str, title: Sentence) -> Status:
        """Makes a member that is its key."""
        member = str.__new__(cls, key)
        member._value_ = key
        member.title = title
        return member


IMAGE_PARTS = {
    "left": Sentence("left part"),
    "right": Sentence("right part"),
    "upper": Sentence("upper part"),
    "lower": Sentence("lower part"),
}
"""Parts of an image, for sentences."""


def shown_landmarks(count: int, whole: bool = False) -> Sentence:
    """How many landmarks an image shows; ``whole``: that its edge does not cut."""
    if whole:
        return Sentence(
            "The image shows {count} whole landmark" if count == 1 else "The image shows {count} whole landmarks",
            count=count,
        )
    return Sentence(
        "The image shows {count} landmark" if count == 1 else "The image shows {count} landmarks", count=count
    )


def too_few_landmarks(count: int, missing: int, whole: bool = False) -> Sentence:
    """The reason that an image has no fix: it shows ``count`` landmarks, and ``missing`` more are needed."""
    needed = Sentence(
        "at least {count} more is needed" if missing == 1 else "at least {count} more are needed", count=missing
    )
    return Sentence("{shown}; {needed}.", shown=shown_landmarks(count, whole), needed=needed)


class Method(_Keyed):
    """A road to a fix; each equals its key, the text of the column ``method``.

    The order is that of the parameter METHOD: ``list(Method)[number]``.

    Attributes:
        number: Value of the parameter METHOD.
    """

    number: int

    AUTOMATIC = "automatic", 0, Sentence("Automatic")
    TOPOLOGY_VECTOR = "topology vector", 1, Sentence("Topology vector (He & Wu 2025)")
    CONSTELLATION = "constellation", 2, Sentence("Constellation")
    MAP_CORRELATION = "map correlation", 3, Sentence("Map correlation")

    def __new__(cls, key: str, number: int, title: Sentence) -> Method:
        """Makes a member that is its key."""
        member = str.__new__(cls, key)
        member._value_ = key
        member.number, member.title = number, title
        return member

    @classmethod
    def of_number(cls, number: int) -> Method:
        """The method that the parameter METHOD means."""
        return list(cls)[number]


@dataclass(frozen=True)
class Prior:
    """What is known of an image beforehand, each narrowing the search; None is nothing.

    Attributes:
        position: Map (x, y) of the image's center; counts only with a radius.
        radius: How far off that may be, map units.
        heading_deg: Of the image's top, clockwise from grid north.
        heading_range_deg: How far off that may be to either side.
        pixel_size_range: Smallest and largest ground sampling distance, map units.
    """

    position: tuple[float, float] | None = None
    radius: float | None = None
    heading_deg: float | None = None
    heading_range_deg: float = 180.0
    pixel_size_range: tuple[float, float] | None = None


@dataclass(frozen=True)
class Place:
    """Where an image may lie.

    Attributes:
        position: Map (x, y) of its center.
        heading_deg: Of its top, clockwise from grid north; None where the method doesn't tell.
        pixel_size_m: Ground sampling distance; None where the method doesn't tell.
        log_odds: Natural logarithm of the odds against chance; of the constellation.
        inliers: Landmarks that agree with the map; of the constellation.
        score: Correlation of class areas, −1 to 1; of map correlation.
    """

    position: tuple[float, float]
    heading_deg: float | None = None
    pixel_size_m: float | None = None
    log_odds: float | None = None
    inliers: int | None = None
    score: float | None = None

    @property
    def oriented(self) -> tuple[float, float]:
        """Heading in degrees and pixel size in map units, of a method that tells both.

        Raises:
            ValueError: The method doesn't: topology vectors.
        """
        if self.heading_deg is None or self.pixel_size_m is None:
            raise ValueError("the place has no heading and pixel size")
        return self.heading_deg, self.pixel_size_m


@dataclass(frozen=True)
class Matches:
    """Landmarks of an image and of the map that agree, m of them.

    Attributes:
        on_map: (m,) int64, those of the database's landmarks.
        pixels_xy: (m, 2) float64, pixel coordinates (column, row) of the image's landmarks.
        seen_xy: (m, 2) float64, map coordinates (x, y) where the fix puts them.
        residuals: (m,) float64, how far from the map's landmarks that is, map units.
    """

    on_map: np.ndarray
    pixels_xy: np.ndarray
    seen_xy: np.ndarray
    residuals: np.ndarray

    def __len__(self) -> int:
        """How many landmarks agree."""
        return len(self.on_map)


@dataclass(frozen=True)
class CorrelationPeaks:
    """How well class areas agree with the map, correlations −1 to 1.

    Attributes:
        score: At the best place.
        runner_up: Highest at any other place.
        mirror: At the best place of the mirrored image, which can't be right.
        detail: How much better what is finer than the pixels of the search agrees at the best place than at all others,
            the mirrored image's too: −ln of a density, 0 where it is as usual.
        runner_up_detail: Highest at any other place.
    """

    score: float
    runner_up: float
    mirror: float
    detail: float = 0.0
    runner_up_detail: float = 0.0


@dataclass(frozen=True)
class Localization:
    """What is known of an image's place; None where the method doesn't tell.

    Attributes:
        status: What came of the image.
        method: The road that found the fix, or was tried first.
        references: Landmarks described.
        reason: Why there is no fix; of one, what it doesn't hold for, if anything.
        best: The best place, also where it is not good enough for a fix.
        confidence: Of a fix: probability that it is right, 1 − ``risk``; 1 − d/T of topology vectors, as published,
            which is no probability.
        risk: Probability that the best place is wrong, from all evidence, calibrated on trials; told without a fix,
            too. None of topology vectors.
        is_doubted: There is no fix only because of the risk: more evidence would make it one.
        alternatives: Without a fix, the places that it may be, most likely first (``best`` among them).
        error_95_m: Radius around ``best`` that holds the true position in 95 % of fixes, or the longer semi-axis.
        covariance: Of the best place's position, heading and pixel size.
        matches: The landmarks that agree with the map at the best place; no part of a comparison of results.
        search_capped: The search left out the most common patterns, as it does in very large databases.
        mirror_log_odds: Of the best place of the mirrored image, which can't be right; of the constellation.
        runner_up_log_odds: Of the best other place; of the constellation, −inf without one.
        peaks: Of map correlation, also where it was only the second road.
        distance: Between topology vectors.
        window: Name of the window matched.
        window_index: Its number in the database.
        footprint: (4, 2) map coordinates of the ground at the image's corners, upper left first, clockwise, of a fix;
            the window's where only that is known. No part of a comparison of results.
        nadir: Map (x, y) straight below the camera of an image that was leveled.
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
        """Whether the best place is accepted."""
        return self.status is Status.FIX

    @property
    def place(self) -> Place | None:
        """Where the image lies; None without a fix."""
        return self.best if self.is_fix else None

    @property
    def position(self) -> tuple[float, float] | None:
        """Map (x, y) of the image's center; None without a fix."""
        return None if self.place is None else self.place.position

    @property
    def heading_deg(self) -> float | None:
        """Of the image's top, clockwise from grid north; None without a fix, and of topology vectors."""
        return None if self.place is None else self.place.heading_deg

    @property
    def pixel_size_m(self) -> float | None:
        """Ground sampling distance; None without a fix, and of topology vectors."""
        return None if self.place is None else self.place.pixel_size_m
