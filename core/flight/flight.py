"""A whole flight: follow it image by image, extend each track back to its start, and smooth it.

See docs/explanation/method.md#flights.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

import numpy as np

from ..localization import LIKELY_RISK
from ..localizer.localizer import Localizer
from .evidence import prepare_image
from .measurement import GATE, Measurement, distance, measure_near, shared_variance
from .model import FlightImage, FlightPose
from .motion import Link, links_by_image
from .pool import Pool, move_states, predict, update
from .reported_pose import likely, report_pose
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
"""Rounds of smoothing. Each measures images again at the place that all others expect; the last only weights."""

AGREES = 1.5
"""An image measured within this many standard deviations of the place that all others expect is not measured again."""

FIRST_DEVIATIONS = (0.25, 0.2, 0.1)
"""Standard deviations of a track's first image before any measurement: share of its edge, radians, ln pixel size."""

LEAST_SHARED_M2 = 1e-4
"""Least variance of the shared displacement, m²: without a measurement, a covariance would be singular."""


def localize_flight(
    images: Sequence[FlightImage], links: Sequence[Link], localizer: Localizer, settings: FlightSettings = FLIGHT
) -> tuple[FlightPose, ...]:
    """Localize all images of a flight together.

    Args:
        images: In order of capture.
        links: Between consecutive images, in any order. A missing link is bridged by the motion before.
        localizer: Of a database with its overview.

    Raises:
        ParameterError: A link names an image that the flight does not have.
        DatabaseError: The database was read without its overview.
    """
    solver = FlightSolver(localizer, settings)
    for _ in solver.steps(images, links):
        pass
    return solver.poses


@dataclass
class _Track:
    """A track of the causal pass: its error probability at start and end; first, last and starting image."""

    number: int
    risk: float
    doubt: float
    first: int
    last: int
    found: int


class FlightSolver:
    """Localizes a flight step by step, so that a caller can show progress and cancel.

    Attributes:
        poses: One for each image, in order; empty until all steps are done.
        causal: Poses from each image and the ones before only, as far as the steps are done.
    """

    def __init__(self, localizer: Localizer, settings: FlightSettings = FLIGHT) -> None:
        self.localizer, self.settings = localizer, settings
        self.poses: tuple[FlightPose, ...] = ()
        self.causal: tuple[FlightPose, ...] = ()
        self._looked: list[Looked] = []
        self._doubts: dict[int, float] = {}

    def steps(self, images: Sequence[FlightImage], links: Sequence[Link]) -> Iterator[tuple[int, int]]:
        """Yield (images done, all images) after each image.

        Args:
            images: In order of capture.
            links: As in ``localize_flight``.

        Raises:
            ParameterError: A link names an image that the flight does not have.
            DatabaseError: The database was read without its overview.
        """
        known = links_by_image(links, len(images))
        tracker, poses, tracks = FlightTracker(self.localizer, self.settings), [], []
        self._looked = []
        for number, image in enumerate(images):
            poses.append(tracker.add(image, known.get(number)))
            self._looked.append(tracker.looked)
            if tracker.looked.is_new:
                tracks.append(_Track(tracker.track, tracker.risk, tracker.doubt, number, number, number))
            elif tracker.looked.estimate is not None:
                tracks[-1].last, tracks[-1].doubt = number, tracker.doubt
            self.causal = tuple(poses)
            yield number + 1, len(images)
        self._doubts, earliest = {track.number: track.doubt for track in tracks}, 0
        for track in tracks:
            self._carry_back(images, track, earliest)
            for _ in self._smooth_track(images, track, poses):
                yield len(images), len(images)
            earliest = track.last + 1
        if self.settings.allowed_risk < LIKELY_RISK:
            for _ in self._look_for_likely(images, known, poses):
                yield len(images), len(images)
        self.poses = tuple(poses)

    def _look_for_likely(
        self, images: Sequence[FlightImage], known: Mapping[int, Link], poses: list[FlightPose]
    ) -> Iterator[tuple[int, int]]:
        """Store likely positions in ``poses``: of images in a row that only a larger error probability places."""
        settings = replace(self.settings, allowed_risk=LIKELY_RISK)
        runs = groupby(range(len(images)), lambda n: poses[n].place is None)
        for numbers in [list(run) for is_open, run in runs if is_open]:
            links = [
                replace(known[n], first=n - 1 - numbers[0], second=n - numbers[0]) for n in numbers[1:] if n in known
            ]
            solver = FlightSolver(self.localizer, settings)
            yield from solver.steps([images[n] for n in numbers], links)
            for n, pose in zip(numbers, solver.poses):
                if pose.is_fix:
                    poses[n] = likely(pose, solver._doubts[pose.track], self.settings.allowed_risk) or poses[n]

    def _carry_back(self, images: Sequence[FlightImage], track: _Track, earliest: int) -> None:
        """Follow a track back from the image that started it, and measure the images on the way."""
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
            seen = prepare_image(images[number], pyramid, prior, settings)
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
        """Store the smoothed poses of a track in ``poses``; yields before each repeated measurement.

        Images are measured again at the place that all others expect unless they were measured there. This corrects
        images that got a wrong place from the ones before. Measurements that contradict the others are dropped.
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
        """Return the smoothed estimate of each image of a track, and the variance of the shared displacement in m²."""
        settings = self.settings
        shared_m2 = max(shared_variance([one for one in measured if one is not None], settings), LEAST_SHARED_M2)
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
    known = np.diag(pool.variances[0, [0, 0, 1, 2]])
    expected = Estimate(pool.states[0], known)
    gain = known @ np.linalg.inv(known + soften(measured, expected).covariance)
    off = measured.state - expected.state
    off[2] = wrap_angle(off[2])
    left = np.diag(known - gain @ known)
    return Pool((expected.state + gain @ off)[None], left[None, [0, 2, 3]], pool.evidence)
