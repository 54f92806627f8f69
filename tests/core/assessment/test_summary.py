"""Summaries of assessments: predictions and landmarks fall into their bins."""

import numpy as np

from semref.core.assessment.summary import brier_score, calibration, success_by_landmarks
from semref.core.evaluation.trial import Query, Trial
from semref.core.localization import Localization, Method, Status
from semref.core.simulation.views import View


def trial(status, landmarks, is_right=False) -> Trial:
    result = Localization(Status(status), Method.CONSTELLATION, 9)
    return Trial(Query(View(0.0, 0.0)), Method.CONSTELLATION, result, is_right, landmarks=landmarks)


def test_without_trials_there_is_nothing_to_tell():
    assert success_by_landmarks([]) == calibration(np.array([]), np.array([])) == []
    assert brier_score(np.array([np.nan]), np.array([True])) is None


def test_calibration_puts_each_prediction_into_its_bin():
    found = calibration(np.array([0.05, 0.95, 1.0, np.nan]), np.array([False, True, True, True]))
    assert [(one.low, one.rate.successes, one.rate.trials) for one in found] == [(0.0, 0, 1), (0.9, 2, 2)]


def test_success_is_counted_by_landmarks_in_view():
    found = success_by_landmarks([trial("no_match", 2), trial("fix", 2, True), trial("fix", 90, True)])
    assert [(one.low, one.rate.successes, one.rate.trials) for one in found] == [(0.0, 1, 2), (80.0, 1, 1)]


def test_the_brier_score_is_the_mean_squared_miss():
    assert brier_score(np.array([1.0, 0.5, np.nan]), np.array([True, False, True])) == 0.125
