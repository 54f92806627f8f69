"""Rates: confidence intervals of known cases, and values in bins."""

import math

import numpy as np
import pytest

from semref.core.evaluation.rates import Rate, binned, rate_of, wilson


@pytest.mark.parametrize(
    ("successes", "trials", "interval"),
    [(0, 10, (0.0, 0.2775)), (10, 10, (0.7225, 1.0)), (5, 10, (0.2366, 0.7634)), (299, 300, (0.9814, 0.9994))],
)
def test_intervals_are_those_of_wilson(successes, trials, interval):
    assert wilson(successes, trials) == pytest.approx(interval, abs=5e-4)
    assert Rate(successes, trials).interval == wilson(successes, trials)


def test_a_rate_counts_true():
    assert rate_of([True, False, np.True_]) == Rate(2, 3)


def test_every_value_is_in_its_bin_and_the_last_bin_includes_its_end():
    first, last = binned([0.0, 0.1, 0.9, 1.0], [True, False, True, True], (0.0, 0.25, 0.5, 1.0))
    assert (first.low, first.high, first.at, first.rate) == (0.0, 0.25, pytest.approx(0.05), Rate(1, 2))
    assert (last.low, last.high, last.at, last.rate) == (0.5, 1.0, pytest.approx(0.95), Rate(2, 2))


def test_a_last_bin_may_have_no_end():
    (only,) = binned([300], [False], (0, 80, math.inf))
    assert (only.low, only.high, only.rate) == (80, math.inf, Rate(0, 1))
