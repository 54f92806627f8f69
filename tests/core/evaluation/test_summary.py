import json
import math
from dataclasses import replace

import numpy as np
import pytest

from semref.core.evaluation.as_json import FIELDS, evaluation_json, values_of
from semref.core.evaluation.evaluation import MAP, MIRRORED, NOISE, NOISE_LEVELS, OFFSET, OFFSETS, SCALING, WindowQuery
from semref.core.evaluation.rates import Rate, binned, rate_of, wilson
from semref.core.evaluation.summary import (
    accuracy_summaries,
    brier_score,
    calibration,
    covered,
    error_curve,
    held_shares,
    noise_rates,
    percentile,
    reliability,
    success_by_landmarks,
    success_by_offset,
    summarize,
)
from semref.core.evaluation.trial import Trial, judge
from semref.core.localization import Localization, Method, Place, Status
from semref.core.simulation.noise import LabelNoise
from semref.core.simulation.views import View


def trial(right=True, error=1.0, confidence=0.9, status="fix", kind=MAP, ratio=None, landmarks=9, **query):
    result = Localization(Status(status), Method.CONSTELLATION, 9, best=Place((0.0, 0.0)), confidence=confidence)
    tried, error = WindowQuery(View(0.0, 0.0), kind, **query), error if status in ("fix", "likely") else None
    known = {"radius_ratio": ratio, "landmarks": landmarks, "is_likely_right": right and status == "likely"}
    return Trial(tried, Method.CONSTELLATION, result, right and status == "fix", error, **known)


def test_without_trials_nothing_is_known():
    summary = summarize([], Method.CONSTELLATION)
    assert (summary.right.share, summary.median_error, summary.false_accepts.share) == (None, None, None)
    assert success_by_offset([], Method.CONSTELLATION) == reliability([], Method.CONSTELLATION) == []
    assert [len(part) for part in error_curve([], Method.CONSTELLATION)] == [0, 0]
    assert percentile([None], 50) is None


def test_rates_and_errors_are_of_the_right_trials():
    mirrored = [trial(False, 5000, kind=MIRRORED), *[trial(status="no_match", kind=MIRRORED)] * 3]
    tried = [trial(error=e) for e in (1, 2, 30)] + [trial(False, 900), trial(status="ambiguous")]
    every = mirrored + tried + [trial(False, kind=SCALING)] * 9
    summary = summarize(every, Method.CONSTELLATION)
    assert (summary.right, summary.wrong, summary.false_accepts) == (Rate(3, 5), Rate(1, 5), Rate(1, 4))
    assert summary.median_error == 2 and summary.statuses == {"ambiguous": 1, "fix": 4}
    errors, shares = error_curve(every, Method.CONSTELLATION)
    assert errors.tolist() == [1, 2, 30, 900] and shares.tolist() == [0.2, 0.4, 0.6, 0.8]


def test_likely_positions_change_no_rate_or_error_of_fixes():
    fixes = [trial(error=e) for e in (1, 2, 30)] + [trial(False, 900)]
    likely = [trial(error=7, status="likely", ratio=3.0), trial(False, 5000, status="likely", ratio=9.0)]
    refused = [trial(status="no_match")] * 2
    mirrored = [trial(False, 5000, status="likely", kind=MIRRORED)]
    found, expected = (summarize(fixes + others, Method.CONSTELLATION) for others in (likely, refused))
    assert (found.likely, expected.likely) == (Rate(1, 2), Rate(0, 0))
    assert (found.right, found.wrong, found.covered) == (expected.right, expected.wrong, expected.covered)
    assert (found.median_error, found.error_95) == (expected.median_error, expected.error_95)
    assert summarize(mirrored, Method.CONSTELLATION).false_accepts == Rate(0, 1)
    every = fixes + likely + mirrored
    assert error_curve(every, Method.CONSTELLATION)[0].tolist() == [1, 2, 30, 900]
    assert accuracy_summaries(every) == accuracy_summaries(fixes)
    assert sum(one.rate.trials for one in reliability(every, Method.CONSTELLATION)) == 4


def test_coverage_counts_only_trials_with_a_radius():
    assert covered([trial(ratio=0.3), trial(ratio=1.0), trial(ratio=1.2), trial()]) == Rate(2, 3)


def test_success_is_counted_for_each_offset():
    moved = [trial(offset < 0.04, kind=OFFSET, offset=offset) for offset in OFFSETS for _ in range(2)]
    found = success_by_offset(moved, Method.CONSTELLATION)
    assert [one.at for one in found] == pytest.approx(OFFSETS)
    assert [one.rate for one in found] == [Rate(2, 2), *[Rate(0, 2)] * 6]


def test_success_is_counted_for_each_bin_of_landmarks():
    first, last = success_by_landmarks([trial(landmarks=4), trial(False, landmarks=300)])
    assert (first.low, first.high, last.low, last.high) == (0, 5, 80, np.inf)


def test_reliability_counts_fixes_and_mirrored_ones_as_wrong():
    tried = [trial(confidence=1.0)] * 3 + [trial(False, confidence=0.95, kind=MIRRORED)]
    (only,) = reliability([*tried, trial(status="no_match", confidence=0.93)], Method.CONSTELLATION)
    assert only.rate == Rate(3, 4) and only.at == pytest.approx((3 + 0.95) / 4)


def test_calibration_puts_each_prediction_into_its_bin():
    found = calibration(np.array([0.05, 0.95, 1.0, np.nan]), np.array([False, True, True, True]))
    assert [(one.low, one.rate) for one in found] == [(0.0, Rate(0, 1)), (0.9, Rate(2, 2))]
    assert calibration(np.array([]), np.array([])) == []


def test_the_brier_score_is_the_mean_squared_miss():
    assert brier_score(np.array([1.0, 0.5, np.nan]), np.array([True, False, True])) == 0.125
    assert brier_score(np.array([np.nan]), np.array([True])) is None


def test_the_grid_of_noise_has_missed_in_rows_and_spurious_in_columns():
    levels = [level / 100 for level in NOISE_LEVELS]
    noises = [LabelNoise(missed, spurious) for missed in levels for spurious in levels for _ in range(2)]
    rates = noise_rates([trial(n == LabelNoise(0.4, 0.2), kind=NOISE, noise=n) for n in noises])
    assert rates[2][1] == Rate(2, 2) and rates[1][2] == Rate(0, 2)
    assert sum(rate.trials for row in rates for rate in row) == 32


def test_shares_of_errors_are_counted_in_the_ellipses_of_50_95_and_99_percent():
    # Divided by the 95 % ellipse, the 50 % radius is 0.481 and the 99 % radius is 1.240.
    tried = [trial(ratio=ratio) for ratio in (0.4, 0.9, 1.2, 1.3)]
    assert [rate.successes for rate in held_shares(tried)] == [1, 2, 3]


def test_methods_of_automatic_are_counted_by_the_method_of_the_fix():
    stars = [trial(right=n > 0, confidence=0.95, ratio=0.3 * n) for n in range(4)]
    areas = [
        replace(one, result=replace(one.result, method=Method.MAP_CORRELATION, confidence=0.6))
        for one in (trial(ratio=2.0), trial(right=False))
    ]
    first, second = accuracy_summaries([*areas, *stars, trial(status="no_match")])
    assert (first.method, second.method) == (Method.CONSTELLATION, Method.MAP_CORRELATION)
    assert first.right == Rate(3, 4) and first.confidence == pytest.approx(0.95)
    assert first.calibration_error == pytest.approx(0.2) and second.calibration_error == pytest.approx(0.1)
    assert [rate.successes for rate in first.contained] == [1, 3, 3] and second.contained[1] == Rate(0, 1)


FOUND = Localization(Status.FIX, Method.CONSTELLATION, 9, best=Place((103.0, 204.0), 30.0, 1.0), confidence=0.999)


def trials():
    made = []
    for number in range(4):
        query = WindowQuery(View(100.0, 200.0, 30.0, is_mirrored=number == 3), MAP if number < 3 else MIRRORED, number)
        result = FOUND if number == 0 else Localization(Status.NO_MATCH, Method.CONSTELLATION)
        made.append(judge(query, Method.CONSTELLATION, result))
    return made


def test_a_trial_has_every_column_and_how_far_off_it_is():
    values = values_of(trials()[0])
    assert list(values) == [name for name, _ in FIELDS]
    assert (values["error"], values["right"], values["true_x"], values["x"]) == (5.0, 1, 100.0, 103.0)


def test_the_text_has_settings_rates_and_trials():
    report = json.loads(evaluation_json(trials(), [Method.CONSTELLATION], {"SEED": 3}, Rate(7, 9)))
    assert report["settings"] == {"SEED": 3} and list(report["methods"]) == ["constellation"]
    assert report["windows"] == {"tried": 7, "all": 9}
    right = report["methods"]["constellation"]["right"]
    assert 0 < right["low"] < right["share"] == 1 / 3 < right["high"] < 1
    assert [trial["kind"] for trial in report["trials"]] == [MAP] * 3 + [MIRRORED]


@pytest.mark.parametrize(
    ("successes", "trials", "interval"),
    [(0, 10, (0.0, 0.2775)), (10, 10, (0.7225, 1.0)), (5, 10, (0.2366, 0.7634)), (299, 300, (0.9814, 0.9994))],
)
def test_intervals_are_those_of_wilson(successes, trials, interval):
    assert wilson(successes, trials) == pytest.approx(interval, abs=5e-4)
    assert Rate(successes, trials).interval == wilson(successes, trials)


def test_a_rate_counts_true():
    assert rate_of([True, False, np.True_]) == Rate(2, 3)


def test_every_value_is_in_its_bin_and_the_last_bin_includes_its_end_or_has_none():
    first, last = binned([0.0, 0.1, 0.9, 1.0], [True, False, True, True], (0.0, 0.25, 0.5, 1.0))
    assert (first.low, first.high, first.at, first.rate) == (0.0, 0.25, pytest.approx(0.05), Rate(1, 2))
    assert (last.low, last.high, last.at, last.rate) == (0.5, 1.0, pytest.approx(0.95), Rate(2, 2))
    (only,) = binned([300], [False], (0, 80, math.inf))
    assert (only.low, only.high, only.rate) == (80, math.inf, Rate(0, 1))
