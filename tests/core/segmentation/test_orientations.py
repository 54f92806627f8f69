from concurrent.futures import CancelledError
from threading import Event

import numpy as np
import pytest

from semref.core.segmentation.model import averaged_scores

GOING_ON = Event()


class Shifting:
    """Network that returns the colors of an image, moved to the right and down, as shadows move what it sees."""

    def __init__(self, tile_hw, right=1, down=2):
        self.tile_hw, self._moved, self.seen = tile_hw, (down, right), 0

    def scores(self, images):
        assert {image.shape[:2] for image in images} == {self.tile_hw} and all(i.flags.c_contiguous for i in images)
        self.seen += len(images)
        moved = [np.roll(image, self._moved, axis=(0, 1)) for image in images]
        return np.stack(moved).transpose(0, 3, 1, 2).astype(np.float32)


def images(height, width):
    return list(np.random.default_rng(3).integers(0, 255, (2, height, width, 3)).astype(np.uint8))


@pytest.mark.parametrize(("tile_hw", "count"), [((16, 16), 8), ((12, 20), 4)])
def test_a_tile_in_each_orientation_has_the_same_average(tile_hw, count):
    model, (first, second) = Shifting(tile_hw), images(*tile_hw)
    whole = averaged_scores(model, [first, second], GOING_ON)
    assert whole.shape == (2, 3, *tile_hw) and whole.dtype == np.float32 and model.seen == 2 * count
    turned = averaged_scores(model, [np.ascontiguousarray(first[::-1, ::-1])], GOING_ON)
    np.testing.assert_allclose(turned[0], whole[0, :, ::-1, ::-1], rtol=1e-6)
    mirrored = averaged_scores(model, [np.ascontiguousarray(second[:, ::-1])], GOING_ON)
    np.testing.assert_allclose(mirrored[0], whole[1, :, :, ::-1], rtol=1e-6)


def test_errors_that_depend_on_a_direction_average_out_and_a_network_without_them_gives_its_own_scores():
    image = np.zeros((16, 16, 3), np.uint8)
    image[8, 4] = 255
    found = averaged_scores(Shifting((16, 16)), [image], GOING_ON)[0, 0]
    rows, columns = np.indices(found.shape)
    center = (found * rows).sum() / found.sum(), (found * columns).sum() / found.sum()
    assert center == pytest.approx((8, 4))
    model, tiles = Shifting((12, 20), 0, 0), images(12, 20)
    np.testing.assert_array_equal(averaged_scores(model, tiles, GOING_ON), model.scores(tiles))


def test_it_stops_between_two_orientations():
    model, stop = Shifting((12, 20)), Event()
    model.scores = lambda images: stop.set() or np.zeros((1, 3, 12, 20), np.float32)
    with pytest.raises(CancelledError):
        averaged_scores(model, images(12, 20)[:1], stop)
