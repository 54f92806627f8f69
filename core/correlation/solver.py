"""Map correlation: an image's place by overlap of class areas, for labels too poor for centers of gravity.

Told in docs/method.md#map-correlation.

All places, turns and scales at coarse pixels (correlation_search), the best of them moved to their optimum at finer
and finer pixels (correlation_refine), then a decision on the evidence: how well image and map agree, how much worse
the next best other place does, and how well the *mirrored* image does, which can never be right and has the same
classes, density and regularity, so that its best peak shows what chance gives on this map. A place that is the only one
but not known closely (a straight shore) is told as a possible place, not as a fix.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import List, Optional, Tuple

import numpy as np

from ..errors import LabelMapError
from .class_pyramid import MapPyramid, evidence_level, mirrored_level
from .decision import FIX, NO_MATCH, Evidence, confidence_of, decide, exact_enough, position_error_95
from .places import (
    COARSE_EDGE,
    DECISION_EDGE,
    MOST_COMPARISONS,
    CorrelationSettings,
    Prior,
    apart_m,
    best_places,
    comparisons,
    finest_pose,
    image_evidence,
    missing_information,
    reduced_image,
    search_space,
    size_for,
)
from .refine import NOT_COMPARABLE, Pose, axes, score_at
from .search import QUIET_ENERGY

MAP_CORRELATION = "map correlation"
TOO_LITTLE_INFORMATION = "too_little_information"

ALTERNATIVE_BAND = 0.1
"""Other places are told when their score is at most this much below the best one's."""

NOMINAL_RANGE = (0.7, 1.4)
"""Pixel sizes looked for without a prior, in units of window size / image size of the database."""


@dataclass(frozen=True)
class Alternative:
    """Another place the image may show: map position, heading (° clockwise from grid north), pixel size, score."""

    position: Tuple[float, float]
    heading_deg: float
    pixel_size_m: float
    score: float


@dataclass(frozen=True)
class CorrelationResult:
    """What map correlation makes of an image.

    status: ``fix``, ``ambiguous``, ``no_match`` or ``too_little_information``; reason: one sentence without a fix.
    position: map (x, y) of the image's center; heading_deg: of the image's top, clockwise from grid north;
    pixel_size_m: ground sampling distance; covariance_m2: ((xx, xy), (xy, yy)) of the position, map axes;
    score, runner_up, decoy: correlation −1…1 of the best place, of the next best other place and of the mirrored
    image's best; alternatives: other places with scores near the best, best first. The pose is also given without a
    fix, as the best guess, but for ``too_little_information``.
    """

    status: str
    reason: str = ""
    position: Optional[Tuple[float, float]] = None
    heading_deg: Optional[float] = None
    pixel_size_m: Optional[float] = None
    confidence: float = 0.0
    error_95_m: Optional[float] = None
    covariance_m2: Optional[Tuple[Tuple[float, float], Tuple[float, float]]] = None
    score: float = 0.0
    runner_up: float = 0.0
    decoy: float = 0.0
    alternatives: Tuple[Alternative, ...] = ()
    method: str = MAP_CORRELATION


def localize(
    labels_hw: np.ndarray,
    pyramid: MapPyramid,
    pixel_sizes_m: Tuple[float, float],
    prior: Prior = Prior(),  # noqa: B008 - frozen
    settings: CorrelationSettings = CorrelationSettings(),  # noqa: B008 - frozen
) -> CorrelationResult:
    """Finds a label image on a map. Same input, same result.

    ``labels_hw``: (H, W) uint8 labels of the map's class table, 0 = unknown; ``pyramid``: the map's overview, prepared
    once: ``MapPyramid(overview, (x0, y0, pixel size))``; ``pixel_sizes_m``: smallest and largest ground sampling
    distance to look for. Raises LabelMapError for an image without pixels and ValueError for
    a range of pixel sizes that is empty or not positive.
    """
    if labels_hw.size == 0:
        raise LabelMapError("labels.no_pixels")
    if not 0 < pixel_sizes_m[0] <= pixel_sizes_m[1]:
        raise ValueError(f"Pixel sizes from {pixel_sizes_m[0]:g} to {pixel_sizes_m[1]:g} m are no range.")
    if not pyramid.space.channels:
        reason = "The map has fewer than two classes, so that no place differs from another."
        return CorrelationResult(TOO_LITTLE_INFORMATION, reason)
    image = image_evidence(np.ascontiguousarray(labels_hw), pyramid)
    coarse = reduced_image(image, COARSE_EDGE)
    missing = missing_information(coarse, pyramid)
    if missing:
        return CorrelationResult(TOO_LITTLE_INFORMATION, missing)
    space = search_space(pyramid, pixel_sizes_m, prior)
    if comparisons(space, coarse) > MOST_COMPARISONS:
        reason = "The image shows too little ground to search this whole map for it; give a prior position."
        return CorrelationResult(TOO_LITTLE_INFORMATION, reason)
    quiet = QUIET_ENERGY * pyramid.energy
    distance = apart_m(coarse, pixel_sizes_m)
    poses = best_places(image, pyramid, space, settings, settings.candidates, quiet, distance)
    if not poses:
        return CorrelationResult(NO_MATCH, "No place of the map has labels under at least half of the image.")
    decoys = best_places(mirrored_level(image), pyramid, space, settings, settings.decoys, quiet, distance)
    evidence = Evidence(poses[0].score, poses[1].score if len(poses) > 1 else 0.0, decoys[0].score if decoys else 0.0)
    pose, covariance = finest_pose(image, pyramid, poses[0], quiet)
    diagonal_m = float(np.hypot(*labels_hw.shape)) * pose.pixel_size_m
    return _result(pyramid, pose, covariance, evidence, poses[1:], diagonal_m)


def agreement_at(
    labels_hw: np.ndarray,
    pyramid: MapPyramid,
    position: Tuple[float, float],
    heading_deg: float,
    pixel_size_m: float,
) -> Optional[float]:
    """Correlation −1…1 of a label image with the map at a pose that another method found; milliseconds.

    Pose as in ``CorrelationResult``. None where class areas can't tell: the image has too few labels or hardly more
    than one class, or the map has labels under less than half of it.
    """
    if not pyramid.space.channels:
        return None
    image = evidence_level(np.ascontiguousarray(labels_hw), pyramid.space, size_for(labels_hw.shape, DECISION_EDGE))
    if missing_information(image, pyramid):
        return None
    x, y = position[0] - pyramid.frame[0], pyramid.frame[1] - position[1]
    score = score_at(image, pyramid, Pose(x, y, heading_deg, pixel_size_m), QUIET_ENERGY * pyramid.energy)
    return None if score == NOT_COMPARABLE else score


def _result(
    pyramid: MapPyramid,
    pose: Pose,
    covariance: np.ndarray,
    evidence: Evidence,
    others: List[Pose],
    diagonal_m: float,
) -> CorrelationResult:
    """The verdict in map coordinates; ``covariance`` (4, 4) as ``refine`` gives it."""
    # Image pixels to map axes: y of the map goes up.
    to_map = np.array([[1.0], [-1.0]]) * axes(pose)
    spread = to_map @ covariance[:2, :2] @ to_map.T if np.isfinite(covariance).all() else np.full((2, 2), np.inf)
    error_95 = position_error_95(spread, evidence.score, pyramid.frame[2])
    status, reason = decide(evidence)
    if status == FIX:
        status, reason = exact_enough(error_95, diagonal_m)
    alternatives = tuple(
        Alternative(_map_position(pyramid, other), other.heading_deg, other.pixel_size_m, other.score)
        for other in others
        if other.score >= evidence.score - ALTERNATIVE_BAND
    )
    return CorrelationResult(
        status,
        reason,
        position=_map_position(pyramid, pose),
        heading_deg=pose.heading_deg,
        pixel_size_m=pose.pixel_size_m,
        confidence=confidence_of(evidence) if status == FIX else 0.0,
        error_95_m=error_95,
        covariance_m2=tuple(tuple(float(number) for number in row) for row in spread),
        score=evidence.score,
        runner_up=evidence.runner_up,
        decoy=evidence.decoy,
        alternatives=alternatives,
    )


def _map_position(pyramid: MapPyramid, pose: Pose) -> Tuple[float, float]:
    return pyramid.frame[0] + pose.x, pyramid.frame[1] - pose.y
