"""Displaced objects: shifted classes, leaning roofs, displaced neighborhoods."""

import numpy as np
import pytest
from made_labels import squares

from semref.core.landmarks.landmarks import extract_landmarks
from semref.core.simulation.displacement import displace, with_leaning_roofs
from semref.core.simulation.noise import LabelNoise


def moves(labels_hw, value):
    """Return (n, 2) displacements of the squares of a class."""
    before, after = (extract_landmarks(each, (value,), 50).centers_xy for each in (squares(), labels_hw))
    return np.array([center - before[np.hypot(*(before - center).T).argmin()] for center in after])


def test_a_class_is_shifted_and_what_it_leaves_is_filled():
    labels = displace(squares(), LabelNoise(class_shifts=((2, 3.0, -2.0),)), np.random.default_rng(0))
    np.testing.assert_allclose(moves(labels, 2), np.tile([3.0, -2.0], (50, 1)))
    assert not moves(labels, 1).any()
    assert set(np.unique(labels)) == {1, 2, 7} and (labels != 7).sum() == (squares() != 7).sum()


def test_shifts_of_less_than_a_pixel_remain_where_boundaries_jitter():
    off = []
    for seed in range(8):
        noise = LabelNoise(jitter=1.5, class_shifts=((2, 0.4, 0.0),))
        off.append(moves(displace(squares(), noise, np.random.default_rng(seed)), 2).mean(axis=0))
    assert np.mean(off, axis=0) == pytest.approx((0.4, 0.0), abs=0.15)


def test_roofs_lean_away_from_the_center_by_that_share():
    noise = LabelNoise(leaning=0.02, leaning_spread=0.0, leaning_classes=(2,))
    labels = with_leaning_roofs(squares(), noise, np.random.default_rng(0), (1, 2), 1)
    before = extract_landmarks(squares(), (2,), 50).centers_xy
    np.testing.assert_allclose(moves(labels, 2), 0.02 * (before - 200), atol=0.51)
    assert not moves(labels, 1).any()


def test_displaced_neighborhoods_move_together():
    noise = LabelNoise(displaced=3.0, displaced_kernels=((2000.0, 1.0),))
    means, spreads = [], []
    for seed in range(12):
        off = moves(displace(squares(), noise, np.random.default_rng(seed)), 1)
        means.append(off.mean(axis=0))
        spreads.append(off.std(axis=0).mean())
    assert np.std(means) == pytest.approx(3.0, rel=0.4) and np.mean(spreads) < 2.0
