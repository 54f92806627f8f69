"""Poses as rows of numbers, there and back."""

import numpy as np
import pytest

from semref.core.correlation.refine import ScoredPose
from semref.core.flight.states import as_poses, as_states, place_of, state_of, turns_of
from semref.core.geometry.pose import turn_of
from semref.core.localization import Place


def test_poses_become_states_and_poses_again():
    pose = ScoredPose(120.0, 340.0, 275.0, 1.5)
    states = as_states([pose])
    assert states[0] == pytest.approx((120.0, -340.0, np.radians(275.0), np.log(1.5)))
    (again,) = as_poses(states)
    assert (again.x, again.y, again.heading_deg, again.pixel_size_m) == pytest.approx((120.0, 340.0, 275.0, 1.5))
    assert turns_of(states)[0] == pytest.approx(turn_of(275.0, 1.5))
    assert as_states([]).shape == (0, 4)


def test_places_become_states_and_places_again():
    place = Place((500.0, 900.0), 359.0, 2.0)
    state = state_of(place, (100.0, 1000.0))
    assert state[:2] == pytest.approx((400.0, -100.0))
    again = place_of(state, (100.0, 1000.0))
    assert again.position == pytest.approx(place.position)
    assert again.oriented == pytest.approx(place.oriented)
