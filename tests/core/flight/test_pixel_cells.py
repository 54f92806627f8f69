"""Cells of shared ground, found again."""

from functools import partial

import cv2
import numpy as np
import pytest

from semref.core.flight.pixel_cells import CELL_PX, MOST_CELLS, SharedGround
from semref.core.flight.pixel_features import photo_features
from semref.core.flight.pixel_fit import similarity


def textured(shape, seed=0):
    noise = np.random.default_rng(seed).normal(0, 1, shape).astype(np.float32)
    return np.clip(128 + 300 * cv2.GaussianBlur(noise, (0, 0), 3), 0, 255).astype(np.uint8)


PICTURE = textured((300, 400))
SAME = partial(similarity, np.array([1.0, 0.0, 0.0, 0.0]))


def test_cells_are_found_where_they_lie():
    features = photo_features(PICTURE)
    ground = SharedGround(features, features, SAME)
    second, first = ground.found()
    assert ground.overlap == 1
    assert 20 < len(ground.corners) <= 2 * MOST_CELLS
    assert second == pytest.approx(first, abs=0.05)


def test_a_proposal_that_is_off_is_corrected_by_each_cell():
    features = photo_features(PICTURE)
    second, first = SharedGround(features, features, partial(similarity, np.array([1.0, 0, 2.5, -1.5]))).found()
    assert np.median(first - second, axis=0) == pytest.approx([0, 0], abs=0.1)


def test_cells_lie_in_the_overlap_only():
    features = photo_features(PICTURE)
    ground = SharedGround(features, features, partial(similarity, np.array([1.0, 0, 240.0, 0])))
    assert ground.overlap == pytest.approx(0.4, abs=0.03)
    assert ground.corners[:, 0].min() >= 240
    assert ground.corners[:, 0].max() <= 400 - CELL_PX


def test_flat_ground_has_no_cells():
    picture = PICTURE.copy()
    picture[:, :200] = 100
    features = photo_features(picture)
    assert SharedGround(features, features, SAME).corners[:, 0].min() > 150
