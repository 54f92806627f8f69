import numpy as np
import pytest

from semref.core.errors import LabelMapError, ParameterError
from semref.core.geometry.leveling import (
    Attitude,
    attitude_from_gimbal,
    focal_length_from_35mm,
    focal_length_from_view,
    leveling,
)
from semref.core.geometry.pose import turn_of
from semref.core.labels.sources import ArrayLabels
from semref.core.simulation.views import PIXELS, View, cut, map_coordinates

SHAPE = (200, 260)
FIELD_OF_VIEW = 60.0
FOCAL = focal_length_from_view(FIELD_OF_VIEW, SHAPE)
TILTS = [(0, 0), (5, 0), (10, 90), (10, 200), (20, 45), (30, 0), (30, 300), (30, 180)]


def tilted(tilt_deg: float, direction_deg: float, heading_deg: float = 25.0) -> View:
    return View(500.3, -480.7, heading_deg, 1.3, SHAPE[1], SHAPE[0], tilt_deg, direction_deg, FIELD_OF_VIEW)


def attitude_of(tilt_deg: float, direction_deg: float) -> Attitude:
    """Return the attitude of a view: the axis leans by ``tilt_deg`` towards ``direction_deg``, clockwise from up."""
    tilt, direction = np.radians((tilt_deg, direction_deg))
    pitch = np.arcsin(np.sin(tilt) * np.cos(direction))
    roll = np.arctan2(np.sin(tilt) * np.sin(direction), np.cos(tilt))
    return Attitude(float(np.degrees(roll)), float(np.degrees(pitch)))


def blocks() -> ArrayLabels:
    small = np.random.default_rng(3).integers(1, 6, (100, 100), dtype=np.uint8)
    return ArrayLabels(np.kron(small, np.ones((10, 10), np.uint8)))


@pytest.mark.parametrize(("tilt", "direction"), TILTS)
def test_the_homography_is_the_tilted_views_truth(tilt, direction):
    view = tilted(tilt, direction)
    way = leveling(attitude_of(tilt, direction), FOCAL, SHAPE)
    rng = np.random.default_rng(0)
    columns, rows = rng.uniform(0, SHAPE[1], 50), rng.uniform(0, SHAPE[0], 50)
    x, y, w = way.homography @ np.array([columns, rows, np.ones(50)])
    offsets = way.middle + (x / w - way.shape_hw[1] / 2) + 1j * (way.shape_hw[0] / 2 - y / w)
    on_map = complex(*view.position) + turn_of(view.heading_deg, view.pixel_size) * offsets
    expected = map_coordinates(view, columns, rows)
    np.testing.assert_allclose((on_map.real, on_map.imag), expected, atol=1e-9)


@pytest.mark.parametrize(("tilt", "direction"), TILTS)
def test_a_tilted_view_leveled_with_its_true_attitude_is_the_level_view(tilt, direction):
    view = tilted(tilt, direction)
    way = leveling(attitude_of(tilt, direction), FOCAL, SHAPE)
    leveled = way.level(cut(blocks(), PIXELS, view))
    middle = complex(*view.position) + turn_of(view.heading_deg, view.pixel_size) * way.middle
    height, width = way.shape_hw
    seen_from = View(middle.real, middle.imag, view.heading_deg, view.pixel_size, width, height)
    level = cut(blocks(), PIXELS, seen_from)
    seen = leveled > 0
    # Two nearest-neighbor steps move edges by up to a pixel; squares are 7.7 pixels wide.
    assert (leveled == level)[seen].mean() > 0.85
    assert (leveled == np.roll(level, 4, axis=0))[seen].mean() < 0.75
    # Some ground is missing: at 30° one far pixel covers several level pixels.
    area = 0.5 * abs((way.corners.conj() * np.roll(way.corners, -1)).imag.sum())
    assert seen.sum() == pytest.approx(area, rel=0.02)


def test_pitch_leans_towards_the_top_and_roll_towards_the_right():
    pitched, rolled = (leveling(attitude, FOCAL, SHAPE) for attitude in (Attitude(0, 10), Attitude(10, 0)))
    assert pitched.nadir.imag < -20 and pitched.nadir.real == pytest.approx(0)
    assert pitched.middle.imag > 3 and pitched.middle.real == pytest.approx(0, abs=0.5)
    assert rolled.nadir.real < -20 and rolled.nadir.imag == pytest.approx(0)
    assert rolled.middle.real > 3 and rolled.middle.imag == pytest.approx(0, abs=0.5)


def test_the_nadir_distance_follows_from_height_and_tilt():
    way = leveling(Attitude(0, 20), 1000.0, (600, 600))
    height = 1000.0 * np.cos(np.radians(20)) ** 1.5
    assert way.nadir == pytest.approx(-1j * height * np.tan(np.radians(20)))


@pytest.mark.parametrize(
    ("gimbal_roll", "gimbal_pitch", "roll", "pitch"),
    [(0, -90, 0, 0), (0, -80, 0, 10), (0, -95, 0, -5), (180, -90, 0, 0), (90, -80, -10, 0), (-90, -80, 10, 0)],
)
def test_a_gimbals_angles_count_from_the_horizon_and_roll_about_the_axis(gimbal_roll, gimbal_pitch, roll, pitch):
    attitude = attitude_from_gimbal(gimbal_roll, gimbal_pitch)
    assert (attitude.roll_deg, attitude.pitch_deg) == pytest.approx((roll, pitch))


def test_focal_lengths_agree_with_each_other():
    # DJI: 24 mm (35 mm equivalent) is 84° across the diagonal.
    focal = focal_length_from_35mm(24, (3000, 4000))
    assert np.degrees(2 * np.arctan(2500 / focal)) == pytest.approx(84.1, abs=0.1)
    across = np.degrees(2 * np.arctan(2000 / focal))
    assert focal_length_from_view(across, (3000, 4000)) == pytest.approx(focal)


@pytest.mark.parametrize("attitude", [Attitude(0, 50), Attitude(-60, 0), Attitude(80, 80)])
def test_a_view_near_the_horizon_is_refused(attitude):
    with pytest.raises(ParameterError, match=r"at most 75° is possible"):
        leveling(attitude, FOCAL, SHAPE)


@pytest.mark.parametrize("angles", [(90, 0), (0, -90), (200, 0), (float("nan"), 0)])
def test_angles_that_look_away_from_the_ground_are_refused(angles):
    with pytest.raises(ParameterError, match="does not look at the ground"):
        Attitude(*angles)


def test_no_pixels_too_many_and_a_gimbal_above_the_horizon_are_refused():
    with pytest.raises(LabelMapError, match="no pixels"):
        leveling(Attitude(0, 1), 100.0, (0, 5))
    with pytest.raises(LabelMapError, match="reduce the image first"):
        leveling(Attitude(0, 1), 1e6, (10, 40_000))
    with pytest.raises(ParameterError, match="gimbal pitch of 10°"):
        attitude_from_gimbal(0, 10)


@pytest.mark.parametrize("focal_length", [float("inf"), float("nan"), 1e300, -1.0, 0.0])
def test_a_focal_length_that_no_camera_has_is_refused(focal_length):
    with pytest.raises(ParameterError, match="focal length is"):
        leveling(Attitude(1.0, 2.0), focal_length, (90, 120))
