"""Many poses moved at once: where one pose moved alone goes."""

import numpy as np
import pytest

from semref.core.correlation.class_pyramid import reduced_level
from semref.core.correlation.refine import NOT_COMPARABLE, ScoredPose, refine
from semref.core.correlation.refine_many import refine_many

TRUE = ScoredPose(703.4, 598.1, 41.0, 1.03)


def starts(count=12):
    rng = np.random.default_rng(8)
    off = rng.uniform(-1, 1, (count, 4)) * (20, 20, 5, 0.06)
    return [
        ScoredPose(TRUE.x + x, TRUE.y + y, TRUE.heading_deg + turn, TRUE.pixel_size_m * np.exp(growth))
        for x, y, turn, growth in off
    ]


@pytest.mark.parametrize("edge", [16, 32, 64])
def test_many_poses_go_where_each_would_go_alone(patch_pyramid, image_at, edge):
    image = reduced_level(image_at(703.4, 598.1, 41.0, 1.03, 128), (edge, edge))
    together = refine_many(image, patch_pyramid, starts(), patch_pyramid.quiet, 4)
    alone = [refine(image, patch_pyramid, pose, patch_pyramid.quiet, 4) for pose in starts()]
    assert [pose.score for pose in together] == pytest.approx([pose.score for pose in alone], abs=0.02)
    for pose in together:
        assert np.hypot(pose.x - TRUE.x, pose.y - TRUE.y) < 6 and abs(pose.heading_deg - 41) < 1.5


def test_a_pose_beside_the_map_is_not_comparable_and_no_pose_gives_none(patch_pyramid, image_at):
    image = image_at(703.4, 598.1, 41.0, 1.03, 32)
    beside = ScoredPose(-5000.0, 0.0, 0.0, 1.0)
    assert refine_many(image, patch_pyramid, [beside], patch_pyramid.quiet, 2)[0].score == NOT_COMPARABLE
    assert refine_many(image, patch_pyramid, [], patch_pyramid.quiet, 2) == []
