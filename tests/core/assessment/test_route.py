"""Routes: points along lines, gaps in the expected positions, and proposed shifts."""

from __future__ import annotations

import numpy as np
import pytest

from semref.core.assessment.route import ShiftHint, best_shift, gaps, route_points, stretch
from semref.core.errors import ParameterError

BENT = np.array([(0.0, 0.0), (100.0, 0.0), (100.0, 0.0), (100.0, 55.0)])


def test_points_are_at_even_distances_and_at_both_ends():
    points = route_points([BENT], 50.0)
    assert points.along.tolist() == [0, 50, 100, 150, 155]
    assert points.places.tolist() == [[0, 0], [50, 0], [100, 0], [100, 50], [100, 55]]
    assert points.headings_deg.tolist() == [90, 90, 0, 0, 0]
    assert points.lengths == (155.0,)


@pytest.mark.parametrize("lines", [[], [np.zeros((1, 2))], [np.zeros((3, 2))]])
def test_a_route_without_length_is_refused(lines):
    with pytest.raises(ParameterError, match="no line with a length"):
        route_points(lines, 10.0)


@pytest.mark.parametrize(
    "spacing, said",
    [(0.0, "between points is 0"), (float("nan"), "is nan"), (1e-3, "or more")],
)
def test_an_impossible_spacing_is_refused(spacing, said):
    with pytest.raises(ParameterError, match=said):
        route_points([BENT], spacing)


def test_shifted_points_are_to_the_right_of_the_direction_of_flight():
    points = route_points([BENT], 50.0)
    assert points.shifted(np.array([1, 3]), 10.0).tolist() == [[50, -10], [110, 50]]
    assert points.shifted(np.array([1]), -10.0).tolist() == [[50, 10]]


@pytest.mark.parametrize(
    "good, expected",
    [
        ([1, 1, 1, 1, 1], []),
        ([1, 0, 0, 1, 1], [(0, 150)]),
        ([0, 1, 0, 1, 0], [(0, 50), (50, 150), (150, 155)]),
        ([0, 0, 0, 0, 0], [(0, 155)]),
    ],
)
def test_a_gap_goes_from_the_last_good_point_to_the_next_one(good, expected):
    points = route_points([BENT], 50.0)
    found = gaps(points, np.array(good, float), 0.9)
    assert [(gap.start, gap.end) for gap in found] == expected


def test_gaps_never_run_from_one_line_into_the_next():
    points = route_points([BENT[:2], BENT[2:]], 50.0)
    found = gaps(points, np.zeros(len(points)), 0.5)
    assert [(gap.line, gap.start, gap.end, gap.points.tolist()) for gap in found] == [
        (0, 0.0, 100.0, [0, 1, 2]),
        (1, 0.0, 55.0, [3, 4, 5]),
    ]


def test_the_shortest_of_equally_good_shifts_is_proposed():
    successes = [np.full(3, value) for value in (0.9, 0.88, 0.3, 0.9)]
    hint = best_shift(np.full(3, 0.2), [-100.0, -50.0, 50.0, 100.0], successes)
    assert hint == ShiftHint(-50.0, pytest.approx(0.88), pytest.approx(0.2))


def test_no_shift_is_proposed_without_a_gain():
    assert best_shift(np.full(3, 0.8), [-50.0, 50.0], [np.full(3, 0.85), np.full(3, 0.1)]) is None


def test_the_stretches_of_a_lines_points_join_to_the_line_and_to_no_other():
    points = route_points([BENT[:2], np.array([(0.0, 9.0), (10.0, 9.0)])], 50.0)
    first = [stretch(points, n).tolist() for n in range(3)]
    assert first == [[[0, 0], [25, 0]], [[25, 0], [50, 0], [75, 0]], [[75, 0], [100, 0]]]
    assert [stretch(points, n).tolist() for n in (3, 4)] == [[[0, 9], [5, 9]], [[5, 9], [10, 9]]]
