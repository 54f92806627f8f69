"""THE result of localizing an image, whatever the method."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional, Tuple

import numpy as np

from .constellation.solver import AMBIGUOUS, FIX, NO_MATCH, TOO_FEW_REFERENCES, ConstellationResult
from .correlation.solver import MAP_CORRELATION, TOO_LITTLE_INFORMATION, CorrelationResult
from .geometry.pose import PoseUncertainty

__all__ = ["AMBIGUOUS", "FIX", "NO_MATCH", "TOO_FEW_REFERENCES", "Localization", "PossiblePlace"]

AUTOMATIC = "automatic"
TOPOLOGY_VECTOR = "topology vector"
CONSTELLATION = "constellation"
METHODS = (AUTOMATIC, TOPOLOGY_VECTOR, CONSTELLATION, MAP_CORRELATION)


@dataclass(frozen=True)
class PossiblePlace:
    """Where an image may lie: map (x, y) of its center, heading of its top clockwise from grid north, pixel size."""

    position: Tuple[float, float]
    heading_deg: float
    pixel_size_m: float


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


@dataclass(frozen=True)
class Localization:
    """What is known of an image's position; None where a method doesn't tell.

    status: ``fix``, ``ambiguous``, ``no_match`` or ``too_few_references``; reason: one sentence without a fix, two if
    two methods were tried, else empty; method: that of METHODS which found the fix, or was tried first;
    position: map coordinates (x, y) of the image's center; heading_deg: of the image's top, clockwise from grid north;
    pixel_size_m: ground sampling distance; error_95_m: radius; distance: of topology vectors;
    references: landmarks described; inliers: those that agree with the map.
    confidence: of the constellation and of map correlation, the probability that the best place is the right one,
    calibrated on trials; alternatives: without a fix, the places that it may be, most likely first;
    uncertainty: 95 % ellipse, deviations of heading and pixel size;
    search_capped: the search left out the most common patterns, as it does in very large databases.
    """

    status: str
    method: str
    references: int
    reason: str = ""
    position: Optional[Tuple[float, float]] = None
    heading_deg: Optional[float] = None
    pixel_size_m: Optional[float] = None
    confidence: float = 0.0
    distance: Optional[float] = None
    inliers: Optional[int] = None
    log_odds: Optional[float] = None
    error_95_m: Optional[float] = None
    window: Optional[str] = None
    window_index: Optional[int] = None
    alternatives: Tuple[PossiblePlace, ...] = ()
    uncertainty: Optional[PoseUncertainty] = None
    search_capped: bool = False


def place_of(found) -> PossiblePlace:
    """The pose of anything that has one: a result with a fix, a place of the constellation, of map correlation."""
    x, y = found.position
    return PossiblePlace((float(x), float(y)), float(found.heading_deg), float(found.pixel_size_m))


def from_constellation(result: ConstellationResult) -> Localization:
    """The constellation's result: places without a fix are alternatives, never a position."""
    place = result.place
    common = {"status": result.status, "method": CONSTELLATION, "references": result.references}
    common.update(reason=result.reason, search_capped=result.capped, confidence=result.confidence)
    if place is None:
        return Localization(**common)
    common.update(log_odds=place.log_odds, inliers=place.inliers)
    if result.status != FIX:
        places = (place, *result.alternatives) if result.status == AMBIGUOUS else ()
        return Localization(**common, alternatives=tuple(place_of(other) for other in places))
    return Localization(
        **common,
        position=place.position,
        heading_deg=place.heading_deg,
        pixel_size_m=place.pixel_size_m,
        error_95_m=result.uncertainty.semi_major if result.uncertainty else None,
        uncertainty=result.uncertainty,
    )


def from_correlation(result: CorrelationResult) -> Localization:
    """Map correlation's result: places without a fix are alternatives, never a position."""
    status = NO_MATCH if result.status == TOO_LITTLE_INFORMATION else result.status
    if status != FIX:
        places = (result, *result.alternatives) if status == AMBIGUOUS else ()
        alternatives = tuple(place_of(place) for place in places)
        return Localization(status, MAP_CORRELATION, 0, result.reason, alternatives=alternatives)
    place = place_of(result)
    return Localization(
        status,
        MAP_CORRELATION,
        0,
        position=place.position,
        heading_deg=place.heading_deg,
        pixel_size_m=place.pixel_size_m,
        confidence=float(result.confidence),
        error_95_m=float(result.error_95_m),
    )
