import dataclasses

import numpy as np
import pytest

from semref.core.constellation import lookup
from semref.core.constellation.hypotheses import query_triangles
from semref.core.constellation.index import similar_triangles
from semref.core.constellation.lookup import Lookup, _fitted, find_seeds
from semref.core.constellation.neighbors import ClassMatcher, SteppedMatcher
from semref.core.constellation.settings import CONSTELLATION
from semref.core.geometry.pose import fit_similarity
from semref.core.localization import Prior

ORIGIN = (500_000.0, 5_200_000.0)
SCALES = (0.4, 2.5)
TRUE = (900.0, 1100.0, 70.0, 1.1)
"""East and north of the origin, heading and pixel size of the cut."""
RANKS = np.array([0, 1, 2, -1, 1])


def lookup_of(index, query, prior):
    return Lookup(index, query, query_triangles(query, CONSTELLATION, CONSTELLATION.limits.anchors[0]), prior)


def seeds_of(index, query, prior):
    return find_seeds(lookup_of(index, query, prior), 10**7)


def same_seeds(one, other):
    assert one.capped == other.capped and len(one.votes) == len(other.votes) > 0
    for name in ("centers", "turns", "focuses", "votes"):
        np.testing.assert_allclose(getattr(one, name), getattr(other, name), rtol=1e-12, atol=1e-9)


@pytest.mark.parametrize("place", [TRUE, (700.0, 800.0, 0.0, 0.8), (1200.0, 1000.0, 251.0, 1.6)])
def test_the_true_pose_has_the_most_votes(index, cut, place):
    made = cut(*place)
    seeds = seeds_of(index, made.query, Prior(pixel_size_range=SCALES))
    assert abs(seeds.centers[0] - made.pose.center) < 5
    assert abs(seeds.turns[0] / made.pose.turn - 1) < 0.02
    assert not seeds.capped and (np.diff(seeds.votes) <= 0).all()


def test_poses_are_the_fits_of_triangles_whose_classes_agree(index, cut):
    query = cut(*TRUE).query
    triple, hits = query_triangles(query, CONSTELLATION, CONSTELLATION.limits.anchors[0]).members[:3], np.arange(900)
    members, source = np.column_stack(index.members(hits)), hits % 3
    same = (index.ranks[members] == query.ranks[triple[source]]).all(axis=1)
    assert 0 < same.sum() < len(hits) and index.keys_tell_classes
    # With ten classes, triangles of different classes share a key.
    many = dataclasses.replace(index, class_values=np.arange(10, dtype=np.uint8))
    found = _fitted(many, query, triple, source, hits)
    image = query.points[triple[source[same]]]
    expected = fit_similarity(image, index.points[members[same]], np.ones(image.shape))
    for part, wanted in zip(found, (*expected, image.mean(axis=1))):
        np.testing.assert_allclose(part, wanted, rtol=1e-9, atol=1e-6)
    some = _fitted(index, query, triple, source[same], hits[same])
    assert all(np.array_equal(*parts) for parts in zip(found, some))


def test_the_mirrored_image_has_far_fewer_votes_for_any_pose(index, cut):
    made, prior = cut(*TRUE), Prior(pixel_size_range=SCALES)
    votes = [seeds_of(index, query, prior).votes.max() for query in (made.query, made.query.mirrored())]
    assert votes[1] < votes[0] / 5


def test_no_seed_is_outside_the_prior(index, cut):
    query = cut(*TRUE).query
    prior = Prior((ORIGIN[0] + 1300, ORIGIN[1] + 700), 250.0, 200.0, 60.0, (0.7, 1.9))
    seeds = seeds_of(index, query, prior)
    assert len(seeds.votes)
    assert np.abs(seeds.centers + index.origin - complex(*prior.position)).max() <= 250
    assert np.abs((-np.degrees(np.angle(seeds.turns)) - 200 + 180) % 360 - 180).max() <= 60
    assert np.abs(seeds.turns).min() > 0.69 and np.abs(seeds.turns).max() < 1.91


def test_a_cap_that_leaves_hits_out_is_reported(index, cut):
    query = cut(*TRUE).query
    prior = Prior(pixel_size_range=SCALES)
    everything = seeds_of(index, query, prior)
    few = find_seeds(lookup_of(index, query, prior), 300)
    assert few.capped and few.votes.sum() < everything.votes.sum()


def test_a_search_that_looks_farther_goes_on_from_what_was_looked_up(index, cut, monkeypatch):
    monkeypatch.setattr(lookup, "PORTION", 150)
    looked, query = [], cut(*TRUE).query

    def like(index, hits, *args):
        looked.append(len(hits))
        return similar_triangles(index, hits, *args)

    monkeypatch.setattr(lookup, "similar_triangles", like)
    farther = lookup_of(index, query, Prior(pixel_size_range=SCALES))
    counts = []
    for cap in (300, 900, 10**7, 900):
        looked.clear()
        found = find_seeds(farther, cap)
        counts.append(sum(looked))
        looked.clear()
        same_seeds(found, find_seeds(lookup_of(index, query, Prior(pixel_size_range=SCALES)), cap))
        counts.append(sum(looked))
    first, alone, second, both, rest, everything, again, once_more = counts
    assert 0 < first == alone < both < everything
    assert second == both - first and rest == everything - both
    # A lower limit can't leave anything out here.
    assert again == once_more == both


def test_the_mirrored_image_is_looked_up_as_such_with_no_heading_known(index, cut):
    query, prior = cut(*TRUE).query, Prior(None, None, 70.0, 5.0, SCALES)
    mirrored = lookup_of(index, query, prior).mirrored()
    same_seeds(find_seeds(mirrored, 10**7), seeds_of(index, query.mirrored(), Prior(pixel_size_range=SCALES)))


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
