"""Effects of tilt and lens on a level pose, on views of a made map with a known camera."""

import math

import numpy as np
import pytest

from semref.core.correlation.class_pyramid import evidence_level
from semref.core.correlation.refine import ScoredPose, refine
from semref.core.correlation.view_effects import view_effect
from semref.core.geometry.error_settings import SharedErrors
from semref.core.geometry.frame import MapFrame
from semref.core.simulation.views import View, cut

FRAME = MapFrame.at((0.0, 0.0), 4.0)
PLACE, PIXEL_M, EDGE = (703.4, -598.1), 1.4, 500
FACTOR = 0.5
ERRORS = SharedErrors(map_accuracy=0.1)


def seen(patches, patch_pyramid, **camera):
    """Return the evidence of a view and the level pose that fits it best."""
    view = View(*PLACE, 41.0, PIXEL_M, EDGE, EDGE, **camera)
    image = evidence_level(cut(patches, FRAME, view), patch_pyramid.space, (64, 64))
    start = ScoredPose(PLACE[0], -PLACE[1], 41.0, PIXEL_M)
    return image, refine(image, patch_pyramid, start, patch_pyramid.quiet, 8)


def away(pose):
    """Return the distance from the true place in meters."""
    return math.dist((pose.x, -pose.y), PLACE)


@pytest.mark.parametrize("direction_deg", [20.0, 250.0])
@pytest.mark.parametrize("tilt_deg", [5.0, 10.0])
def test_a_tilted_camera_is_seen_and_the_place_put_right(patches, patch_pyramid, tilt_deg, direction_deg):
    image, level = seen(patches, patch_pyramid, tilt_deg=tilt_deg, tilt_direction_deg=direction_deg)
    found = view_effect(image, patch_pyramid, level, FACTOR, ERRORS)
    assert away(level) > 3.0 and away(found.correct(level)) < 0.3 * away(level)


def test_a_lens_that_bends_makes_the_pixel_size_uncertain_or_right(patches, patch_pyramid):
    image, level = seen(patches, patch_pyramid, lens=0.03)
    found = view_effect(image, patch_pyramid, level, FACTOR, ERRORS)
    moved = found.correct(level)
    assert abs(level.pixel_size_m / PIXEL_M - 1) > 0.005
    assert abs(moved.pixel_size_m / PIXEL_M - 1) < 2 * np.sqrt(found.covariance[3, 3]) + 0.003


def test_the_more_labels_err_the_less_is_known_of_the_camera(patches, patch_pyramid):
    image, level = seen(patches, patch_pyramid)
    sure, unsure = (view_effect(image, patch_pyramid, level, factor, ERRORS) for factor in (0.3, 30.0))
    assert unsure.covariance[0, 0] > 10 * sure.covariance[0, 0]
