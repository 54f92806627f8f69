import numpy as np
import pytest

from semref.core.assessment.flights import FlownRoute, FlownRoutes
from semref.core.assessment.route import ShiftHint, best_shift, gaps, route_points, stretch
from semref.core.errors import DatabaseError, ParameterError
from semref.core.simulation.conditions import Conditions
from semref.core.simulation.noise import LabelNoise
from semref.core.steps import result_of

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


@pytest.mark.parametrize("spacing, said", [(0.0, "between points is 0"), (float("nan"), "is nan"), (1e-3, "or more")])
def test_an_impossible_spacing_is_refused(spacing, said):
    with pytest.raises(ParameterError, match=said):
        route_points([BENT], spacing)


def test_shifted_points_are_to_the_right_of_the_direction_of_flight():
    points = route_points([BENT], 50.0)
    assert points.shifted(np.array([1, 3]), 10.0).tolist() == [[50, -10], [110, 50]]
    assert points.shifted(np.array([1]), -10.0).tolist() == [[50, 10]]


@pytest.mark.parametrize(
    "good, expected",
    [("11111", []), ("10011", [(0, 150)]), ("01010", [(0, 50), (50, 150), (150, 155)]), ("00000", [(0, 155)])],
)
def test_a_gap_goes_from_the_last_good_point_to_the_next_one(good, expected):
    points = route_points([BENT], 50.0)
    found = gaps(points, np.array(list(good), float), 0.9)
    assert [(gap.start, gap.end) for gap in found] == expected


def test_gaps_never_run_from_one_line_into_the_next():
    points = route_points([BENT[:2], BENT[2:]], 50.0)
    found = gaps(points, np.zeros(len(points)), 0.5)
    found = [(gap.line, gap.start, gap.end, gap.points.tolist()) for gap in found]
    assert found == [(0, 0.0, 100.0, [0, 1, 2]), (1, 0.0, 55.0, [3, 4, 5])]


def test_the_shortest_of_equally_good_shifts_is_proposed_and_none_without_a_gain():
    successes = [np.full(3, value) for value in (0.9, 0.88, 0.3, 0.9)]
    hint = best_shift(np.full(3, 0.2), [-100.0, -50.0, 50.0, 100.0], successes)
    assert hint == ShiftHint(-50.0, pytest.approx(0.88), pytest.approx(0.2))
    assert best_shift(np.full(3, 0.8), [-50.0, 50.0], [np.full(3, 0.85), np.full(3, 0.1)]) is None


def test_the_stretches_of_a_lines_points_join_to_the_line_and_to_no_other():
    points = route_points([BENT[:2], np.array([(0.0, 9.0), (10.0, 9.0)])], 50.0)
    first = [stretch(points, n).tolist() for n in range(3)]
    assert first == [[[0, 0], [25, 0]], [[25, 0], [50, 0], [75, 0]], [[75, 0], [100, 0]]]
    assert [stretch(points, n).tolist() for n in (3, 4)] == [[[0, 9], [5, 9]], [[5, 9], [10, 9]]]


CLEAR = Conditions(LabelNoise(missed=0.1))
ALONG = np.array([(600110.0, 5199700.0), (600880.0, 5199700.0)])
"""Route from the landmarks of the west over the empty east."""


@pytest.fixture(scope="module")
def result(assessed_database, localizer):
    routes = FlownRoutes(assessed_database, localizer, CLEAR, 220.0, 0.02, 5)
    return result_of(routes.fly(route_points([ALONG], 70.0), 2))


@pytest.mark.slow
def test_over_landmarks_a_flight_soon_has_a_position_and_it_is_right(result):
    first = result.first(0, 1.0)
    assert first is not None and first <= 210
    known = np.isfinite(result.errors)
    assert (known == result.is_placed).all()
    west = known & (result.points.along < 400)
    assert np.median(result.errors[west]) < 5 and (result.errors[west] < 3 * result.radii[west]).all()


def test_over_nothing_the_radius_grows_until_the_position_is_given_up(result):
    east = result.points.along >= 490
    placed, radius = result.placed[east], result.radius[east]
    stated = radius[np.isfinite(radius)]
    assert len(stated) > 1 and stated[-1] > 1.5 * np.nanmin(result.radius)
    assert (np.diff(stated) > 0).all() or placed[-1] < 1


def test_many_flights_are_summarized():
    points = route_points([np.array([(0.0, 0.0), (0.0, 300.0)]), np.array([(0.0, 0.0), (0.0, 100.0)])], 100.0)
    placed = np.array([[0, 1, 1, 0, 0, 0], [0, 0, 1, 1, 0, 1]], bool)
    radii = np.where(placed, [[0, 5.0, 6.0, 0, 0, 0], [0, 0, 8.0, 9.0, 0, 7.0]], np.nan)
    lost = np.array([[0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 0, 0]], bool)
    route = FlownRoute(points, placed, radii, radii, lost)
    assert route.placed.tolist() == [0, 0.5, 1, 0.5, 0, 0.5]
    assert route.radius[[1, 2, 3, 5]].tolist() == [5.0, 7.0, 9.0, 7.0] and np.isnan(route.radius[[0, 4]]).all()
    assert route.lost.tolist() == [0, 0, 0, 0.5, 0, 0]
    assert (route.first(0, 0.5), route.first(0, 0.9)) == (100.0, 200.0)
    assert (route.first(1, 0.5), route.first(1, 0.9)) == (100.0, None)
    other = route_points([np.array([(0.0, 0.0), (0.0, 300.0)]), np.array([(0.0, 0.0), (0.0, 100.0)])], 40.0)
    assert route.at(other).tolist() == [0, 0, 1, 1, 2, 2, 2, 3, 3, 4, 4, 5, 5]


def test_impossible_flights_are_refused(assessed_database, localizer):
    from dataclasses import replace

    without = replace(assessed_database, overview=None)
    with pytest.raises(DatabaseError, match="no overview"):
        FlownRoutes(without, localizer, CLEAR, 200.0, 0.01, 1)
    routes = FlownRoutes(assessed_database, localizer, CLEAR, 200.0, 0.01, 1)
    with pytest.raises(ParameterError, match="at most 20000"):
        next(routes.fly(route_points([ALONG], 50.0), 20_001))
