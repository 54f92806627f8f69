"""Blocks of tiles together are the rows of the whole image."""

import numpy as np
import pytest

from semref.core.labels.image_source import ArrayImage
from semref.core.segmentation import blocks
from semref.core.segmentation.certainty import Sureness, softmax
from semref.core.segmentation.tiling import segment, segment_tiles, tiles_of

VALUES = (1, 2, 3)


class Undecided:
    """Network with scores that depend on the place in the tile: another order of sums gives other labels."""

    tile_hw, tiles_at_once, runs_at_once, has_scores = (64, 48), 1, 1, True
    probabilities = staticmethod(softmax)

    def __init__(self):
        self.field = np.random.default_rng(5).normal(0, 1, (3, *self.tile_hw)).astype(np.float32)

    def scores(self, images):
        bands = np.stack([np.moveaxis(image, 2, 0) for image in images]).astype(np.float32) / 255
        return self.field * (bands + np.float32(0.3))


@pytest.mark.slow
@pytest.mark.parametrize("shape", [(8, 9), (64, 48), (200, 131)])
@pytest.mark.parametrize("overlap", [0, 0.2, 0.75])
@pytest.mark.parametrize("count", [1, 3])
def test_blocks_with_their_seams_are_the_whole_to_the_last_bit(monkeypatch, shape, overlap, count):
    monkeypatch.setattr(blocks, "TILES_A_BLOCK", count)
    rng, model = np.random.default_rng(2), Undecided()
    image = ArrayImage(rng.integers(0, 256, (*shape, 3), np.uint8), rng.random(shape) < 0.9)
    tiles = tiles_of(model, shape, overlap)

    def elsewhere(calls):
        for first, size in calls:
            some, sure = tiles.block(model.tile_hw, first, size), Sureness()
            rows = [rows for _, rows in segment_tiles(model, image, VALUES, overlap, some) if rows is not None]
            for one in rows:
                sure.add(one.sure)
            yield np.concatenate([one.labels_hw for one in rows]), sure.total, sure.count

    shares, found = zip(*blocks.segment_blocks(tiles, model.tile_hw, elsewhere))
    wanted = [rows for _, rows in segment(model, image, VALUES, overlap) if rows is not None]
    assert list(shares) == sorted(shares) and shares[-1] == 1
    assert [one.first for one in found] == [one.first for one in wanted]
    for one, other in zip(found, wanted):
        np.testing.assert_array_equal(one.labels_hw, other.labels_hw)
    assert sum(one.sure.count for one in found) == sum(one.sure.count for one in wanted)
    assert sum(one.sure.total for one in found) == pytest.approx(sum(one.sure.total for one in wanted), rel=1e-12)
