"""Places near an expected one where an image's class areas agree with the map, and how likely each of them is.

See docs/explanation/method.md#flights.

Where little is known of an image before it is looked at – after a missing link, at the
start of a track –, more than one place near by may agree about as well. They are all looked for, as far as what is
known reaches, and weighed: taking the nearest for certain is how a right track comes to tell wrong poses.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..correlation.class_pyramid import EvidenceLevel, MapPyramid
from ..correlation.places import distinct, edge_m, reduce_image
from ..correlation.refine import ScoredPose
from ..correlation.refine_many import refine_many
from .settings import FlightSettings
from .states import as_poses, as_states, wrap_angle

REACH = 2.5
"""Deviations of what is expected that places are looked for in."""

PULLED = (1 / 16, 0.25, 0.18)
"""From so far a place draws a start to itself: share of the image's edge, radians, ln pixel size; a pixel of the first
look, and the steps of its turns and sizes."""

MOST_STARTS = 400
"""Nearest ones; bounds the time where little is known."""

APART = 0.03
"""Places nearer to each other than this share of the image's edge are one."""

KEPT = ((16, 24, 2), (32, 12, 2), (64, 6, 4))
"""Pixels along an edge, places that are kept, steps to each."""


def starts_around(state: np.ndarray, covariance: np.ndarray, edge: float) -> np.ndarray:
    """(n, 4) states within ``REACH`` deviations of an expected one, so close that each place near by draws one of them.

    Args:
        state: (4,) expected.
        covariance: (4, 4) of it.
        edge: Of the image on the ground, meters.
    """
    # Along the axes of the ellipse: after a missing link it is long and narrow.
    strengths, directions = np.linalg.eigh(covariance[:2, :2])
    deviations = np.sqrt(np.maximum([*strengths, covariance[2, 2], covariance[3, 3]], 0))
    pulled = np.array([PULLED[0] * edge, *PULLED])[[0, 0, 2, 3]]
    rings = np.ceil(REACH * deviations / pulled - 0.5).clip(0, 20).astype(int)
    grid = np.meshgrid(*[np.arange(-ring, ring + 1) for ring in rings], indexing="ij")
    offsets = np.stack([axis.ravel() for axis in grid], axis=1) * pulled
    square = (offsets**2 / np.maximum(deviations, 1e-9) ** 2).sum(axis=1)
    nearest = np.argsort(square, kind="stable")
    offsets = offsets[nearest[square[nearest] <= 4 * REACH**2]][:MOST_STARTS]
    offsets[:, :2] = offsets[:, :2] @ directions.T
    return state + offsets


def places_near(
    image: EvidenceLevel, pyramid: MapPyramid, state: np.ndarray, covariance: np.ndarray, settings: FlightSettings
) -> list[tuple[ScoredPose, float]]:
    """The places near an expected one where class areas agree, most likely first, each with its probability.

    Args:
        image: Its evidence.
        state: (4,) expected.
        covariance: (4, 4) of that.

    Returns:
        Those among which one is likely to be the right one, their probabilities adding up to 1; none where nothing
        agrees.
    """
    edge = edge_m(image, float(np.exp(state[3])))
    poses = as_poses(starts_around(state, covariance, edge))
    known = covariance + np.diag([(APART * edge) ** 2] * 2 + [0.02**2, 0.02**2])
    odds = np.zeros(0)
    for edge_px, kept, steps in KEPT:
        poses = [
            pose
            for pose in refine_many(reduce_image(image, edge_px), pyramid, poses, pyramid.quiet, steps)
            if pose.score > 0
        ]
        odds = log_odds(poses, state, known, settings)
        poses = distinct([poses[n] for n in np.argsort(-odds, kind="stable")], image, APART, kept)
    if not poses:
        return []
    odds = log_odds(poses, state, known, settings)
    shares = np.exp(odds - odds.max())
    return [(pose, float(share)) for pose, share in zip(poses, shares / shares.sum())]


def log_odds(poses: Sequence[ScoredPose], state: np.ndarray, known: np.ndarray, settings: FlightSettings) -> np.ndarray:
    """(n,) ln of how likely poses are, up to what they share: by their agreement, and by how far they are off.

    Args:
        poses: With their scores.
        state: (4,) expected.
        known: (4, 4) covariance of how far places are off that.
    """
    off = as_states(poses) - state
    off[:, 2] = wrap_angle(off[:, 2])
    scores = np.array([pose.score for pose in poses]).clip(0, 0.999)
    agreement = -0.5 * settings.comparisons * np.log(1 - scores**2)
    return agreement - 0.5 * (off * np.linalg.solve(known, off.T).T).sum(axis=1)
