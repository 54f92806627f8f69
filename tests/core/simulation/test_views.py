import numpy as np
import pytest

from semref.core.geometry.frame import MapFrame
from semref.core.simulation.views import PIXELS, View, cut, image_coordinates, lies_on, map_coordinates

MAP = MapFrame.at((700_000.0, 5_200_000.0), 2.0)
TILTED = {"tilt_deg": 12.0, "tilt_direction_deg": 200.0}


@pytest.fixture
def labels_hw():
    return np.random.default_rng(0).integers(1, 5, (200, 260), dtype=np.uint8)


def seen_from(column, row, heading=0.0, width=61, height=61, **changes) -> View:
    return View(column, -row, heading, 1.0, width, height, **changes)


def test_heading_90_shows_the_east_at_the_top():
    labels = np.zeros((100, 100), np.uint8)
    labels[50, 70] = 9
    assert np.argwhere(cut(labels, PIXELS, seen_from(50.5, 50.5, 90.0)) == 9).tolist() == [[10, 30]]


def test_beyond_the_map_there_is_nothing(labels_hw):
    seen = cut(labels_hw, PIXELS, seen_from(0, 0, 0.0, 40, 20))
    assert not seen[:10].any() and not seen[:, :20].any() and seen[10:, 20:].all()
    assert not cut(labels_hw, PIXELS, seen_from(-500, -500)).any()


@pytest.mark.parametrize("changes", [{}, {"tilt_deg": 10.0}, {"lens": 0.03}, {"is_mirrored": True}])
def test_each_pixel_shows_its_place_in_any_strip(labels_hw, changes):
    view = View(130.3, -99.8, 33.0, 1.2, 70, 75, **changes)
    columns, rows = np.meshgrid(np.arange(70) + 0.5, np.arange(75) + 0.5)
    x, y = map_coordinates(view, columns, rows)
    np.testing.assert_array_equal(cut(labels_hw, PIXELS, view), labels_hw[(-y).astype(int), x.astype(int)])


def test_a_photo_of_three_bands_is_cut_like_a_label_map(labels_hw):
    view = View(120.3, -99.8, 33.0, 1.2, 64, 64)
    seen = cut(np.dstack([labels_hw] * 3), PIXELS, view)
    np.testing.assert_array_equal(seen[:, :, 1], cut(labels_hw, PIXELS, view))
    assert cut(np.dstack([labels_hw] * 3), PIXELS, seen_from(-500, 0)).shape == (61, 61, 3)


def test_one_view_shows_the_same_ground_of_maps_with_other_pixels(labels_hw):
    view = View(700_260.0, 5_199_800.0, 25.0, 1.3, 80, 60)
    fine = np.kron(labels_hw, np.ones((4, 4), np.uint8))
    np.testing.assert_array_equal(cut(labels_hw, MAP, view), cut(fine, MapFrame.at(MAP.origin, 0.5), view))


def test_a_mirrored_view_shows_left_and_right_exchanged(labels_hw):
    plain, mirrored = (seen_from(100.2, 90.7, 40.0, is_mirrored=flag) for flag in (False, True))
    np.testing.assert_array_equal(cut(labels_hw, PIXELS, mirrored), cut(labels_hw, PIXELS, plain)[:, ::-1])
    assert mirrored.plain() == plain and plain.plain() is plain


def test_a_tilted_camera_sees_farther_where_it_is_tilted_to_and_its_center_stays():
    view = View(100.0, 120.0, 30.0, 1.5, 80, 60, tilt_deg=10.0, tilt_direction_deg=50.0)
    assert map_coordinates(view, np.array(40.0), np.array(30.0)) == (100.0, 120.0)
    view = View(0.0, 0.0, 0.0, 1.0, 100, 100, tilt_deg=10.0)
    x, y = map_coordinates(view, np.array([50.0, 50.0]), np.array([0.0, 100.0]))
    assert y[0] > 55 > 50 > -y[1] and x == pytest.approx([0, 0])


def test_a_view_is_on_the_map_if_all_its_pixels_are(labels_hw):
    frame = MAP.of_shape(labels_hw.shape)
    inside = View(700_260.0, 5_199_800.0, 30.0, 2.0, 64, 64)
    assert lies_on(frame, inside) and cut(labels_hw, MAP, inside).all()
    beyond = View(700_040.0, 5_199_800.0, 30.0, 2.0, 64, 64)
    assert not lies_on(frame, beyond) and not cut(labels_hw, MAP, beyond).all()


def test_a_view_has_the_footprint_that_it_covers():
    view = View(3.0, 4.0, pixel_size=0.5, width_px=640, height_px=480)
    assert (view.position, view.footprint, view.shape_hw) == ((3.0, 4.0), 320.0, (480, 640))


def test_a_lens_moves_the_corners_by_its_share_and_leaves_the_center():
    view = View(1000.0, 2000.0, 30.0, 0.5, 640, 480, lens=0.03)
    plain = View(1000.0, 2000.0, 30.0, 0.5, 640, 480)
    columns, rows = np.array([320.0, 0.0, 640.0]), np.array([240.0, 0.0, 480.0])
    bent, straight = (np.array(map_coordinates(one, columns, rows)) - [[1000.0], [2000.0]] for one in (view, plain))
    np.testing.assert_allclose(bent, straight * [1.0, 1.03, 1.03])


@pytest.mark.parametrize(
    "changes",
    [{}, {"is_mirrored": True}, {"lens": 0.03}, TILTED, {**TILTED, "lens": 0.02}, {**TILTED, "is_mirrored": True}],
)
def test_points_of_the_map_are_at_the_pixels_that_show_them(changes):
    view = View(700_100.0, 5_199_900.0, 137.0, 1.7, 640, 480, **changes)
    pixels = np.random.default_rng(1).uniform((0, 0), (640, 480), (50, 2))
    found = image_coordinates(view, np.column_stack(map_coordinates(view, *pixels.T)))
    np.testing.assert_allclose(found, pixels, atol=1e-3 if changes.keys() >= TILTED.keys() else 1e-6)
