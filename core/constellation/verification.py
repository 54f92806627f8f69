"""Verify poses: a likelihood ratio for every landmark of the image and of the map there.

See docs/explanation/method.md#constellation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..geometry.pose import Pose, fit_similarity, fit_tilted, huber, numbers_of, stack_of
from .hypotheses import SeenLandmarks
from .index import AREA_BIN, AREA_BINS, ConstellationIndex
from .matching import (
    NOISE_FACTORS,
    Nearest,
    PoseMatcher,
    biweight,
    center_noise,
    matched_within,
    median,
    noise_factor,
)
from .neighbors import SteppedMatcher
from .parts import Side
from .settings import NoiseModel

MINIMUM_MATCHES = 4
"""Smallest number of matches for fitting a pose again: a pose has four numbers."""

REFINEMENTS = 6
"""Rounds of matching and fitting for one pose. Set by hand."""

ROBUST_REFINEMENTS = 4
"""The first rounds, which trust near matches more, to drop wrong ones; the others weigh by Huber's rule, which the
covariance assumes. Set by hand."""

GROWING_GATE = 0.006
"""For tilted cameras: largest residual of a match beyond its noise, share of the image's diagonal. Set by hand."""

GROWING_REACH = (0.15, 0.2, 0.3, 0.4, 0.55, 0.75, 1.0, 1.0)
"""For tilted cameras: largest distance of matches from the point where the pose is valid, round by round, share of the
diagonal. Set by hand."""

ASSUMED_OBJECTS = 3
"""Landmarks that form a hypothesis can't be evidence for it. Any three of the matched ones may have formed it, so this
many times their mean is subtracted."""

ASSUMED_OBJECTS_TILTED = 5
"""The same for a tilted camera, with four more numbers in its pose, as many as two landmarks give."""

FIRST_NOISE_FACTOR = 2.0
"""Ratio of noise to the assumed one for the first matches of a pose that is not yet fitted."""


@dataclass(frozen=True)
class PoseEvidence:
    """A verified pose: log odds against a chance hit, m matched pairs and their noise.

    Attributes:
        log_odds: Natural logarithm of the odds against chance.
        matched: (m,) int64, landmarks of the image.
        objects: (m,) int64, landmarks of the map.
        deviations: (m,) σ of each match, map units.
        noise_factor: Ratio of the noise to the assumed one.
        expected: (M,) int64, landmarks of the map that should be visible.
        possible: (k,) int64, landmarks of the image that could be on the map.
    """

    pose: Pose
    log_odds: float
    matched: np.ndarray
    objects: np.ndarray
    deviations: np.ndarray
    noise_factor: float
    expected: np.ndarray
    possible: np.ndarray

    @cached_property
    def noise(self) -> float:
        """Median σ of the matches, map units; 0 without any."""
        return median(self.deviations) if len(self.deviations) else 0.0

    @property
    def considered(self) -> int:
        """Number of landmarks of the image that could be on the map."""
        return len(self.possible)


@dataclass(frozen=True)
class Verifier:
    """Data of map and image for verification.

    Attributes:
        minimum_area_px: Smallest area, px², of landmarks extracted from the image.
        side: The part of the image to verify; None for all of it.
        view: (4,) complex corners of what a leveled image shows, pixels from its center, clockwise; None for all of it.
    """

    index: ConstellationIndex
    width_px: float
    height_px: float
    minimum_area_px: float
    side: Side | None = None
    view: np.ndarray | None = None


def match_ratios(
    index: ConstellationIndex, query: SeenLandmarks, nearest: Nearest, log_scale: np.ndarray
) -> np.ndarray:
    """Return (…, n) likelihood ratio of every landmark's nearest match against a random hit at the local density.

    It is 0 without a match.

    Args:
        query: The image's n landmarks.
        nearest: Their nearest landmarks of the map.
        log_scale: ln pixel size, broadcastable.
    """
    noise, deviations = index.settings.noise, nearest.deviations
    found = np.maximum(nearest.objects, 0)
    position = -0.5 * (nearest.distances / deviations) ** 2 - np.log(2 * np.pi * deviations**2 * index.densities[found])
    area = query.log_areas + 2 * log_scale
    off = area - index.log_areas[found]
    seen = (1 - noise.area_outliers) * _normal(off, noise.area_deviation)
    seen += noise.area_outliers * _normal(off, noise.area_outlier_deviation)
    bins = np.clip(((area - AREA_BINS[0]) / AREA_BIN).astype(np.int64), 0, len(AREA_BINS) - 1)
    ratio = np.exp(np.clip(position, -50, 30)) * seen / index.area_densities[query.ranks, bins]
    return np.where((nearest.objects >= 0) & (nearest.distances <= noise.gate_in_noise * deviations), ratio, 0)


def gains(ratios: np.ndarray, distractors: float | np.ndarray) -> np.ndarray:
    """Return ln of every landmark's likelihood ratio, if a share (broadcastable) is unrelated to the map."""
    return np.log(distractors + (1 - distractors) * ratios)


def averaged_log_odds(
    ratios: np.ndarray,
    matched: np.ndarray,
    missing: np.ndarray | int,
    assumed: np.ndarray | int,
    noise: NoiseModel,
) -> np.ndarray:
    """Return (…) log likelihood ratio of all landmarks, averaged over shares of distractors and visibilities.

    The quality of an image's labels is unknown beforehand. With the shares that suit it, a poor image keeps evidence
    that one fixed share would remove, and a good one loses at most ln of their number.

    Args:
        ratios: (…, n) of the image's landmarks; 1 for one that is neither for the pose nor against it.
        matched: (…, n) bool, those with a match.
        missing: (…) landmarks of the map that should be visible and are not.
        assumed: (…) matches that may have formed the hypothesis; this many times their mean gain is subtracted.
        noise: The shares.
    """
    distractors, unseen = np.array(noise.distractors), np.log1p(-np.array(noise.visibility))
    gained = gains(ratios, distractors.reshape(-1, *[1] * ratios.ndim))
    counts = np.maximum(matched.sum(axis=-1), 1)
    of_image = gained.sum(axis=-1) - assumed * np.maximum((gained * matched).sum(axis=-1) / counts, 0)
    terms = of_image[:, None] + missing * unseen.reshape(-1, *[1] * (ratios.ndim - 1))
    largest = terms.max(axis=(0, 1))
    return largest + np.log(np.exp(terms - largest).mean(axis=(0, 1)))


def _normal(x: np.ndarray, deviation: float) -> np.ndarray:
    return np.exp(-0.5 * (x / deviation) ** 2) / (np.sqrt(2 * np.pi) * deviation)


def rough_scores(
    index: ConstellationIndex, query: SeenLandmarks, centers: np.ndarray, turns: np.ndarray, gates: Sequence[float]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Fit poses all at once, with shrinking gates, and return them with scores; missing landmarks do not count.

    Args:
        query: The image's largest landmarks only, all of known class.
        centers: (S,) complex, map units from the index's origin.
        turns: (S,) complex, heading and pixel size.
        gates: Largest residuals of a match, one after the other, pixels.

    Returns:
        (S,) centers, turns and scores.
    """
    noise, matcher = index.settings.noise, SteppedMatcher(index.matcher, query.ranks, len(centers))
    for gate in gates:
        size = np.abs(turns)[:, None]
        distances, objects = matcher.match(centers[:, None] + turns[:, None] * query.points, gate * size)
        off = query.log_areas + 2 * np.log(size) - index.log_areas[np.maximum(objects, 0)]
        near = (distances <= gate * size) & (np.abs(off) < 1.5)
        weights = near / center_noise(query.log_areas, size, noise) ** 2
        fitted = fit_similarity(query.points[None], index.points[np.maximum(objects, 0)], weights)
        enough = near.sum(axis=1) >= 4
        enough &= np.abs(np.log(np.maximum(np.abs(fitted[1]), 1e-12) / size[:, 0])) < 0.3
        centers = np.where(enough, fitted[0], centers)
        turns = np.where(enough, fitted[1], turns)
    size = np.abs(turns)[:, None]
    deviations = 1.5 * center_noise(query.log_areas, size, noise)
    within = noise.gate_in_noise * deviations
    distances, objects = matcher.match(centers[:, None] + turns[:, None] * query.points, within)
    ratios = match_ratios(index, query, Nearest(distances, objects, deviations), np.log(size))
    return centers, turns, gains(ratios, noise.rough_distractors).sum(axis=1)


def telling_objects(query: SeenLandmarks, count: int) -> np.ndarray:
    """Return ascending indices of the largest whole landmarks of known class, at most ``count``."""
    usable = np.flatnonzero(query.whole & (query.ranks >= 0))
    return np.sort(usable[np.argsort(-query.log_areas[usable], kind="stable")[:count]])


def verify(verifier: Verifier, query: SeenLandmarks, poses: Sequence[Pose]) -> list[PoseEvidence]:
    """Refine poses of a level camera by matching and fitting, independently but all at once, then weigh them.

    Args:
        query: The image's ``telling_objects``.
    """
    return _refined(verifier, query, poses, PoseMatcher(verifier.index, query, len(poses)), tilted=False)


def verify_tilted(
    verifier: Verifier, query: SeenLandmarks, poses: Sequence[Pose], focuses: Sequence[complex]
) -> list[PoseEvidence]:
    """Verify poses of a camera that may be tilted, independently but all at once.

    Args:
        query: The image's ``telling_objects``.
        focuses: Point of the image where each is valid; matches spread from there over the image.
    """
    poses, matcher = list(poses), PoseMatcher(verifier.index, query, len(poses))
    away = np.abs(query.points - np.reshape(focuses, (-1, 1)))
    growing = np.arange(len(poses))
    for reach in GROWING_REACH:
        if not len(growing):
            break
        before = [poses[k] for k in growing]
        ones = np.ones((len(growing), 1))
        nearest, ends = matcher.match(stack_of(numbers_of(before)), ones, GROWING_GATE * query.diagonal, growing)
        matched = matched_within(nearest, ends) & (away[growing] <= reach * query.diagonal)
        loose = nearest.deviations / np.maximum(biweight(nearest.distances, ends), 0.05) ** 0.5
        enough = matched.sum(axis=1) >= MINIMUM_MATCHES
        for row in np.flatnonzero(enough):
            kept, pose = np.flatnonzero(matched[row]), before[row]
            on_map = verifier.index.points[nearest.objects[row, kept]]
            fitted = fit_tilted(query.points[kept], on_map, loose[row, kept], pose, query.diagonal)
            enough[row] = 0.7 < abs(fitted.turn / pose.turn) < 1.4
            if enough[row]:
                poses[growing[row]] = fitted
        growing = growing[enough]
    return _refined(verifier, query, poses, matcher, tilted=True)


def gained_by_tilt(verifier: Verifier, query: SeenLandmarks, evidence: PoseEvidence) -> float:
    """Return the gain in log likelihood of a level pose's matches if the camera may be tilted; about 2 if it is level.

    Args:
        query: The image's ``telling_objects``.
        evidence: Of a level pose, with at least ``MINIMUM_MATCHES``.
    """
    image, on_map = query.points[evidence.matched], verifier.index.points[evidence.objects]
    level = np.abs(evidence.pose.on_map(image) - on_map)
    loose = evidence.deviations / np.sqrt(huber(level, evidence.deviations))
    tilted = fit_tilted(image, on_map, loose, evidence.pose, query.diagonal)
    least = (NOISE_FACTORS[0] / evidence.noise_factor) ** 2
    before, after = (((off / loose) ** 2).mean() / 2 for off in (level, np.abs(tilted.on_map(image) - on_map)))
    return len(image) * float(_surprise(before, least) - _surprise(after, least))


def _surprise(variance: float, least: float) -> float:
    """Return −ln likelihood of residuals with this mean square on each axis, with equal noise, at least ``least``."""
    noise = max(variance, least)
    return float(np.log(noise) + variance / noise)


def _refined(
    verifier: Verifier, query: SeenLandmarks, poses: Sequence[Pose], matcher: PoseMatcher, tilted: bool
) -> list[PoseEvidence]:
    """Match and fit until both agree, then weigh. A pose that loses its matches stays unchanged."""
    index = verifier.index
    if not poses:
        return []
    numbers, factors = numbers_of(poses), np.full(len(poses), FIRST_NOISE_FACTOR)
    moving = np.arange(len(poses))
    for number in range(REFINEMENTS):
        before, factor = numbers[:, moving], factors[moving, None]
        nearest, ends = matcher.match(stack_of(before), factor, which=moving)
        kept = matched_within(nearest, ends)
        weights = 1 / nearest.deviations**2
        if number < ROBUST_REFINEMENTS:
            weights *= np.maximum(biweight(nearest.distances, ends), 1e-6)
        else:
            weights *= huber(nearest.distances, factor * nearest.deviations)
        on_map = index.points[nearest.objects]
        good = np.flatnonzero(kept.sum(axis=1) >= MINIMUM_MATCHES)
        fit = _fitted_tilted if tilted else _fitted
        fitted = fit(query, on_map[good], np.where(kept, weights, 0.0)[good], before[:, good])
        ratios = np.abs(fitted[1] / before[1, good])
        alike = (ratios > 0.7) & (ratios < 1.4)
        good, fitted = good[alike], fitted[:, alike]
        if not len(good):
            break
        moving = moving[good]
        numbers[:, moving] = fitted
        residuals = np.abs(stack_of(fitted).on_map(query.points) - on_map[good]) / nearest.deviations[good]
        factors[moving] = noise_factor(np.where(kept[good], residuals, np.inf), 8 if tilted else 4)
    return weigh_all(verifier, query, [Pose(*of) for of in numbers.T.tolist()], factors, matcher)


def _fitted(query: SeenLandmarks, on_map: np.ndarray, weights: np.ndarray, before: np.ndarray) -> np.ndarray:
    """Return (4, S) numbers of level poses by least squares, on matches (S, n) with weights, 0 for no match."""
    fitted = np.zeros_like(before)
    fitted[:2] = fit_similarity(query.points[None], on_map, weights)
    return fitted


def _fitted_tilted(query: SeenLandmarks, on_map: np.ndarray, weights: np.ndarray, before: np.ndarray) -> np.ndarray:
    """Return (4, S) numbers of poses of cameras that may be tilted, starting at ``before`` (4, S)."""
    fitted = np.empty_like(before)
    for k, (numbers, points, weight) in enumerate(zip(before.T.tolist(), on_map, weights)):
        kept = np.flatnonzero(weight)
        pose = fit_tilted(query.points[kept], points[kept], weight[kept] ** -0.5, Pose(*numbers), query.diagonal)
        fitted[:, k] = pose.center, pose.turn, pose.stretch, pose.slope
    return fitted


def weigh_all(
    verifier: Verifier,
    query: SeenLandmarks,
    poses: Sequence[Pose],
    factors: np.ndarray,
    matcher: PoseMatcher | None = None,
) -> list[PoseEvidence]:
    """Return the evidence for each of S poses without fitting it.

    Args:
        query: The image's ``telling_objects``.
        factors: (S,) ratio of the noise to the assumed one.
        matcher: Of these poses; None to make one.
    """
    index, settings = verifier.index, verifier.index.settings
    numbers, matcher = numbers_of(poses), matcher or PoseMatcher(index, query, len(poses))
    all_poses = stack_of(numbers)
    log_sizes = np.log(all_poses.pixel_sizes(query.points))
    nearest, _ = matcher.match(all_poses, factors[:, None])
    deviations = factors[:, None] * nearest.deviations
    is_matched = matched_within(nearest, settings.noise.gate_in_noise * deviations)
    objects = np.where(is_matched, nearest.objects, -1)
    ratios = match_ratios(index, query, Nearest(nearest.distances, objects, deviations), log_sizes)
    # Landmarks much smaller than any on the map, beyond area noise, are neither for nor against a pose. If their
    # matches counted, a pose at which hardly any landmark is large enough would have no evidence against it.
    smallest = (
        np.log(max(index.minimum_area_m2, 1e-12)) - settings.noise.smaller_in_noise * settings.noise.area_deviation
    )
    could_be = query.log_areas + 2 * log_sizes >= smallest
    is_matched &= could_be
    expected = expected_objects(verifier, query, numbers)
    # NumPy sorts for ``isin``, which takes several times as long for a few numbers.
    missing = np.array(
        [len(set(some.tolist()).difference(of[has].tolist())) for some, of, has in zip(expected, objects, is_matched)]
    )
    makers = [ASSUMED_OBJECTS if pose.is_level else ASSUMED_OBJECTS_TILTED for pose in poses]
    log_odds = averaged_log_odds(np.where(could_be, ratios, 1.0), is_matched, missing, np.array(makers), settings.noise)
    found = []
    for k, pose in enumerate(poses):
        matched = np.flatnonzero(is_matched[k])
        # Matches that force a tilt that no camera has are no evidence for it.
        odds = float(log_odds[k]) - pose.tilt_surprise(query.diagonal)
        of_map, noise, possible = objects[k, matched], deviations[k, matched], np.flatnonzero(could_be[k])
        found.append(PoseEvidence(pose, odds, matched, of_map, noise, float(factors[k]), expected[k], possible))
    return found


def depth_in_view(view: np.ndarray, points: np.ndarray) -> np.ndarray:
    """Return (n,) distances of points (n,) from the border of a convex polygon of clockwise corners; outside < 0."""
    edges = np.roll(view, -1) - view
    away = (points - view[:, None]) * (edges.conj() / np.abs(edges))[:, None]
    return -away.imag.max(axis=0)


def expected_objects(verifier: Verifier, query: SeenLandmarks, numbers: np.ndarray) -> list[np.ndarray]:
    """Return landmarks of the map, (M,) each, that an image should show whole, no smaller than in ``query``.

    Args:
        numbers: (4, S) of S poses (``numbers_of``).
    """
    index, settings = verifier.index, verifier.index.settings
    half = complex(verifier.width_px, verifier.height_px) / 2
    corners = stack_of(numbers).on_map(np.array([half, -half, half.conjugate(), -half.conjugate()]))
    east, north = corners.real, corners.imag
    lows, highs = east.min(axis=1) + 1j * north.min(axis=1), east.max(axis=1) + 1j * north.max(axis=1)
    boxes = [index.within(low, high) for low, high in zip(lows.tolist(), highs.tolist())]
    which, found = np.repeat(np.arange(len(boxes)), [len(box) for box in boxes]), np.concatenate(boxes)
    whole = index.whole[found]
    which, found = which[whole], found[whole]
    each = stack_of(numbers, which)
    inside = each.in_image(index.points[found])
    log_areas_px = index.log_areas[found] - 2 * np.log(each.pixel_sizes(inside))
    edge = np.exp(log_areas_px / 2)
    seen = (np.abs(inside.real) < half.real - edge) & (np.abs(inside.imag) < half.imag - edge)
    if verifier.side is not None:
        seen &= verifier.side.contains(inside)
    if verifier.view is not None:
        seen &= depth_in_view(verifier.view, inside) > edge
    smallest = np.log(max(verifier.minimum_area_px, 1e-12))
    if len(query.points) >= settings.limits.largest_objects:
        smallest = max(smallest, float(query.log_areas.min()))
    shown = np.flatnonzero(seen & (log_areas_px > smallest + settings.noise.area_deviation))
    return np.split(found[shown], np.searchsorted(which[shown], np.arange(1, len(boxes))))
