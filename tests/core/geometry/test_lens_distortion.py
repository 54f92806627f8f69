from dataclasses import replace

import cv2
import numpy as np
import pytest

from semref.core.geometry.camera import Camera, Lens
from semref.core.geometry.lens_distortion import LensDistortion, border
from semref.core.geometry.leveling import Attitude, leveling

PHANTOM = LensDistortion(
    (3659.78 / 4864, 3653.17 / 4864),
    (-7.71 / 4864, 45.9 / 4864),
    (-0.269478, 0.115681, -0.0357628),
    (-0.0000875619, -0.000306177),
)
"""Values that photos of a Phantom 4 RTK state (4864 × 3648)."""
RATIONAL = LensDistortion((0.75, 0.75), (0.0, 0.0), (0.2, 0.03, 0.0, 0.4, 0.05, 0.001))
SHAPE = 360, 480


@pytest.mark.parametrize("lens", [PHANTOM, RATIONAL], ids=["phantom", "rational"])
def test_rays_are_seen_where_opencv_has_them(lens):
    rays = np.random.default_rng(1).uniform(-0.6, 0.6, (50, 2))
    k1, k2, k3, *others = lens.radial
    camera = np.array([[lens.focal_xy[0], 0, lens.center_xy[0]], [0, lens.focal_xy[1], lens.center_xy[1]], [0, 0, 1]])
    factors = np.array([k1, k2, *lens.tangential, k3, *others])
    wanted = cv2.projectPoints(np.column_stack([rays, np.ones(50)]), np.zeros(3), np.zeros(3), camera, factors)[0]
    np.testing.assert_allclose(lens.seen(rays), wanted[:, 0], atol=1e-9)


@pytest.mark.parametrize("lens", [PHANTOM, RATIONAL], ids=["phantom", "rational"])
def test_what_is_seen_leads_back_to_its_ray(lens):
    seen = border(0.75)
    np.testing.assert_allclose(lens.seen(lens.rays(seen)), seen, atol=1e-6)
    assert lens.is_usable(0.75)


@pytest.mark.parametrize(
    "lens",
    [
        LensDistortion((0.75, 0.75), (0, 0), (-2.0, 0.0, 0.0)),
        LensDistortion((0.0, 0.75), (0, 0), (-0.1, 0.0, 0.0)),
        LensDistortion((0.75, 0.75), (0, 0), (float("inf"), 0.0, 0.0)),
        LensDistortion((0.75, 0.75), (0, 0), (1e12, -1e12, 1e12)),
    ],
    ids=["turns back", "no focal length", "infinite", "absurd"],
)
def test_an_impossible_lens_is_not_used(lens):
    assert not lens.is_usable(0.75)


def bent_image(scene, way):
    height, width = SHAPE
    rows, columns = np.mgrid[0:height, 0:width]
    straight = way.bent.straight(np.column_stack([columns.ravel(), rows.ravel()]) + 0.5)
    ground = np.column_stack([straight, np.ones(len(straight))]) @ way.homography.T
    x, y = (ground[:, :2] / ground[:, 2:]).T
    return scene(x, y).reshape(SHAPE).astype(np.uint8)


@pytest.mark.slow
@pytest.mark.parametrize("attitude", [Attitude(0, 0), Attitude(4, -7)], ids=["level", "tilted"])
@pytest.mark.parametrize("lens", [PHANTOM, RATIONAL], ids=["phantom", "rational"])
def test_what_a_lens_bent_is_straight_again(lens, attitude):
    way = leveling(attitude, 0.75 * SHAPE[1], SHAPE, lens)

    def squares(x, y):
        return 1 + (np.floor(x / 40) + np.floor(y / 40)) % 2

    level = way.level(bent_image(squares, way))
    rows, columns = np.nonzero(level)
    wanted = squares(columns + 0.5, rows + 0.5)
    wrong = level[rows, columns] != wanted
    assert wrong.mean() < 0.03 and len(rows) > 0.9 * SHAPE[0] * SHAPE[1]
    # Only pixels at the edges of squares may differ.
    from_edge = np.minimum(*(np.abs((v[wrong] + 0.5 + 20) % 40 - 20) for v in (rows, columns)))
    assert from_edge.max(initial=0) <= 1.5


def test_points_lead_back_into_the_bent_image():
    way = leveling(Attitude(3, 2), 0.75 * SHAPE[1], SHAPE, PHANTOM)
    pixels = np.array([[10.0, 20.0], [240.0, 180.0], [470.0, 350.0]])
    straight = way.bent.straight(pixels)
    level = np.column_stack([straight, np.ones(3)]) @ way.homography.T
    np.testing.assert_allclose(way.in_image(level[:, :2] / level[:, 2:]), pixels, atol=1e-3)


def test_planes_are_straightened_as_labels_are():
    way = leveling(Attitude(0, 0), 0.75 * SHAPE[1], SHAPE, PHANTOM)
    labels = bent_image(lambda x, y: np.where(x > 200, 200, 0), way)
    small = cv2.resize(labels, None, fx=0.25, fy=0.25, interpolation=cv2.INTER_AREA)
    planes = way.level_planes(small[:, :, None], SHAPE)
    level = way.level(labels)
    small = cv2.resize(level, planes.shape[1::-1], interpolation=cv2.INTER_AREA)
    inside = np.s_[5:-5, 5:-5]
    assert np.abs(planes[:, :, 0].astype(int) - small)[inside].mean() < 3


def test_a_lens_without_attitude_gives_no_nadir():
    camera = Camera(lens=Lens("field_of_view", 67.4), distortion=PHANTOM)
    way = camera.leveling(SHAPE)
    assert way is not None and way.nadir is None
    assert Camera(lens=Lens("field_of_view", 67.4)).leveling(SHAPE) is None
    tilted = Camera(Attitude(5, 0), Lens("field_of_view", 67.4), distortion=PHANTOM)
    assert replace(tilted, attitude=None).leveling(SHAPE).nadir is None and tilted.leveling(SHAPE).nadir is not None


def test_the_shift_is_how_far_corners_are_moved():
    assert LensDistortion((0.75, 0.75), (0, 0), (0.0, 0.0, 0.0)).shift(0.75) == pytest.approx(0, abs=1e-6)
    assert 0.02 < PHANTOM.shift(0.75) < 0.2
