"""The displacement between two maps equals the known displacement of their landmarks."""

import numpy as np
import pytest

from semref.core.landmarks.class_shifts import PieceShift, piece_shifts
from semref.core.landmarks.displacement import correlations_of, displacement_of
from semref.core.simulation.fields import correlated_shifts

KERNELS = ((60.0, 0.4), (2000.0, 0.4))


def piece(points, offsets, corner=0j):
    return PieceShift(1, len(points), 0j, 1.0, points, offsets, corner)


def points_of(rng, count, size=3000.0):
    return rng.uniform(0, size, (count, 2)) @ (1, 1j)


def test_deviation_and_share_moved_are_those_of_the_offsets():
    rng = np.random.default_rng(1)
    offsets = 2.0 * (rng.normal(size=4000) + 1j * rng.normal(size=4000))
    offsets[:3000] = 0.02
    found = displacement_of([piece(points_of(rng, 4000), offsets)], pixel_size=0.5)
    assert (found.pairs, found.moved) == (4000, pytest.approx(0.25, abs=0.01))
    assert found.moved_deviation == pytest.approx(1.0, rel=0.05)
    assert found.deviation == pytest.approx(0.5, rel=0.05)
    assert all(abs(share) < 0.15 for _, _, share in found.correlations)


def test_correlations_are_those_of_the_field():
    rng = np.random.default_rng(2)
    total = []
    for _ in range(40):
        points = points_of(rng, 400)
        offsets = correlated_shifts(np.column_stack([points.real, points.imag]), KERNELS, rng) @ (1, 1j)
        offsets += 0.2**0.5 * (rng.normal(size=400) + 1j * rng.normal(size=400))
        total.append([share for _, _, share in correlations_of(points, offsets)])
    found = np.mean(total, axis=0)
    middles = np.array([20, 46, 93, 190, 385, 770, 1520])
    wanted = sum(share * np.exp(-middles / length) for length, share in KERNELS)
    np.testing.assert_allclose(found[:5], wanted[:5], atol=0.15)
    assert found[0] > found[3] > found[6]


def test_pieces_are_placed_by_their_corners():
    near, far = piece(np.arange(40) + 0j, np.ones(40) + 0j), piece(np.arange(40) + 0j, -np.ones(40) + 0j, 1500 + 0j)
    ranges = {low: share for low, _, share in displacement_of([near, far]).correlations}
    assert ranges[0] == pytest.approx(1) and ranges[1000] == pytest.approx(-1)


def test_pairs_of_label_images_have_their_places_and_offsets():
    true = np.zeros((200, 200), np.uint8)
    for row in range(10, 170, 40):
        for column in range(10, 170, 40):
            true[row : row + 12, column : column + 12] = 1
    found = displacement_of(piece_shifts(true, np.roll(true, (2, 3), (0, 1)), (1,), 100 + 0j), 2.0)
    assert (found.pairs, found.moved) == (16, 1.0)
    assert found.deviation == pytest.approx(2.0 * abs(3 + 2j) / 2**0.5)


def test_maps_without_common_landmarks_have_no_displacement():
    assert displacement_of([]) is None
    same = displacement_of([piece(np.zeros(5, complex), np.zeros(5, complex))])
    assert (same.moved, same.deviation, same.correlations) == (0.0, 0.0, ())
