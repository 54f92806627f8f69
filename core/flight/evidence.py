"""Evidence of one image: its best places on the whole map, and its agreement with the map at an expected place.

See docs/explanation/method.md#flights. Even an image without a fix of its own agrees better with the map at its true
place than at nearly all others. The agreement is measured in standard deviations of what chance gives for this image:
its agreement at random places of the map, refined like the expected place.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..correlation.class_pyramid import EvidenceLevel, MapPyramid
from ..correlation.decision import risk_of_peaks, worth_of_outlines
from ..correlation.places import distinct, first_peaks, image_evidence, missing_information, reduce_image, search_spaces
from ..correlation.refine import ScoredPose
from ..correlation.refine_many import refine_many
from ..localization import Localization, Prior, log_odds_of
from .model import FlightImage
from .settings import FlightSettings
from .states import state_of

STEPS = 2
"""Gauss–Newton steps from an expected place, which is at most one pixel of the first look off."""

LEAST_SPREAD = 0.03
"""Least standard deviation of an image's agreement at random places, in Fisher's z."""

SEED = 16


@dataclass(frozen=True)
class SeenImage:
    """An image prepared for hypotheses: its evidence at the pixels of map correlation's first look.

    Attributes:
        evidence: Of its labels; None if they contain too little information.
        edge_px: Root of its area, pixels.
        chance: Mean and standard deviation of its agreement at random places, in Fisher's z.
        prior: Of this image, with a range of pixel sizes.
        own_state: (4,) of its best place by itself; None without one.
        own_odds: ln of the odds that this place is right.
    """

    evidence: EvidenceLevel | None
    edge_px: float
    chance: tuple[float, float]
    prior: Prior
    own_state: np.ndarray | None = None
    own_odds: float = 0.0


def prepare_image(image: FlightImage, pyramid: MapPyramid, prior: Prior, settings: FlightSettings) -> SeenImage:
    """Return an image prepared for hypotheses.

    Args:
        image: Its labels of the map's class table, or their shares, and its localization by itself.
        prior: Of the image, with a range of pixel sizes.
    """
    edge_px = float(np.sqrt(image.labels_hw.size))
    evidence = None
    if pyramid.space.channels:
        fine = image_evidence(np.ascontiguousarray(image.labels_hw), pyramid, image.shares)
        evidence = reduce_image(fine, pyramid.settings.coarse_edge)
        evidence = None if missing_information(evidence, pyramid) else evidence
    seen = SeenImage(evidence, edge_px, (0.0, 1.0), prior, *_own(image.own, pyramid.frame.origin))
    if evidence is None:
        return seen
    scores = np.array([pose.score for pose in score_poses(seen, pyramid, random_poses(pyramid, prior, settings.nulls))])
    found = np.arctanh(np.clip(scores[scores > -1], -0.9, 0.9))
    spread = max(float(found.std()), LEAST_SPREAD) if len(found) else 1.0
    return replace(seen, chance=(float(found.mean()) if len(found) else 0.0, spread))


def _own(own: Localization | None, origin: tuple[float, float]) -> tuple[np.ndarray | None, float]:
    """Return state and ln odds of the best place of an image by itself.

    Without a photo's outlines: photos that overlap share the edges that agree by chance, and their evidence adds up.
    """
    if own is None or own.best is None or own.risk is None or own.best.heading_deg is None:
        return None, 0.0
    odds = log_odds_of(own.risk)
    if own.peaks is not None and own.peaks.outlines is not None:
        # Log odds are bounded, so a difference can be too small.
        by_labels = risk_of_peaks(replace(own.peaks, outlines=None, runner_up_outlines=None))
        odds = min(odds, max(odds - worth_of_outlines(own.peaks.outlines), log_odds_of(by_labels)))
    return state_of(own.best, origin), odds


def random_poses(pyramid: MapPyramid, prior: Prior, count: int) -> list[ScoredPose]:
    """Return poses on ground of the map that shows something; the same ones every time.

    Places are drawn in proportion to the energy of their evidence: on a map of few buildings, an image of a town would
    agree with any other town far better than with the empty ground that covers most of the map.
    """
    rng = np.random.default_rng(SEED)
    level = pyramid.whole(pyramid.level_of(8 * pyramid.frame.pixel_size))
    if level is None or prior.pixel_size_range is None:
        return []
    energy = np.where(level.known > 0.5, (level.evidence**2).sum(axis=2), 0.0).astype(np.float64)
    if not energy.any():
        return []
    low, high = np.log(prior.pixel_size_range)
    picked = rng.choice(energy.size, count, p=(energy / energy.sum()).ravel())
    rows, columns = np.unravel_index(picked, energy.shape)
    headings, sizes = rng.uniform(0, 360, count), np.exp(rng.uniform(low, high, count))
    return [
        ScoredPose(float(x), float(y), float(heading), float(size))
        for x, y, heading, size in zip((columns + 0.5) * level.pixel[0], (rows + 0.5) * level.pixel[1], headings, sizes)
    ]


def score_poses(seen: SeenImage, pyramid: MapPyramid, poses: Sequence[ScoredPose]) -> list[ScoredPose]:
    """Return poses refined to the best agreement of image and map nearby, with their scores."""
    if seen.evidence is None:
        return list(poses)
    return refine_many(seen.evidence, pyramid, list(poses), pyramid.quiet, STEPS)


def best_poses(seen: SeenImage, pyramid: MapPyramid, count: int, apart: float) -> list[ScoredPose]:
    """Return the best places of an image by itself, refined at the pixels of the first look, best first.

    Args:
        apart: Least distance between two places, as a share of the image's edge.
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
    """Return ln of the likelihood ratio of right to wrong places, (n,), from agreements (n,) at expected places."""
    offset, slope, least, most = settings.evidence_curve
    mean, spread = seen.chance
    above = (np.arctanh(np.clip(scores, -0.9, 0.999)) - mean) / spread
    return np.clip(offset + slope * above, least, most)
