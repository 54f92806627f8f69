"""Map coordinates become pixels and back exactly."""

import numpy as np
import pytest

from semref.core.geometry.frame import MapFrame

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
