"""Pieces of a map show what the map shows."""

import numpy as np

from semref.core.labels.sources import ArrayLabels


def test_a_piece_is_a_view_of_the_labels():
    labels = np.random.default_rng(1).integers(0, 9, (150, 190)).astype(np.uint8)
    source = ArrayLabels(labels)
    piece = source.read(20, 30, 100, 90)
    assert source.shape_hw == (150, 190) and np.shares_memory(piece, labels)
    np.testing.assert_array_equal(piece, labels[30:120, 20:120])
