"""Accuracy of map correlation: shared errors do not average out."""

import numpy as np
import pytest

from semref.core.correlation.exactness import covariance_on_map, full_pose_covariance, shared_over
from semref.core.correlation.refine import ScoredPose
from semref.core.correlation.view_effects import ViewEffect
from semref.core.geometry.error_settings import SharedErrors
from semref.core.geometry.radius import CIRCLE_95

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
    x, y = (
        axis.ravel() for axis in np.meshgrid(np.linspace(-edge / 2, edge / 2, 5), np.linspace(-edge / 2, edge / 2, 5))
    )
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
