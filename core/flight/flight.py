"""A whole flight at once: the causal track, carried back to where it began, and smoothed.

Told in docs/explanation/method.md#flights.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..localizer.localizer import Localizer
from .evidence import prepare_image
from .links import links_by_image
from .measurement import GATE, Measurement, distance, measure_near, shared_variance
from .model import FlightImage, FlightPose
from .motion import Link
from .pool import Pool, move_states, predict, update
from .reported_pose import report_pose
from .settings import FLIGHT, FlightSettings
from .smoothing import (
    Estimate,
    Step,
    drift_of,
    first_estimate,
    smooth,
    soften,
    step_over,
    with_measurement,
    without_measurement,
)
from .states import wrap_angle
from .tracker import SIZE_RANGE, FlightTracker, Looked

ROUNDS = 3
"""In which images are looked at where all others expect them; the last one only weighs."""

AGREES = 1.5
"""An image that was measured within so many deviations of where all others expect it isn't looked at again."""

FIRST_DEVIATIONS = (0.25, 0.2, 0.1)
"""Of a track's first image before anything is measured: share of its edge, radians, ln pixel size."""


def localize_flight(
    images: Sequence[FlightImage], links: Sequence[Link], localizer: Localizer, settings: FlightSettings = FLIGHT
) -> tuple[FlightPose, ...]:
    """The joint answer for all images of a flight.

    Args:
        images: In order; each is asked for once or twice.
        links: Between consecutive images, in any order; where one is missing the motion before is assumed to go on.
        localizer: Of a database with its overview.

    Raises:
        ParameterError: A link is of images that the flight doesn't have.
        DatabaseError: The database was read without its overview.
    """
    solver = FlightSolver(localizer, settings)
    for _ in solver.steps(images, links):
        pass
    return solver.poses


@dataclass
class _Track:
    """A track as the causal pass had it: its number, risk, first and last image, and the image it was found at."""

    number: int
    risk: float
    first: int
    last: int
    found: int


class FlightSolver:
    """Localizes a flight step by step, so that whoever runs it can tell progress and stop.

    Attributes:
        poses: One for each image, in order; empty before the steps are done.
        causal: What was known image by image, from those before alone, so far.
    """

    def __init__(self, localizer: Localizer, settings: FlightSettings = FLIGHT) -> None:
        """Prepares.

        Args:
            localizer: Of a database with its overview.
        """
        self.localizer, self.settings = localizer, settings
        self.poses: tuple[FlightPose, ...] = ()
        self.causal: tuple[FlightPose, ...] = ()
        self._looked: list[Looked] = []

    def steps(self, images: Sequence[FlightImage], links: Sequence[Link]) -> Iterator[tuple[int, int]]:
        """(images done, images) after each image.

        Args:
            images: In order.
            links: As of ``localize_flight``.

        Raises:
            ParameterError: A link is of images that the flight doesn't have.
            DatabaseError: The database was read without its overview.
        """
        known = links_by_image(links, len(images))
        tracker, poses, tracks = FlightTracker(self.localizer, self.settings), [], []
        self._looked = []
        for number, image in enumerate(images):
            poses.append(tracker.add(image, known.get(number)))
            self._looked.append(tracker.looked)
            if tracker.looked.is_new:
                tracks.append(_Track(tracker.track, tracker.risk, number, number, number))
            elif tracker.looked.estimate is not None:
                tracks[-1].last = number
            self.causal = tuple(poses)
            yield number + 1, len(images)
        earliest = 0
        for track in tracks:
            self._carry_back(images, track, earliest)
            for _ in self._smooth_track(images, track, poses):
                yield len(images), len(images)
            earliest = track.last + 1
        self.poses = tuple(poses)

    def _carry_back(self, images: Sequence[FlightImage], track: _Track, earliest: int) -> None:
        """Follows a track from where it was found back to where it began, and measures the images there."""
        settings, pyramid = self.settings, self.localizer.pyramid
        estimate = self._looked[track.found].estimate
        if estimate is None:
            return
        variances = np.diag(estimate.covariance)
        pool = Pool(estimate.state[None], variances[None, [0, 2, 3]], np.zeros((1, settings.window)))
        for number in range(track.found - 1, earliest - 1, -1):
            link = self._looked[number + 1].link
            if link is None:
                break
            back = move_states(pool.states, link, back=True)
            pool = replace(predict(pool, link), states=back)
            size, ratio = float(np.exp(pool.states[0, 3])), SIZE_RANGE
            prior = replace(images[number].prior, pixel_size_range=(size / ratio, size * ratio))
            seen = prepare_image(images[number].labels_hw, pyramid, prior, images[number].own, settings)
            pool = update(pool, seen, pyramid, 1.0, settings)
            if pool.evidence[0, -settings.recent :].sum() < settings.lost_evidence:
                break
            spread = np.diag(pool.variances[0, [0, 0, 1, 2]])
            measured = measure_near(images[number], self.localizer, pool.states[0], spread, settings)
            if measured is not None:
                pool = _with_measurement(pool, measured)
            self._looked[number] = replace(
                self._looked[number], measured=measured, estimate=Estimate(pool.states[0], spread)
            )
            track.first = number

    def _smooth_track(self, images: Sequence[FlightImage], track: _Track, poses: list[FlightPose]) -> Iterator[None]:
        """Puts the poses of a track into ``poses``; one step an image that is measured once more.

        Images are looked at again where all others expect them, unless they were measured there: so one that was led
        astray by what came before it alone is set right. Measurements that the others contradict are left out.
        """
        settings, numbers = self.settings, range(track.first, track.last + 1)
        looked = [self._looked[number] for number in numbers]
        links = [one.link for one in looked[1:] if one.link is not None]
        drift = drift_of(links)
        first, kept = [one.measured for one in looked], [one.measured for one in looked]
        estimates, shared_m2 = self._estimate_track(looked, kept, images[track.first], drift)
        for look in range(ROUNDS):
            for n, number in enumerate(numbers):
                expected = estimates[n]
                used, measured = kept[n], first[n]
                if used is not None:
                    expected = without_measurement(expected, used, shared_m2)
                is_far = measured is None or distance(measured, *expected.pose) > AGREES
                if is_far and look + 1 < ROUNDS:
                    yield
                    measured = first[n] = measure_near(images[number], self.localizer, *expected.pose, settings)
                if measured is not None and distance(measured, *expected.pose) > GATE:
                    measured = None
                kept[n] = None if measured is None else soften(measured, expected)
            estimates, shared_m2 = self._estimate_track(looked, kept, images[track.first], drift)
        for number, estimate in zip(numbers, estimates):
            poses[number] = report_pose(images[number], self.localizer, estimate, track.risk, track.number)

    def _estimate_track(
        self, looked: list[Looked], measured: list[Measurement | None], image: FlightImage, drift: float
    ) -> tuple[list[Estimate], float]:
        """Of each image of a track, with what all of them tell; the displacement's variance."""
        settings = self.settings
        shared_m2 = shared_variance([one for one in measured if one is not None], settings)
        start = looked[0].estimate
        if start is None:
            return [], shared_m2
        share, heading, size = FIRST_DEVIATIONS
        position = share * float(np.sqrt(image.labels_hw.size) * np.exp(start.mean[3]))
        deviations = np.array([position, position, heading, size])
        estimates = [first_estimate(start.mean[:4], deviations, shared_m2, drift)]
        steps: list[Step] = []
        for number, one in enumerate(measured):
            link = looked[number].link
            if number and link is not None:
                steps.append(step_over(estimates[-1], link, shared_m2, settings))
                estimates.append(steps[-1].predicted)
            if one is not None:
                estimates[-1] = with_measurement(estimates[-1], one, shared_m2)
        return smooth(estimates, steps), shared_m2


def _with_measurement(pool: Pool, measured: Measurement) -> Pool:
    """One hypothesis with a measurement."""
    known = np.diag(pool.variances[0, [0, 0, 1, 2]])
    expected = Estimate(pool.states[0], known)
    gain = known @ np.linalg.inv(known + soften(measured, expected).covariance)
    off = measured.state - expected.state
    off[2] = wrap_angle(off[2])
    left = np.diag(known - gain @ known)
    return Pool((expected.state + gain @ off)[None], left[None, [0, 2, 3]], pool.evidence)
