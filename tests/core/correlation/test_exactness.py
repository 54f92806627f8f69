"""How exactly map correlation knows a place: what is shared does not average out."""

import numpy as np
import pytest

from semref.core.correlation.exactness import covariance_on_map, known_pose, noise_factor, shared_over
from semref.core.correlation.refine import ScoredPose
from semref.core.geometry.error_settings import ClassBias, SharedErrors

POSE = ScoredPose(100.0, 200.0, 30.0, 2.0, 0.7)
SPREAD = np.diag([1.0, 4.0, 1e-6, 1e-6])


def test_deviations_are_turned_and_scaled_to_the_map():
    found = covariance_on_map(ScoredPose(0, 0, 90.0, 2.0), SPREAD)
    # The image's right points south.
    np.testing.assert_allclose(found[:2, :2], [[16.0, 0.0], [0.0, 4.0]], atol=1e-9)


def test_a_less_exact_map_makes_a_larger_radius():
    radii = [known_pose(POSE, SPREAD, 1280.0, 4.0, SharedErrors(accuracy)).radius_95 for accuracy in (0.0, 1.0, 10.0)]
    assert radii[0] < radii[1] < radii[2] and radii[2] > 10


def test_a_bias_of_classes_is_added():
    bias = SharedErrors(0.0, class_biases=(ClassBias(1, east=3.0, spread=0.5),))
    known = known_pose(POSE, 1e-6 * SPREAD, 1280.0, 4.0, bias)
    assert known.parts[0][0] == "classes" and known.radius_95 > 2.4 * 2.1


def test_what_nothing_tells_is_infinite():
    known = known_pose(POSE, np.full((4, 4), np.inf), 1280.0, 4.0, SharedErrors())
    assert known.radius_95 is None and known.position[0][0] == np.inf


def test_worse_agreement_makes_deviations_larger():
    assert noise_factor(0.9) < noise_factor(0.6) < noise_factor(0.3)


def test_a_small_image_shares_more_of_the_displacement():
    kernels = ((60.0, 0.3), (2000.0, 0.2))
    shares = [shared_over(kernels, edge) for edge in (1.0, 300.0, 3000.0)]
    assert shares[0] == pytest.approx(0.5, abs=0.01) and shares[0] > shares[1] > shares[2] > 0.05
