from dataclasses import replace

import numpy as np
import pytest

from semref.core.correlation.class_pyramid import MapPyramid, evidence_level
from semref.core.correlation.compare import NOT_COMPARABLE, compare
from semref.core.correlation.exactness import covariance_on_map
from semref.core.correlation.refine import ScoredPose, is_held_by_edge, map_under, pose_covariance, refine, score_at
from semref.core.correlation.refine_many import refine_many
from semref.core.correlation.search import SearchSpace, search
from semref.core.geometry.frame import MapFrame
from semref.core.geometry.radius import CIRCLE_95
from semref.core.simulation.views import View, cut

TRUE = ScoredPose(703.4, 598.1, 41.0, 1.03)
PIXEL_M = 500 / 64 * TRUE.pixel_size_m
"""Size of one evidence pixel on the ground."""
HEADINGS = np.arange(0.0, 360.0, 30.0)


@pytest.fixture(scope="module")
def image(image_at):
    return image_at(TRUE.x, TRUE.y, TRUE.heading_deg, TRUE.pixel_size_m)


@pytest.mark.parametrize("x, y, heading, growth", [(6, -5, 0, 1), (-4, 3, 2, 1.01), (0, 0, -3, 0.98)])
def test_a_pose_beside_the_true_one_is_moved_there_finer_than_a_pixel(patch_pyramid, image, x, y, heading, growth):
    start = ScoredPose(TRUE.x + x, TRUE.y + y, TRUE.heading_deg + heading, TRUE.pixel_size_m * growth)
    found = refine(image, patch_pyramid, start, patch_pyramid.quiet, 8)
    assert np.hypot(found.x - TRUE.x, found.y - TRUE.y) < 0.2 * PIXEL_M
    assert abs(found.heading_deg - TRUE.heading_deg) < 0.3
    assert found.pixel_size_m == pytest.approx(TRUE.pixel_size_m, rel=0.005)
    assert found.score > score_at(image, patch_pyramid, start, patch_pyramid.quiet)


def test_the_score_is_high_at_the_true_pose_and_missing_beside_the_map_where_the_edge_holds_it(patch_pyramid, image):
    places = [TRUE, ScoredPose(TRUE.x + 150, TRUE.y - 80, 41.0, 1.03), ScoredPose(-3000, 0, 0, 1)]
    here, there, beside = (score_at(image, patch_pyramid, place, patch_pyramid.quiet) for place in places)
    assert here > 0.8 and there < 0.4 and beside == NOT_COMPARABLE
    assert [is_held_by_edge(image, patch_pyramid, p, patch_pyramid.quiet) for p in places] == [False, False, True]


def test_the_radius_contains_the_errors_of_noisy_labels_and_grows_with_them(patches, patch_pyramid):
    view = View(TRUE.x, -TRUE.y, TRUE.heading_deg, TRUE.pixel_size_m, 500, 500)
    labels, radii = cut(patches, MapFrame.at((0.0, 0.0), 4.0), view), []
    beside = ScoredPose(TRUE.x + 3, TRUE.y - 2, TRUE.heading_deg + 1, TRUE.pixel_size_m)
    for noise in (0.1, 0.3, 0.6):
        spreads, units = [], []
        for seed in range(30):
            wrong, other = np.random.default_rng(seed).random((2, 20, 20)).repeat(25, axis=1).repeat(25, axis=2)
            spoiled = np.where(wrong < noise, 1 + (5 * other).astype(np.uint8), labels)
            seen = evidence_level(spoiled, patch_pyramid.space, (128, 128))
            found = refine(seen, patch_pyramid, beside, patch_pyramid.quiet, 12)
            spread = covariance_on_map(found, pose_covariance(seen, patch_pyramid, found, patch_pyramid.quiet))[:2, :2]
            off = np.array([found.x - TRUE.x, TRUE.y - found.y])
            units.append(np.sqrt(off @ np.linalg.solve(spread, off)) / CIRCLE_95)
            spreads.append(np.trace(spread))
        assert 0.25 < np.percentile(units, 95) < 1.1, noise
        radii.append(np.median(spreads))
    assert 4 * radii[0] < 2 * radii[1] < radii[2]


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("place", [TRUE, ScoredPose(-3000, 0, 0, 1)])
def test_an_image_of_one_class_agrees_nowhere_and_its_covariance_is_infinite(patch_pyramid, image, place):
    alike = type(image)(np.ones_like(image.evidence), image.known, image.pixel)
    (found,) = refine_many(alike, patch_pyramid, [place], 0.0, 2)
    assert found.score == (0.0 if place is TRUE else NOT_COMPARABLE)
    assert np.isinf(pose_covariance(alike, patch_pyramid, place, patch_pyramid.quiet)).all()


@pytest.mark.parametrize("x, y, heading, size", [(600, 500, 0, 1.0), (850, 640, 120, 1.0), (700, 600, 300, 1.2)])
def test_the_true_place_turn_and_scale_have_the_highest_score(patch_pyramid, image_at, x, y, heading, size):
    space = SearchSpace(HEADINGS, np.array([0.8, 1.0, 1.2]), (0.0, 0.0, 1440.0, 1200.0))
    best = search(image_at(x, y, heading, size, 32), patch_pyramid, space)[0]
    assert np.hypot(best[1] - x, best[2] - y) < 16 * size
    assert (best[3], best[4]) == (heading, size)
    assert best[0] > 0.6


def test_peaks_are_sorted_by_score_inside_the_box_and_missing_beside_the_map(patch_pyramid, image_at):
    image, pixel = image_at(850, 640, 120, 1.0, 32), 500 / 32
    inside, beside = (700.0, 500.0, 1000.0, 800.0), (9000.0, 9000.0, 9400.0, 9400.0)
    found, none = (search(image, patch_pyramid, SearchSpace(HEADINGS, np.ones(1), box)) for box in (inside, beside))
    assert len(found) > 3 and (np.diff(found[:, 0]) <= 0).all()
    assert (found[:, 1:3] >= (700, 500)).all() and (found[:, 1:3] <= (1000 + pixel, 800 + pixel)).all()
    assert none.shape == (0, 5)


def spoiled(labels, share, seed):
    """Return labels with blocks of 25 × 25 pixels in random classes on a share of the area."""
    wrong, other = np.random.default_rng(seed).random((2, 20, 20)).repeat(25, axis=1).repeat(25, axis=2)
    return np.where(wrong < share, 1 + (5 * other).astype(np.uint8), labels)


@pytest.mark.parametrize("beyond_px", [0, -20])
def test_the_edge_of_the_map_does_not_attract_an_image_that_shows_ground_beyond_it(patches, beyond_px):
    frame, edge = MapFrame.at((0.0, 0.0), 4.0), patches.copy()
    edge[: round(TRUE.y / 4) + beyond_px] = 0
    pyramid = MapPyramid(edge, frame)
    labels = cut(patches, frame, View(TRUE.x, -TRUE.y, TRUE.heading_deg, TRUE.pixel_size_m, 500, 500))
    start, found = replace(TRUE, pixel_size_m=1.01 * TRUE.pixel_size_m), []
    for seed in range(20):
        seen = evidence_level(spoiled(labels, 0.3, seed), pyramid.space, (64, 64))
        found.append(refine(seen, pyramid, start, pyramid.quiet, 12).y)
    assert np.mean(found) == pytest.approx(TRUE.y, abs=0.3)


def test_poor_labels_are_compared_at_the_norm_of_the_map(patches, patch_pyramid):
    frame = MapFrame.at((0.0, 0.0), 4.0)
    labels = cut(patches, frame, View(TRUE.x, -TRUE.y, TRUE.heading_deg, TRUE.pixel_size_m, 500, 500))
    seen = evidence_level(spoiled(labels, 0.6, 0), patch_pyramid.space, (64, 64))
    found = compare(seen, *map_under(seen, patch_pyramid, TRUE), patch_pyramid.quiet)
    assert np.linalg.norm(found.seen) == pytest.approx(np.linalg.norm(found.there), rel=1e-4)
    assert 0.2 < found.score < 0.5
