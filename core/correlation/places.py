"""Map correlation's list of places: from the whole map to a handful of refined poses, coarse to fine.

Told in docs/method.md#map-correlation.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..localization import Prior
from ..sentences import Sentence
from .class_pyramid import EvidenceLevel, MapPyramid, evidence_level, reduced_level
from .refine import ScoredPose, pose_covariance, refine
from .search import SearchSpace, search


def image_evidence(labels_hw: np.ndarray, pyramid: MapPyramid) -> EvidenceLevel:
    """The image's evidence at the finest pixels that are used: ``finest_edge`` of them along an edge or all it has."""
    return evidence_level(labels_hw, pyramid.space, size_for(_shape(labels_hw), pyramid.settings.finest_edge))


def size_for(shape_hw: tuple[int, int], edge: int) -> tuple[int, int]:
    """(width, height) of an image of that shape with ``edge``² pixels, never more than it has."""
    height, width = shape_hw
    step = max(1.0, np.sqrt(height * width) / edge)
    return max(1, int(round(width / step))), max(1, int(round(height / step)))


def reduced_image(image: EvidenceLevel, edge: int) -> EvidenceLevel:
    """The image at about edge × edge pixels (the root of its area), never more than it has."""
    return reduced_level(image, size_for(_shape(image.known), edge))


def missing_information(coarse: EvidenceLevel, pyramid: MapPyramid) -> Sentence | None:
    """Why the image can't be found on any map; None when it may."""
    settings = pyramid.settings
    labeled = float(coarse.known.mean())
    if labeled < settings.least_labeled:
        return Sentence("localization.too_few_labels", labeled=labeled, least=settings.least_labeled)
    energy = float(coarse.evidence.var(axis=(0, 1)).sum()) / pyramid.energy
    if energy < settings.least_energy:
        return Sentence("localization.hardly_one_class")
    return None


def search_space(pyramid: MapPyramid, prior: Prior) -> SearchSpace:
    """All turns (or those of the prior), its pixel sizes in even ratios, and the part of the map to search.

    Raises:
        ValueError: The prior has no range of pixel sizes.
    """
    settings = pyramid.settings
    if prior.pixel_size_range is None:
        raise ValueError("Without a range of pixel sizes nothing can be searched.")
    low, high = np.log(prior.pixel_size_range[0]), np.log(prior.pixel_size_range[1])
    count = max(1, int(np.ceil((high - low) / np.log(settings.scale_step) - 1e-9)))
    sizes = np.exp(low + (np.arange(count) + 0.5) * (high - low) / count)
    if prior.heading_deg is None or prior.heading_range_deg >= 180:
        headings = np.arange(0.0, 360.0 - 1e-9, settings.turn_step_deg)
    else:
        first = prior.heading_deg - prior.heading_range_deg
        span = (prior.heading_deg + prior.heading_range_deg - first) % 360.0
        turns = max(1, int(np.ceil(span / settings.turn_step_deg - 1e-9)))
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


def comparisons(space: SearchSpace, coarse: EvidenceLevel) -> float:
    """Places × turns × scales that ``search`` compares."""
    width, height = space.box_m[2] - space.box_m[0], space.box_m[3] - space.box_m[1]
    pixels_m2 = coarse.pixel[0] * coarse.pixel[1] * space.pixel_sizes_m**2
    return float((width * height / pixels_m2).sum() * len(space.headings_deg))


def apart_m(coarse: EvidenceLevel, pixel_sizes_m: tuple[float, float]) -> float:
    """Distance from which two poses count as different places: a quarter of the image's edge on the ground."""
    height, width = coarse.known.shape
    pixels = np.sqrt(coarse.pixel[0] * width * coarse.pixel[1] * height)
    return 0.25 * float(pixels * np.sqrt(pixel_sizes_m[0] * pixel_sizes_m[1]))


def best_places(
    image: EvidenceLevel,
    pyramid: MapPyramid,
    space: SearchSpace,
    count: int,
    distance_m: float,
) -> list[ScoredPose]:
    """The best poses, refined at the decision's pixels, best first, no two at the same place.

    Args:
        image: Its evidence at the finest pixels.
        pyramid: The map's.
        space: What is searched.
        count: Places refined after the first look.
        distance_m: From which two poses count as different places.
    """
    settings, quiet = pyramid.settings, pyramid.quiet
    coarse = reduced_image(image, settings.coarse_edge)
    peaks = search(coarse, pyramid, space)
    # Neighboring peaks may lead to different optima: at first, places are told apart at half the distance.
    starts = [ScoredPose(x, y, heading, size, score) for score, x, y, heading, size in peaks]
    starts = distinct(starts, distance_m / 2, count)
    moved = [refine(coarse, pyramid, pose, quiet, 4) for pose in starts]
    moved = distinct(sorted(moved, key=lambda pose: -pose.score), distance_m / 2, settings.finalists)
    finer = reduced_image(image, settings.decision_edge)
    finest = [refine(finer, pyramid, pose, quiet, 4) for pose in moved]
    return distinct(sorted(finest, key=lambda pose: -pose.score), distance_m, settings.finalists)


def distinct(poses: list[ScoredPose], distance_m: float, count: int) -> list[ScoredPose]:
    """The first ``count`` poses of which none is nearer than ``distance_m`` to an earlier one."""
    kept: list[ScoredPose] = []
    places = np.empty((count, 2))
    for pose in poses:
        if len(kept) == count:
            break
        here = np.array([pose.x, pose.y])
        if not kept or np.hypot(*(places[: len(kept)] - here).T).min() >= distance_m:
            places[len(kept)] = here
            kept.append(pose)
    return kept


def finest_pose(image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose) -> tuple[ScoredPose, np.ndarray]:
    """The pose refined at finer and finer pixels, to the map's overview pixel at most, and its covariance.

    That is taken at the decision's pixels: finer ones promise an accuracy that poor labels don't keep (measured with
    strong noise: 95 % of the errors are below 3.5 deviations at 64 pixels along an edge, below 7.9 at 128).
    """
    height, width = image.known.shape
    first, quiet = pyramid.settings.decision_edge, pyramid.quiet
    edge, decision = first, reduced_image(image, first)
    ground_m = np.sqrt(height * width * image.pixel[0] * image.pixel[1]) * pose.pixel_size_m
    last = min(np.sqrt(height * width), ground_m / pyramid.frame.pixel_size)
    while True:
        moved = refine(reduced_image(image, edge), pyramid, pose, quiet, 4)
        if moved.score > 0:
            pose = replace(moved, score=pose.score)
        if edge * 2 > max(last * 1.2, first):
            return pose, pose_covariance(decision, pyramid, pose, quiet)
        edge *= 2
