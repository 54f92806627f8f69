"""Descriptions of triangles, compared with numbers worked out by hand."""

import numpy as np
import pytest

from semref.core.constellation.triangles import ORDERS, canonical_order, describe_triangles

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
