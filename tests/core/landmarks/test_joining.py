"""Pieces that touch, by a border, by a corner or through others, are one."""

import cv2
import numpy as np

from semref.core.landmarks.joining import connected_components, touching_runs


def test_runs_of_a_picture_join_to_its_connected_regions():
    for seed in range(5):
        mask = (np.random.default_rng(seed).random((40, 50)) < 0.4).astype(np.uint8)
        steps = np.diff(np.pad(mask, ((0, 0), (1, 1))).astype(int), axis=1)
        rows, starts = np.nonzero(steps == 1)
        stops = np.nonzero(steps == -1)[1]
        found = connected_components(len(rows), touching_runs(rows, starts, stops))
        count, parts = cv2.connectedComponents(mask, connectivity=8)
        assert len(np.unique(found)) == count - 1
        assert len(set(zip(found.tolist(), parts[rows, starts].tolist()))) == count - 1


def test_runs_touch_by_a_corner_but_not_over_a_gap_or_a_row():
    rows, starts, stops = np.array([0, 0, 1, 1, 3]), np.array([0, 7, 3, 9, 3]), np.array([3, 8, 6, 12, 6])
    assert touching_runs(rows, starts, stops).tolist() == [[0, 2]]


def test_components_are_numbered_in_order_of_their_first():
    assert connected_components(6, np.array([[5, 0], [4, 3], [1, 5]])).tolist() == [0, 0, 1, 2, 2, 0]
    assert connected_components(2, np.empty((0, 2), int)).tolist() == [0, 1]
