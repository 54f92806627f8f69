"""Refinement of many poses by local contrast."""

from dataclasses import replace

import numpy as np
import pytest

from semref.core.correlation.detail import window_px
from semref.core.correlation.places import best_places, search_space
from semref.core.correlation.refine import ScoredPose
from semref.core.correlation.refine_many import refine_many
from semref.core.localization import Prior


@pytest.mark.parametrize("edge, window", [(8, 3), (16, 5), (32, 9), (64, 17)])
def test_the_window_has_the_same_share_of_the_image_at_every_look(image_at, edge, window):
    assert window_px(image_at(703.4, 598.1, 41.0, 1.03, edge), 0.28) == window


def test_refinement_by_local_contrast_has_the_same_optimum(patch_pyramid, image_at):
    image = image_at(703.4, 598.1, 41.0, 1.03)
    start = ScoredPose(697.0, 605.0, 43.0, 1.05)
    (pose,) = refine_many(image, patch_pyramid, [start], patch_pyramid.quiet, 8, 17)
    assert np.hypot(pose.x - 703.4, pose.y - 598.1) < 2 and abs(pose.heading_deg - 41) < 0.3


def test_a_slope_over_the_whole_image_hides_no_place(patch_pyramid, image_at):
    """A network that prefers one class at one side of the image adds such a slope."""
    image = image_at(703.4, 598.1, 41.0, 1.03)
    slope = np.linspace(-6, 6, 64, dtype=np.float32)[None, :, None] * np.float32(np.sqrt(patch_pyramid.energy))
    sloped = replace(image, evidence=image.evidence + slope)
    start = ScoredPose(703.4, 598.1, 41.0, 1.03)
    (whole,), (local,) = (
        refine_many(sloped, patch_pyramid, [start], patch_pyramid.quiet, 0, window) for window in (None, 17)
    )
    assert whole.score < 0.4 < 0.7 < local.score
    space = search_space(patch_pyramid, Prior(heading_deg=41.0, heading_range_deg=20.0, pixel_size_range=(0.9, 1.15)))
    poses, _ = best_places(sloped, patch_pyramid, (space, None), 256)
    assert any(np.hypot(pose.x - 703.4, pose.y - 598.1) < 20 for pose in poses)
