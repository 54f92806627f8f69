"""Footprints of images: corners and any pixel between them."""

from __future__ import annotations

import numpy as np
import pytest

from semref.core.geometry.footprint import image_corners, is_parallelogram, on_ground


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
