"""Hypotheses for the pose of the latest image of a flight."""

import numpy as np

from semref.core.flight.evidence import SeenImage
from semref.core.flight.pool import Pool, update
from semref.core.flight.settings import FLIGHT
from semref.core.localization import Prior


def test_a_hypothesis_near_the_images_own_place_gets_its_evidence_and_moves_there():
    own = np.array([100.0, 100.0, 0.10, np.log(3.0)])
    seen = SeenImage(None, 96.0, (0.0, 1.0), Prior(), own, own_odds=10.0)
    states = np.array([[115.0, 92.0, 0.05, np.log(3.1)], [400.0, 400.0, 0.05, np.log(3.1)]])
    pool = Pool(states, np.full((2, 3), (100.0, 0.01, 0.01)), np.zeros((2, FLIGHT.window)))
    found = update(pool, seen, None, 1.0, FLIGHT)
    assert found.evidence[0, -1] > 5 and found.evidence[1, -1] == 0
    assert (np.abs(found.states[0] - own) < (1.5, 1.5, 0.001, 0.001)).all()
    assert (found.variances[0] < pool.variances[0] / 5).all()
    np.testing.assert_array_equal(found.states[1], states[1])
    np.testing.assert_array_equal(found.variances[1], pool.variances[1])
