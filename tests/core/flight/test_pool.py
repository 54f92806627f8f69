"""Hypotheses: carried along links, told apart, weighed by own places."""

import numpy as np
import pytest

from semref.core.flight.evidence import SeenImage
from semref.core.flight.motion import Link, as_rows
from semref.core.flight.pool import OWN_MOST, Pool, moved, own_worth, predicted, pruned, same_place
from semref.core.flight.settings import FLIGHT
from semref.core.localization import Prior

LINK = Link(0, 1, (20.0, -100.0), 0.2, 0.1, as_rows(np.diag([4.0, 4.0, 0.01, 0.0004])))


def pool_at(*places, totals=None):
    states = np.array([(x, y, heading, np.log(2.0)) for x, y, heading in places], np.float64)
    evidence = np.zeros((len(states), 3))
    evidence[:, -1] = np.arange(len(states), 0, -1) if totals is None else totals
    return Pool(states, np.tile((100.0, 0.01, 0.001), (len(states), 1)), evidence)


def test_states_move_along_a_link_and_back():
    states = pool_at((0, 0, 0.0), (50, 60, np.pi / 2)).states
    there = moved(states, LINK)
    assert there[0] == pytest.approx((40.0, 200.0, 0.2, np.log(2.0) + 0.1))
    assert there[1, :2] == pytest.approx((50 + 200.0, 60 - 40.0))
    assert moved(there, LINK, back=True) == pytest.approx(states)


def test_a_predicted_hypothesis_is_less_sure_and_has_room_for_evidence():
    before = pool_at((0, 0, 0.0))
    after = predicted(before, LINK)
    assert (after.variances > before.variances).all()
    assert after.evidence.tolist() == [[0.0, 1.0, 0.0]]
    in_meters = Link(0, 1, (40.0, -200.0), 0.2, 0.1, LINK.covariance, in_meters=True)
    assert predicted(before, in_meters).variances[0, 0] < after.variances[0, 0]


def test_of_hypotheses_at_one_place_the_best_is_kept():
    pool = pool_at((0, 0, 0.0), (10, 0, 0.1), (10, 0, 2.0), (500, 0, 0.0), totals=(1.0, 3.0, 2.0, 0.5))
    kept = pruned(pool, edge_m=640.0, count=10, apart=0.25)
    assert kept.totals.tolist() == [3.0, 2.0, 0.5]
    assert len(pruned(pool, edge_m=640.0, count=2, apart=0.25)) == 2
    assert len(pruned(Pool.empty(3), edge_m=640.0, count=2, apart=0.25)) == 0


def test_an_own_place_speaks_for_hypotheses_at_it_alone():
    pool = pool_at((0, 0, 0.0), (2000, 0, 0.0))
    seen = SeenImage(None, 320.0, (0.0, 1.0), Prior(), np.array([20.0, 0.0, 0.05, np.log(2.0)]), 30.0)
    offset, slope = FLIGHT.risk_curve
    most = (OWN_MOST - offset) / slope
    assert own_worth(pool.states, pool.variances, seen, FLIGHT).tolist() == [most, 0.0]
    unsure = SeenImage(None, 320.0, (0.0, 1.0), Prior(), seen.own_state, -1.0)
    assert own_worth(pool.states, pool.variances, unsure, FLIGHT).tolist() == [0.0, 0.0]


def test_the_same_place_has_the_same_heading():
    states = pool_at((0, 0, 0.0), (0, 0, np.pi), (0, 0, 2 * np.pi)).states
    assert same_place(states, states[0], 10.0).tolist() == [True, False, True]
