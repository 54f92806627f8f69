from dataclasses import replace

import numpy as np
import pytest

from semref.core.assessment.flights import link_between
from semref.core.flight.measurement import Measurement, shared_variance
from semref.core.flight.motion import Link, LinkSource, as_rows
from semref.core.flight.settings import FLIGHT
from semref.core.flight.smoothing import (
    DRIFT,
    Estimate,
    drift_of,
    first_estimate,
    smooth,
    soften,
    step_over,
    with_measurement,
    without_measurement,
)
from semref.core.geometry.pose import PoseCovariance
from semref.core.geometry.radius import CIRCLE_95
from semref.core.geometry.shared_errors import AREAS, CLASSES, MAP
from semref.core.simulation.views import View

STEP_M, SHARED_M2, OWN_M2 = 200.0, 4.0, 4.0
HEADING, SIZE = 0.005, 0.003


def a_link(number, rng=None):
    off = DRIFT * STEP_M
    known = as_rows(np.diag([off**2, off**2, HEADING**2, SIZE**2]))
    error = np.zeros(4) if rng is None else rng.normal(0, 1, 4) * (off, off, HEADING, SIZE)
    return Link(number, number + 1, (error[0], -STEP_M + error[1]), error[2], error[3], known)


def track(count, measured, rng, shared_m2=SHARED_M2):
    """Return estimates of a straight flight to the north; the images ``measured`` have measurements."""
    kept = np.exp(-STEP_M / FLIGHT.map_length)
    displacement = rng.normal(0, np.sqrt(SHARED_M2), 2)
    covariance = np.diag([SHARED_M2 + OWN_M2] * 2 + [0.01**2, 0.01**2])
    estimates, steps = [first_estimate(np.zeros(4), np.array([50, 50, 0.1, 0.1]), shared_m2, DRIFT)], []
    for number in range(count):
        if number:
            steps.append(step_over(estimates[-1], a_link(number - 1, rng), shared_m2, FLIGHT))
            estimates.append(steps[-1].predicted)
            displacement = kept * displacement + rng.normal(0, np.sqrt(SHARED_M2 * (1 - kept**2)), 2)
        if number in measured:
            state = np.array([0.0, number * STEP_M, 0.0, 0.0]) + rng.normal(0, 1, 4) * (2, 2, 0.01, 0.01)
            state[:2] += displacement
            estimates[-1] = with_measurement(estimates[-1], Measurement(state, covariance), shared_m2)
    return smooth(estimates, steps)


def deviation(estimate):
    return np.sqrt(np.diag(estimate.pose_covariance)[:2])


def test_places_predicted_by_motion_only_are_in_their_growing_ellipses():
    rng, drift, inside = np.random.default_rng(3), 0.03, []
    for _ in range(150):
        bias, course, views = complex(*rng.normal(0, drift, 2)), rng.uniform(0, 360), [View(0, 0, 0.0, 1.0, 640, 640)]
        for _ in range(10):
            course += rng.normal(0, 6)
            east, north = STEP_M * np.sin(np.radians(course)), STEP_M * np.cos(np.radians(course))
            views.append(replace(views[-1], x=views[-1].x + east, y=views[-1].y + north, heading_deg=course % 360))
        pairs = enumerate(zip(views, views[1:]))
        links = [link_between(number, pair, drift, bias, rng) for number, pair in pairs]
        deviations = np.array([2.0, 2.0, 0.005, 0.005])
        state = np.array([0, 0, np.radians(views[0].heading_deg), 0]) + rng.normal(0, deviations)
        estimate, radii = first_estimate(state, deviations, 0.0, drift_of(links)), []
        for link, view in zip(links, views[1:]):
            estimate = step_over(estimate, link, 0.0, FLIGHT).predicted
            off, known = estimate.mean[:2] - view.position, estimate.covariance[:2, :2]
            inside.append(off @ np.linalg.solve(known, off) <= -2 * np.log(0.05))
            radii.append(np.trace(known))
        assert radii == sorted(radii)
    assert 0.93 < np.mean(inside) < 0.99


def test_stated_deviations_are_those_of_the_errors():
    rng = np.random.default_rng(1)
    units = []
    for _ in range(150):
        for number, estimate in enumerate(track(12, {0, 1, 2, 7, 11}, rng)):
            units.append((estimate.state[:2] - (0.0, number * STEP_M)) / deviation(estimate))
    assert np.sqrt(np.mean(np.square(units))) == pytest.approx(1.0, abs=0.1)


def test_many_measurements_do_not_promise_what_they_share():
    rng = np.random.default_rng(3)
    middle = deviation(track(12, set(range(12)), rng)[6]).max()
    without = deviation(track(12, set(range(12)), rng, shared_m2=1e-9)[6]).max()
    assert middle > 1.2 * without
    assert middle > 0.5 * np.sqrt(SHARED_M2)


@pytest.mark.parametrize(("map_m", "shared_m2"), [(1.2, 1.2**2 + 0.5**2), (0.1, FLIGHT.shared_share * 2.0)])
def test_all_images_of_a_flight_share_the_errors_of_map_and_classes(map_m, shared_m2):
    parts = tuple((cause, CIRCLE_95 * one) for cause, one in ((AREAS, 0.6), (MAP, map_m), (CLASSES, 0.5)))
    known = PoseCovariance(((2.0, 0.0), (0.0, 2.0)), 0.1, 0.001, parts=parts)
    measured = Measurement.of(np.zeros(4), known, 0.25)
    assert shared_variance([measured] * 3, FLIGHT) == pytest.approx(shared_m2, rel=0.1)


def test_later_images_improve_earlier_ones():
    rng = np.random.default_rng(4)
    found = track(4, {2, 3}, rng)
    assert np.hypot(*found[0].state[:2]) < 4 * deviation(found[0]).max()
    assert deviation(found[0]).max() < 10


def track_of(count=6):
    """Return filtered and smoothed estimates of a straight track, its measurements, and their shared error."""
    link = Link(0, 1, (0.0, -100.0), 0.0, 0.0, as_rows(np.diag([9.0, 9.0, 1e-4, 1e-4])))
    measured = [Measurement(np.array([3.0, 100.0 * n, 0.01, 0.0]), np.diag([16, 25, 1e-3, 1e-3])) for n in range(count)]

    def estimated(kept):
        estimates, steps = [first_estimate(np.zeros(4), np.array([80.0, 80.0, 0.2, 0.1]), 4.0, 0.01)], []
        for n, one in enumerate(kept):
            if n:
                steps.append(step_over(estimates[-1], link, 4.0, FLIGHT))
                estimates.append(steps[-1].predicted)
            if one is not None:
                estimates[-1] = with_measurement(estimates[-1], one, 4.0)
        return smooth(estimates, steps)

    return estimated, measured


@pytest.mark.parametrize("left_out", [0, 3, 5])
def test_a_measurement_can_be_taken_out_of_the_track(left_out):
    estimated, measured = track_of()
    whole = estimated(measured)
    others = estimated([None if n == left_out else one for n, one in enumerate(measured)])
    alone = without_measurement(whole[left_out], measured[left_out], 4.0)
    # Each measurement bends the linearized motion slightly.
    assert alone.state == pytest.approx(others[left_out].state, abs=0.05)
    assert np.diag(alone.covariance) == pytest.approx(np.diag(others[left_out].covariance), rel=0.02)


def test_a_measurement_far_from_what_is_expected_pulls_less():
    expected = Estimate(np.zeros(8), np.eye(8))
    near = Measurement(np.array([1.0, 0.0, 0.0, 0.0]), np.eye(4))
    assert soften(near, expected) is near
    far = soften(replace(near, state=np.array([10.0, 0.0, 0.0, 0.0])), expected)
    assert far.covariance == pytest.approx(np.eye(4) * (4 + 50) / 8)


def test_links_that_state_more_may_be_wrong_all_along_by_more():
    def stated(share, source=LinkSource.PIXELS):
        return Link(0, 1, (0.0, -200.0), 0.0, 0.0, as_rows(np.diag([2 * (share * 200) ** 2] * 2 + [1e-4] * 2)), source)

    assert drift_of([stated(0.05)] * 3) == pytest.approx(0.05)
    assert drift_of([stated(0.001)]) == DRIFT == drift_of([])
    assert drift_of([stated(0.001), *[stated(0.4, LinkSource.ASSUMED)] * 5]) == DRIFT
