"""Neighbors equal those of a search through all pairs."""

import numpy as np

from semref.core.constellation import neighbors
from semref.core.constellation.neighbors import ClassMatcher, nearest_larger


def test_the_matcher_finds_the_same_objects_as_a_search_through_all():
    rng = np.random.default_rng(3)
    points = rng.uniform(-500, 500, 200) + 1j * rng.uniform(-500, 500, 200)
    ranks, asked = rng.integers(0, 3, 200), rng.integers(0, 3, 30)
    places = rng.uniform(-500, 500, (4, 30)) + 1j * rng.uniform(-500, 500, (4, 30))
    distances, objects = ClassMatcher(points, ranks).match(places, asked)
    all_distances = np.abs(places[..., None] - points)
    all_distances[:, asked[:, None] != ranks] = np.inf
    np.testing.assert_array_equal(objects, all_distances.argmin(axis=2))
    np.testing.assert_allclose(distances, all_distances.min(axis=2), rtol=1e-3, atol=1e-3)


def test_an_object_of_an_unknown_class_has_no_match():
    distances, objects = ClassMatcher(np.array([0j, 5j]), np.array([0, 0])).match(
        np.zeros((1, 2), complex), np.array([-1, 0])
    )
    assert objects.tolist() == [[-1, 0]] and distances.tolist() == [[np.inf, 0.0]]


def test_nearest_larger_objects_equal_those_of_a_search_through_all(monkeypatch):
    rng = np.random.default_rng(4)
    points, areas = rng.uniform(0, 1000, (150, 2)), rng.permutation(150) + 1.0
    # As many candidates as there are objects: nothing is left out for the time.
    monkeypatch.setattr(neighbors, "CANDIDATES_PER_NEIGHBOR", 50)
    found = nearest_larger(points, areas, 3)
    for one in range(150):
        larger = np.flatnonzero(areas > areas[one])
        by_distance = larger[np.argsort(np.hypot(*(points[larger] - points[one]).T))][:3]
        assert [other for other in found[one] if other >= 0] == by_distance.tolist()
