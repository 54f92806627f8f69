import numpy as np
import pytest
from made_patches import MODEST, PRIOR, STRONG, error_m, spoiled, view

from semref.core.correlation.class_pyramid import EvidenceLevel, evidence_level
from semref.core.correlation.places import (
    ChanceLevels,
    best_places,
    chance_levels,
    distinct,
    edge_m,
    finest_pose,
    missing_information,
    near_size,
    search_space,
)
from semref.core.correlation.refine import ScoredPose
from semref.core.correlation.solver import localize, part_against
from semref.core.localization import Prior


def test_distinct_places_are_kept_apart_and_the_first_of_near_ones_stays():
    image = EvidenceLevel(np.zeros((10, 10, 1), np.float32), np.ones((10, 10), np.float32), (10.0, 10.0))
    poses = [ScoredPose(x, y, 0.0, 1.0) for x, y in [(0, 0), (30, 0), (100, 0), (100, 49), (0, 50), (300, 300)]]
    assert [(pose.x, pose.y) for pose in distinct(poses, image, 0.5, 9)] == [(0, 0), (100, 0), (0, 50), (300, 300)]
    assert [(pose.x, pose.y) for pose in distinct(poses, image, 0.5, 2)] == [(0, 0), (100, 0)]


def test_the_best_place_is_the_true_one_and_the_others_are_elsewhere(patch_pyramid, image_at):
    image = image_at(703.4, 598.1, 41.0, 1.03, 128)
    prior = Prior((500_700.0, 5_199_400.0), 200.0, 45.0, 20.0, (0.9, 1.15))
    poses, chance = best_places(image, patch_pyramid, (search_space(patch_pyramid, prior), None), 8)
    pose, covariance = finest_pose(image, patch_pyramid, poses[0])
    assert np.hypot(pose.x - 703.4, pose.y - 598.1) < 2
    assert abs(pose.heading_deg - 41) < 0.3 and np.isfinite(covariance).all()
    apart = patch_pyramid.settings.apart
    above = [np.arctanh(pose.score) - chance.at(pose.pixel_size_m) for pose in poses]
    for number, one in enumerate(poses):
        for before, other in enumerate(poses[:number]):
            away = np.hypot(one.x - other.x, one.y - other.y)
            assert away >= apart * edge_m(image, other.pixel_size_m) and above[number] <= above[before]


@pytest.mark.parametrize("pixel_m", [0.4, 0.7, 1.4])
def test_an_image_of_any_ground_is_found_where_all_sizes_are_searched(patch_pyramid, image_at, pixel_m):
    image = image_at(703.4, 598.1, 41.0, pixel_m, 128)
    space = search_space(patch_pyramid, Prior(pixel_size_range=(0.35, 1.7)))
    pose = best_places(image, patch_pyramid, (space, None), 64)[0][0]
    assert np.hypot(pose.x - 703.4, pose.y - 598.1) < 10
    assert abs(pose.pixel_size_m / pixel_m - 1) < 0.02


def test_a_pose_is_not_refined_to_a_pixel_size_that_was_not_asked_for(patch_pyramid, image_at):
    image = image_at(703.4, 598.1, 41.0, 0.7, 128)
    space = search_space(patch_pyramid, Prior(pixel_size_range=(1.2, 1.6)))
    poses, _ = best_places(image, patch_pyramid, (space, None), 64)
    assert all(1.0 < pose.pixel_size_m < 1.9 for pose in poses)


def test_a_score_is_moved_to_another_size_by_what_chance_gives_there():
    chance = ChanceLevels(np.log([1.0, 2.0]), np.array([0.6, 0.4]))
    assert np.arctanh(chance.moved(np.tanh(0.9), 1.0, 2.0)) == pytest.approx(0.7)
    assert chance.moved(0.5, 1.5, 1.5) == pytest.approx(0.5)
    assert chance.moved(np.tanh(0.1), 1.0, 2.0) == 0.0


def test_chance_is_the_median_of_enough_good_peaks():
    scores = np.tanh(np.concatenate([[2.0], np.full(20, 0.3)]))
    peaks = np.array([(score, 0.0, 0.0, 0.0, size) for size in (1.0, 1.2) for score in scores])
    assert chance_levels(peaks, np.array([1.0, 1.2])).levels == pytest.approx([0.3, 0.3])
    assert (chance_levels(peaks[:24], np.array([1.0, 1.2])).levels == 0).all()


def test_sizes_with_enough_peaks_decide_for_the_others():
    sizes = np.array([0.8, 1.0, 1.2])
    # Refined peaks have their own sizes.
    peaks = np.array([(np.tanh(0.3), 0.0, 0.0, 0.0, size) for size in (*[1.03] * 20, *[1.21] * 5)])
    chance = chance_levels(peaks, sizes, are_chosen=True)
    assert chance.at(sizes) == pytest.approx([0.3] * 3)
    assert (chance_levels(peaks[:5], sizes, are_chosen=True).levels == 0).all()


def test_decoys_are_looked_for_at_the_sizes_next_to_the_best(patch_pyramid):
    space = search_space(patch_pyramid, Prior(pixel_size_range=(0.5, 2.0)))
    sizes = near_size(space, 1.0).pixel_sizes_m
    assert 1 <= len(sizes) <= 3 and np.abs(np.log(sizes)).max() <= np.log(1.2) + 1e-9
    assert len(near_size(space, 0.1).pixel_sizes_m) == 1


def test_a_prior_bounds_what_is_searched(patch_pyramid):
    prior = Prior((500_700.0, 5_199_400.0), 200.0, 5.0, 20.0, (0.9, 1.15))
    space = search_space(patch_pyramid, prior)
    assert space.box_m == (500.0, 400.0, 900.0, 800.0)
    assert np.abs((space.headings_deg - 5 + 180) % 360 - 180).max() < 20 and len(space.headings_deg) >= 3
    assert 0.9 < space.pixel_sizes_m.min() < space.pixel_sizes_m.max() < 1.15
    anywhere = search_space(patch_pyramid, Prior(pixel_size_range=(0.9, 1.15)))
    assert anywhere.box_m == (0.0, 0.0, 1440.0, 1200.0) and len(anywhere.headings_deg) == 25


@pytest.mark.parametrize(
    "value, said",
    [(0, "Only 0% of the image has classes of the map"), (3, "hardly more than one class"), (None, "None")],
)
def test_an_image_without_labels_or_of_one_class_has_no_place(patch_pyramid, patches, value, said):
    labels = patches[:200, :200] if value is None else np.full((200, 200), value, np.uint8)
    missing = missing_information(evidence_level(labels, patch_pyramid.space, (32, 32)), patch_pyramid)
    assert said in str(missing)


HERE, ELSEWHERE = (1300.0, 1000.0), (2000.0, 1450.0)
PARTS = {"left": np.s_[:, :175], "right": np.s_[:, 385:], "upper": np.s_[:175], "lower": np.s_[385:]}


@pytest.mark.slow
@pytest.mark.parametrize("name", PARTS)
@pytest.mark.parametrize("noise", [None, MODEST])
def test_the_part_that_shows_another_place_is_named(labels, pyramid, name, noise):
    image = view(labels, HERE, 40, 1.0)
    image[PARTS[name]] = view(labels, ELSEWHERE, 40, 1.0)[PARTS[name]]
    found = localize(image if noise is None else spoiled(image, noise, 7), pyramid, PRIOR)
    assert found.is_fix and error_m(found.best, HERE) < 10
    assert str(found.reason).startswith(f"In the {name} part of the image, classes hardly match the map")
    values = dict(found.reason.values)
    assert values["agreement"] < 0.5 * values["whole"]


@pytest.mark.slow
@pytest.mark.parametrize("noise", [None, MODEST, STRONG])
@pytest.mark.parametrize("center", [HERE, ELSEWHERE, (700.0, 1200.0)])
def test_an_image_of_one_place_agrees_in_all_its_parts(labels, pyramid, noise, center):
    image = view(labels, center, 75, 1.1)
    found = localize(image if noise is None else spoiled(image, noise, 3), pyramid, PRIOR)
    assert found.is_fix and found.reason is None


def test_a_place_of_another_method_is_compared_part_by_part_too(labels, pyramid):
    image = view(labels, HERE, 40, 1.0)
    place = localize(image, pyramid, PRIOR).best
    assert part_against(image, pyramid, place) is None
    image[PARTS["lower"]] = view(labels, ELSEWHERE, 40, 1.0)[PARTS["lower"]]
    assert dict(part_against(image, pyramid, place).values)["part"].template == "lower part"
