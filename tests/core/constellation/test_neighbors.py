"""Nearest landmarks of a class, for points that move step by step."""

from __future__ import annotations

import numpy as np

from semref.core.constellation.neighbors import ClassMatcher, SteppedMatcher

RANKS = np.array([0, 1, 2, -1, 1])


def complex_points(rng, *shape, size):
    return rng.uniform(-size, size, shape) + 1j * rng.uniform(-size, size, shape)


def test_a_landmark_within_reach_is_found_after_every_step_and_a_far_one_never_counts_as_near():
    rng = np.random.default_rng(5)
    # Class 2 has no landmark; coordinates as on a map of a continent, where 32 bits resolve half a meter.
    matcher = ClassMatcher(complex_points(rng, 4000, size=3e6), rng.integers(0, 2, 4000))
    stepped, places = SteppedMatcher(matcher, RANKS, 500), complex_points(rng, 500, len(RANKS), size=3e6)
    skipped, some = 0, np.arange(0, 500, 2)
    for which, reach in ((None, 60_000.0), (None, 30_000.0), (some, np.full((250, 1), 20_000.0))):
        places = places if which is None else places[which]
        distances, objects = stepped.match(places, reach, which)
        expected, of_map = matcher.match(places, RANKS)
        near = expected <= reach
        assert near.any() and (near == (distances <= reach)).all()
        np.testing.assert_array_equal(distances[near], expected[near])
        np.testing.assert_array_equal(objects[near], of_map[near])
        skipped += np.isinf(distances[:, RANKS < 2]).sum()
        places = places + complex_points(rng, *places.shape, size=9000.0)
    assert skipped > 500


def test_only_wanted_points_are_matched():
    matcher = ClassMatcher(np.array([0j, 10 + 0j]), np.array([0, 0]))
    distances, objects = matcher.match(np.array([[1 + 0j, 9 + 0j]]), np.array([0, 0]), np.array([[False, True]]))
    assert objects.tolist() == [[-1, 1]] and distances.tolist() == [[np.inf, 1.0]]
