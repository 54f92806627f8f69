import numpy as np
import pytest

from semref.core.geometry.pose import Pose, fit_similarity, fit_tilted, heading_of, image_points, turn_of

IMAGE = image_points(np.random.default_rng(3).uniform(0, 400, (60, 2)), 400, 300)
LEVEL = Pose(6e5 + 5e6j, turn_of(37.0, 0.5))
TILTED = Pose(6e5 + 5e6j, turn_of(200.0, 0.5), 0.02 - 0.01j, 3e-4 + 2e-4j)
LEVEL_THERE = Pose(6e5 + 5e6j, turn_of(70.0, 0.5))
STEEP = Pose(6e5 + 5e6j, turn_of(70.0, 0.5), 0.06 + 0.03j, 1e-3 - 5e-4j)


@pytest.mark.parametrize("heading", [0, 90, 181.5, 359])
def test_a_rotation_gives_heading_and_pixel_size(heading):
    turn = turn_of(heading, 0.25)
    assert heading_of(turn) == pytest.approx(heading) and abs(turn) == pytest.approx(0.25)


@pytest.mark.parametrize("pose", [LEVEL, TILTED])
def test_the_size_of_a_pixel_is_the_root_of_its_ground(pose):
    if pose is TILTED:
        pose = Pose(pose.center, pose.turn, 0j, pose.slope)
    step = 1e-2
    here, right, up = (pose.on_map(IMAGE + offset) for offset in (0, step, 1j * step))
    area = ((right - here).conj() * (up - here)).imag / step**2
    np.testing.assert_allclose(pose.pixel_sizes(IMAGE), np.sqrt(area), rtol=1e-3)


def test_points_give_their_similarity_back_whatever_their_weights():
    weights = np.random.default_rng(4).uniform(0.1, 1, len(IMAGE))
    center, turn = fit_similarity(IMAGE, LEVEL.on_map(IMAGE), weights)
    assert center == pytest.approx(LEVEL.center) and turn == pytest.approx(LEVEL.turn)


def test_coincident_points_leave_heading_and_scale_open():
    found = fit_tilted(np.zeros(4, complex), np.full(4, LEVEL.center + 2), np.ones(4), LEVEL, 500.0)
    assert found.center == pytest.approx(LEVEL.center + 2)
    assert (found.turn, found.stretch, found.slope) == (pytest.approx(LEVEL.turn), 0, 0)


@pytest.mark.parametrize("pose", [TILTED, STEEP])
def test_exact_points_of_a_tilted_camera_give_its_pose_back(pose):
    on_map = pose.on_map(IMAGE)
    first = Pose(*(complex(part) for part in fit_similarity(IMAGE, on_map, np.ones(len(IMAGE)))))
    assert np.abs(first.on_map(IMAGE) - on_map).max() > 10
    found = fit_tilted(IMAGE, on_map, np.full(len(IMAGE), 1e-4), first, 500.0)
    np.testing.assert_allclose(found.on_map(IMAGE), on_map, rtol=0, atol=1e-5)
    assert found.center == pytest.approx(pose.center, rel=0, abs=1e-5)
    assert found.turn == pytest.approx(pose.turn, rel=1e-6)
    assert found.stretch == pytest.approx(pose.stretch, rel=1e-5)
    assert found.slope == pytest.approx(pose.slope, rel=1e-5)


def test_a_prior_keeps_the_tilt_moderate_if_points_are_uncertain():
    on_map = STEEP.on_map(IMAGE)
    slopes = [abs(fit_tilted(IMAGE, on_map, np.full(len(IMAGE), off), LEVEL_THERE, 500.0).slope) for off in (0.1, 1e4)]
    assert slopes[1] < 0.05 * slopes[0]
