"""What stands on the ground of a photo: gables with a ridge, flat halls, round crowns."""

import numpy as np
import shapely

from sample.photo_objects import HALL_HEIGHT_M, crown_relief, make_roof


def roof_of(polygon, seed=1):
    x, y = np.meshgrid(np.arange(0.5, 40), np.arange(0.5, 40))
    return make_roof(np.random.default_rng(seed), polygon, x, y)


def test_a_house_is_highest_along_the_middle_of_its_longer_side():
    relief = roof_of(shapely.box(10, 15, 30, 25)).relief
    assert relief[19:21, 12:28].min() > relief[15:17, 12:28].max()
    np.testing.assert_allclose(relief[19], relief[20], atol=1e-5)


def test_a_hall_is_flat():
    roof = roof_of(shapely.box(5, 5, 30, 30))
    assert roof.eaves == HALL_HEIGHT_M and not roof.relief.any()


def test_crowns_are_round_hills_from_0_to_1():
    crowns = crown_relief(np.random.default_rng(2), (80, 80), 4.0)
    assert crowns.min() >= 0 and crowns.max() == 1
    assert 0.2 < (crowns > 0).mean() <= 1
