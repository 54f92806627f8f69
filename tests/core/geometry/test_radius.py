"""Circles and ellipses contain the stated share of errors."""

import numpy as np
import pytest

from semref.core.geometry.radius import circle_radius, ellipse_of


@pytest.mark.parametrize("deviations", [(1.0, 1.0), (3.0, 1.0), (5.0, 0.1)])
@pytest.mark.parametrize("held", [0.5, 0.95, 0.99])
def test_a_circle_contains_its_share_of_the_errors(deviations, held):
    rng = np.random.default_rng(4)
    turn = np.array([[0.8, -0.6], [0.6, 0.8]])
    errors = rng.normal(size=(200_000, 2)) * deviations @ turn.T
    covariance = turn @ np.diag(np.square(deviations)) @ turn.T
    assert (np.hypot(*errors.T) <= circle_radius(covariance, held)).mean() == pytest.approx(held, abs=0.003)


def test_a_circle_is_that_of_equal_axes_or_of_a_line():
    assert circle_radius(np.eye(2)) == pytest.approx(2.4477, abs=1e-3)
    assert circle_radius(np.diag([4.0, 0.0])) == pytest.approx(2 * 1.96, abs=0.01)
    assert circle_radius(np.zeros((2, 2))) == 0.0
    assert circle_radius(np.full((2, 2), np.inf)) == np.inf


def test_the_ellipse_points_along_the_larger_error():
    found = ellipse_of(np.array([[1.0, 1.0], [1.0, 1.0]]) + 0.25 * np.eye(2))
    assert found.orientation_deg == pytest.approx(45.0)
    assert found.semi_major == pytest.approx(2.4477 * 1.5, abs=1e-3) and found.semi_minor == pytest.approx(
        2.4477 / 2, abs=1e-3
    )
