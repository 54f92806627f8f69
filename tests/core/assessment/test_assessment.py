from dataclasses import replace

import numpy as np
import pytest

from semref.core.assessment.assessment import REASONS, Assessment, to_correlate
from semref.core.assessment.cells import ground_cells
from semref.core.assessment.model import Chances, beta_quantiles, fit_success, local_sums
from semref.core.evaluation.summary import brier_score
from semref.core.simulation.conditions import Conditions
from semref.core.simulation.noise import USUAL

FOOTPRINT = 250.0


@pytest.fixture(scope="module")
def assessed(assessed_database, localizer):
    """Return cells, trials and estimates of the made map under the usual noise, and their assessment."""
    assessment = Assessment(assessed_database, localizer, FOOTPRINT, Conditions(USUAL), seed=1)
    cells = ground_cells(assessed_database, 100.0)
    trials = [assessment.run(query) for query in assessment.plan(cells.centers, cells.size, 100)]
    return cells, trials, assessment.estimate(cells.centers, trials, spread=cells.size), assessment


@pytest.mark.slow
def test_success_and_an_error_are_expected_where_landmarks_are_and_nowhere_else(assessed):
    cells, _, estimates, _ = assessed
    inside = (cells.columns <= 4) & (cells.columns >= 1) & (cells.rows >= 1) & (cells.rows <= 4)
    outside = cells.columns >= 8
    assert estimates.success[inside].min() > 0.9
    assert estimates.success[outside].max() < 0.1
    assert estimates.landmarks[inside].min() > 15 and estimates.landmarks[outside].max() == 0
    assert all(estimates.reasons[n] == "too_few_references" for n in np.flatnonzero(outside))
    assert np.isfinite(estimates.error[(cells.columns == 2) & (cells.rows == 2)]).all()
    assert np.isnan(estimates.error[cells.columns == 9]).all()
    assert np.nanmax(estimates.error) < 0.02 * FOOTPRINT


@pytest.mark.slow
def test_success_is_in_its_interval_trials_are_spread_evenly_and_predictions_come_true(assessed):
    cells, trials, estimates, assessment = assessed
    assert ((estimates.low <= estimates.success) & (estimates.success <= estimates.high)).all()
    assert set(estimates.trials.tolist()) <= {len(trials) // len(cells), len(trials) // len(cells) + 1}
    assert set(estimates.reasons) <= {*REASONS, ""}
    model = assessment.model
    assert brier_score(model.left_out, model.successes > 0) < 0.06


@pytest.mark.slow
def test_the_same_seed_gives_the_same_assessment_and_another_one_another(assessed_database, localizer, assessed):
    cells, trials, _, _ = assessed
    again, other = (Assessment(assessed_database, localizer, FOOTPRINT, Conditions(USUAL), seed) for seed in (1, 2))
    queries = again.plan(cells.centers, cells.size, 100)
    assert queries == [trial.query for trial in trials]
    positions = [again.run(query).result.position for query in queries[:10]]
    assert positions == [trial.result.position for trial in trials[:10]]
    assert other.plan(cells.centers, cells.size, 100) != queries


@pytest.mark.slow
def test_map_correlation_adds_where_landmarks_fail(assessed):
    cells, trials, alone, assessment = assessed
    chosen = to_correlate(assessment.seed, trials, 30)
    assert len(chosen) == 30 and not any(trials[n].is_fix for n in chosen)
    found = {n: replace(trials[n], is_right=True, error=1.0) for n in chosen}
    both = assessment.estimate(cells.centers, trials, found, cells.size)
    assert (both.success >= alone.success - 1e-9).all()
    assert both.success.min() > 0.7


@pytest.mark.slow
def test_a_square_with_landmarks_on_one_side_has_the_mean_of_its_parts(assessed):
    _, trials, _, assessment = assessed
    # The landmarks end in the middle of this square.
    place = np.array([[600600.0, 5199700.0]])
    square = assessment.estimate(place, trials, spread=300.0)
    parts = assessment.estimate(place + [[-100, 0], [0, 0], [100, 0]], trials)
    assert parts.success[0] > parts.success[2] + 0.15
    assert parts.success[2] < square.success[0] < parts.success[0]


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
