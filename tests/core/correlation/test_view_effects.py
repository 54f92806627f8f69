import math

import numpy as np
import pytest

from semref.core.correlation.class_pyramid import evidence_level
from semref.core.correlation.exactness import covariance_on_map, full_pose_covariance, shared_over
from semref.core.correlation.refine import ScoredPose, refine
from semref.core.correlation.view_effects import ViewEffect, view_effect
from semref.core.geometry.error_settings import SharedErrors
from semref.core.geometry.frame import MapFrame
from semref.core.geometry.radius import CIRCLE_95
from semref.core.simulation.views import View, cut

FRAME = MapFrame.at((0.0, 0.0), 4.0)
PLACE, PIXEL_M, EDGE = (703.4, -598.1), 1.4, 500
ERRORS = SharedErrors(map_accuracy=0.1)


def seen(patches, patch_pyramid, **camera):
    """Return the evidence of a view and the level pose that fits it best."""
    view = View(*PLACE, 41.0, PIXEL_M, EDGE, EDGE, **camera)
    image = evidence_level(cut(patches, FRAME, view), patch_pyramid.space, (64, 64))
    start = ScoredPose(PLACE[0], -PLACE[1], 41.0, PIXEL_M)
    return image, refine(image, patch_pyramid, start, patch_pyramid.quiet, 8)


def away(pose):
    return math.dist((pose.x, -pose.y), PLACE)


@pytest.mark.parametrize("direction_deg", [20.0, 250.0])
@pytest.mark.parametrize("tilt_deg", [5.0, 10.0])
def test_a_tilted_camera_is_seen_and_the_place_put_right(patches, patch_pyramid, tilt_deg, direction_deg):
    image, level = seen(patches, patch_pyramid, tilt_deg=tilt_deg, tilt_direction_deg=direction_deg)
    found = view_effect(image, patch_pyramid, level, ERRORS)
    assert away(level) > 3.0 and away(found.correct(level)) < 0.3 * away(level)


def test_a_lens_that_bends_makes_the_pixel_size_uncertain_or_right(patches, patch_pyramid):
    image, level = seen(patches, patch_pyramid, lens=0.03)
    found = view_effect(image, patch_pyramid, level, ERRORS)
    moved = found.correct(level)
    assert abs(level.pixel_size_m / PIXEL_M - 1) > 0.005
    assert abs(moved.pixel_size_m / PIXEL_M - 1) < 2 * np.sqrt(found.covariance[3, 3]) + 0.003


def test_the_more_labels_err_the_less_is_known_of_the_camera(patches, patch_pyramid):
    image, level = seen(patches, patch_pyramid)
    spoiled = np.random.default_rng(6).permuted(image.evidence.reshape(-1, 4), axis=0).reshape(image.evidence.shape)
    noisy = type(image)((image.evidence + 2 * spoiled).astype(np.float32), image.known, image.pixel)
    sure, unsure = (view_effect(one, patch_pyramid, level, ERRORS) for one in (image, noisy))
    assert unsure.covariance[0, 0] > 10 * sure.covariance[0, 0]


POSE = ScoredPose(100.0, 200.0, 30.0, 2.0, 0.7)
SPREAD = np.diag([1.0, 4.0, 1e-6, 1e-6])


def test_deviations_are_turned_and_scaled_to_the_map():
    found = covariance_on_map(ScoredPose(0, 0, 90.0, 2.0), SPREAD)
    # The image's right points south.
    np.testing.assert_allclose(found[:2, :2], [[16.0, 0.0], [0.0, 4.0]], atol=1e-9)


def test_a_small_image_shares_more_of_the_displacement():
    kernels = ((60.0, 0.3), (2000.0, 0.2))
    shares = [shared_over(kernels, edge)[0, 0] for edge in (1.0, 300.0, 3000.0)]
    assert shares[0] == pytest.approx(0.5, abs=0.01) and shares[0] > shares[1] > shares[2] > 0.05


def test_a_displaced_map_turns_and_stretches_an_image_as_a_fit_to_its_places_does():
    rng, edge, kernels = np.random.default_rng(5), 1280.0, ((60.0, 0.28), (2000.0, 0.25))
    side = np.linspace(-edge / 2, edge / 2, 5)
    x, y = (axis.ravel() for axis in np.meshgrid(side, side))
    away = np.hypot(x[:, None] - x, y[:, None] - y)
    field = np.linalg.cholesky(sum(w * np.exp(-away / length) for length, w in kernels) + 1e-9 * np.eye(25))
    design = np.vstack([np.column_stack([x, -y]), np.column_stack([y, x])])
    moved = [field @ rng.normal(size=25) for _ in range(4000)]
    fits = [np.linalg.lstsq(design, np.concatenate(pair), rcond=None)[0] for pair in zip(moved[::2], moved[1::2])]
    growth, turn = np.var(fits, axis=0)
    expected = shared_over(kernels, edge)
    assert growth == pytest.approx(expected[3, 3], rel=0.15) and turn == pytest.approx(expected[2, 2], rel=0.15)


def test_uncertainty_of_the_camera_is_a_part_of_the_radius():
    effect = ViewEffect(np.zeros(4), np.diag([9.0, 9.0, 0.0, 0.0]))
    known = full_pose_covariance(POSE, 1e-6 * SPREAD, 1280.0, 4.0, SharedErrors(0.0), effect)
    assert known.parts[0] == ("view", pytest.approx(CIRCLE_95 * 6.0)) and known.deviations[0] > 6.0
