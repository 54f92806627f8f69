"""Sample pictures show their place, are on the map, and have unique names."""

import numpy as np
import pytest

from sample import pictures

SEED = 1671


@pytest.fixture
def labels_hw():
    return np.random.default_rng(0).integers(0, 7, (200, 260), dtype=np.uint8)


def view(column, row, heading=0.0, scale=1.0):
    return pictures.Picture("v.png", "test", column, row, heading, scale)


def test_a_view_beyond_the_map_is_refused(labels_hw):
    with pytest.raises(ValueError, match="beyond the map"):
        pictures.cut(labels_hw, view(20, 100), 64)


def test_planned_views_are_on_the_map_with_different_names():
    labels = np.zeros((3000, 4000), np.uint8)
    views = pictures.plan_views(labels.shape, SEED)
    assert len({v.name for v in views}) == len(views) == 46
    assert all(pictures.cut(labels, v).shape == (640, 640) for v in views)


def test_views_on_windows_are_centered_on_the_window_of_their_name():
    for v in pictures.plan_views((3000, 4000), SEED):
        if v.window:
            column, row = (int(n) for n in v.window.split("_"))
            assert column % pictures.STRIDE_PX == row % pictures.STRIDE_PX == 0
            assert (v.column, v.row) == (column + 320, row + 320)
            assert v.name.endswith(f"_{v.window}.png")


def test_a_map_too_small_for_the_pictures_is_refused():
    with pytest.raises(ValueError, match="smaller pixel size"):
        pictures.plan_views((900, 2000), SEED)


def test_more_photos_begin_with_the_same_ones():
    few, many = (pictures.plan_photos((3000, 4000), SEED, count) for count in (12, 200))
    assert many[:12] == few
    assert len({view.name for view in many}) == 200


def test_the_photos_of_a_flight_overlap_and_their_tops_point_where_it_goes():
    views = pictures.plan_flight((3000, 4000))
    labels = np.zeros((3000, 4000), np.uint8)
    assert all(pictures.cut(labels, view).shape == (640, 640) for view in views)
    steps = np.diff([(view.column, view.row) for view in views], axis=0)
    assert (np.hypot(*steps.T) < 0.6 * 640).all()
    headings = np.degrees(np.arctan2(steps[:, 0], -steps[:, 1])) % 360
    between = [(a.heading_deg + b.heading_deg) / 2 for a, b in zip(views, views[1:])]
    np.testing.assert_allclose(headings, between, atol=8)
