"""Assessments: expected success where it is known what must come out."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from semref.core.assessment.assessment import REASONS, Assessment
from semref.core.assessment.cells import ground_cells
from semref.core.assessment.images import AssessmentNoise, ImageSimulator, SimulatedFix
from semref.core.assessment.model import Chances, beta_quantiles, fit_success, local_sums
from semref.core.assessment.summary import brier_score, calibration, success_by_landmarks
from semref.core.database.build import BuildSettings, DatabaseBuilder
from semref.core.database.model import MapLandmarks
from semref.core.errors import DatabaseError, ParameterError
from semref.core.geometry.frame import MapFrame
from semref.core.labels.class_table import ClassTable, LandCoverClass
from semref.core.labels.sources import ArrayLabels
from semref.core.landmarks.landmarks import extract_landmarks
from semref.core.localizer.localizer import Localizer
from semref.core.simulation.views import View, cut_view

TABLE = ClassTable(
    (
        LandCoverClass(1, "building", "#ff0000", "reference"),
        LandCoverClass(2, "water", "#0000ff", "reference"),
        LandCoverClass(4, "field", "#00ff00"),
    )
)
FRAME = MapFrame('PROJCS["a metric CRS"]', (600000.0, 1.0, 0.0, 5200000.0, 0.0, -1.0))
HEIGHT, WIDTH, BUILT = 600, 1000, 600
"""Pixels of the map; landmarks lie in its first BUILT columns."""
FOOTPRINT = 250.0
CLEAN = AssessmentNoise(0.0, 0.0, 0.0, 0.0)


def made_map(count: int = 330, background: int = 4) -> np.ndarray:
    random = np.random.default_rng(7)
    labels = np.full((HEIGHT, WIDTH), background, np.uint8)
    for _ in range(40 * count):
        h, w = random.integers(6, 16, 2)
        row, column = random.integers(1, HEIGHT - h - 1), random.integers(1, BUILT - w - 1)
        around = labels[row - 1 : row + h + 1, column - 1 : column + w + 1]
        if count and (around == background).all():
            labels[row : row + h, column : column + w] = random.integers(1, 3)
            count -= 1
    return labels


MAP = made_map()


def built(labels: np.ndarray):
    builder = DatabaseBuilder(ArrayLabels(labels), FRAME, TABLE, BuildSettings(250.0, 125.0, 30.0), "1.2.3")
    for _ in builder.steps():
        pass
    return replace(builder.database, overview=builder.overview)


@pytest.fixture(scope="module")
def database():
    return built(MAP)


@pytest.fixture(scope="module")
def localizer(database):
    return Localizer(database)


@pytest.fixture(scope="module")
def assessed(database, localizer):
    """Cells, trials, fixes and estimates of the made map under the usual noise."""
    assessment = Assessment(database, localizer, FOOTPRINT, AssessmentNoise(), seed=1)
    cells = ground_cells(database, 100.0)
    trials = assessment.plan(cells.centers, cells.size, 100)
    fixes = [assessment.run(trial) for trial in trials]
    return cells, trials, fixes, assessment.estimate(cells.centers, trials, fixes, None, cells.size), assessment


# --- simulated images ---


@pytest.mark.parametrize("heading", [0.0, 30.0, 137.0])
def test_a_simulated_image_has_the_landmarks_that_an_image_of_the_map_shows(database, localizer, heading):
    simulator = ImageSimulator(localizer, database, FOOTPRINT, CLEAN)
    x, y = 600300.0, 5199700.0
    found, centers = simulator.whole_objects(x, y, heading)
    view = View(300.0, 300.0, heading, 1.0, 250, 250)
    seen = extract_landmarks(cut_view(ArrayLabels(MAP), view), (1, 2), 20.0)
    seen = seen.select(~seen.touches_edge)
    apart = np.hypot(*(centers[:, None] - seen.centers_xy[None]).transpose(2, 0, 1))
    # Which of those at the border are whole is told from their boxes, not from their pixels.
    inner, seen_inner = (np.abs(xy - 125).max(axis=1) < 110 for xy in (centers, seen.centers_xy))
    seen_inner &= seen.areas_px > 40
    # Neighbors a pixel apart flow together in some turned images.
    assert (apart[inner].min(axis=1) < 1.0).mean() > 0.85 and (apart[:, seen_inner].min(axis=0) < 1.0).mean() > 0.85
    assert inner.sum() > 15 and len(found) == len(centers)


def test_without_noise_an_image_is_found_where_it_is(database, localizer):
    simulator = ImageSimulator(localizer, database, FOOTPRINT, CLEAN)
    fix = simulator.constellation(600300.0, 5199700.0, 77.0, np.random.default_rng(1))
    assert fix.is_fix and fix.right and fix.error < 0.5 and fix.objects > 20


def test_where_there_are_no_landmarks_there_is_no_fix(database, localizer):
    fix = ImageSimulator(localizer, database, FOOTPRINT, CLEAN).constellation(
        600850.0, 5199700.0, 0.0, np.random.default_rng(1)
    )
    assert (fix.status, fix.objects, fix.right, fix.error) == ("too_few_references", 0, False, None)


def test_the_noise_is_what_is_asked_for(database, localizer):
    rng = np.random.default_rng(3)
    noise = AssessmentNoise(missed=0.5, invented=0.0, misnamed=0.0, ragged=0.0)
    simulator = ImageSimulator(localizer, database, FOOTPRINT, noise)
    counts = [simulator.objects(600300.0, 5199700.0, 0.0, rng) for _ in range(40)]
    # Some too small for the catalogue come on top, a third as many.
    share = np.mean([len(objects) / landmarks for objects, landmarks in counts])
    assert share == pytest.approx(0.5 + 0.35, abs=0.08)


@pytest.mark.parametrize("values", [{"missed": 1.2}, {"invented": -0.1}, {"ragged": -1.0}, {"ragged": float("nan")}])
def test_noise_that_cannot_be_is_refused_by_name(values):
    with pytest.raises(ParameterError, match=next(iter(values)).upper()):
        AssessmentNoise(**values)


@pytest.mark.parametrize("footprint", [0.0, -5.0, float("nan"), float("inf")])
def test_a_footprint_that_is_none_is_refused(database, localizer, footprint):
    with pytest.raises(ParameterError, match="FOOTPRINT"):
        ImageSimulator(localizer, database, footprint, CLEAN)


def test_a_database_without_landmarks_is_refused(database):
    references = MapLandmarks(np.empty((0, 2)), np.empty(0, np.uint8), np.empty(0), np.empty(0, bool))
    empty = replace(database, references=references)
    with pytest.raises(DatabaseError, match="no landmark"):
        ImageSimulator(Localizer(empty), empty, FOOTPRINT, CLEAN)


def test_a_footprint_beyond_the_scales_searched_is_known(database, localizer):
    assert ImageSimulator(localizer, database, FOOTPRINT, CLEAN).is_searched
    assert not ImageSimulator(localizer, database, 2.6 * FOOTPRINT, CLEAN).is_searched


# --- expectations ---


def test_success_is_expected_where_landmarks_are_and_nowhere_else(assessed):
    cells, _, _, estimates, _ = assessed
    inside = (cells.columns <= 4) & (cells.columns >= 1) & (cells.rows >= 1) & (cells.rows <= 4)
    outside = cells.columns >= 8
    assert estimates.success[inside].min() > 0.9
    assert estimates.success[outside].max() < 0.1
    assert estimates.objects[inside].min() > 15 and estimates.objects[outside].max() == 0
    assert all(estimates.reasons[n] == "too_few_references" for n in np.flatnonzero(outside))


def test_success_lies_in_its_interval_and_trials_are_spread_evenly(assessed):
    cells, trials, _, estimates, _ = assessed
    assert ((estimates.low <= estimates.success) & (estimates.success <= estimates.high)).all()
    assert set(estimates.trials.tolist()) <= {len(trials) // len(cells), len(trials) // len(cells) + 1}
    assert set(estimates.reasons) <= {*REASONS, ""}


def test_an_error_is_expected_only_where_there_are_fixes(assessed):
    cells, _, _, estimates, _ = assessed
    assert np.isfinite(estimates.error[(cells.columns == 2) & (cells.rows == 2)]).all()
    assert np.isnan(estimates.error[cells.columns == 9]).all()
    assert np.nanmax(estimates.error) < 0.02 * FOOTPRINT


def test_predictions_from_the_other_trials_come_true(assessed):
    model = assessed[4].model
    assert brier_score(model.left_out, model.successes > 0) < 0.06


def test_the_same_seed_gives_the_same_assessment_and_another_one_another(database, localizer, assessed):
    cells, trials, fixes, _, _ = assessed
    again = Assessment(database, localizer, FOOTPRINT, AssessmentNoise(), seed=1)
    assert again.plan(cells.centers, cells.size, 100) == trials
    assert [again.run(trial) for trial in trials[:10]] == fixes[:10]
    other = Assessment(database, localizer, FOOTPRINT, AssessmentNoise(), seed=2)
    assert other.plan(cells.centers, cells.size, 100) != trials


def test_map_correlation_adds_where_landmarks_fail(assessed):
    cells, trials, fixes, alone, assessment = assessed
    chosen = assessment.to_correlate(trials, fixes, 30)
    assert len(chosen) == 30 and not any(fixes[n].is_fix for n in chosen)
    found = {n: SimulatedFix("fix", 0, True, 1.0, "map correlation") for n in chosen}
    both = assessment.estimate(cells.centers, trials, fixes, found, cells.size)
    assert (both.success >= alone.success - 1e-9).all()
    assert both.success.min() > 0.7


def test_map_correlation_is_tried_on_the_overview():
    rng = np.random.default_rng(2)
    patches = np.kron(rng.choice([1, 2, 4], (15, 25)), np.ones((40, 40))).astype(np.uint8)
    database = built(patches)
    assessment = Assessment(database, Localizer(database), FOOTPRINT, CLEAN, seed=1, correlation=True)
    trials = assessment.plan(np.array([[600400.0, 5199700.0]]), 0.0, 1)
    fix = assessment.run_correlation(trials[0])
    assert fix.right and fix.method == "map correlation"


def test_a_square_with_landmarks_on_one_side_has_the_mean_of_its_parts(assessed):
    cells, trials, fixes, _, assessment = assessed
    # The landmarks end in the middle of this square.
    place = np.array([[600000.0 + BUILT, 5199700.0]])
    square = assessment.estimate(place, trials, fixes, None, 300.0)
    parts = assessment.estimate(place + [[-100, 0], [0, 0], [100, 0]], trials, fixes)
    assert parts.success[0] > parts.success[2] + 0.3
    assert parts.success[2] < square.success[0] < parts.success[0]


# --- ground ---


def test_the_squares_cover_the_map(database):
    cells = ground_cells(database, 100.0)
    assert len(cells) == 60
    assert cells.centers.min(axis=0).tolist() == [600050.0, 5199450.0]
    assert (cells.columns.max(), cells.rows.max()) == (9, 5)


def test_unlabeled_ground_counts_inside_the_map_but_not_around_it():
    labels = np.zeros((HEIGHT, WIDTH), np.uint8)
    labels[:, :600] = MAP[:, :600]
    labels[210:390, 210:390] = 0
    cells = ground_cells(built(labels), 60.0)
    places = set(zip(cells.columns.tolist(), cells.rows.tolist()))
    assert (4, 4) in places and (5, 5) in places
    assert max(column for column, _ in places) == 9


@pytest.mark.parametrize("size, said", [(0.0, "SPACING"), (float("nan"), "SPACING"), (0.5, "give 2.47 or more")])
def test_a_spacing_that_cannot_be_is_refused(database, size, said):
    with pytest.raises(ParameterError, match=said):
        ground_cells(database, size)


# --- the model ---


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


def test_trials_nearby_count_where_the_regression_knows_nothing():
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


# --- summaries ---


def test_calibration_puts_each_prediction_into_its_bin():
    found = calibration(np.array([0.05, 0.95, 1.0, np.nan]), np.array([False, True, True, True]))
    assert [(one.low, one.rate.successes, one.rate.trials) for one in found] == [(0.0, 0, 1), (0.9, 2, 2)]
    assert brier_score(np.array([np.nan]), np.array([True])) is None


def test_success_is_counted_by_landmarks_in_view():
    fixes = [SimulatedFix("no_match", 2), SimulatedFix("fix", 2, True, 1.0), SimulatedFix("fix", 90, True, 1.0)]
    found = [(one.low, one.rate.successes, one.rate.trials) for one in success_by_landmarks(fixes)]
    assert found == [(0.0, 1, 2), (80.0, 1, 1)]
