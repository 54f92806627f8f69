"""Poses of a track from links and measurements: a Kalman filter forward, a Rauch–Tung–Striebel smoother backward.

See docs/explanation/method.md#flights. Each image has eight numbers. Four are its pose: meters east and north, heading
in radians clockwise, ln pixel size. Two are the error of map and labels around it (east, north), which all measurements
there share and which fades along the way, so that many measurements do not look too accurate. Two are the constant
error of links along the flight (along, across).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from .measurement import Measurement
from .motion import Link, LinkSource
from .settings import FlightSettings
from .states import wrap_angle

DRIFT = 0.01
"""Least standard deviation of the constant error of links: share of the distance along and, in radians, across."""

SIZE = 8
TAILS = 4.0
"""Degrees of freedom of measurement errors: 1 in 100 is as large as 1 in 40,000 would be without tails."""

MOST_DRIFT = 0.2
"""Largest standard deviation of the constant error of links."""

_SEEN = np.eye(4, SIZE)
_SEEN[:2, 4:6] = np.eye(2)
"""Measurement matrix: the pose, its position with the shared displacement."""


@dataclass(frozen=True)
class Estimate:
    """Estimate of one image.

    Attributes:
        mean: (8,) as in the module's description.
        covariance: (8, 8) of it.
    """

    mean: np.ndarray
    covariance: np.ndarray

    @property
    def state(self) -> np.ndarray:
        """(4,) of the pose."""
        return self.mean[:4]

    @property
    def pose_covariance(self) -> np.ndarray:
        """(4, 4) of the pose."""
        return self.covariance[:4, :4]

    @property
    def pose(self) -> tuple[np.ndarray, np.ndarray]:
        """State (4,) and covariance (4, 4) of the pose."""
        return self.state, self.pose_covariance


@dataclass(frozen=True)
class Step:
    """Step from one image to the next.

    Attributes:
        transition: (8, 8) of small deviations.
        predicted: Estimate of the next image before its measurement.
    """

    transition: np.ndarray
    predicted: Estimate


def first_estimate(state: np.ndarray, deviations: np.ndarray, shared_m2: float, drift: float) -> Estimate:
    """Return the estimate of a track's first image.

    Args:
        state: (4,) of its pose.
        deviations: (4,) of the pose.
        shared_m2: Variance of the shared displacement along an axis.
        drift: Standard deviation of the constant error of links, from ``drift_of``.
    """
    variances = [*np.square(deviations), shared_m2, shared_m2, drift**2, drift**2]
    return Estimate(np.array([*state, 0.0, 0.0, 0.0, 0.0]), np.diag(variances))


def drift_of(links: Iterable[Link]) -> float:
    """Return the standard deviation of links' constant error: half of their stated variance may be constant.

    Args:
        links: Known ones of the flight; assumed links are ignored.
    """
    shares = [
        np.sqrt(np.trace(np.array(link.covariance)[:2, :2]) / 4) / abs(link.step)
        for link in links
        if link.source is not LinkSource.ASSUMED and abs(link.step) > 0
    ]
    return float(np.clip(np.median(shares), DRIFT, MOST_DRIFT)) if shares else DRIFT


def step_over(before: Estimate, link: Link, shared_m2: float, settings: FlightSettings) -> Step:
    """Return the step to the next image over a link.

    Args:
        before: Estimate of the link's first image.
        shared_m2: Variance of the shared displacement along an axis, m².
    """
    x, y, heading, size, east, north, along, across = before.mean
    unit = np.exp((0.0 if link.in_meters else size) - 1j * heading)
    motion = unit * link.step * (1 + along - 1j * across)
    kept = float(np.exp(-abs(motion) / settings.map_length))
    mean = np.array(
        [x + motion.real, y + motion.imag, heading + link.turn, size + link.log_scale, east * kept, north * kept]
    )
    transition = np.eye(SIZE)
    aside = -1j * motion
    transition[:2, 2] = aside.real, aside.imag
    if not link.in_meters:
        transition[:2, 3] = motion.real, motion.imag
    transition[:2, 6] = motion.real, motion.imag
    transition[:2, 7] = aside.real, aside.imag
    transition[4, 4] = transition[5, 5] = kept
    noise = np.zeros((SIZE, SIZE))
    # Right and down in the image, rotated to the map.
    turn = np.eye(4)
    turn[:2, :2] = np.array([[unit.real, unit.imag], [unit.imag, -unit.real]])
    noise[:4, :4] = turn @ np.array(link.covariance) @ turn.T
    noise[4:6, 4:6] = shared_m2 * (1 - kept**2) * np.eye(2)
    covariance = transition @ before.covariance @ transition.T + noise
    return Step(transition, Estimate(np.array([*mean, along, across]), covariance))


def with_measurement(expected: Estimate, measured: Measurement, shared_m2: float) -> Estimate:
    """Return the estimate after a measurement; its variance includes that of the shared displacement."""
    noise = _own_noise(measured, shared_m2)
    gain = np.linalg.solve(_SEEN @ expected.covariance @ _SEEN.T + noise, _SEEN @ expected.covariance).T
    # Joseph's form keeps the covariance symmetric and positive.
    left = np.eye(SIZE) - gain @ _SEEN
    covariance = left @ expected.covariance @ left.T + gain @ noise @ gain.T
    return Estimate(expected.mean + gain @ _off(expected, measured), covariance)


def without_measurement(estimate: Estimate, measured: Measurement, shared_m2: float) -> Estimate:
    """Return the estimate of an image from all others: its own measurement is removed again."""
    seen = np.linalg.solve(_own_noise(measured, shared_m2), _SEEN)
    covariance = np.linalg.inv(np.linalg.inv(estimate.covariance) - _SEEN.T @ seen)
    covariance = (covariance + covariance.T) / 2
    return Estimate(estimate.mean - covariance @ seen.T @ _off(estimate, measured), covariance)


def soften(measured: Measurement, expected: Estimate) -> Measurement:
    """Return a measurement with a larger covariance the farther it is from the expected pose: label errors have tails.

    The weights are those of Student's t with ``TAILS`` degrees of freedom in iteratively reweighted least squares.
    """
    off = measured.state - expected.state
    off[2] = wrap_angle(off[2])
    square = float(off @ np.linalg.solve(measured.covariance + expected.pose_covariance, off))
    factor = (TAILS + square) / (TAILS + len(off))
    return replace(measured, covariance=factor * measured.covariance) if factor > 1 else measured


def _own_noise(measured: Measurement, shared_m2: float) -> np.ndarray:
    """Return (4, 4) covariance of a measurement without the part that its neighbors share."""
    noise = measured.covariance.copy()
    noise[:2, :2] -= min(shared_m2, 0.95 * float(np.linalg.eigvalsh(noise[:2, :2])[0])) * np.eye(2)
    return noise


def _off(expected: Estimate, measured: Measurement) -> np.ndarray:
    """Return (4,) difference of a measurement from the expected pose."""
    off = measured.state - _SEEN @ expected.mean
    off[2] = wrap_angle(off[2])
    return off


def smooth(filtered: list[Estimate], steps: list[Step]) -> list[Estimate]:
    """Return the estimates of all images with the information of later ones.

    Args:
        filtered: (n,) estimates from earlier images.
        steps: (n − 1,) from each image to the next.
    """
    found = [filtered[-1]]
    for before, step in zip(filtered[-2::-1], steps[::-1]):
        gain = np.linalg.solve(step.predicted.covariance, step.transition @ before.covariance).T
        off = found[-1].mean - step.predicted.mean
        off[2] = wrap_angle(off[2])
        covariance = before.covariance + gain @ (found[-1].covariance - step.predicted.covariance) @ gain.T
        found.append(Estimate(before.mean + gain @ off, (covariance + covariance.T) / 2))
    return found[::-1]
