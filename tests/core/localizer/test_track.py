"""Jumps: as few fixes as possible are flagged, so that the others can be reached in time."""

import numpy as np
import pytest

from semref.core.localizer.track import jumps


def flagged(times, xs, speed=10.0, errors=None, confidences=None) -> list:
    positions = np.column_stack([xs, np.zeros(len(xs))])
    errors = np.zeros(len(xs)) if errors is None else np.array(errors)
    confidences = np.ones(len(xs)) if confidences is None else np.array(confidences)
    return np.flatnonzero(jumps(np.array(times, float), positions, errors, confidences, speed)).tolist()


@pytest.mark.parametrize(
    ("times", "xs", "expected"),
    [
        ([], [], []),
        ([5], [0], []),
        ([0, 1, 2, 3], [0, 9, 18, 27], []),
        ([0, 1, 2, 3], [0, 9, 500, 27], [2]),
        ([0, 1, 2, 3, 4], [900, 9, 18, 27, 800], [0, 4]),
        ([0, 1, 2, 3, 4, 5], [0, 9, 500, 503, 36, 45], [2, 3]),
        ([0, 1, 2, 3, 4], [300, 500, 0, 5, 900], [0, 1, 4]),
    ],
    ids=["none", "one", "steady", "one jump", "first and last", "two beside each other", "most are wrong"],
)
def test_the_fewest_fixes_are_flagged(times, xs, expected):
    assert flagged(times, xs) == expected


def test_errors_of_both_fixes_are_allowed_for():
    assert flagged([0, 1, 2], [0, 16, 20], errors=[3, 3, 3]) == []
    assert flagged([0, 1, 2], [0, 17, 20], errors=[3, 3, 3]) == [1]


def test_fixes_of_the_same_moment_must_be_close():
    assert flagged([0, 0, 1], [0, 50, 5]) == [1]


def test_a_long_flight_with_many_wrong_fixes_keeps_the_right_ones():
    rng = np.random.default_rng(4)
    times = np.arange(1000.0)
    xs = 8 * times + rng.normal(0, 0.5, 1000)
    wrong = rng.random(1000) < 0.2
    xs[wrong] = rng.uniform(-1e6, 1e6, wrong.sum())
    assert flagged(times, xs, errors=np.full(1000, 2.0)) == np.flatnonzero(wrong).tolist()
