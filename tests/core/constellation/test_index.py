"""The index finds its own triangles, and no triangles with other labels."""

import numpy as np
import pytest

from semref.core.constellation.index import (
    _kind_of_codes,
    ascending_order,
    build_index,
    expand_ranges,
    key_ranges,
    similar_triangles,
)
from semref.core.constellation.settings import CONSTELLATION
from semref.core.constellation.triangles import ORDERS, describe_triangles, neighbor_pairs
from semref.core.database.model import MapLandmarks

REACH = np.full((40, 5), 0.02)


@pytest.fixture(scope="module")
def asked(index):
    """Return 40 of the index's own triangles: their numbers, descriptions and labels."""
    chosen = np.random.default_rng(5).choice(len(index.triangles), 40, replace=False)
    members = np.column_stack(index.members(chosen))
    return chosen, describe_triangles(index.points[members], index.log_areas[members]), index.ranks[members]


def hits_of(index, numbers, ranks):
    which, first, last = key_ranges(index, numbers, ranks, REACH)
    stretch, hits = expand_ranges(first, last)
    source = which[stretch]
    like, source = similar_triangles(index, hits, source, numbers, REACH)
    return source, like


def test_each_of_its_own_triangles_is_found(index, asked):
    chosen, numbers, ranks = asked
    source, hits = hits_of(index, numbers, ranks)
    assert {(k, one) for k, one in enumerate(chosen)} <= set(zip(source.tolist(), hits.tolist()))
    assert len(hits) < 40 * 10


def test_objects_in_a_box_equal_those_of_a_search_through_all(index):
    low, high = -300 - 150j, 420 + 610j
    x, y = index.points.real, index.points.imag
    inside = (x >= low.real) & (x <= high.real) & (y >= low.imag) & (y <= high.imag)
    assert 50 < inside.sum() < 400
    assert sorted(index.within(low, high)) == np.flatnonzero(inside).tolist()


@pytest.mark.parametrize("bits", [9, 16, 31, 47])
def test_integers_are_ordered_like_by_a_stable_sort(bits):
    keys = np.random.default_rng(bits).integers(0, 2**bits, 5000) // 3 * 3
    keys[::7] = keys[0]
    kinds = (np.uint32, np.int64) if bits < 32 else (np.int64,)
    for kind in kinds:
        np.testing.assert_array_equal(ascending_order(keys.astype(kind)), np.argsort(keys, kind="stable"))
    assert ascending_order(keys[:0]).shape == (0,)


def test_objects_cut_by_the_edge_make_no_triangles(catalogue):
    cut = np.arange(len(catalogue.classes)) % 3 == 0
    landmarks = MapLandmarks(catalogue.positions, catalogue.classes, catalogue.areas_m2, cut)
    index = build_index(landmarks, 1.0)
    members = np.column_stack(index.members(np.arange(len(index.triangles))))
    assert len(members) > 1000 and not cut[members].any()


@pytest.mark.parametrize("count", [10_000, 23_000_000, 24_000_000, 60_000_000])
def test_the_code_of_the_last_triangle_fits_its_kind_whatever_the_number_of_landmarks(count):
    kind = np.dtype(_kind_of_codes(count, CONSTELLATION))
    last = count * len(neighbor_pairs(CONSTELLATION.limits.neighbors)) * len(ORDERS) - 1
    assert last <= np.iinfo(kind).max
    # Smaller codes use half the memory.
    assert (kind == np.int32) == (last <= np.iinfo(np.int32).max)
