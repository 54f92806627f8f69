"""A whole flight at once: the causal track, carried back to where it began, and smoothed.

Told in docs/method.md#flights.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..errors import ParameterError
from ..localizer.localizer import Localizer
from .evidence import seen_image
from .measurement import Measurement, distance
from .model import FlightImage, FlightPose, FlightResult
from .motion import Link
from .pool import Pool, moved, predicted, updated
from .settings import FLIGHT, FlightSettings
from .smoothing import Estimate, Step, first_estimate, smoothed, step_over, with_measurement
from .tracker import FlightTracker, Looked, measured_near, shared_variance, told_pose

ROUNDS = 3
"""In which measurements that the smoothed track contradicts are left out."""

FIRST_DEVIATIONS = (0.25, 0.2, 0.1)
"""Of a track's first image before anything is measured: share of its edge, radians, ln pixel size."""


def localize_flight(
    images: Sequence[FlightImage], links: Sequence[Link], localizer: Localizer, settings: FlightSettings = FLIGHT
) -> FlightResult:
    """The joint answer for all images of a flight.

    Args:
        images: In order; each is asked for once or twice.
        links: Between consecutive images, in any order; where one is missing the motion before is assumed to go on.
        localizer: Of a database with its overview.
        settings: Of flights.

    Raises:
        ParameterError: A link is of images that the flight doesn't have.
        DatabaseError: The database was read without its overview.
    """
    solver = FlightSolver(localizer, settings)
    for _ in solver.steps(images, links):
        pass
    return solver.result


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
        result: What came of it; of no image before the steps are done.
        causal: What was known image by image, from those before alone, so far.
    """

    def __init__(self, localizer: Localizer, settings: FlightSettings = FLIGHT) -> None:
        """Prepares.

        Args:
            localizer: Of a database with its overview.
            settings: Of flights.
        """
        self.localizer, self.settings = localizer, settings
        self.result = FlightResult(())
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
                risk = poses[-1].risk
                tracks.append(_Track(tracker.track, 1.0 if risk is None else risk, number, number, number))
            elif tracker.looked.estimate is not None:
                tracks[-1].last = number
            self.causal = tuple(poses)
            yield number + 1, len(images)
        earliest = 0
        for track in tracks:
            self._carry_back(images, track, earliest)
            for pose in self._smoothed(images, track):
                poses[pose.number] = pose
            earliest = track.last + 1
        self.result = FlightResult(tuple(poses))

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
            back = moved(pool.states, link, back=True)
            pool = replace(predicted(pool, link), states=back)
            size, ratio = float(np.exp(pool.states[0, 3])), settings.size_range
            prior = replace(images[number].prior, pixel_size_range=(size / ratio, size * ratio))
            seen = seen_image(images[number].labels_hw, pyramid, prior, images[number].own, settings)
            pool = updated(pool, seen, pyramid, 1.0, settings)
            if pool.evidence[0, -settings.recent :].sum() < settings.lost_evidence:
                break
            spread = np.diag(pool.variances[0, [0, 0, 1, 2]])
            measured = measured_near(images[number], self.localizer, pool.states[0], spread, settings)
            if measured is not None:
                pool = Pool(measured.state[None], np.diag(measured.covariance)[None, [0, 2, 3]], pool.evidence)
            self._looked[number] = replace(
                self._looked[number], measured=measured, estimate=Estimate(pool.states[0], spread)
            )
            track.first = number

    def _smoothed(self, images: Sequence[FlightImage], track: _Track) -> list[FlightPose]:
        """The poses of a track, without measurements that the rest contradicts."""
        numbers = range(track.first, track.last + 1)
        looked = [self._looked[number] for number in numbers]
        measured = [one.measured for one in looked]
        estimates: list[Estimate] = []
        for _ in range(ROUNDS):
            estimates = self._estimated(looked, measured, images[track.first])
            off = [
                one is not None and distance(one, estimate.state, estimate.pose_covariance) > self.settings.gate
                for one, estimate in zip(measured, estimates)
            ]
            if not any(off):
                break
            measured = [None if is_off else one for one, is_off in zip(measured, off)]
        return [
            told_pose(images[number], number, self.localizer, estimate, track.risk, track.number)
            for number, estimate in zip(numbers, estimates)
        ]

    def _estimated(
        self, looked: list[Looked], measured: list[Measurement | None], image: FlightImage
    ) -> list[Estimate]:
        """Of each image of a track, with what all of them tell."""
        settings = self.settings
        shared_m2 = shared_variance([one for one in measured if one is not None], settings)
        start = looked[0].estimate
        if start is None:
            return []
        share, heading, size = FIRST_DEVIATIONS
        position = share * float(np.sqrt(image.labels_hw.size) * np.exp(start.mean[3]))
        deviations = np.array([position, position, heading, size])
        estimates = [first_estimate(start.mean[:4], deviations, shared_m2, settings)]
        steps: list[Step] = []
        for number, one in enumerate(measured):
            link = looked[number].link
            if number and link is not None:
                steps.append(step_over(estimates[-1], link, shared_m2, settings))
                estimates.append(steps[-1].predicted)
            if one is not None:
                estimates[-1] = with_measurement(estimates[-1], one, shared_m2)
        return smoothed(estimates, steps)


def links_by_image(links: Sequence[Link], count: int) -> dict[int, Link]:
    """Links between consecutive images by the number of the second one.

    Args:
        links: Of the flight; those that leave out images are not used.
        count: Of images.

    Raises:
        ParameterError: A link is of images that the flight doesn't have.
    """
    for link in links:
        if link.second >= count:
            raise ParameterError("flight.link_of_no_image", second=link.second, count=count)
    return {link.second: link for link in links if link.second == link.first + 1}
