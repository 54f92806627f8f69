"""Labeled triangles: numbers of three landmarks that are equal in every image, at any scale and heading."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from .neighbors import nearest_larger

# Vertex order A, B, C for each of the six orders of a triple's members.
ORDERS = np.array([(0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)], np.int64)


def triples(points: np.ndarray, areas: np.ndarray, neighbor_count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return triples of a landmark and two of its nearest larger ones.

    Args:
        points: (N,) complex.
        areas: (N,) in the square of the same unit.
        neighbor_count: K, nearest larger landmarks of each.

    Returns:
        (N, K) int32 neighbors and (N, P) bool, which of the P = K (K − 1) / 2 ``neighbor_pairs`` exist.
    """
    points_xy = np.column_stack([points.real, points.imag])
    neighbors = nearest_larger(points_xy, areas, neighbor_count)
    pairs = neighbor_pairs(neighbor_count)
    exists = neighbors >= 0
    return neighbors, exists[:, pairs[:, 0]] & exists[:, pairs[:, 1]]


def neighbor_pairs(neighbor_count: int) -> np.ndarray:
    """Return (P, 2) pairs of neighbor ranks that form triples with their anchor."""
    return np.array(list(combinations(range(neighbor_count), 2)), np.int64).reshape(-1, 2)


def canonical_order(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Order the vertices: AB is the longest side, and C is nearer to A than to B.

    Args:
        points: (T, 3) complex.

    Returns:
        (T,) index into ORDERS, and (T, 3) side lengths in ascending order.
    """
    opposite = np.abs(points[:, (1, 2, 0)] - points[:, (2, 0, 1)])
    rank = np.argsort(opposite, axis=1, kind="stable")
    # B is opposite the shortest side, A opposite the middle one, C opposite the longest.
    order = _ORDER_OF_MEMBERS[rank[:, 1], rank[:, 0]]
    return order, np.take_along_axis(opposite, rank, axis=1)


def describe_triangles(points: np.ndarray, log_areas: np.ndarray) -> np.ndarray:
    """Return (T, 5) float64: C in the frame of AB (along, across), then ln(area / |AB|²) of A, B and C.

    They are invariant to rotation, shift and scale; a mirrored triangle has the opposite second number.

    Args:
        points: (T, 3) complex in the order A, B, C, y up.
        log_areas: (T, 3) ln of areas in the square of the same unit.
    """
    a, b, c = points.T
    side = b - a
    place = (c - a) / side
    sizes = log_areas - 2 * np.log(np.abs(side))[:, None]
    return np.column_stack([place.real, place.imag, sizes])


_ORDER_OF_MEMBERS = np.zeros((3, 3), np.int64)
for _number, (_a, _b, _c) in enumerate(ORDERS):
    _ORDER_OF_MEMBERS[_a, _b] = _number
