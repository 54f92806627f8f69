"""Measure one image at the place where its flight expects it, by class areas and landmarks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..correlation.class_pyramid import EvidenceLevel, MapPyramid
from ..correlation.exactness import full_pose_covariance
from ..correlation.places import edge_m, finest_pose, image_evidence, missing_information, reduce_image
from ..correlation.refine import ScoredPose, score_at
from ..geometry.error_settings import SharedErrors
from ..geometry.pose import PoseCovariance
from ..geometry.radius import CIRCLE_95
from ..geometry.shared_errors import CLASSES, MAP
from ..localization import Localization, Prior
from ..localizer.localizer import Localizer
from .model import FlightImage
from .nearby import places_near
from .settings import FlightSettings
from .states import place_of, state_of, wrap_angle

LOOSEST = 0.05
"""A measurement is not used if its standard deviation exceeds this share of the image's edge on the ground."""

GATE = 4.0
"""Measurements more standard deviations than this from the expected place are outvoted."""

FINEST_EDGE = 256
"""Most pixels along an edge for refinement; the neighbors of the image add the rest."""

SHARED_PERCENTILE = 25
"""Percentile of a track's measurements by variance: the shared part is not larger than that of the better ones."""

SHARED_STEP = 0.4
"""Step of the logarithm of that percentile from image to image."""

LEAST_SHARE = 0.02
"""Places less probable than this are left out."""


@dataclass(frozen=True)
class Measurement:
    """A measured pose of one image.

    Attributes:
        state: (4,) meters east and north of the map's corner, heading in radians clockwise, ln pixel size.
        covariance: (4, 4) of it, including the part shared with its neighbors.
        shared_m2: Variance along an axis by the errors of the map and of the classes, which it shares with its
            neighbors, m².
    """

    state: np.ndarray
    covariance: np.ndarray
    shared_m2: float = 0.0

    @classmethod
    def of(cls, state: np.ndarray, known: PoseCovariance, pixel_size: float) -> Measurement | None:
        """Return the measurement of a pose; None if its covariance is not known."""
        full = full_covariance(known, pixel_size)
        shared_m2 = sum((known.part(cause) / CIRCLE_95) ** 2 for cause in (MAP, CLASSES))
        return None if full is None else cls(state, full, shared_m2)


def full_covariance(known: PoseCovariance, pixel_size: float) -> np.ndarray | None:
    """Return (4, 4) of map x and y, heading in radians and ln pixel size; None if the covariance is not known."""
    full = np.zeros((4, 4))
    full[:2, :2] = known.position
    full[2, 2] = np.radians(known.heading_deviation_deg) ** 2
    full[3, 3] = (known.pixel_size_deviation / pixel_size) ** 2
    return full if np.isfinite(full).all() and full[0, 0] > 0 else None


def own_measurement(own: Localization | None, pyramid: MapPyramid) -> Measurement | None:
    """Return the fix of an image by itself as a measurement; None without a fix."""
    if own is None or own.fix is None or own.covariance is None or own.fix.heading_deg is None:
        return None
    return Measurement.of(state_of(own.fix, pyramid.frame.origin), own.covariance, own.fix.oriented[1])


def measure_by_areas(
    image: FlightImage, localizer: Localizer, state: np.ndarray, covariance: np.ndarray, settings: FlightSettings
) -> Measurement | None:
    """Return the place nearby where class areas agree; None without agreement or with too large a covariance.

    For several places of similar probability, the result is their mean with a covariance that includes all of them.

    Args:
        state: (4,) expected.
        covariance: (4, 4) of it.
    """
    pyramid = localizer.pyramid
    if not pyramid.space.channels:
        return None
    evidence = image_evidence(np.ascontiguousarray(image.labels_hw), pyramid, image.shares)
    if missing_information(reduce_image(evidence, pyramid.settings.coarse_edge), pyramid):
        return None
    likely = places_near(evidence, pyramid, state, covariance, settings)
    errors = localizer.errors.with_biases(image.biases)
    found = []
    for pose, share in likely:
        one = _measure_at(evidence, pyramid, pose, errors, settings) if share >= LEAST_SHARE else None
        if one is not None:
            found.append((one, share))
    if not found:
        return None
    whole = mixture(found)
    loosest_m = LOOSEST * edge_m(evidence, float(np.exp(whole.state[3])))
    if np.trace(whole.covariance[:2, :2]) / 2 > loosest_m**2:
        return None
    return whole if distance(whole, state, covariance) <= GATE else None


def _measure_at(
    image: EvidenceLevel, pyramid: MapPyramid, pose: ScoredPose, errors: SharedErrors, settings: FlightSettings
) -> Measurement | None:
    """Return the measurement at a place; None if class areas do not determine the whole pose."""
    pose, spread = finest_pose(reduce_image(image, FINEST_EDGE), pyramid, pose, settings.least_trusted)
    score = score_at(reduce_image(image, pyramid.settings.decision_edge), pyramid, pose, pyramid.quiet)
    if score < settings.least_score or not np.isfinite(spread).all():
        return None
    ground_m = edge_m(image, pose.pixel_size_m)
    known = full_pose_covariance(pose, spread, ground_m, pyramid.frame.pixel_size, errors)
    moved = np.array([pose.x, -pose.y, np.radians(pose.heading_deg), np.log(pose.pixel_size_m)])
    return Measurement.of(moved, known, pose.pixel_size_m)


def mixture(found: Sequence[tuple[Measurement, float]]) -> Measurement:
    """Return one measurement for several possible ones.

    Args:
        found: Measurements with their probabilities, at least one, the most probable one first.
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
    """Return the fix of the constellation near an expected place; None without one.

    Args:
        state: (4,) expected.
        covariance: (4, 4) of it.
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
    if image.leveling is not None:
        localizer = localizer.with_view(image.leveling.view)
    found = localizer.localize_by_constellation(image.labels_hw, prior, image.biases)
    measured = own_measurement(found, localizer.pyramid)
    return measured if measured is not None and distance(measured, state, covariance) <= GATE else None


def distance(measured: Measurement, state: np.ndarray, covariance: np.ndarray) -> float:
    """Return the distance of a measurement from the expected pose, in standard deviations per degree of freedom."""
    off = measured.state - state
    off[2] = wrap_angle(off[2])
    square = float(off @ np.linalg.solve(measured.covariance + covariance, off))
    return float(np.sqrt(max(square, 0.0) / 2))


def measure_near(
    image: FlightImage, localizer: Localizer, state: np.ndarray, covariance: np.ndarray, settings: FlightSettings
) -> Measurement | None:
    """Return the measurement of an image at an expected place: its own fix, class areas or landmarks; None without one.

    Args:
        state: (4,) expected.
        covariance: (4, 4) of it.
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
    """Return the variance of the displacement that neighboring measurements share, along an axis, m²."""
    share = settings.shared_share
    shared = [max(one.shared_m2, share * float(np.trace(one.covariance[:2, :2])) / 2) for one in measured]
    return float(np.percentile(shared, SHARED_PERCENTILE)) if shared else 0.0


def shared_after(shared_m2: float, measured: Measurement, settings: FlightSettings) -> float:
    """Return ``shared_variance`` updated with one more measurement, without the earlier ones: a step to the percentile.

    Args:
        shared_m2: Value before; 0 without measurements.
    """
    here = shared_variance([measured], settings)
    if shared_m2 <= 0:
        return here
    share = SHARED_PERCENTILE / 100
    return shared_m2 * float(np.exp(SHARED_STEP * (share if here > shared_m2 else share - 1)))
