"""Blocks of tiles together are the rows of the whole image."""

import numpy as np
import pytest
from made_models import painted, write_model

from semref.core.labels.image_source import ArrayImage
from semref.core.segmentation.blocks import segment_blocks
from semref.core.segmentation.certainty import Sureness
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.tiling import segment, segment_tiles, tiles_of

VALUES = (1, 2, 3)


@pytest.mark.parametrize("shape", [(40, 50), (1100, 620)])
def test_blocks_are_the_rows_of_the_whole(tmp_path, shape):
    model = SegmentationModel(str(write_model(tmp_path / "m.onnx")), 1)
    pixels = painted(np.random.default_rng(1).integers(1, 4, shape).astype(np.uint8))
    noise = np.random.default_rng(2).integers(0, 60, pixels.shape).astype(np.uint8)
    image, tiles = ArrayImage(np.where(pixels > 128, pixels - noise, pixels + noise)), tiles_of(model, shape, 0.25)

    def elsewhere(calls):
        for first, count in calls:
            some = tiles.block(model.tile_hw, first, count)
            rows = [rows for _, rows in segment_tiles(model, image, VALUES, 0.25, some) if rows is not None]
            sure = Sureness()
            for one in rows:
                sure.add(one.sure)
            yield np.concatenate([one.labels_hw for one in rows]), sure.total, sure.count

    shares, found = zip(*segment_blocks(tiles, model.tile_hw, elsewhere))
    wanted = [rows for _, rows in segment(model, image, VALUES, 0.25) if rows is not None]
    assert list(shares) == sorted(shares) and shares[-1] == 1
    assert [one.first for one in found] == [one.first for one in wanted]
    for one, other in zip(found, wanted):
        np.testing.assert_array_equal(one.labels_hw, other.labels_hw)
    assert sum(one.sure.count for one in found) == sum(one.sure.count for one in wanted)
    assert sum(one.sure.total for one in found) == pytest.approx(sum(one.sure.total for one in wanted))
