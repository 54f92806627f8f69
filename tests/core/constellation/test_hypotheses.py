"""Seeds of a cut of a made catalogue, whose pose is known."""

import dataclasses

import numpy as np
import pytest

from semref.core.constellation import hypotheses
from semref.core.constellation.hypotheses import _poses, find_seeds, query_triangles
from semref.core.constellation.settings import CONSTELLATION
from semref.core.geometry.pose import fit_similarity
from semref.core.localization import Prior

ORIGIN = (500_000.0, 5_200_000.0)
SCALES = (0.4, 2.5)
TRUE = (900.0, 1100.0, 70.0, 1.1)
"""East and north of the origin, heading and pixel size of the cut."""


def seeds_of(index, query, prior):
    return find_seeds(index, query, query_triangles(query, CONSTELLATION), prior, 10**7)


@pytest.mark.parametrize("place", [TRUE, (700.0, 800.0, 0.0, 0.8), (1200.0, 1000.0, 251.0, 1.6)])
def test_the_true_pose_has_the_most_votes(index, cut, place):
    made = cut(*place)
    seeds = seeds_of(index, made.query, Prior(pixel_size_range=SCALES))
    assert abs(seeds.centers[0] - made.pose.center) < 5
    assert abs(seeds.turns[0] / made.pose.turn - 1) < 0.02
    assert not seeds.capped and (np.diff(seeds.votes) <= 0).all()


def test_no_cluster_is_told_twice(index, cut):
    seeds = seeds_of(index, cut(*TRUE).query, Prior(pixel_size_range=SCALES))
    assert len(set(zip(seeds.centers.tolist(), seeds.turns.tolist()))) == len(seeds.votes) > CONSTELLATION.seeds


def test_poses_are_the_fits_of_triangles_whose_classes_agree(index, cut):
    query = cut(*TRUE).query
    triple, hits = query_triangles(query, CONSTELLATION).members[:3], np.arange(900)
    members, source = np.column_stack(index.members(hits)), hits % 3
    same = (index.ranks[members] == query.ranks[triple[source]]).all(axis=1)
    assert 0 < same.sum() < len(hits) and index.keys_tell_classes
    # With ten classes triangles of several ones share a key.
    many = dataclasses.replace(index, class_values=np.arange(10, dtype=np.uint8))
    found = _poses(many, query, triple, source, hits)
    image = query.points[triple[source[same]]]
    expected = fit_similarity(image, index.points[members[same]], np.ones(image.shape))
    for part, wanted in zip(found, (*expected, image.mean(axis=1))):
        np.testing.assert_allclose(part, wanted, rtol=1e-9, atol=1e-6)
    some = _poses(index, query, triple, source[same], hits[same])
    assert all(np.array_equal(*parts) for parts in zip(found, some))


def test_the_mirrored_image_has_far_fewer_votes_for_any_pose(index, cut):
    made, prior = cut(*TRUE), Prior(pixel_size_range=SCALES)
    votes = [seeds_of(index, query, prior).votes.max() for query in (made.query, made.query.mirrored())]
    assert votes[1] < votes[0] / 5


def test_no_seed_lies_outside_the_prior(index, cut):
    query = cut(*TRUE).query
    prior = Prior((ORIGIN[0] + 1300, ORIGIN[1] + 700), 250.0, 200.0, 60.0, (0.7, 1.9))
    seeds = seeds_of(index, query, prior)
    assert len(seeds.votes)
    assert np.abs(seeds.centers + index.origin - complex(*prior.position)).max() <= 250
    assert np.abs((-np.degrees(np.angle(seeds.turns)) - 200 + 180) % 360 - 180).max() <= 60
    assert np.abs(seeds.turns).min() > 0.69 and np.abs(seeds.turns).max() < 1.91


def test_a_cap_leaves_hits_out_and_says_so(index, cut):
    query = cut(*TRUE).query
    triangles, prior = query_triangles(query, CONSTELLATION), Prior(pixel_size_range=SCALES)
    everything = find_seeds(index, query, triangles, prior, 10**7)
    few = find_seeds(index, query, triangles, prior, 300)
    assert few.capped and few.votes.sum() < everything.votes.sum()


@pytest.mark.parametrize("spread", [30, 300, 3_000_000])
def test_of_very_many_poses_the_fullest_cells_are_the_same_as_when_all_are_sorted(monkeypatch, spread):
    rng = np.random.default_rng(4)
    # Few cells, most of them full; many, of which some are; so many that hardly any holds two poses.
    cells = [rng.integers(-spread, spread, 30_000).astype(float) for _ in range(2)]
    values = rng.normal(size=30_000) + 1j * rng.normal(size=30_000), np.arange(30_000) * (1 + 0j)
    counted = hypotheses._cell_means(cells, values, 40)
    monkeypatch.setattr(hypotheses, "_SORTED_AT_ONCE", 10**9)
    everything = hypotheses._cell_means(cells, values, 40)
    assert len(counted[0]) == 40
    for one, other in zip(counted, everything):
        np.testing.assert_array_equal(one, other)


def test_objects_that_are_cut_or_of_unknown_class_make_no_triangles(cut):
    query = cut(*TRUE).query
    query.whole[::4] = False
    query.ranks[1::4] = -1
    triangles = query_triangles(query, CONSTELLATION)
    assert len(triangles) == len(triangles.numbers) == len(triangles.tolerances) > 50
    assert set(np.unique(triangles.members % 4)) == {2, 3}
