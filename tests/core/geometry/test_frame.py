import numpy as np
import pytest

from semref.core.geometry.footprint import image_corners, is_parallelogram, on_ground
from semref.core.geometry.frame import MapFrame
from semref.core.geometry.radius import circle_radius, ellipse_of

FRAME = MapFrame.at((600000.0, 5200000.0), 0.5, (300, 400), "a metric CRS")


@pytest.mark.parametrize("points", [np.empty((0, 2)), np.array([3.0, 4.0]), np.arange(24.0).reshape(3, 4, 2)])
def test_pixels_come_back_from_the_map_in_whatever_shape_they_come(points):
    found = FRAME.to_pixels(FRAME.to_map(points))
    assert found.shape == points.shape
    np.testing.assert_array_equal(found, points)


def test_a_part_has_its_place_in_the_whole():
    part = FRAME.part(10, 20, (30, 40))
    assert part == MapFrame.at((600005.0, 5199990.0), 0.5, (30, 40), "a metric CRS")
    np.testing.assert_array_equal(part.to_map((1, 2)), FRAME.to_map((11, 22)))


@pytest.mark.parametrize(("factor", "shape"), [(1, (300, 400)), (4, (75, 100)), (7, (43, 58))])
def test_reduced_pixels_cover_the_whole_map(factor, shape):
    reduced = FRAME.reduced(factor)
    assert (reduced.shape_hw, reduced.pixel_size, reduced.origin) == (shape, 0.5 * factor, FRAME.origin)


def test_gdals_numbers_stay_as_they_were_read():
    numbers = (1.0, 0.1, 0.0, 2.0, 0.0, -0.1 * (1 + 1e-9))
    assert MapFrame("", numbers).geotransform == numbers


def test_an_image_that_looks_north_has_its_upper_left_corner_in_the_north_west():
    corners = image_corners((1000.0, 2000.0), 0.0, 0.5, 40, 20)
    np.testing.assert_allclose(corners, [(990, 2005), (1010, 2005), (1010, 1995), (990, 1995)])


@pytest.mark.parametrize("heading", [0, 33, 190])
def test_pixels_of_a_level_image_are_evenly_spaced_on_the_ground(heading):
    corners = image_corners((6e5, 5e6), heading, 0.25, 300, 200)
    assert is_parallelogram(corners)
    found = on_ground(np.array([(0, 0), (300, 200), (150, 100)]), corners, (200, 300))
    np.testing.assert_allclose(found, [corners[0], corners[2], (6e5, 5e6)], atol=1e-6)


def test_a_tilted_image_s_diagonals_still_cross_where_they_cross_on_the_ground():
    footprint = np.array([(0.0, 100.0), (120.0, 100.0), (80.0, 0.0), (30.0, 0.0)])
    assert not is_parallelogram(footprint)
    np.testing.assert_allclose(
        on_ground(np.array([(0, 0), (10, 0), (10, 10), (0, 10)]), footprint, (10, 10)), footprint
    )
    crossing = on_ground(np.array([(5, 5)]), footprint, (10, 10))[0]
    for one, other in ((0, 2), (1, 3)):
        along, to = footprint[other] - footprint[one], crossing - footprint[one]
        assert along[0] * to[1] - along[1] * to[0] == pytest.approx(0, abs=1e-9)


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
    assert found.semi_major == pytest.approx(2.4477 * 1.5, abs=1e-3)
    assert found.semi_minor == pytest.approx(2.4477 / 2, abs=1e-3)
