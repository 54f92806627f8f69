"""Flights along a route, simulated from a database only."""

import numpy as np
import pytest

from semref.core.assessment.flights import FlightPlan, FlownRoute, FlownRoutes
from semref.core.assessment.route import route_points
from semref.core.errors import DatabaseError, ParameterError
from semref.core.simulation.conditions import Conditions
from semref.core.simulation.noise import LabelNoise

CLEAR = Conditions(LabelNoise(missed=0.1))
ALONG = np.array([(600110.0, 5199700.0), (600880.0, 5199700.0)])
"""Route from the landmarks of the west over the empty east."""


def flown(database, localizer, plan, line=ALONG, spacing=70.0):
    routes = FlownRoutes(database, localizer, CLEAR, plan)
    steps = list(routes.steps(route_points([line], spacing)))
    assert steps[-1] == (plan.flights * len(routes.result.points),) * 2
    return routes.result


@pytest.fixture(scope="module")
def result(assessed_database, localizer):
    return flown(assessed_database, localizer, FlightPlan(2, 220.0, 0.02, 5))


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
    told = radius[np.isfinite(radius)]
    assert len(told) > 1 and told[-1] > 1.5 * np.nanmin(result.radius)
    assert (np.diff(told) > 0).all() or placed[-1] < 1


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
        FlownRoutes(without, localizer, CLEAR, FlightPlan(1, 200.0, 0.01, 1))
    routes = FlownRoutes(assessed_database, localizer, CLEAR, FlightPlan(20_001, 200.0, 0.01, 1))
    with pytest.raises(ParameterError, match="at most 20000"):
        next(routes.steps(route_points([ALONG], 50.0)))
