"""One image measured near where its flight expects it: by class areas, and by landmarks where they agree."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..correlation.class_pyramid import EvidenceLevel, MapPyramid
from ..correlation.exactness import full_pose_covariance, noise_factor
from ..correlation.places import edge_m, finest_pose, image_evidence, missing_information, reduce_image
from ..correlation.refine import ScoredPose, score_at
from ..geometry.error_settings import SharedErrors
from ..geometry.pose import PoseCovariance
from ..localization import Localization, Prior
from ..localizer.localizer import Localizer
from .model import FlightImage
from .nearby import places_near
from .settings import FlightSettings
from .states import place_of, state_of, wrap_angle

LOOSEST = 0.05
"""Measurements whose deviation is more than this share of the image's edge on the ground are not used."""

GATE = 4.0
"""Measurements farther from what the flight expects than so many deviations are outvoted."""

FINEST_EDGE = 256
"""Pixels along an edge up to which an image is refined here: its neighbors tell the rest."""

SHARED_PERCENTILE = 25
"""Of a track's measurements, by their variance: what they share is not larger than what the better ones have."""

SHARED_STEP = 0.4
"""Of that, in its logarithm, from image to image."""

LEAST_SHARE = 0.02
"""Places less likely than this are left out."""


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


def own_measurement(own: Localization | None, pyramid: MapPyramid) -> Measurement | None:
    """The fix of an image alone."""
    if own is None or own.place is None or own.covariance is None or own.place.heading_deg is None:
        return None
    full = full_covariance(own.covariance, own.place.oriented[1])
    return None if full is None else Measurement(state_of(own.place, pyramid.frame.origin), full, is_own=True)


def measure_by_areas(
    image: FlightImage, localizer: Localizer, state: np.ndarray, covariance: np.ndarray, settings: FlightSettings
) -> Measurement | None:
    """Moved to where class areas agree near an expected place; None where they don't, or where they can't tell where.

    Where several places are about as likely their mean is told, with a covariance that reaches all of them.

    Args:
        state: (4,) expected.
        covariance: (4, 4) of that.
    """
    pyramid = localizer.pyramid
    if not pyramid.space.channels:
        return None
    evidence = image_evidence(np.ascontiguousarray(image.labels_hw), pyramid)
    if missing_information(reduce_image(evidence, pyramid.settings.coarse_edge), pyramid):
        return None
    likely = places_near(evidence, pyramid, state, covariance, settings)
    errors = localizer.errors.with_biases(image.biases)
    found = []
    for pose, share in likely:
        one = _measured_at(evidence, pyramid, pose, errors, settings) if share >= LEAST_SHARE else None
        if one is not None:
            found.append((one, share))
    if not found:
        return None
    whole = mixture(found)
    loosest_m = LOOSEST * edge_m(evidence, float(np.exp(whole.state[3])))
    if np.trace(whole.covariance[:2, :2]) / 2 > loosest_m**2:
        return None
    return whole if distance(whole, state, covariance) <= GATE else None


def _measured_at(
    image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose, errors: SharedErrors, settings: FlightSettings
) -> Measurement | None:
    """A place as exactly as class areas tell it; None where they don't tell all of the pose."""
    pose, spread = finest_pose(reduce_image(image, FINEST_EDGE), pyramid, pose)
    score = score_at(reduce_image(image, pyramid.settings.decision_edge), pyramid, pose, pyramid.quiet)
    if score < settings.least_score or not np.isfinite(spread).all():
        return None
    ground_m = edge_m(image, pose.pixel_size_m)
    spread = (deviation_factor(ground_m, settings) * noise_factor(score, pyramid.settings)) ** 2 * spread
    known = full_pose_covariance(pose, spread, ground_m, pyramid.frame.pixel_size, errors)
    full = full_covariance(known, pose.pixel_size_m)
    if full is None:
        return None
    moved = np.array([pose.x, -pose.y, np.radians(pose.heading_deg), np.log(pose.pixel_size_m)])
    return Measurement(moved, full, score=float(score))


def deviation_factor(edge_m: float, settings: FlightSettings) -> float:
    """What deviations of class areas' fits are multiplied with: of little ground, neighboring parts err alike."""
    factor, enough_m, power = settings.measured_factor
    return factor * max(1.0, enough_m / edge_m) ** power


def mixture(found: Sequence[tuple[Measurement, float]]) -> Measurement:
    """One measurement of several that may be, with the shares that they are likely with.

    Args:
        found: At least one, each with its share; the first is the most likely one.
    """
    first, total = found[0][0], sum(share for _, share in found)
    off = np.array([one.state - first.state for one, _ in found])
    off[:, 2] = wrap_angle(off[:, 2])
    shares = np.array([share for _, share in found]) / total
    mean = shares @ off
    apart = off - mean
    covariance = sum(share * one.covariance for share, (one, _) in zip(shares, found))
    return replace(first, state=first.state + mean, covariance=covariance + (shares[:, None] * apart).T @ apart)


def measure_by_landmarks(
    image: FlightImage, localizer: Localizer, state: np.ndarray, covariance: np.ndarray
) -> Measurement | None:
    """The constellation's fix near an expected place; None where there is none.

    Args:
        state: (4,) expected.
        covariance: (4, 4) of that.
    """
    deviations = np.sqrt(np.diag(covariance))
    size = float(np.exp(state[3]))
    radius = GATE * float(deviations[:2].max()) + 0.01 * float(np.sqrt(image.labels_hw.size)) * size
    ratio = float(np.exp(GATE * deviations[3] + 0.02))
    prior = Prior(
        place_of(state, localizer.pyramid.frame.origin).position,
        radius,
        float(np.degrees(state[2]) % 360),
        float(min(np.degrees(GATE * deviations[2]) + 2.0, 180.0)),
        (size / ratio, size * ratio),
    )
    found = localizer.localize_by_constellation(image.labels_hw, prior, image.biases)
    measured = own_measurement(found, localizer.pyramid)
    if measured is None or distance(measured, state, covariance) > GATE:
        return None
    return Measurement(measured.state, measured.covariance)


def distance(measured: Measurement, state: np.ndarray, covariance: np.ndarray) -> float:
    """How far a measurement is from what is expected, in deviations of both, per degree of freedom."""
    off = measured.state - state
    off[2] = wrap_angle(off[2])
    square = float(off @ np.linalg.solve(measured.covariance + covariance, off))
    return float(np.sqrt(max(square, 0.0) / 2))


def measure_near(
    image: FlightImage, localizer: Localizer, state: np.ndarray, covariance: np.ndarray, settings: FlightSettings
) -> Measurement | None:
    """What an image says itself at an expected place: its own fix, landmarks, or class areas; None where nothing.

    Args:
        state: (4,) expected.
        covariance: (4, 4) of that.
    """
    own = own_measurement(image.own, localizer.pyramid)
    if own is not None and distance(own, state, covariance) <= GATE:
        return own
    found = measure_by_areas(image, localizer, state, covariance, settings)
    if found is not None:
        near = measure_by_landmarks(image, localizer, found.state, found.covariance)
        return near or found
    return measure_by_landmarks(image, localizer, state, covariance)


def shared_variance(measured: list[Measurement], settings: FlightSettings) -> float:
    """Of the displacement that neighboring measurements share, along an axis, map units²."""
    variances = [float(np.trace(one.covariance[:2, :2])) / 2 for one in measured]
    return settings.shared_share * float(np.percentile(variances, SHARED_PERCENTILE)) if variances else 0.0


def shared_after(shared_m2: float, measured: Measurement, settings: FlightSettings) -> float:
    """``shared_variance`` image by image, without keeping them: a step towards the percentile with each of them.

    Args:
        shared_m2: Until now; of no measurement 0.
        measured: The next one.
    """
    here = shared_variance([measured], settings)
    if shared_m2 <= 0:
        return here
    share = SHARED_PERCENTILE / 100
    return shared_m2 * float(np.exp(SHARED_STEP * (share if here > shared_m2 else share - 1)))
