"""An image measured near where its flight expects it."""

import sys
from pathlib import Path

import numpy as np
import pytest

from semref.core.flight.measurement import Measurement, by_areas, by_landmarks, distance, of_own
from semref.core.flight.states import state_of
from semref.core.geometry.pose import PoseCovariance
from semref.core.localization import Localization, Method, Place, Status

sys.path.insert(0, str(Path(__file__).parent))
from conftest import FEW, FRAME

sys.path.pop(0)

EXPECTED = np.diag([100.0, 100.0, 0.002, 0.001])


@pytest.fixture(scope="module")
def truth(flown):
    view = flown.views[3]
    return state_of(Place(view.position, view.heading_deg, view.pixel_size), FRAME.origin)


def test_class_areas_measure_an_image_near_its_place(flown, localizer, truth):
    found = by_areas(flown.images[3], localizer, truth + (8, -6, 0.03, 0.01), EXPECTED, FEW)
    assert np.hypot(*(found.state - truth)[:2]) < 6
    assert 0.1 < np.sqrt(found.covariance[0, 0]) < 20


def test_far_from_its_place_an_image_measures_nothing(flown, localizer, truth):
    there = flown.images[3], localizer, truth + (500, 300, 1.0, 0.0), EXPECTED
    assert by_areas(*there, FEW) is by_landmarks(*there) is None


def test_an_own_fix_is_a_measurement_and_a_place_that_is_none_is_not(localizer):
    known = PoseCovariance(((4.0, 1.0), (1.0, 9.0)), 2.0, 0.03)
    best = Place((500_100.0, 5_199_900.0), 90.0, 3.0)
    fix = Localization(Status.FIX, Method.CONSTELLATION, best=best, covariance=known)
    found = of_own(fix, localizer.pyramid)
    assert found.is_own and found.state[:2] == pytest.approx((100.0, -100.0))
    assert np.sqrt(np.diag(found.covariance)) == pytest.approx((2.0, 3.0, np.radians(2.0), 0.01))
    assert of_own(Localization(Status.NO_MATCH, Method.CONSTELLATION, best=best), localizer.pyramid) is None
    assert of_own(None, localizer.pyramid) is None


def test_distances_are_in_deviations_of_both_and_know_the_circle():
    measured = Measurement(np.array([3.0, 0.0, 0.01, 0.0]), np.eye(4) * 0.5)
    same = distance(measured, np.array([0.0, 0.0, 0.01 + 2 * np.pi, 0.0]), np.eye(4) * 0.5)
    assert same == pytest.approx(3 / np.sqrt(2))
