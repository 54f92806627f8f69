import numpy as np
import pytest

from semref.core.geometry.camera import Camera, Lens, above_ground, above_takeoff
from semref.core.geometry.leveling import Attitude

WIDE = Lens("focal_length_px", 1000.0)


def test_a_pixel_covers_height_over_focal_length():
    low, high = Camera(lens=WIDE, attitude=Attitude(0, 0), height=above_ground(200.0)).pixel_sizes((600, 800))
    assert low == pytest.approx((0.9 * 200 - 3) / 1030) and high == pytest.approx((1.1 * 200 + 3) / 970)


@pytest.mark.parametrize(("told", "least", "most"), [(100, 60, 140), (1000, 870, 1130), (20, 8, 52)])
def test_a_height_above_the_place_of_take_off_may_be_off_by_30_m_but_never_below_the_ground(told, least, most):
    assert above_takeoff(told).range_m == pytest.approx((least, most))


def test_a_tilted_camera_sees_larger_pixels():
    level, tilted, unknown = (
        Camera(lens=WIDE, attitude=attitude, height=above_ground(200.0)).pixel_sizes((600, 800))
        for attitude in (Attitude(0, 0), Attitude(0, 30), None)
    )
    assert np.array(tilted) == pytest.approx(np.array(level) * np.cos(np.radians(30)) ** -1.5)
    assert unknown[0] == level[0] and level[1] < unknown[1] < tilted[1]


def test_a_flat_picture_may_be_cut_from_a_higher_sensor():
    lens = Lens("focal_length_35mm", 20.0)
    low, high = lens.focal_lengths_px((2250, 4000))
    whole = 20 / np.hypot(36, 24) * 5000
    assert low < 20 / np.hypot(36, 24) * np.hypot(2250, 4000) < whole < high
    assert lens.focal_lengths_px((3000, 4000))[1] == pytest.approx(whole * 1.03)


@pytest.mark.parametrize(("lens", "height"), [(WIDE, None), (None, 100), (Lens("field_of_view", 60.0, 1.5), 100)])
def test_pixel_size_is_unknown_without_height_or_lens(lens, height):
    camera = Camera(lens=lens, height=height and above_ground(height))
    assert camera.pixel_sizes((600, 800)) is None and camera.pixel_size((600, 800)) is None


@pytest.mark.parametrize("attitude", [None, Attitude(0, 0), Attitude(10, -30)])
def test_the_pixel_size_is_in_its_range(attitude):
    camera = Camera(lens=WIDE, attitude=attitude, height=above_takeoff(100.0))
    low, high = camera.pixel_sizes((600, 800))
    assert low < camera.pixel_size((600, 800)) < high
    if attitude is None:
        assert camera.pixel_size((600, 800)) == pytest.approx(0.1)


@pytest.mark.parametrize("pitch", [80, 89.9, -85])
def test_a_view_to_the_horizon_has_no_single_pixel_size(pitch):
    assert Camera(lens=WIDE, attitude=Attitude(0, pitch), height=above_ground(100.0)).pixel_size((600, 800)) is None


def test_an_image_that_is_taken_as_it_is_keeps_what_else_is_known():
    camera = Camera(Attitude(3, 4), WIDE, "a.csv", 7.0, height=above_ground(100.0), heading_deg=12.0)
    plain = camera.without_leveling()
    assert plain.leveling((600, 800)) is None and plain.attitude is None
    assert (plain.lens, plain.time_s, plain.height, plain.heading_deg) == (WIDE, 7.0, camera.height, 12.0)
