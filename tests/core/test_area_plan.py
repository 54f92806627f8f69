from dataclasses import replace

import numpy as np
import pytest

from semref.core.area_plan import MeasuredLandmarks, plan_area, training_resolution_cm


@pytest.fixture
def village():
    """Return 400 houses of 6 × 10 m on 800 × 800 m, every 40 m."""
    axis = np.arange(20.0, 800, 40)
    centers = np.array([(x, y) for x in axis for y in axis])
    return MeasuredLandmarks(np.full(400, 60.0), np.full(400, 6.0), centers, (0.0, 0.0, 800.0, 800.0))


def test_window_and_stride_follow_from_the_shorter_side_of_a_photo(village):
    plan = plan_area(village, (207.0, 156.0))
    assert (plan.window_m, plan.stride_m) == (150, 37.5)


def test_the_smallest_landmarks_set_minimum_area_and_pixels_which_are_larger_on_large_maps(village):
    plan = plan_area(village, (200.0, 150.0))
    assert (plan.minimum_area_m2, plan.pixel_size_m) == (30, 0.5)
    # A landmark of the minimum area has 50 pixels or more.
    sheds = replace(village, areas_m2=np.where(np.arange(400) < 40, 8.0, 60.0))
    plan = plan_area(sheds, (200.0, 150.0))
    assert (plan.minimum_area_m2, plan.pixel_size_m) == (4, 0.25)
    assert plan.minimum_area_m2 / plan.pixel_size_m**2 >= 50
    country = replace(village, extent=(0.0, 0.0, 100_000.0, 100_000.0))
    assert plan_area(country, (200.0, 150.0)).pixel_size_m == 2.0


def test_landmarks_in_a_photo_are_those_around_a_landmark(village):
    assert plan_area(village, (160.0, 160.0)).per_photo == 16
    assert plan_area(replace(village, extent=(0.0, 0.0, 8000.0, 8000.0)), (160.0, 160.0)).per_photo == 16
    plan = plan_area(replace(village, areas_m2=np.full(400, 2.0)), (160.0, 160.0))
    assert (plan.landmarks, plan.per_photo) == (0, 0)


def test_the_size_of_the_database_is_estimated_and_a_window_is_not_larger_than_the_map(village):
    assert 0.2 < plan_area(village, (160.0, 160.0)).megabytes < 0.4
    assert plan_area(village, (5000.0, 4000.0)).window_m == 800


@pytest.mark.parametrize(("pixel_m", "resolution"), [(0.1, 40), (0.35, None), (None, None)])
def test_training_uses_coarser_pixels_only_where_the_imagery_is_finer(village, pixel_m, resolution):
    assert plan_area(village, (200.0, 150.0), pixel_m).resolution_cm == resolution
    assert training_resolution_cm([], pixel_m) is None
