"""Find all places near an expected one where class areas agree with the map, with their probabilities.

See docs/explanation/method.md#flights. If the pose of an image is uncertain, as after a missing link or at the start of
a track, several places nearby may agree about equally well. All of them are found and weighted. To accept the nearest
place alone would give a right track wrong poses.
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
"""Radius of the search in standard deviations of the expected pose."""

PULLED = (1 / 16, 0.25, 0.18)
"""Distance from which refinement still converges to a place: share of the image's edge, radians, ln pixel size. They
are a pixel of the first look and its steps of turns and sizes."""

MOST_STARTS = 400
"""Most start poses, the nearest ones first; limits the time if the pose is uncertain."""

APART = 0.03
"""Places closer than this share of the image's edge count as one."""

KEPT = ((16, 24, 2), (32, 12, 2), (64, 6, 4))
"""For each round: pixels along an edge, places kept, refinement steps."""


def starts_around(state: np.ndarray, covariance: np.ndarray, edge: float) -> np.ndarray:
    """Return (n, 4) start states within ``REACH`` standard deviations, dense enough to converge to every place.

    Args:
        state: (4,) expected.
        covariance: (4, 4) of it.
        edge: Of the image on the ground, meters.
    """
    # Along the axes of the ellipse, which is long and narrow after a missing link.
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
    """Return places near an expected one where class areas agree, most probable first, with their probabilities.

    Args:
        state: (4,) expected.
        covariance: (4, 4) of it.

    Returns:
        Poses with probabilities that sum to 1; empty if no place agrees.
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
    """Return (n,) ln likelihood of poses from agreement and distance, up to a common constant.

    Args:
        state: (4,) expected.
        known: (4, 4) covariance of the distance from it.
    """
    off = as_states(poses) - state
    off[:, 2] = wrap_angle(off[:, 2])
    scores = np.array([pose.score for pose in poses]).clip(0, 0.999)
    agreement = -0.5 * settings.comparisons * np.log(1 - scores**2)
    return agreement - 0.5 * (off * np.linalg.solve(known, off.T).T).sum(axis=1)
