"""Places near an expected one, weighed."""

import numpy as np
import pytest

from semref.core.correlation.places import image_evidence
from semref.core.correlation.refine import ScoredPose
from semref.core.flight.measurement import Measurement, by_areas, factor_of, mixed
from semref.core.flight.model import FlightImage
from semref.core.flight.nearby import REACH, log_odds, places_near, starts_around
from semref.core.flight.settings import FLIGHT
from semref.core.flight.states import state_of
from semref.core.localization import Place

ORIGIN = (500_000.0, 5_200_000.0)


@pytest.fixture(scope="module")
def truth(flown):
    view = flown.views[3]
    return state_of(Place(view.position, view.heading_deg, view.pixel_size), ORIGIN)


def test_a_place_that_is_known_well_is_looked_at_alone():
    state = np.array([100.0, -200.0, 1.0, 0.5])
    assert np.array_equal(starts_around(state, np.diag([4.0, 4.0, 1e-4, 1e-4]), 640.0), state[None])


def test_starts_fill_what_is_expected_along_its_axes():
    state, edge = np.array([100.0, -200.0, 1.0, 0.5]), 320.0
    axis = np.array([np.cos(0.6), np.sin(0.6)])
    covariance = np.diag([25.0, 25.0, 1e-4, 1e-4])
    covariance[:2, :2] += 80.0**2 * np.outer(axis, axis)
    off = (starts_around(state, covariance, edge) - state)[:, :2]
    along, across = off @ axis, off @ np.array([-axis[1], axis[0]])
    assert np.abs(along).max() > (REACH - 0.5) * 80 and np.abs(across).max() < 2 * edge / 16
    places = np.sort(np.unique(along.round(6)))
    assert np.diff(places).max() < edge / 16 + 1e-6


def test_an_image_two_pixels_of_the_first_look_off_is_found_where_so_little_is_known(flown, localizer, truth):
    labels, off = flown.images[3].labels_hw, np.array([45.0, -40.0, 0.05, 0.0])
    loosely = np.diag([45.0**2, 45.0**2, 0.05**2, 0.03**2])
    image = image_evidence(labels, localizer.pyramid)
    likely = places_near(image, localizer.pyramid, truth + off, loosely, FLIGHT)
    best, share = likely[0]
    assert np.hypot(best.x - truth[0], -best.y - truth[1]) < 12 and share > 0.9
    assert sum(part for _, part in likely) == pytest.approx(1.0)
    found = by_areas(FlightImage("", labels), localizer, truth + off, loosely, FLIGHT)
    assert np.hypot(*(found.state - truth)[:2]) < 12


def test_agreement_and_nearness_are_weighed_together():
    state, known = np.zeros(4), np.diag([100.0, 100.0, 0.01, 0.01])
    near, far = ScoredPose(5.0, 0.0, 0.0, 1.0, 0.5), ScoredPose(30.0, 0.0, 0.0, 1.0, 0.5)
    better = ScoredPose(30.0, 0.0, 0.0, 1.0, 0.7)
    odds = log_odds([near, far, better], state, known, FLIGHT)
    assert odds[0] - odds[1] == pytest.approx((9.0 - 0.25) / 2)
    assert odds[2] > odds[0]


def test_two_places_as_likely_are_told_as_one_that_reaches_both():
    one = Measurement(np.array([0.0, 0.0, 3.1, 0.0]), np.eye(4) * 4.0)
    other = Measurement(np.array([30.0, 0.0, -3.1, 0.0]), np.eye(4) * 4.0)
    both = mixed([(one, 0.5), (other, 0.5)])
    assert both.state[0] == pytest.approx(15.0) and both.covariance[0, 0] == pytest.approx(4 + 15**2)
    assert abs(both.state[2]) == pytest.approx(np.pi, abs=1e-9) and both.covariance[1, 1] == pytest.approx(4.0)


def test_little_ground_is_known_less_exactly_than_its_fit_says():
    factor, enough_m, _ = FLIGHT.measured_factor
    assert factor_of(10 * enough_m, FLIGHT) == factor_of(enough_m, FLIGHT) == factor
    assert factor_of(enough_m / 2, FLIGHT) > 1.5 * factor
