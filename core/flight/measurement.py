"""One image measured near where its flight expects it: by class areas, and by landmarks where they agree."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..correlation.class_pyramid import MapPyramid
from ..correlation.exactness import known_pose, noise_factor
from ..correlation.places import finest_pose, image_evidence, reduced_image
from ..correlation.refine import NOT_COMPARABLE, ScoredPose, refine, score_at
from ..geometry.pose import PoseCovariance
from ..localization import Localization, Prior
from ..localizer.localizer import Localizer
from .settings import FlightSettings
from .states import place_of, state_of, turned

FINEST_EDGE = 256
"""Pixels along an edge up to which an image is refined here: its neighbors tell the rest."""


@dataclass(frozen=True)
class Measurement:
    """Where one image says that it lies.

    Attributes:
        state: (4,) meters east and north of the map's corner, heading in radians clockwise, ln pixel size.
        covariance: (4, 4) of it, what it shares with its neighbors included.
        is_own: It is the fix of the image alone.
        score: Correlation of class areas; None of landmarks.
    """

    state: np.ndarray
    covariance: np.ndarray
    is_own: bool = False
    score: float | None = None


def full_covariance(known: PoseCovariance, pixel_size: float) -> np.ndarray | None:
    """(4, 4) of map x and y, heading in radians, ln pixel size, the position's apart; None where it isn't known."""
    full = np.zeros((4, 4))
    full[:2, :2] = known.position
    full[2, 2] = np.radians(known.heading_deviation_deg) ** 2
    full[3, 3] = (known.pixel_size_deviation / pixel_size) ** 2
    return full if np.isfinite(full).all() and full[0, 0] > 0 else None


def of_own(own: Localization | None, pyramid: MapPyramid) -> Measurement | None:
    """The fix of an image alone."""
    if own is None or own.place is None or own.covariance is None or own.place.heading_deg is None:
        return None
    full = full_covariance(own.covariance, own.place.oriented[1])
    return None if full is None else Measurement(state_of(own.place, pyramid.frame.origin), full, is_own=True)


def by_areas(
    labels_hw: np.ndarray, localizer: Localizer, state: np.ndarray, covariance: np.ndarray, settings: FlightSettings
) -> Measurement | None:
    """Moved to where class areas agree best near an expected place; None where they don't.

    Args:
        labels_hw: (H, W) uint8 labels.
        localizer: Of the database.
        state: (4,) expected.
        covariance: (4, 4) of that.
        settings: Of flights.
    """
    pyramid, errors = localizer.pyramid, localizer.errors
    if not pyramid.space.channels:
        return None
    image = image_evidence(np.ascontiguousarray(labels_hw), pyramid)
    pose = ScoredPose(float(state[0]), float(-state[1]), float(np.degrees(state[2]) % 360), float(np.exp(state[3])))
    edge, decision = pyramid.settings.coarse_edge, pyramid.settings.decision_edge
    while edge <= decision:
        pose = refine(reduced_image(image, edge), pyramid, pose, pyramid.quiet, 4)
        edge *= 2
    if pose.score <= 0:
        return None
    pose, spread = finest_pose(reduced_image(image, FINEST_EDGE), pyramid, pose)
    score = score_at(reduced_image(image, decision), pyramid, pose, pyramid.quiet)
    if score == NOT_COMPARABLE or not np.isfinite(spread).all():
        return None
    spread = (settings.measured_factor * noise_factor(score, pyramid.settings)) ** 2 * spread
    edge_m = float(np.sqrt(labels_hw.size)) * pose.pixel_size_m
    known = known_pose(pose, spread, edge_m, pyramid.frame.pixel_size, errors)
    full = full_covariance(known, pose.pixel_size_m)
    if full is None:
        return None
    moved = np.array([pose.x, -pose.y, np.radians(pose.heading_deg), np.log(pose.pixel_size_m)])
    found = Measurement(moved, full, score=float(score))
    if np.trace(full[:2, :2]) / 2 > (settings.loosest * edge_m) ** 2:
        return None
    return found if distance(found, state, covariance) <= settings.gate else None


def by_landmarks(
    labels_hw: np.ndarray, localizer: Localizer, state: np.ndarray, covariance: np.ndarray, settings: FlightSettings
) -> Measurement | None:
    """The constellation's fix near an expected place; None where there is none.

    Args:
        labels_hw: (H, W) uint8 labels.
        localizer: Of the database.
        state: (4,) expected.
        covariance: (4, 4) of that.
        settings: Of flights.
    """
    deviations = np.sqrt(np.diag(covariance))
    size = float(np.exp(state[3]))
    radius = settings.gate * float(deviations[:2].max()) + 0.01 * float(np.sqrt(labels_hw.size)) * size
    ratio = float(np.exp(settings.gate * deviations[3] + 0.02))
    prior = Prior(
        place_of(state, localizer.pyramid.frame.origin).position,
        radius,
        float(np.degrees(state[2]) % 360),
        float(min(np.degrees(settings.gate * deviations[2]) + 2.0, 180.0)),
        (size / ratio, size * ratio),
    )
    found = localizer.localize_by_constellation(labels_hw, prior)
    measured = of_own(found, localizer.pyramid)
    if measured is None or distance(measured, state, covariance) > settings.gate:
        return None
    return Measurement(measured.state, measured.covariance)


def distance(measured: Measurement, state: np.ndarray, covariance: np.ndarray) -> float:
    """How far a measurement is from what is expected, in deviations of both, per degree of freedom."""
    off = measured.state - state
    off[2] = turned(off[2])
    square = float(off @ np.linalg.solve(measured.covariance + covariance, off))
    return float(np.sqrt(max(square, 0.0) / 2))
