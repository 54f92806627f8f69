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
from semref.core.constellation.triangles import ORDERS, canonical_order, describe_triangles, neighbor_pairs
from semref.core.database.model import MapLandmarks

REACH = np.full((40, 5), 0.02)


def test_each_of_its_own_triangles_is_found(index):
    # 40 of the index's own triangles: their numbers, descriptions and labels.
    chosen = np.random.default_rng(5).choice(len(index.triangles), 40, replace=False)
    members = np.column_stack(index.members(chosen))
    numbers = describe_triangles(index.points[members], index.log_areas[members])
    which, first, last = key_ranges(index, numbers, index.ranks[members], REACH)
    stretch, hits = expand_ranges(first, last)
    hits, source = similar_triangles(index, hits, which[stretch], numbers, REACH)
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


RIGHT_ANGLE = np.array([[0j, 5 + 0j, 1.8 + 2.4j]])
"""Sides 3, 4 and 5; C is nearer to A, above AB."""
LOG_AREAS = np.log([[4.0, 9.0, 25.0]])


def made_triangles(seed, count=50):
    rng = np.random.default_rng(seed)
    return rng.normal(size=(count, 3)) + 1j * rng.normal(size=(count, 3)), rng.uniform(1, 4, (count, 3))


def test_a_known_triangle_has_the_numbers_worked_out_by_hand():
    numbers = describe_triangles(RIGHT_ANGLE, LOG_AREAS)
    np.testing.assert_allclose(numbers, [[0.36, 0.48, *np.log([4 / 25, 9 / 25, 1.0])]], atol=1e-12)


@pytest.mark.parametrize("turn", [1j, 2.5 + 0j, 0.3 - 0.7j])
def test_turning_moving_and_scaling_change_no_number(turn):
    points, log_areas = made_triangles(1)
    moved = describe_triangles(points * turn + (300 - 20j), log_areas + 2 * np.log(abs(turn)))
    np.testing.assert_allclose(moved, describe_triangles(points, log_areas), atol=1e-8)


def test_a_mirrored_triangle_differs_only_in_its_handedness():
    points, log_areas = made_triangles(2)
    there, mirrored = describe_triangles(points, log_areas), describe_triangles(-points.conj(), log_areas)
    np.testing.assert_allclose(mirrored, there * [1, -1, 1, 1, 1], atol=1e-8)
    assert np.abs(there[:, 1]).min() > 1e-3


def test_whatever_order_the_members_come_in_the_vertices_are_named_alike():
    for members in ORDERS:
        given = RIGHT_ANGLE[:, members]
        order, sides = canonical_order(given)
        np.testing.assert_allclose(given[0, ORDERS[order[0]]], RIGHT_ANGLE[0])
        np.testing.assert_allclose(sides, [[3.0, 4.0, 5.0]])
