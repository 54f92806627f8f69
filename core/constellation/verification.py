"""What speaks for a pose: a likelihood ratio for every object of the image and of the map there.

Told in docs/method.md#constellation.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..geometry.pose import Pose, fit_similarity, fit_tilted, huber
from .hypotheses import SeenLandmarks
from .index import AREA_BIN, AREA_BINS, ConstellationIndex
from .parts import Side
from .settings import ConstellationSettings

MEDIAN_OF_RAYLEIGH = 1.1774
"""Median length of a residual whose two coordinates have a standard deviation of 1."""


@dataclass(frozen=True)
class PoseEvidence:
    """A verified pose: log odds against a chance hit, m matched pairs and their noise.

    Attributes:
        pose: Where the image lies.
        log_odds: Natural logarithm of the odds against chance.
        matched: (m,) int64, objects of the image.
        objects: (m,) int64, those of the map.
        deviations: (m,) σ of each match, map units.
        noise_factor: How much of the assumed noise there is.
        expected: (M,) int64, objects of the map that should be seen.
        possible: (k,) int64, objects of the image that could be on the map.
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
    def missing(self) -> int:
        """How many objects of the map should be seen and aren't."""
        return len(np.setdiff1d(self.expected, self.objects))

    @property
    def considered(self) -> int:
        """How many objects of the image could be on the map."""
        return len(self.possible)


@dataclass(frozen=True)
class Verifier:
    """What verification needs of catalogue and image.

    Attributes:
        index: The map's catalogue.
        width_px: Of the image.
        height_px: Of the image.
        minimum_area_px: Area, px², below which objects were not taken from the image.
        side: The part of the image that is looked at; None for all of it.
    """

    index: ConstellationIndex
    width_px: float
    height_px: float
    minimum_area_px: float
    side: Side | None = None


@dataclass(frozen=True)
class Nearest:
    """Nearest objects of the map to those of an image, of the same class; … stands for as many poses as there are.

    Attributes:
        distances: (…, n) map units, inf where there is none.
        objects: (…, n) int64, −1 where there is none.
        deviations: (…, n) σ of each distance, map units.
    """

    distances: np.ndarray
    objects: np.ndarray
    deviations: np.ndarray


def center_noise(
    log_areas_px: np.ndarray, pixel_size: np.ndarray | float, settings: ConstellationSettings
) -> np.ndarray:
    """Assumed σ of centers, map units.

    Args:
        log_areas_px: (…, n) ln of areas in px².
        pixel_size: Map units, broadcastable.
        settings: Of the constellation.
    """
    return pixel_size * np.hypot(settings.center_noise_px, settings.center_noise_in_sizes * np.exp(log_areas_px / 2))


def match_ratios(
    index: ConstellationIndex, query: SeenLandmarks, nearest: Nearest, log_scale: np.ndarray
) -> np.ndarray:
    """(…, n) likelihood ratio of every object's nearest match against a random hit at the local density.

    Without a match it is 0.

    Args:
        index: The map's catalogue.
        query: The image's n objects.
        nearest: What is nearest to them.
        log_scale: ln pixel size, broadcastable.
    """
    settings, deviations = index.settings, nearest.deviations
    found = np.maximum(nearest.objects, 0)
    position = -0.5 * (nearest.distances / deviations) ** 2 - np.log(2 * np.pi * deviations**2 * index.densities[found])
    area = query.log_areas + 2 * log_scale
    off = area - index.log_areas[found]
    outliers = settings.area_outliers
    seen = (1 - outliers) * _normal(off, settings.area_deviation)
    seen += outliers * _normal(off, settings.area_outlier_deviation)
    bins = np.clip(((area - AREA_BINS[0]) / AREA_BIN).astype(np.int64), 0, len(AREA_BINS) - 1)
    ratio = np.exp(np.clip(position, -50, 30)) * seen / index.area_densities[query.ranks, bins]
    return np.where((nearest.objects >= 0) & (nearest.distances <= settings.gate_in_noise * deviations), ratio, 0)


def gains(ratios: np.ndarray, distractors: float | np.ndarray) -> np.ndarray:
    """Logarithm of every object's likelihood ratio, if a share (broadcastable) has nothing to do with the map."""
    return np.log(distractors + (1 - distractors) * ratios)


def averaged_log_odds(
    ratios: np.ndarray, matched: np.ndarray, missing: int, assumed: int, settings: ConstellationSettings
) -> float:
    """Logarithm of the likelihood ratio of all objects, averaged over shares of distractors and visibilities.

    How poor an image's labels are is not known beforehand. At the shares that suit it, a poor image keeps evidence that
    one fixed share would take from it, and a good one loses no more than ln of their number.

    Args:
        ratios: (n,) of the objects that could be on the map.
        matched: (n,) bool, those with a match.
        missing: Objects of the map that should be seen and aren't.
        assumed: Matches that may have made the hypothesis; so many times their mean gain is taken off.
        settings: The shares.
    """
    gained = gains(ratios, np.array(settings.distractors)[:, None])
    means = np.maximum(gained[:, matched].mean(axis=1), 0) if matched.any() else 0.0
    of_image = gained.sum(axis=1) - assumed * means
    of_map = missing * np.log1p(-np.array(settings.visibility))
    terms = of_image[:, None] + of_map
    largest = terms.max()
    return float(largest + np.log(np.exp(terms - largest).mean()))


def _normal(x: np.ndarray, deviation: float) -> np.ndarray:
    return np.exp(-0.5 * (x / deviation) ** 2) / (np.sqrt(2 * np.pi) * deviation)


def rough_scores(
    index: ConstellationIndex, query: SeenLandmarks, centers: np.ndarray, turns: np.ndarray, gates: Sequence[float]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Poses fitted all at once, with shrinking gates, and their scores; what the image lacks doesn't count.

    Args:
        index: The map's catalogue.
        query: The image's most telling objects only, all of known class.
        centers: (S,) complex, map units from the index's origin.
        turns: (S,) complex, heading and pixel size.
        gates: How far off a match may be, one after the other, pixels.

    Returns:
        (S,) centers, turns and scores.
    """
    settings = index.settings
    for gate in gates:
        size = np.abs(turns)[:, None]
        distances, objects = index.matcher.match(centers[:, None] + turns[:, None] * query.points, query.ranks)
        off = query.log_areas + 2 * np.log(size) - index.log_areas[np.maximum(objects, 0)]
        near = (distances <= gate * size) & (np.abs(off) < 1.5)
        weights = near / center_noise(query.log_areas, size, settings) ** 2
        fitted = fit_similarity(query.points[None], index.points[np.maximum(objects, 0)], weights)
        enough = near.sum(axis=1) >= 4
        enough &= np.abs(np.log(np.maximum(np.abs(fitted[1]), 1e-12) / size[:, 0])) < 0.3
        centers = np.where(enough, fitted[0], centers)
        turns = np.where(enough, fitted[1], turns)
    size = np.abs(turns)[:, None]
    distances, objects = index.matcher.match(centers[:, None] + turns[:, None] * query.points, query.ranks)
    deviations = 1.5 * center_noise(query.log_areas, size, settings)
    ratios = match_ratios(index, query, Nearest(distances, objects, deviations), np.log(size))
    return centers, turns, gains(ratios, settings.rough_distractors).sum(axis=1)


def telling_objects(query: SeenLandmarks, count: int) -> np.ndarray:
    """Ascending places of the largest whole objects of known class, at most ``count``."""
    usable = np.flatnonzero(query.whole & (query.ranks >= 0))
    return np.sort(usable[np.argsort(-query.log_areas[usable], kind="stable")[:count]])


def verify(verifier: Verifier, query: SeenLandmarks, pose: Pose) -> PoseEvidence:
    """Refines the pose of a level camera by match and fit, then weighs it.

    Args:
        verifier: Catalogue and image.
        query: The image's ``telling_objects``.
        pose: A first one.
    """
    return _refined(verifier, query, pose, 2.0)


def verify_tilted(verifier: Verifier, query: SeenLandmarks, pose: Pose, focus: complex) -> PoseEvidence:
    """The same for a camera that may be tilted.

    Args:
        verifier: Catalogue and image.
        query: The image's ``telling_objects``.
        pose: A first one.
        focus: Where in the image it holds; matches spread from there over the image.
    """
    settings = verifier.index.settings
    gate = settings.growing_gate * query.diagonal
    for reach in settings.growing_reach:
        nearest = _nearest(verifier.index, query, pose)
        distances, objects, deviations = nearest.distances, nearest.objects, nearest.deviations
        near = (np.abs(query.points - focus) <= reach * query.diagonal) & _one_to_one(distances, objects)
        ends = gate * abs(pose.turn) + settings.gate_in_noise * deviations
        kept = np.flatnonzero(near & (distances <= ends))
        if len(kept) < settings.minimum_matches:
            break
        loose = deviations[kept] / np.maximum(biweight(distances[kept], ends[kept]), 0.05) ** 0.5
        fitted = fit_tilted(query.points[kept], verifier.index.points[objects[kept]], loose, pose, query.diagonal)
        if not 0.7 < abs(fitted.turn / pose.turn) < 1.4:
            break
        pose = fitted
    return _refined(verifier, query, pose, 2.0, tilted=True)


def gained_by_tilt(verifier: Verifier, query: SeenLandmarks, evidence: PoseEvidence) -> float:
    """Log likelihood that the matches of a level pose gain if the camera may be tilted; 2 on average if it is level.

    Args:
        verifier: Catalogue and image.
        query: The image's ``telling_objects``.
        evidence: Of a level pose, with ``minimum_matches`` or more.
    """
    image, on_map = query.points[evidence.matched], verifier.index.points[evidence.objects]
    level = np.abs(evidence.pose.on_map(image) - on_map)
    loose = evidence.deviations / np.sqrt(huber(level, evidence.deviations))
    tilted = fit_tilted(image, on_map, loose, evidence.pose, query.diagonal)
    least = (verifier.index.settings.noise_factors[0] / evidence.noise_factor) ** 2
    before, after = (((off / loose) ** 2).mean() / 2 for off in (level, np.abs(tilted.on_map(image) - on_map)))
    return len(image) * float(_surprise(before, least) - _surprise(after, least))


def _surprise(variance: float, least: float) -> float:
    """−ln likelihood of a residual whose squares have this mean along each axis, if noise is as large but not less."""
    noise = max(variance, least)
    return float(np.log(noise) + variance / noise)


def _refined(verifier: Verifier, query: SeenLandmarks, pose: Pose, factor: float, tilted: bool = False) -> PoseEvidence:
    """Match and fit until both agree; then the evidence."""
    settings = verifier.index.settings
    for number in range(settings.refinements):
        nearest = _nearest(verifier.index, query, pose)
        distances, objects, deviations = nearest.distances, nearest.objects, nearest.deviations
        ends = settings.gate_in_noise * factor * deviations
        kept = np.flatnonzero(_one_to_one(distances, objects) & (distances <= ends))
        if len(kept) < settings.minimum_matches:
            break
        image, on_map, weights = query.points[kept], verifier.index.points[objects[kept]], 1 / deviations[kept] ** 2
        if number < settings.robust_refinements:
            weights *= np.maximum(biweight(distances[kept], ends[kept]), 1e-6)
        else:
            weights *= huber(distances[kept], factor * deviations[kept])
        if tilted:
            fitted = fit_tilted(image, on_map, weights**-0.5, pose, query.diagonal)
        else:
            fitted = Pose(*(complex(value) for value in fit_similarity(image, on_map, weights)))
        if not 0.7 < abs(fitted.turn / pose.turn) < 1.4:
            break
        pose = fitted
        residuals = np.abs(pose.on_map(image) - on_map) / deviations[kept]
        factor = noise_factor(residuals, 8 if tilted else 4, settings)
    return weigh(verifier, query, pose, factor)


def noise_factor(residuals: np.ndarray, fitted: int, settings: ConstellationSettings) -> float:
    """σ of matches over the assumed one.

    From the median, because some matches are wrong. A pose takes its numbers out of the residuals: the squares of n
    true ones are smaller by 2 n / (2 n − fitted). Few residuals tell little, so the assumption counts as well.

    Args:
        residuals: (n,) lengths over the assumed σ.
        fitted: Numbers of the pose.
        settings: Of the constellation.
    """
    count = len(residuals)
    measured = (median(residuals) / MEDIAN_OF_RAYLEIGH) ** 2 * 2 * count / max(2 * count - fitted, 1)
    assumed = settings.assumed_matches
    factor = float(np.sqrt((count * measured + assumed) / (count + assumed)))
    least, most = settings.noise_factors
    return min(max(factor, least), most)


def median(values: np.ndarray) -> float:
    """Median of a few values, (n,) with n ≥ 1; NumPy's takes ten times as long to come to the same."""
    ordered = np.sort(values)
    return float(ordered[(len(ordered) - 1) // 2] + ordered[len(ordered) // 2]) / 2


def weigh(verifier: Verifier, query: SeenLandmarks, pose: Pose, factor: float) -> PoseEvidence:
    """The evidence for a pose as it is.

    Args:
        verifier: Catalogue and image.
        query: The image's ``telling_objects``.
        pose: Where the image may lie.
        factor: How much of the assumed noise there is.
    """
    index, settings = verifier.index, verifier.index.settings
    log_sizes = np.log(pose.pixel_sizes(query.points))
    nearest = _nearest(index, query, pose)
    distances, deviations = nearest.distances, factor * nearest.deviations
    objects = np.where(_one_to_one(distances, nearest.objects), nearest.objects, -1)
    ratios = match_ratios(index, query, Nearest(distances, objects, deviations), log_sizes)
    # Smaller than anything on the map, more than area noise explains: neither for nor against. Were those that match
    # for it, a pose at which hardly anything is large enough would have nothing against it.
    smallest = np.log(max(index.minimum_area_m2, 1e-12)) - settings.smaller_in_noise * settings.area_deviation
    could_be = query.log_areas + 2 * log_sizes >= smallest
    is_matched = could_be & (objects >= 0) & (distances <= settings.gate_in_noise * deviations)
    matched, expected = np.flatnonzero(is_matched), expected_objects(verifier, query, pose)
    missing = len(expected) - len(np.intersect1d(expected, objects[matched], assume_unique=True))
    makers = settings.assumed_objects if pose.is_level else settings.assumed_objects_tilted
    log_odds = averaged_log_odds(ratios[could_be], is_matched[could_be], missing, makers, settings)
    # Matches that draw a camera to a tilt that no camera has are no evidence for it.
    log_odds -= pose.tilt_surprise(query.diagonal)
    possible = np.flatnonzero(could_be)
    return PoseEvidence(pose, log_odds, matched, objects[matched], deviations[matched], factor, expected, possible)


def expected_objects(verifier: Verifier, query: SeenLandmarks, pose: Pose) -> np.ndarray:
    """(M,) objects of the map that an image with this pose should show whole, none smaller than those in ``query``."""
    index, settings = verifier.index, verifier.index.settings
    half = complex(verifier.width_px, verifier.height_px) / 2
    corners = pose.on_map(np.array([half, -half, half.conjugate(), -half.conjugate()]))
    low = complex(corners.real.min(), corners.imag.min())
    found = index.within(low, complex(corners.real.max(), corners.imag.max()))
    found = found[index.whole[found]]
    inside = pose.in_image(index.points[found])
    log_areas_px = index.log_areas[found] - 2 * np.log(pose.pixel_sizes(inside))
    edge = np.exp(log_areas_px / 2)
    seen = (np.abs(inside.real) < half.real - edge) & (np.abs(inside.imag) < half.imag - edge)
    if verifier.side is not None:
        seen &= verifier.side.holds(inside)
    smallest = np.log(max(verifier.minimum_area_px, 1e-12))
    if len(query.points) >= settings.largest_objects:
        smallest = max(smallest, float(query.log_areas.min()))
    return found[seen & (log_areas_px > smallest + settings.area_deviation)]


def _nearest(index: ConstellationIndex, query: SeenLandmarks, pose: Pose) -> Nearest:
    """What is nearest to the image's objects at a pose, (n,) each, with the assumed deviations."""
    distances, objects = index.matcher.match(pose.on_map(query.points)[None], query.ranks)
    noise = center_noise(query.log_areas, abs(pose.turn), index.settings)
    return Nearest(distances[0].astype(np.float64), objects[0], noise)


def _one_to_one(distances: np.ndarray, objects: np.ndarray) -> np.ndarray:
    """(n,) bool: the nearest of the image's objects that share one of the map's."""
    order = np.lexsort((distances, objects))
    best = np.zeros(len(objects), bool)
    best[order[np.concatenate([[True], np.diff(objects[order]) != 0])[: len(order)]]] = True
    return best & (objects >= 0)


def biweight(distances: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """Tukey's biweight: (n,) weights, 1 at distance 0, falling smoothly to 0 at the end."""
    return np.maximum(1 - (distances / ends) ** 2, 0) ** 2
