"""Poses of a track from its links and its measurements: a Kalman filter forth, Rauch, Tung and Striebel's back.

See docs/explanation/method.md#flights.

Of each image eight numbers are estimated: its pose (meters east and north, heading in
radians clockwise, ln pixel size); how far off map and labels are around it (east, north), which every measurement there
shares and which fades along the way, so that many measurements don't promise what none of them knows; and by what
share links are wrong all along the flight (along, across).
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
"""Deviation of a flight's constant errors of links: share of the distance along and, in radians, across."""

SIZE = 8
TAILS = 4.0
"""Degrees of freedom of measurements' errors: 1 in 100 is as far off as 1 in 40,000 would be without tails."""

MOST_DRIFT = 0.2
"""Of a flight's links, as ``FlightSettings.drift``, however far they are off."""

_SEEN = np.eye(4, SIZE)
_SEEN[:2, 4:6] = np.eye(2)
"""What is measured: the pose, its position with the displacement."""


@dataclass(frozen=True)
class Estimate:
    """Of one image.

    Attributes:
        mean: (8,) as the module says.
        covariance: (8, 8) of it.
    """

    mean: np.ndarray
    covariance: np.ndarray

    @property
    def state(self) -> np.ndarray:
        """(4,) the pose."""
        return self.mean[:4]

    @property
    def pose_covariance(self) -> np.ndarray:
        """(4, 4) of the pose."""
        return self.covariance[:4, :4]

    @property
    def pose(self) -> tuple[np.ndarray, np.ndarray]:
        """(4,) and (4, 4) of it."""
        return self.state, self.pose_covariance


@dataclass(frozen=True)
class Step:
    """From one image to the next.

    Attributes:
        transition: (8, 8) of small deviations.
        predicted: The next image's, before it is measured.
    """

    transition: np.ndarray
    predicted: Estimate


def first_estimate(state: np.ndarray, deviations: np.ndarray, shared_m2: float, drift: float) -> Estimate:
    """Of a track's first image.

    Args:
        state: (4,) about where it lies.
        deviations: (4,) of that.
        shared_m2: Variance of the displacement along an axis.
        drift: Deviation of what is wrong with links all along, as ``drift_of`` tells it.
    """
    variances = [*np.square(deviations), shared_m2, shared_m2, drift**2, drift**2]
    return Estimate(np.array([*state, 0.0, 0.0, 0.0, 0.0]), np.diag(variances))


def drift_of(links: Iterable[Link]) -> float:
    """Deviation of links' constant errors: half of the variance that they state may be the same all along.

    Args:
        links: Of the flight, as far as known; assumed ones tell nothing.
    """
    shares = [
        np.sqrt(np.trace(np.array(link.covariance)[:2, :2]) / 4) / abs(link.step)
        for link in links
        if link.source is not LinkSource.ASSUMED and abs(link.step) > 0
    ]
    return float(np.clip(np.median(shares), DRIFT, MOST_DRIFT)) if shares else DRIFT


def step_over(before: Estimate, link: Link, shared_m2: float, settings: FlightSettings) -> Step:
    """The next image as a link has it.

    Args:
        before: Of the link's first image.
        shared_m2: Variance of the displacement along an axis, map units².
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
    # Right and down of the image, on the map.
    turn = np.eye(4)
    turn[:2, :2] = np.array([[unit.real, unit.imag], [unit.imag, -unit.real]])
    noise[:4, :4] = turn @ np.array(link.covariance) @ turn.T
    noise[4:6, 4:6] = shared_m2 * (1 - kept**2) * np.eye(2)
    covariance = transition @ before.covariance @ transition.T + noise
    return Step(transition, Estimate(np.array([*mean, along, across]), covariance))


def with_measurement(expected: Estimate, measured: Measurement, shared_m2: float) -> Estimate:
    """The estimate after a measurement, of whose variance a part is the displacement's."""
    noise = _own_noise(measured, shared_m2)
    gain = np.linalg.solve(_SEEN @ expected.covariance @ _SEEN.T + noise, _SEEN @ expected.covariance).T
    # Joseph's form stays symmetric and positive.
    left = np.eye(SIZE) - gain @ _SEEN
    covariance = left @ expected.covariance @ left.T + gain @ noise @ gain.T
    return Estimate(expected.mean + gain @ _off(expected, measured), covariance)


def without_measurement(estimate: Estimate, measured: Measurement, shared_m2: float) -> Estimate:
    """What all others tell of an image: its estimate, with its own measurement taken out again."""
    seen = np.linalg.solve(_own_noise(measured, shared_m2), _SEEN)
    covariance = np.linalg.inv(np.linalg.inv(estimate.covariance) - _SEEN.T @ seen)
    covariance = (covariance + covariance.T) / 2
    return Estimate(estimate.mean - covariance @ seen.T @ _off(estimate, measured), covariance)


def soften(measured: Measurement, expected: Estimate) -> Measurement:
    """A measurement, the less exact the farther it is from what is expected: errors of labels have long tails.

    By Student's t with ``TAILS`` degrees of freedom, as in iteratively reweighted least squares.
    """
    off = measured.state - expected.state
    off[2] = wrap_angle(off[2])
    square = float(off @ np.linalg.solve(measured.covariance + expected.pose_covariance, off))
    factor = (TAILS + square) / (TAILS + len(off))
    return replace(measured, covariance=factor * measured.covariance) if factor > 1 else measured


def _own_noise(measured: Measurement, shared_m2: float) -> np.ndarray:
    """(4, 4) of a measurement without what it shares with its neighbors."""
    noise = measured.covariance.copy()
    noise[:2, :2] -= min(shared_m2, 0.95 * float(np.linalg.eigvalsh(noise[:2, :2])[0])) * np.eye(2)
    return noise


def _off(expected: Estimate, measured: Measurement) -> np.ndarray:
    """(4,) of a measurement from what is expected."""
    off = measured.state - _SEEN @ expected.mean
    off[2] = wrap_angle(off[2])
    return off


def smooth(filtered: list[Estimate], steps: list[Step]) -> list[Estimate]:
    """All images' estimates with what later ones tell.

    Args:
        filtered: (n,) with what was measured until then.
        steps: (n − 1,) from each to the next.
    """
    found = [filtered[-1]]
    for before, step in zip(filtered[-2::-1], steps[::-1]):
        gain = np.linalg.solve(step.predicted.covariance, step.transition @ before.covariance).T
        off = found[-1].mean - step.predicted.mean
        off[2] = wrap_angle(off[2])
        covariance = before.covariance + gain @ (found[-1].covariance - step.predicted.covariance) @ gain.T
        found.append(Estimate(before.mean + gain @ off, (covariance + covariance.T) / 2))
    return found[::-1]
