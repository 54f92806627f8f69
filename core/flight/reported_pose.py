"""A track's estimate of an image as what is told of it.

Told in docs/explanation/method.md#flights.
"""

from __future__ import annotations

import numpy as np

from ..geometry.pose import PoseCovariance
from ..geometry.shared_errors import covariance_of
from ..localization import LEAST_RISK, Status
from ..localizer.localizer import Localizer
from ..sentences import Sentence
from .measurement import distance, of_own
from .model import FlightImage, FlightPose, PoseSource
from .smoothing import TAILS, Estimate
from .states import place_of

WRONG_SHARE = 0.1
"""A pose that is farther off than this share of the image's edge is wrong, as the benchmarks judge."""

LOOSEST_POSE = 0.5
"""An image whose 95 % radius is larger than this share of its edge is left without a place."""

SAME_SHARE = 0.02
"""An image's own fix that is within this share of its edge agrees with the flight, however exact it claims to be."""


def told_pose(  # noqa: PLR0913 - an image, and what its track says
    image: FlightImage,
    number: int,
    localizer: Localizer,
    estimate: Estimate,
    risk: float,
    track: int,
) -> FlightPose:
    """An estimate as what is told of an image: a place, unless it could as well lie beside the image.

    Args:
        risk: That its track is wrong.
    """
    place = place_of(estimate.state, localizer.pyramid.frame.origin)
    size = place.oriented[1]
    known: PoseCovariance = covariance_of(estimate.pose_covariance, size, ())
    edge_m = float(np.sqrt(image.labels_hw.size)) * size
    if known.radius_95 is None or known.radius_95 > LOOSEST_POSE * edge_m:
        return unplaced(
            image,
            number,
            Sentence(
                "The flight goes on, but where this image lies is known to {radius:.0f} m only, and it shows "
                "{edge:.0f} m.",
                radius=known.radius_95,
                edge=edge_m,
            ),
        )
    risk = max(risk, LEAST_RISK, chance_off(estimate.pose_covariance, WRONG_SHARE * edge_m))
    own = of_own(image.own, localizer.pyramid)
    agrees = False
    if own is not None:
        apart = float(np.hypot(*(own.state - estimate.state)[:2]))
        reach = SAME_SHARE * edge_m
        agrees = apart <= reach or distance(own, estimate.state, estimate.pose_covariance) <= 3
    return FlightPose(
        image.name,
        number,
        Status.FIX,
        None,
        place,
        known,
        risk,
        PoseSource.OWN if agrees else PoseSource.FLIGHT,
        track,
        own is not None and not agrees,
        image.own,
        image.time_s,
        image.size_wh,
    )


def unplaced(image: FlightImage, number: int, reason: Sentence, status: Status = Status.AMBIGUOUS) -> FlightPose:
    """An image that the flight doesn't place."""
    return FlightPose(image.name, number, status, reason, own=image.own, time_s=image.time_s, size_wh=image.size_wh)


def chance_off(covariance: np.ndarray, reach_m: float) -> float:
    """Probability that a place lies farther off than so many meters, by its covariance, with the tails of measurements.

    Args:
        covariance: (4, 4) of the pose.
        reach_m: Meters.
    """
    strongest = max(float(np.linalg.eigvalsh(covariance[:2, :2])[-1]), 1e-12)
    return float((1 + reach_m**2 / (TAILS * strongest)) ** (-TAILS / 2))
