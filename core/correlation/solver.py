"""Map correlation: locate an image by overlap of class areas, for labels too poor for centers of gravity.

See docs/explanation/method.md#map-correlation.

All places, headings and pixel sizes are compared at coarse pixels (``search``), and the best are refined at
increasingly fine pixels (``refine``). The decision uses the agreement of image and map, also in the detail that the
search did not use (``detail``), the score of the next best place, and the score of the *mirrored* image. The mirrored
image can't be right and has the same classes, density and regularity, so that its best peak shows what chance gives on
this map. A place that is unique but inaccurate, as along a straight shore, is reported as a possible place, not as a
fix.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np

from ..errors import LabelMapError
from ..geometry.error_settings import SharedErrors
from ..labels.class_shares import ClassShares
from ..localization import RISK, CorrelationPeaks, Localization, Method, Place, Prior, Status
from ..sentences import Sentence
from .class_pyramid import EvidenceLevel, MapPyramid, evidence_level, mirror_level
from .compare import NOT_COMPARABLE
from .decision import Measured, decide, decide_accuracy, position_error_95, rank, risk_of_peaks
from .exactness import covariance_on_map, full_pose_covariance, leaning_covariance
from .outlines import agreement, map_edges, photo_edges
from .parts import disagreeing_part
from .places import (
    ChanceLevels,
    best_places,
    finest_pose,
    image_evidence,
    missing_information,
    near_size,
    reduce_image,
    search_spaces,
    size_for,
)
from .refine import ScoredPose, is_held_by_edge, map_under, refine, score_at
from .search import SearchSpace
from .view_effects import view_effect

ALTERNATIVE_BAND = 0.1
"""Other places are results if their score is at most this much below the best one's."""


EXACT_STEPS = 3
"""Steps of the refinement before details are compared. Set by hand, for the time."""


def localize(  # noqa: PLR0913 - an image by its labels and their shares, the map, and what is known beforehand
    labels_hw: np.ndarray,
    pyramid: MapPyramid,
    prior: Prior,
    allowed_risk: float = RISK,
    errors: SharedErrors | None = None,
    shares: ClassShares | None = None,
) -> Localization:
    """Find a label image on a map. The same input gives the same result.

    Args:
        labels_hw: (H, W) uint8 labels of the map's class table, 0 = unknown.
        pyramid: Of the map's overview, prepared once.
        prior: With a range of pixel sizes at least.
        errors: Of map and labels; the defaults without it.
        shares: Probable shares of classes, which replace the labels.

    Returns:
        The best place, even if it is not a fix.

    Raises:
        LabelMapError: The image has no pixels.
        ValueError: The range of pixel sizes is empty or not positive, or the radius is not positive.
    """
    _check(labels_hw, prior)
    settings = pyramid.settings
    if not pyramid.space.channels:
        return _no_match(Sentence("The map has only one class, so all places look the same."))
    image = image_evidence(np.ascontiguousarray(labels_hw), pyramid, shares)
    coarse = reduce_image(image, settings.coarse_edge)
    missing = missing_information(coarse, pyramid)
    if missing:
        return _no_match(missing)
    spaces = search_spaces(image, pyramid, prior)
    if spaces is None:
        return _no_match(Sentence("The footprint is too small to search the whole map. Set a prior position."))
    poses, chance = best_places(image, pyramid, spaces, settings.candidates)
    if not poses:
        return _no_match(Sentence("The map has no place with labels under at least half of the image."))
    poses, peaks = _rank_places(image, pyramid, spaces, poses, chance)
    pose, covariance = finest_pose(image, pyramid, poses[0])
    decided = reduce_image(image, settings.decision_edge)
    is_held = is_held_by_edge(decided, pyramid, pose, pyramid.quiet)
    height, width = labels_hw.shape
    diagonal_m = float(np.hypot(height, width)) * pose.pixel_size_m
    errors = errors or SharedErrors()
    leaning = leaning_covariance(decided, pyramid, pose, errors.settings)
    effect = view_effect(decided, pyramid, pose, errors)
    pose = pose if effect is None else effect.correct(pose)
    edge_m = float(np.sqrt(height * width)) * pose.pixel_size_m
    known = full_pose_covariance(pose, covariance + leaning, edge_m, pyramid.frame.pixel_size, errors, effect)
    error_95_m = np.inf if known.radius_95 is None else known.radius_95
    # Without a radius a place is no fix, however exact it is at the finest pixels.
    fit = covariance if np.isfinite(error_95_m) else np.full_like(covariance, np.inf)
    found = _result(pyramid, [pose, *poses[1:]], fit, peaks, (diagonal_m, allowed_risk), is_held)
    if found.is_fix:
        found = replace(found, reason=disagreeing_part(decided, pyramid, pose))
    return replace(found, covariance=known, error_95_m=error_95_m)


def _rank_places(
    image: EvidenceLevel,
    pyramid: MapPyramid,
    spaces: tuple[SearchSpace, SearchSpace | None],
    poses: Sequence[ScoredPose],
    chance: ChanceLevels,
) -> tuple[list[ScoredPose], CorrelationPeaks]:
    """Return the places by score and detail, the best first, and the figures for the decision."""
    settings = pyramid.settings
    best_size = poses[0].pixel_size_m
    # The level of chance depends on the footprint: decoys have the same size, and other places are converted to it.
    space, wide = spaces
    near = near_size(space, best_size), None if wide is None else near_size(wide, best_size)
    mirrored, _ = best_places(mirror_level(image), pyramid, near, settings.decoys)
    level = reduce_image(image, settings.decision_edge)
    flipped = mirror_level(level)
    poses, mirrored = _exact(level, pyramid, poses), _exact(flipped, pyramid, mirrored)
    measured = [
        replace(one, score=chance.moved(one.score, pose.pixel_size_m, best_size))
        for one, pose in zip(measure(level, pyramid, poses), poses)
    ]
    order, peaks = rank(measured, measure(flipped, pyramid, mirrored), settings)
    return [poses[n] for n in order], peaks


def _exact(image: EvidenceLevel, pyramid: MapPyramid, poses: Sequence[ScoredPose]) -> list[ScoredPose]:
    """Return the poses refined at the pixels of an image, with their scores of the search."""
    return [replace(refine(image, pyramid, pose, pyramid.quiet, EXACT_STEPS), score=pose.score) for pose in poses]


def agreement_at(labels_hw: np.ndarray, pyramid: MapPyramid, place: Place) -> float | None:
    """Return the correlation −1…1 of a label image with the map at a place from another method; takes milliseconds.

    Args:
        labels_hw: (H, W) uint8 labels of the map's class table, 0 = unknown.
        place: With heading and pixel size.

    Returns:
        None if class areas are not sufficient: the image has too few labels or hardly more than one class, or the map
        has labels under less than half of it.
    """
    if not pyramid.space.channels:
        return None
    image = _decided_level(labels_hw, pyramid)
    if missing_information(image, pyramid):
        return None
    score = score_at(image, pyramid, _pose_of(place, pyramid), pyramid.quiet)
    return None if score == NOT_COMPARABLE else score


def part_against(labels_hw: np.ndarray, pyramid: MapPyramid, place: Place) -> Sentence | None:
    """Return the part of a label image that disagrees with a place from another method; None without one.

    Args:
        labels_hw: (H, W) uint8 labels of the map's class table, 0 = unknown.
        place: With heading and pixel size.
    """
    return disagreeing_part(_decided_level(labels_hw, pyramid), pyramid, _pose_of(place, pyramid))


def _decided_level(labels_hw: np.ndarray, pyramid: MapPyramid) -> EvidenceLevel:
    """Return a label image at the pixels of the decision."""
    height, width = labels_hw.shape
    size = size_for((height, width), pyramid.settings.decision_edge)
    return evidence_level(np.ascontiguousarray(labels_hw), pyramid.space, size)


def _pose_of(place: Place, pyramid: MapPyramid) -> ScoredPose:
    x, y = place.position[0] - pyramid.frame.origin[0], pyramid.frame.origin[1] - place.position[1]
    return ScoredPose(x, y, *place.oriented)


def _check(labels_hw: np.ndarray, prior: Prior) -> None:
    """Raise the errors of ``localize``."""
    if labels_hw.size == 0:
        raise LabelMapError("The image has no pixels.")
    sizes = prior.pixel_size_range
    if sizes is None or not 0 < sizes[0] <= sizes[1]:
        raise ValueError(f"Pixel sizes {sizes} are not a range.")
    if prior.radius is not None and not prior.radius > 0:
        raise ValueError(f"The radius of the prior is {prior.radius:g}; it must be positive.")


def _no_match(reason: Sentence) -> Localization:
    return Localization(Status.NO_MATCH, Method.MAP_CORRELATION, reason=reason)


def _result(  # noqa: PLR0913 - poses, what is known of the first, and what was asked
    pyramid: MapPyramid,
    poses: list[ScoredPose],
    covariance: np.ndarray,
    peaks: CorrelationPeaks,
    asked: tuple[float, float],
    is_held: bool,
) -> Localization:
    """Return the localization for poses, best first; ``covariance`` is that of the first.

    ``asked``: diagonal of the image on the ground in meters, and the maximum error probability. ``is_held``: the first
    pose is at the map's edge, not where it matches best.
    """
    diagonal_m, allowed_risk = asked
    pose, *others = poses
    settings = pyramid.settings
    spread = covariance_on_map(pose, covariance)[:2, :2] if np.isfinite(covariance).all() else np.full((2, 2), np.inf)
    # The accuracy of the fit only: an inaccurate map and leaning roofs make no place doubtful.
    error_95 = position_error_95(spread, pyramid.frame.pixel_size, settings)
    status, reason = decide(peaks, allowed_risk, settings)
    exactness, looseness = decide_accuracy(error_95, diagonal_m, is_held, settings)
    if status is Status.FIX:
        status, reason = exactness, looseness
    best, risk = _place(pyramid, pose), risk_of_peaks(peaks, settings)
    least = peaks.score - ALTERNATIVE_BAND
    alternatives = (best, *(_place(pyramid, other) for other in others if other.score >= least))
    return Localization(
        status,
        Method.MAP_CORRELATION,
        reason=reason,
        best=best,
        confidence=1 - risk if status is Status.FIX else None,
        risk=risk,
        is_doubted=status is not Status.FIX and exactness is Status.FIX,
        alternatives=alternatives if status is Status.AMBIGUOUS else (),
        peaks=peaks,
    )


def _place(pyramid: MapPyramid, pose: ScoredPose) -> Place:
    x0, y0 = pyramid.frame.origin
    position = float(x0 + pose.x), float(y0 - pose.y)
    return Place(position, float(pose.heading_deg), float(pose.pixel_size_m), score=float(pose.score))


def measure(image: EvidenceLevel, pyramid: MapPyramid, poses: Sequence[ScoredPose]) -> list[Measured]:
    """Return the agreement of image and map at poses.

    Args:
        image: Its evidence, at the decision's pixels.
        poses: Refined at those pixels.
    """
    window = _window(image, pyramid.settings.coarse_edge)
    edges, found = photo_edges(image), []
    for pose in poses:
        there, known = map_under(image, pyramid, pose)
        outlines = None if edges is None else agreement(edges, map_edges(there, known))
        found.append(Measured(pose.score, _detail(image.evidence, there, window), outlines))
    return found


def _detail(evidence: np.ndarray, there: np.ndarray, window: int) -> float:
    """Return how far the detail below the first look's pixels agrees better than with the image shifted.

    The best of very many places agrees well by chance at the pixels of the first look, because it was chosen for that.
    Finer detail took no part in the choice except in the last steps. At a wrong place it agrees hardly better than with
    the image shifted by a few pixels; at the right place clearly better (peak-to-sidelobe ratio of correlation filters,
    Bolme et al. 2010).

    Args:
        evidence: (h, w, C) of the image.
        there: The same of the map.
        window: Edge of a pixel of the first look, in pixels.

    Returns:
        Standard deviations of the correlation with the shifted image; 0 without such detail.
    """
    seen, there = finer(evidence, window), finer(there, window)
    product = np.fft.rfft2(there, axes=(0, 1)) * np.conj(np.fft.rfft2(seen, axes=(0, 1)))
    correlation = np.fft.irfft2(product.sum(axis=2), s=seen.shape[:2])
    down, right = (np.minimum(np.arange(edge), edge - np.arange(edge)) for edge in seen.shape[:2])
    aside = correlation[np.maximum(down[:, None], right) >= window]
    spread = float(aside.std()) if aside.size else 0.0
    return float(correlation[0, 0]) / spread if spread > 0 and window > 1 else 0.0


def _window(image: EvidenceLevel, coarse_edge: int) -> int:
    """Return the odd edge, in pixels of the image, of at least a pixel of the first look; 1 if they are the same."""
    height, width = image.known.shape
    return 2 * int(np.sqrt(height * width) / coarse_edge / 2) + 1


def finer(planes: np.ndarray, window: int) -> np.ndarray:
    """Return (H, W, C) minus the mean over ``window``² pixels around."""
    return planes - cv2.blur(planes, (window, window), borderType=cv2.BORDER_REFLECT).reshape(planes.shape)
