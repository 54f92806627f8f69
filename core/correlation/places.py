"""Find places in map correlation: from the whole map to a few refined poses, coarse to fine.

See docs/explanation/method.md#map-correlation.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..labels.class_shares import ClassShares
from ..localization import Prior
from ..sentences import Sentence
from .class_pyramid import EvidenceLevel, MapPyramid, evidence_level, evidence_of_shares, reduce_level
from .decision import fisher_z
from .outlines import with_edges
from .refine import LEAST_TRUSTED, ScoredPose, pose_covariance, refine
from .refine_many import refine_many
from .search import SearchSpace, search

LEAST_LABELED = 0.3
"""Least share of the image with classes of the map."""

LEAST_ENERGY = 0.02
"""Least variance of the image's evidence, in units of the map's mean energy per pixel: an image of nearly one class
matches every place of that class."""

TURN_STEP_DEG = 14.4
"""Step of the headings: moves the middle of the edges of an image of ``coarse_edge`` by one coarse pixel either way."""

SCALE_STEP = 1.2
"""Ratio of neighboring pixel sizes, for the same reason."""

CHANCE_PEAKS = (1, 12)
"""Range of a pixel size's peaks whose median is the level of chance; the first may be the right place. Set by hand."""

WIDE_EDGE = 8
"""Edge of the image at the look before the first one on large maps (``most_at_once``). Set by hand."""

WIDE_STEP = 1.5
"""Steps of turns and pixel sizes of that look, in units of the first look's: its results start nearer to the optimum
than half a turn step. Set by hand."""

WIDE_CANDIDATES = (4096, 512)
"""Places of that look that are refined at its own pixels, and at those of the first look. Set by hand."""

OVERSHOOT = 1.15
"""Refinement may exceed the outermost searched pixel size by this ratio: half a step and some margin."""


def image_evidence(labels_hw: np.ndarray, pyramid: MapPyramid, shares: ClassShares | None = None) -> EvidenceLevel:
    """Return the image's evidence at the finest pixels in use: at most ``finest_edge`` along an edge.

    It uses the probable shares of classes if they are known.
    """
    if shares is not None:
        return evidence_of_shares(shares, pyramid.space, _shape(labels_hw))
    return evidence_level(labels_hw, pyramid.space, size_for(_shape(labels_hw), pyramid.settings.finest_edge))


def size_for(shape_hw: tuple[int, int], edge: int) -> tuple[int, int]:
    """Return (width, height) with about ``edge``² pixels for an image of that shape, at most its own."""
    height, width = shape_hw
    step = max(1.0, np.sqrt(height * width) / edge)
    return max(1, int(round(width / step))), max(1, int(round(height / step)))


def reduce_image(image: EvidenceLevel, edge: int) -> EvidenceLevel:
    """Return the image at about edge × edge pixels (the root of its area), at most its own."""
    return reduce_level(image, size_for(_shape(image.known), edge))


def missing_information(coarse: EvidenceLevel, pyramid: MapPyramid) -> Sentence | None:
    """Return why the image can't be found on any map; None if it can."""
    labeled = float(coarse.known.mean())
    if labeled < LEAST_LABELED:
        return Sentence(
            "Only {labeled:.0%} of the image has classes of the map; at least {least:.0%} is needed.",
            labeled=labeled,
            least=LEAST_LABELED,
        )
    energy = float(coarse.evidence.var(axis=(0, 1)).sum()) / pyramid.energy
    if energy < LEAST_ENERGY:
        return Sentence(
            "The image shows hardly more than one class; a larger footprint with several classes is needed."
        )
    return None


def search_space(pyramid: MapPyramid, prior: Prior, step: float = 1.0) -> SearchSpace:
    """Return the headings (all or those of the prior), pixel sizes in even ratios, and the part of the map to search.

    ``step``: distance of headings and pixel sizes, in the settings' steps.

    Raises:
        ValueError: The prior has no range of pixel sizes.
    """
    if prior.pixel_size_range is None:
        raise ValueError("The prior has no range of pixel sizes.")
    low, high = np.log(prior.pixel_size_range[0]), np.log(prior.pixel_size_range[1])
    count = max(1, int(np.ceil((high - low) / (step * np.log(SCALE_STEP)) - 1e-9)))
    sizes = np.exp(low + (np.arange(count) + 0.5) * (high - low) / count)
    turn_deg = step * TURN_STEP_DEG
    if prior.heading_deg is None or prior.heading_range_deg >= 180:
        headings = np.arange(0.0, 360.0 - 1e-9, turn_deg)
    else:
        first = prior.heading_deg - prior.heading_range_deg
        span = (prior.heading_deg + prior.heading_range_deg - first) % 360.0
        turns = max(1, int(np.ceil(span / turn_deg - 1e-9)))
        headings = (first + (np.arange(turns) + 0.5) * span / turns) % 360.0
    width, height = pyramid.size_m
    box = (0.0, 0.0, width, height)
    if prior.position is not None and prior.radius is not None:
        x, y = prior.position[0] - pyramid.frame.origin[0], pyramid.frame.origin[1] - prior.position[1]
        box = x - prior.radius, y - prior.radius, x + prior.radius, y + prior.radius
    return SearchSpace(headings, sizes, box)


def _shape(plane: np.ndarray) -> tuple[int, int]:
    height, width = plane.shape
    return height, width


def near_size(space: SearchSpace, pixel_size_m: float) -> SearchSpace:
    """Return the part of a search space with pixel sizes within one step of a given one."""
    step = np.abs(np.log(space.pixel_sizes_m / pixel_size_m))
    return replace(space, pixel_sizes_m=space.pixel_sizes_m[step <= max(step.min(), np.log(SCALE_STEP))])


def comparisons(space: SearchSpace, coarse: EvidenceLevel) -> float:
    """Return the number of comparisons of ``search``: places × headings × pixel sizes."""
    width, height = space.box_m[2] - space.box_m[0], space.box_m[3] - space.box_m[1]
    pixels_m2 = coarse.pixel[0] * coarse.pixel[1] * space.pixel_sizes_m**2
    return float((width * height / pixels_m2).sum() * len(space.headings_deg))


def search_spaces(
    image: EvidenceLevel, pyramid: MapPyramid, prior: Prior
) -> tuple[SearchSpace, SearchSpace | None] | None:
    """Return the search space and, if a look at larger pixels chooses first, the same with larger steps.

    Args:
        image: Evidence at the pixels of the first look or finer ones.
        prior: With a range of pixel sizes.

    Returns:
        None if the image shows too little ground for such a large map.
    """
    settings, space, wide = pyramid.settings, search_space(pyramid, prior), None
    looks = comparisons(space, reduce_image(image, settings.coarse_edge))
    if looks > settings.most_at_once:
        wide = search_space(pyramid, prior, WIDE_STEP)
        looks = comparisons(wide, reduce_image(image, WIDE_EDGE))
    return None if looks > settings.most_comparisons else (space, wide)


def first_peaks(
    image: EvidenceLevel, pyramid: MapPyramid, spaces: tuple[SearchSpace, SearchSpace | None], share: float
) -> np.ndarray:
    """Return rows of ``search``, (N, 5) best first, of the first look.

    Args:
        image: Evidence at the pixels of the first look or finer ones.
        spaces: Of ``search_spaces``.
        share: Of the places from a look at larger pixels that the first look uses.
    """
    space, wide = spaces
    if wide is None:
        return search(reduce_image(image, pyramid.settings.coarse_edge), pyramid, space)
    return _wide_peaks(image, pyramid, wide, share)


def edge_m(image: EvidenceLevel, pixel_size_m: float) -> float:
    """Return the edge on the ground (root of the area) of an image at a pixel size."""
    height, width = _shape(image.known)
    return float(np.sqrt(image.pixel[0] * width * image.pixel[1] * height)) * pixel_size_m


@dataclass(frozen=True)
class ChanceLevels:
    """Level of chance at each searched pixel size: the smaller the ground, the better it matches anywhere.

    Attributes:
        log_sizes: (S,) ln of the pixel sizes, ascending.
        levels: (S,) usual score of a good but wrong place, in Fisher's z.
    """

    log_sizes: np.ndarray
    levels: np.ndarray

    def at(self, pixel_size_m: np.ndarray | float) -> np.ndarray:
        """Return chance's score in Fisher's z at pixel sizes."""
        return np.interp(np.log(pixel_size_m), self.log_sizes, self.levels)

    def moved(self, score: float, from_size_m: float, to_size_m: float) -> float:
        """Return the score at another pixel size that is equally far above chance."""
        moved = fisher_z(score) + float(self.at(to_size_m) - self.at(from_size_m))
        return float(np.tanh(max(moved, 0.0)))


def chance_levels(peaks: np.ndarray, pixel_sizes_m: np.ndarray, are_chosen: bool = False) -> ChanceLevels:
    """Return the level of chance from the peaks of a look, (N, 5) best first: the median of a few for each pixel size.

    All levels are 0 if a pixel size has too few peaks, as in a small search area. If the peaks ``are_chosen`` from all
    sizes together, neighboring sizes are used instead.
    """
    first, last = CHANCE_PEAKS
    nearest = np.abs(np.log(peaks[:, 4, None] / pixel_sizes_m)).argmin(axis=1)
    found = []
    for number, size_m in enumerate(pixel_sizes_m):
        scores = peaks[nearest == number, 0][first:last]
        if len(scores) == last - first:
            found.append((np.log(size_m), float(np.median(np.arctanh(np.clip(scores, 0.0, 0.999))))))
    if not found or len(found) < len(pixel_sizes_m) and not are_chosen:
        return ChanceLevels(np.log(pixel_sizes_m), np.zeros(len(pixel_sizes_m)))
    return ChanceLevels(*np.array(found).T)


def best_places(
    image: EvidenceLevel, pyramid: MapPyramid, spaces: tuple[SearchSpace, SearchSpace | None], count: int
) -> tuple[list[ScoredPose], ChanceLevels]:
    """Return the best poses, refined at the decision's pixels, farthest above chance first, all at different places.

    Args:
        image: Evidence at the finest pixels in use.
        spaces: Of ``search_spaces``.
        count: Places of the first look to refine.
    """
    settings, quiet = pyramid.settings, pyramid.quiet
    last = settings.finalists if image.picture is None else settings.photo_finalists
    space, wide = spaces
    peaks = first_peaks(image, pyramid, spaces, count / settings.candidates)
    chance = chance_levels(peaks, space.pixel_sizes_m, wide is not None)
    poses = _poses_of(peaks)
    # Neighboring peaks may lead to different optima: until the last round, places differ from half the distance on.
    for edge, kept in (
        (settings.coarse_edge, count),
        (settings.middle_edge, settings.middle_candidates),
        (settings.decision_edge, last),
    ):
        level = reduce_image(image, edge)
        starts = distinct(_above_chance(poses, chance), image, _HALF * settings.apart, kept)
        poses = [pose for pose in refine_many(level, pyramid, starts, quiet, _STEPS) if _is_in(pose, space)]
    return distinct(_above_chance(poses, chance), image, settings.apart, last), chance


def _wide_peaks(image: EvidenceLevel, pyramid: MapPyramid, wide: SearchSpace, share: float) -> np.ndarray:
    """Return rows like those of ``search``, (N, 5) best first, of the places that a look at larger pixels chooses.

    ``share``: of the places to refine.
    """
    settings, sizes = pyramid.settings, wide.pixel_sizes_m

    def refined(starts: list[ScoredPose], edge: int) -> np.ndarray:
        moved = refine_many(reduce_image(image, edge), pyramid, starts, pyramid.quiet, _STEPS)
        found = [(p.score, p.x, p.y, p.heading_deg, p.pixel_size_m) for p in moved if _is_in(p, wide)]
        peaks = np.array(found, np.float64).reshape(-1, 5)
        return peaks[np.argsort(-peaks[:, 0], kind="stable")]

    many, few = (round(share * count) for count in WIDE_CANDIDATES)
    peaks = search(reduce_image(image, WIDE_EDGE), pyramid, wide)
    poses = _above_chance(_poses_of(peaks), chance_levels(peaks, sizes))
    peaks = refined(poses[:many], WIDE_EDGE)
    poses = _above_chance(_poses_of(peaks), chance_levels(peaks, sizes, are_chosen=True))
    return refined(distinct(poses, image, _HALF * settings.apart, few), settings.coarse_edge)


_STEPS, _FINE_STEPS, _HALF = 3, 12, 0.5
"""Steps of a refinement of many places, and of the best; share of the final distance between different places. Poor
labels need many steps."""


def _poses_of(peaks: np.ndarray) -> list[ScoredPose]:
    return [ScoredPose(x, y, heading, size, score) for score, x, y, heading, size in peaks]


def _is_in(pose: ScoredPose, space: SearchSpace) -> bool:
    """Return whether a refined pose still has a searched pixel size."""
    low, high = space.pixel_sizes_m[[0, -1]]
    return low / OVERSHOOT <= pose.pixel_size_m <= high * OVERSHOOT


def _above_chance(poses: list[ScoredPose], chance: ChanceLevels) -> list[ScoredPose]:
    """Return the poses sorted by how far they are above chance at their pixel size."""
    if not poses:
        return []
    scores, sizes = np.array([(pose.score, pose.pixel_size_m) for pose in poses]).T
    above = np.arctanh(np.clip(scores, 0.0, 0.999)) - chance.at(sizes)
    return [poses[n] for n in np.argsort(-above, kind="stable")]


def distinct(poses: list[ScoredPose], image: EvidenceLevel, share: float, count: int) -> list[ScoredPose]:
    """Return the first ``count`` poses, without those nearer to an earlier one than a share of that one's edge."""
    kept: list[ScoredPose] = []
    places, distances = np.empty((count, 2)), np.empty(count)
    for pose in poses:
        if len(kept) == count:
            break
        here = np.array([pose.x, pose.y])
        if not kept or (np.hypot(*(places[: len(kept)] - here).T) >= distances[: len(kept)]).all():
            places[len(kept)] = here
            distances[len(kept)] = share * edge_m(image, pose.pixel_size_m)
            kept.append(pose)
    return kept


def finest_pose(
    image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose, least_trusted: float = LEAST_TRUSTED
) -> tuple[ScoredPose, np.ndarray]:
    """Return the pose refined at increasingly fine pixels, at most the overview's, and its covariance at the finest.

    Args:
        least_trusted: As for ``inverse_without_noise``.
    """
    height, width = image.known.shape
    first, quiet = pyramid.settings.decision_edge, pyramid.quiet
    edge = first
    ground_m = np.sqrt(height * width * image.pixel[0] * image.pixel[1]) * pose.pixel_size_m
    last = min(np.sqrt(height * width), ground_m / pyramid.frame.pixel_size)
    while True:
        level = with_edges(reduce_image(image, edge))
        moved = refine(level, pyramid, pose, quiet, _FINE_STEPS)
        if moved.score > 0:
            pose = replace(moved, score=pose.score)
        if edge * 2 > max(last * 1.2, first):
            return pose, pose_covariance(level, pyramid, pose, quiet, least_trusted)
        edge *= 2
