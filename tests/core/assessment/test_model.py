"""The model of success recovers known probabilities, also with few or equal trials."""

import numpy as np
import pytest

from semref.core.assessment.model import Chances, beta_quantiles, fit_success, local_sums


@pytest.mark.slow
def test_the_model_finds_the_probability_that_the_trials_were_drawn_with():
    rng = np.random.default_rng(5)
    places = rng.uniform(0, 1e5, (3000, 2))
    feature = rng.uniform(-2, 2, 3000)
    truth = 1 / (1 + np.exp(-2 * feature))
    model = fit_success(feature[:, None], places, rng.random(3000) < truth, 1000.0)
    chances = model.chances(places, feature[:, None])
    assert np.abs(chances.means - truth).mean() < 0.04
    low, high = chances.interval()
    assert ((low <= chances.means) & (chances.means <= high)).all()


def test_trials_nearby_correct_the_regression():
    rng = np.random.default_rng(6)
    places = rng.uniform(0, 1000, (800, 2))
    right = places[:, 0] < 500
    model = fit_success(np.zeros((800, 1)), places, right, 1000.0)
    chances = model.chances(np.array([[200.0, 500.0], [800.0, 500.0]]), np.zeros((2, 1)))
    assert chances.means[0] > 0.9 and chances.means[1] < 0.1


@pytest.mark.parametrize("outcome", [True, False])
def test_trials_that_all_went_one_way_are_never_certain(outcome):
    model = fit_success(np.ones((10, 2)), np.zeros((10, 2)), np.full(10, outcome), 100.0)
    means = model.chances(np.array([[1e6, 0.0]]), np.ones((1, 2))).means
    assert 0 < means[0] < 1 and (means[0] > 0.8) == outcome


def test_quantiles_of_known_distributions_are_met():
    low, high = beta_quantiles(np.array([1.0, 2.0]), np.array([1.0, 2.0]), (0.025, 0.975))
    assert low.tolist() == pytest.approx([0.025, 0.0943], abs=0.002)
    assert high.tolist() == pytest.approx([0.975, 0.9057], abs=0.002)


def test_either_of_two_chances_has_the_mean_of_both_failing():
    one, two = (Chances(np.array([p]), np.array([20.0])) for p in (0.6, 0.5))
    both = one.either(two)
    assert both.means[0] == pytest.approx(0.8)
    low, high = both.interval()
    assert low[0] < 0.8 < high[0]


def test_weights_of_trials_fall_with_distance():
    counts, sums = local_sums(np.zeros((1, 2)), np.array([[0.0, 0], [10.0, 0], [1e6, 0]]), 10.0, np.array([1.0, 0, 1]))
    assert counts[0] == pytest.approx(1 + np.exp(-0.5)) and sums[0] == pytest.approx(1.0)
