"""The smoother, against simulated tracks whose errors are known."""

import numpy as np
import pytest

from semref.core.flight.measurement import Measurement
from semref.core.flight.motion import Link, as_rows
from semref.core.flight.settings import FLIGHT
from semref.core.flight.smoothing import first_estimate, smoothed, step_over, with_measurement

STEP_M, SHARED_M2, OWN_M2, DRIFT = 200.0, 4.0, 4.0, 0.01
HEADING, SIZE = 0.005, 0.003


def a_link(number, rng=None):
    off = DRIFT * STEP_M
    known = as_rows(np.diag([off**2, off**2, HEADING**2, SIZE**2]))
    error = np.zeros(4) if rng is None else rng.normal(0, 1, 4) * (off, off, HEADING, SIZE)
    return Link(number, number + 1, (error[0], -STEP_M + error[1]), error[2], error[3], known)


def track(count, measured, rng, shared_m2=SHARED_M2):
    """Estimates of a straight flight to the north whose images ``measured`` were measured."""
    kept = np.exp(-STEP_M / FLIGHT.map_length)
    displacement = rng.normal(0, np.sqrt(SHARED_M2), 2)
    covariance = np.diag([SHARED_M2 + OWN_M2] * 2 + [0.01**2, 0.01**2])
    estimates, steps = [first_estimate(np.zeros(4), np.array([50, 50, 0.1, 0.1]), shared_m2, FLIGHT)], []
    for number in range(count):
        if number:
            steps.append(step_over(estimates[-1], a_link(number - 1, rng), shared_m2, FLIGHT))
            estimates.append(steps[-1].predicted)
            displacement = kept * displacement + rng.normal(0, np.sqrt(SHARED_M2 * (1 - kept**2)), 2)
        if number in measured:
            state = np.array([0.0, number * STEP_M, 0.0, 0.0]) + rng.normal(0, 1, 4) * (2, 2, 0.01, 0.01)
            state[:2] += displacement
            estimates[-1] = with_measurement(estimates[-1], Measurement(state, covariance), shared_m2)
    return smoothed(estimates, steps)


def deviation(estimate):
    return np.sqrt(np.diag(estimate.pose_covariance)[:2])


def test_stated_deviations_are_those_of_the_errors():
    rng = np.random.default_rng(1)
    units = []
    for _ in range(150):
        for number, estimate in enumerate(track(12, {0, 1, 2, 7, 11}, rng)):
            units.append((estimate.state[:2] - (0.0, number * STEP_M)) / deviation(estimate))
    assert np.sqrt(np.mean(np.square(units))) == pytest.approx(1.0, abs=0.1)


def test_between_fixes_the_deviation_grows_to_the_middle():
    found = track(11, {0, 10}, np.random.default_rng(2))
    sizes = [deviation(estimate).max() for estimate in found]
    assert sizes[5] > 1.2 * max(sizes[0], sizes[10])
    assert all(a < b for a, b in zip(sizes[:5], sizes[1:6]))


def test_many_measurements_do_not_promise_what_they_share():
    rng = np.random.default_rng(3)
    middle = deviation(track(12, set(range(12)), rng)[6]).max()
    without = deviation(track(12, set(range(12)), rng, shared_m2=1e-9)[6]).max()
    assert middle > 1.2 * without
    assert middle > 0.5 * np.sqrt(SHARED_M2)


def test_later_images_tell_of_earlier_ones():
    rng = np.random.default_rng(4)
    found = track(4, {2, 3}, rng)
    assert np.hypot(*found[0].state[:2]) < 4 * deviation(found[0]).max()
    assert deviation(found[0]).max() < 10


def test_motion_in_meters_needs_no_pixel_size():
    start = first_estimate(np.array([0, 0, np.pi / 2, 3.0]), np.array([1, 1, 0.0, 1.0]), 1.0, FLIGHT)
    step = step_over(start, Link.of_odometry(0, 1, 0.0, 100.0, 0.0, 1.0, 0.0), 1.0, FLIGHT)
    assert step.predicted.state[:2] == pytest.approx((100.0, 0.0))
    assert deviation(step.predicted).max() < 3
