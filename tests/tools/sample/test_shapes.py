"""Curves, blobs and noise have the sizes and places they are asked for."""

import numpy as np
import pytest
from shapely.geometry import LineString, MultiPolygon, Point, box

from sample import shapes


def rng():
    return np.random.default_rng(3)


def test_a_rectangle_has_its_length_along_its_heading():
    upright = shapes.rectangle((10, 20), np.pi / 2, 6, 2)
    assert upright.bounds == pytest.approx((9, 17, 11, 23))


def test_points_turn_from_x_to_y():
    assert shapes.rotated(np.array([[1.0, 0.0]]), np.pi / 2)[0] == pytest.approx((0, 1))


@pytest.mark.parametrize("seed", range(5))
def test_a_blob_lies_around_its_center_in_about_its_radius(seed):
    blob = shapes.blob(np.random.default_rng(seed), (100, 50), 30, 0.1)
    assert blob.is_valid
    assert blob.contains(Point(100, 50))
    assert np.sqrt(blob.area / np.pi) == pytest.approx(30, rel=0.25)


def test_a_meander_goes_from_start_to_end_on_a_longer_way():
    line = shapes.meander(rng(), (0, 0), (4000, 500), 900, 1.1)
    assert line[0] == pytest.approx((0, 0)) and line[-1] == pytest.approx((4000, 500))
    assert LineString(line).length > 1.1 * np.hypot(4000, 500)


def test_smoothing_keeps_the_ends_of_a_line_and_cuts_its_corners():
    smooth = shapes.smoothed(np.array([[0.0, 0], [10, 0], [10, 10]]), 3)
    assert smooth[0].tolist() == [0, 0] and smooth[-1].tolist() == [10, 10]
    assert not (smooth == (10, 0)).all(axis=1).any()


def test_noise_has_mean_0_and_deviation_1():
    field = shapes.noise(rng(), (80, 120), 20, 3)
    assert (field.shape, field.dtype) == ((80, 120), np.float32)
    assert (field.mean(), field.std()) == pytest.approx((0, 1), abs=1e-3)


def test_polygons_are_found_in_any_geometry_without_the_small_ones():
    assert shapes.polygons_of(None) == []
    assert [p.area for p in shapes.polygons_of(MultiPolygon([box(0, 0, 4, 4), box(9, 9, 10, 10)]), 2.0)] == [16]


def test_a_mask_becomes_an_outline_with_its_hole():
    mask = np.zeros((60, 60), bool)
    mask[10:50, 10:50], mask[25:35, 25:35] = True, False
    (outline,) = shapes.mask_polygons(mask, 2.0, 100)
    assert len(outline.interiors) == 1
    assert outline.area == pytest.approx(4 * mask.sum(), rel=0.1)
