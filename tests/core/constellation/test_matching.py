"""Matches of made landmarks at poses of a cut of a made catalogue."""

import numpy as np
import pytest

from semref.core.constellation.matching import (
    Nearest,
    center_noise,
    matched_within,
    nearest_objects,
    noise_factor,
)
from semref.core.constellation.settings import CONSTELLATION
from semref.core.geometry.pose import Pose, fit_similarity


@pytest.mark.parametrize("count", [5, 12, 200])
def test_noise_is_measured_without_bias_from_few_matches_or_many(count):
    rng = np.random.default_rng(count)
    factors = []
    for _ in range(300):
        image = rng.uniform(-600, 600, count) + 1j * rng.uniform(-600, 600, count)
        on_map = image + rng.normal(size=count) + 1j * rng.normal(size=count)
        center, turn = fit_similarity(image, on_map, np.ones(count))
        factors.append(noise_factor(np.abs(center + turn * image - on_map), 4) ** 2)
    assert np.mean(factors) == pytest.approx(1, abs=0.08)


def test_a_few_exact_matches_do_not_make_the_noise_vanish():
    assert noise_factor(np.zeros(4), 4) > 0.7 > noise_factor(np.zeros(40), 4)


def test_noise_is_that_of_pixels_and_of_the_size_together():
    noise = center_noise(np.log([100.0, 400.0]), 2.0, CONSTELLATION.noise)
    assert noise == pytest.approx(2.0 * np.hypot(0.7, [1.0, 2.0]))


def test_of_those_that_share_an_object_only_the_nearest_matches_and_only_within_its_end():
    """One by one: whoever is nearest to an object of the map has it, though it may itself be too far."""
    rng = np.random.default_rng(7)
    for _ in range(40):
        count, objects = int(rng.integers(1, 30)), int(rng.integers(1, 12))
        # Whole numbers tie; of these the first is nearest.
        distances = rng.integers(0, 8, (5, count)).astype(float)
        nearest = Nearest(distances, rng.integers(-1, objects, (5, count)), np.ones((5, count)))
        nearest.distances[nearest.objects < 0] = np.inf
        ends = rng.integers(0, 9, (5, count)).astype(float)
        expected = np.zeros((5, count), bool)
        for pose in range(5):
            for number in range(objects):
                sharing = np.flatnonzero(nearest.objects[pose] == number)
                if len(sharing):
                    first = sharing[np.argmin(distances[pose, sharing])]
                    expected[pose, first] = distances[pose, first] <= ends[pose, first]
        np.testing.assert_array_equal(matched_within(nearest, ends), expected)


def test_what_is_nearest_at_several_poses_is_what_is_nearest_at_each(index, cut):
    made = cut(900.0, 1100.0, 70.0, 1.1)
    poses = [made.pose, Pose(made.pose.center + 80, made.pose.turn * 1.2), Pose(0j, 1j, 0.01 + 0j, 1e-4 + 0j)]
    together = nearest_objects(index, made.query, poses)
    for number, pose in enumerate(poses):
        alone = nearest_objects(index, made.query, [pose])
        for name in ("distances", "objects", "deviations"):
            np.testing.assert_array_equal(getattr(together, name)[number], getattr(alone, name)[0])
    np.testing.assert_array_equal(together.objects[0], made.objects)


def test_noise_of_several_poses_is_that_of_each_whatever_has_no_match():
    rng = np.random.default_rng(3)
    rows = rng.rayleigh(1.3, (6, 40))
    rows[rng.random(rows.shape) < 0.5] = np.inf
    rows[3, 1:] = np.inf
    rows[3, 0] = 1.0
    each = [noise_factor(row[np.isfinite(row)], 4) for row in rows]
    assert noise_factor(rows, 4) == pytest.approx(each, rel=1e-12)
    assert len(set(each)) == len(rows)
