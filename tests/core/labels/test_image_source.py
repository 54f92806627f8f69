"""An image in memory, read piece by piece."""

from __future__ import annotations

import numpy as np

from semref.core.labels.image_source import ArrayImage

IMAGE = np.random.default_rng(2).integers(0, 256, (20, 30, 3), dtype=np.uint8)


def test_a_piece_has_the_pixels_that_lie_there():
    source = ArrayImage(IMAGE)
    pixels, has_data = source.read(4, 7, 10, 5)
    assert source.shape_hw == (20, 30)
    np.testing.assert_array_equal(pixels, IMAGE[7:12, 4:14])
    assert has_data is None


def test_a_piece_tells_where_there_is_data():
    known = np.random.default_rng(3).random((20, 30)) < 0.5
    _, has_data = ArrayImage(IMAGE, known).read(4, 7, 10, 5)
    np.testing.assert_array_equal(has_data, known[7:12, 4:14])
