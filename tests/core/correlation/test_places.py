"""Distinct places, the space that a prior leaves, and images that tell nothing."""

import numpy as np
import pytest

from semref.core.correlation.class_pyramid import evidence_level
from semref.core.correlation.places import (
    apart_m,
    best_places,
    distinct,
    finest_pose,
    missing_information,
    search_space,
    size_for,
)
from semref.core.correlation.refine import ScoredPose
from semref.core.localization import Prior


def test_distinct_places_are_kept_apart_and_the_first_of_near_ones_stays():
    poses = [ScoredPose(x, y, 0.0, 1.0) for x, y in [(0, 0), (30, 0), (100, 0), (100, 49), (0, 50), (300, 300)]]
    assert [(pose.x, pose.y) for pose in distinct(poses, 50.0, 9)] == [(0, 0), (100, 0), (0, 50), (300, 300)]
    assert [(pose.x, pose.y) for pose in distinct(poses, 50.0, 2)] == [(0, 0), (100, 0)]


def test_the_best_place_is_the_true_one_and_the_others_are_elsewhere(patch_pyramid, image_at):
    image = image_at(703.4, 598.1, 41.0, 1.03, 128)
    prior = Prior((500_700.0, 5_199_400.0), 200.0, 45.0, 20.0, (0.9, 1.15))
    poses = best_places(image, patch_pyramid, search_space(patch_pyramid, prior), 8, apart_m(image, (0.9, 1.15)))
    pose, covariance = finest_pose(image, patch_pyramid, poses[0])
    assert np.hypot(pose.x - 703.4, pose.y - 598.1) < 2
    assert abs(pose.heading_deg - 41) < 0.3 and np.isfinite(covariance).all()
    for number, one in enumerate(poses):
        for other in poses[:number]:
            assert np.hypot(one.x - other.x, one.y - other.y) >= apart_m(image, (0.9, 1.15))
            assert one.score <= other.score


def test_a_prior_bounds_what_is_searched(patch_pyramid):
    prior = Prior((500_700.0, 5_199_400.0), 200.0, 5.0, 20.0, (0.9, 1.15))
    space = search_space(patch_pyramid, prior)
    assert space.box_m == (500.0, 400.0, 900.0, 800.0)
    assert np.abs((space.headings_deg - 5 + 180) % 360 - 180).max() < 20 and len(space.headings_deg) >= 5
    assert 0.9 < space.pixel_sizes_m.min() < space.pixel_sizes_m.max() < 1.15
    anywhere = search_space(patch_pyramid, Prior(pixel_size_range=(0.9, 1.15)))
    assert anywhere.box_m == (0.0, 0.0, 1440.0, 1200.0) and len(anywhere.headings_deg) == 50


@pytest.mark.parametrize(
    "value, code", [(0, "localization.too_few_labels"), (3, "localization.hardly_one_class"), (None, None)]
)
def test_an_image_without_labels_or_of_one_class_tells_no_place(patch_pyramid, patches, value, code):
    labels = patches[:200, :200] if value is None else np.full((200, 200), value, np.uint8)
    missing = missing_information(evidence_level(labels, patch_pyramid.space, (32, 32)), patch_pyramid)
    assert (missing and missing.code) == code


def test_a_reduced_image_keeps_its_shape_and_never_gains_pixels():
    assert size_for((400, 1600), 32) == (64, 16)
    assert size_for((10, 20), 32) == (20, 10)
