"""What an image says of any place: its best places by itself, and its agreement with the map at an expected one.

See docs/explanation/method.md#flights.

An image that is placed nowhere by itself still agrees better with the map where it is
than at nearly all other places. How much better is told in deviations of what chance gives for just this image: of its
agreement at random places of the map, moved to their optimum as an expected place is.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..correlation.class_pyramid import EvidenceLevel, MapPyramid
from ..correlation.places import (
    distinct,
    first_peaks,
    image_evidence,
    missing_information,
    reduce_image,
    search_spaces,
)
from ..correlation.refine import ScoredPose
from ..correlation.refine_many import refine_many
from ..localization import Localization, Prior, log_odds_of
from .settings import FlightSettings
from .states import state_of

STEPS = 2
"""Gauss–Newton steps from an expected place: it is at most a pixel of the first look off."""

LEAST_SPREAD = 0.03
"""Of an image's agreement at random places, in Fisher's z."""

SEED = 16


@dataclass(frozen=True)
class SeenImage:
    """An image as hypotheses are compared with it: at the pixels of map correlation's first look.

    Attributes:
        evidence: Of its labels; None where they tell nothing.
        edge_px: Root of its area, pixels.
        chance: Mean and deviation of its agreement, in Fisher's z, at random places.
        prior: What is known of it alone, with a range of pixel sizes.
        own_state: (4,) of its best place by itself; None without one.
        own_odds: ln of the odds that this is right.
    """

    evidence: EvidenceLevel | None
    edge_px: float
    chance: tuple[float, float]
    prior: Prior
    own_state: np.ndarray | None = None
    own_odds: float = 0.0


def prepare_image(
    labels_hw: np.ndarray, pyramid: MapPyramid, prior: Prior, own: Localization | None, settings: FlightSettings
) -> SeenImage:
    """An image, reduced to what hypotheses are compared with.

    Args:
        labels_hw: (H, W) uint8 labels of the map's class table, 0 = unknown.
        prior: With a range of pixel sizes.
        own: What was found for it alone.
    """
    edge_px = float(np.sqrt(labels_hw.size))
    evidence = None
    if pyramid.space.channels:
        fine = image_evidence(np.ascontiguousarray(labels_hw), pyramid)
        evidence = reduce_image(fine, pyramid.settings.coarse_edge)
        evidence = None if missing_information(evidence, pyramid) else evidence
    seen = SeenImage(evidence, edge_px, (0.0, 1.0), prior, *_own(own, pyramid.frame.origin))
    if evidence is None:
        return seen
    scores = np.array([pose.score for pose in score_poses(seen, pyramid, random_poses(pyramid, prior, settings.nulls))])
    found = np.arctanh(np.clip(scores[scores > -1], -0.9, 0.9))
    spread = max(float(found.std()), LEAST_SPREAD) if len(found) else 1.0
    return replace(seen, chance=(float(found.mean()) if len(found) else 0.0, spread))


def _own(own: Localization | None, origin: tuple[float, float]) -> tuple[np.ndarray | None, float]:
    """State and log odds of the best place of an image alone."""
    if own is None or own.best is None or own.risk is None or own.best.heading_deg is None:
        return None, 0.0
    return state_of(own.best, origin), log_odds_of(own.risk)


def random_poses(pyramid: MapPyramid, prior: Prior, count: int) -> list[ScoredPose]:
    """Poses on labeled ground of the map, the same ones every time."""
    rng = np.random.default_rng(SEED)
    level = pyramid.stored(pyramid.level_of(8 * pyramid.frame.pixel_size))
    if level is None or prior.pixel_size_range is None:
        return []
    rows, columns = np.nonzero(level.known > 0.5)
    if not len(rows):
        return []
    low, high = np.log(prior.pixel_size_range)
    picked = rng.integers(0, len(rows), count)
    headings, sizes = rng.uniform(0, 360, count), np.exp(rng.uniform(low, high, count))
    return [
        ScoredPose(float(x), float(y), float(heading), float(size))
        for x, y, heading, size in zip(
            (columns[picked] + 0.5) * level.pixel[0], (rows[picked] + 0.5) * level.pixel[1], headings, sizes
        )
    ]


def score_poses(seen: SeenImage, pyramid: MapPyramid, poses: Sequence[ScoredPose]) -> list[ScoredPose]:
    """Poses moved to where image and map agree best near by, with their scores.

    Args:
        seen: An image with evidence.
        poses: To start from.
    """
    if seen.evidence is None:
        return list(poses)
    return refine_many(seen.evidence, pyramid, list(poses), pyramid.quiet, STEPS)


def best_poses(seen: SeenImage, pyramid: MapPyramid, count: int, apart: float) -> list[ScoredPose]:
    """The best places of an image by itself, refined at the pixels of the first look, best first.

    Args:
        count: At most.
        apart: Least distance between two, share of the image's edge.
    """
    if seen.evidence is None:
        return []
    spaces = search_spaces(seen.evidence, pyramid, seen.prior)
    if spaces is None:
        return []
    peaks = first_peaks(seen.evidence, pyramid, spaces, 2 * count / pyramid.settings.candidates)
    starts = [ScoredPose(x, y, heading, size, score) for score, x, y, heading, size in peaks]
    starts = distinct(starts, seen.evidence, 0.5 * apart, 2 * count)
    refined = sorted(score_poses(seen, pyramid, starts), key=lambda pose: -pose.score)
    return distinct(refined, seen.evidence, apart, count)


def log_ratios(scores: np.ndarray, seen: SeenImage, settings: FlightSettings) -> np.ndarray:
    """(n,) ln of the likelihood ratio of right places against others, of agreements (n,) at expected places."""
    offset, slope, least, most = settings.evidence_curve
    mean, spread = seen.chance
    above = (np.arctanh(np.clip(scores, -0.9, 0.999)) - mean) / spread
    return np.clip(offset + slope * above, least, most)
