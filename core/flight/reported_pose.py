"""The pose that a flight reports for an image, from the estimate of its track (docs/explanation/method.md#flights)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..geometry.shared_errors import covariance_of
from ..localization import LEAST_RISK, LIKELY_RISK, Status, only_likely
from ..localizer.localizer import Localizer
from ..sentences import Sentence
from .measurement import distance, own_measurement
from .model import FlightImage, FlightPose, PoseSource
from .smoothing import TAILS, Estimate
from .states import place_of

WRONG_SHARE = 0.1
"""A pose with a larger error than this share of the image's edge counts as wrong, as in the benchmarks."""

LOOSEST_POSE = 0.5
"""An image has no fix if its 95 % radius is larger than this share of its edge."""

SAME_SHARE = 0.02
"""An image's own fix within this share of its edge agrees with the flight, whatever its covariance."""


def report_pose(image: FlightImage, localizer: Localizer, estimate: Estimate, risk: float, track: int) -> FlightPose:
    """Return the pose of an image; it is only predicted if its 95 % radius is too large.

    Args:
        risk: Error probability of its track.
    """
    place = place_of(estimate.state, localizer.pyramid.frame.origin)
    size = place.oriented[1]
    covariance = covariance_of(estimate.pose_covariance, size, ())
    edge_m = float(np.sqrt(image.labels_hw.size)) * size
    if covariance.radius_95 is None or covariance.radius_95 > LOOSEST_POSE * edge_m:
        reason = Sentence(
            "The flight is tracked, but the 95 % radius of this image ({radius:.0f} m) is too large for its footprint "
            "width ({edge:.0f} m).",
            radius=covariance.radius_95,
            edge=edge_m,
        )
        return predicted(image, localizer, estimate, reason)
    risk = max(risk, LEAST_RISK, tail_probability(estimate.pose_covariance, WRONG_SHARE * edge_m))
    own = own_measurement(image.own, localizer.pyramid)
    agrees = False
    if own is not None:
        apart = float(np.hypot(*(own.state - estimate.state)[:2]))
        agrees = apart <= SAME_SHARE * edge_m or distance(own, estimate.state, estimate.pose_covariance) <= 3
    return FlightPose(
        Status.FIX,
        place=place,
        covariance=covariance,
        risk=risk,
        source=PoseSource.OWN if agrees else PoseSource.FLIGHT,
        track=track,
        is_outvoted=own is not None and not agrees,
        own=image.own,
        size_wh=image.size_wh,
    )


def unplaced(image: FlightImage, reason: Sentence, status: Status = Status.AMBIGUOUS) -> FlightPose:
    """Return the pose of an image that the flight can't place."""
    return FlightPose(status, reason, own=image.own, size_wh=image.size_wh)


def likely(pose: FlightPose, doubt: float, allowed: float) -> FlightPose | None:
    """Return a fix at a larger error probability than allowed as a likely position; None if it is not likely.

    Args:
        pose: With a fix.
        doubt: Error probability of its track at the end.
        allowed: Maximum error probability of a fix.
    """
    risk = max(pose.risk or 0.0, doubt, allowed)
    if risk > LIKELY_RISK:
        return None
    return replace(pose, status=Status.LIKELY, reason=only_likely(risk, allowed), risk=risk, track=0)


def predicted(
    image: FlightImage, localizer: Localizer, estimate: Estimate, reason: Sentence | None = None
) -> FlightPose:
    """Return where the motion since the last fix leads: a place with its covariance, which is no fix.

    Args:
        reason: Why there is no fix; by default because images do not agree with the map any more.
    """
    place = place_of(estimate.state, localizer.pyramid.frame.origin)
    covariance = covariance_of(estimate.pose_covariance, place.oriented[1], ())
    reason = reason or Sentence(
        "The last images do not agree with the map. The motion since the last position leads to {x:.0f}, {y:.0f}, with "
        "a 95 % radius of {radius:.0f} m.",
        x=place.position[0],
        y=place.position[1],
        radius=covariance.radius_95 or np.inf,
    )
    return replace(unplaced(image, reason), place=place, covariance=covariance, source=PoseSource.PREDICTED)


def tail_probability(covariance: np.ndarray, reach_m: float) -> float:
    """Return the probability of an error above ``reach_m`` meters, by Student's t with ``TAILS`` degrees of freedom.

    Args:
        covariance: (4, 4) of the pose.
    """
    strongest = max(float(np.linalg.eigvalsh(covariance[:2, :2])[-1]), 1e-12)
    return float((1 + reach_m**2 / (TAILS * strongest)) ** (-TAILS / 2))
