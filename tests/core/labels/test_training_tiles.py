import numpy as np
import pytest

from semref.core.errors import ParameterError
from semref.core.labels.training_tiles import MOST_TILES, block_size, fitting_tiles, plan_tiles, validation_blocks


def pixels_of(tiles, subset, shape_hw, size):
    used = np.zeros(shape_hw, bool)
    for tile in tiles:
        if tile.subset == subset:
            used[tile.row : tile.row + size, tile.column : tile.column + size] = True
    return used


@pytest.mark.parametrize("stride", [64, 40, 7])
@pytest.mark.parametrize("shape_hw", [(640, 900), (64, 2000), (333, 777)])
def test_no_pixel_is_used_for_both(shape_hw, stride):
    block = block_size(shape_hw, 64)
    grid = np.ones([-(-edge // block) for edge in shape_hw], int)
    tiles = plan_tiles(shape_hw, 64, stride, validation_blocks(grid, 0.3), block)
    training, validation = (pixels_of(tiles, subset, shape_hw, 64) for subset in ("train", "validation"))
    assert training.any() and validation.any()
    assert not (training & validation).any()


def test_tiles_stay_on_the_image_and_one_smaller_than_a_tile_is_refused():
    tiles = plan_tiles((333, 777), 64, 50, np.zeros((4, 7), bool), 128)
    assert max(tile.row + 64 for tile in tiles) <= 333
    assert max(tile.column + 64 for tile in tiles) <= 777
    assert len(tiles) == 6 * 15
    with pytest.raises(ParameterError, match="300 × 50 pixels, less than one tile of 64"):
        plan_tiles((50, 300), 64, 64, np.zeros((1, 5), bool), 64)


@pytest.mark.parametrize("fraction", [0.1, 0.25, 0.5])
def test_validation_has_about_the_asked_fraction_of_the_labels(fraction):
    labeled = np.random.default_rng(3).integers(0, 1000, (8, 8))
    taken = validation_blocks(labeled, fraction)
    assert labeled[taken].sum() / labeled.sum() == pytest.approx(fraction, abs=0.02)


@pytest.mark.parametrize(
    ("shape_hw", "expected"),
    [
        *(((100, 100), (128, 64)), ((2538, 1648), (384, 192)), ((512 * 4, 512 * 6), (512, 256))),
        *(((512 * 30, 512 * 30), (512, 512)), ((100_000, 100_000), (512, 2236))),
    ],
    ids=["too small", "half a town", "enough of the largest", "many", "huge"],
)
def test_tiles_are_large_where_there_is_room_and_overlap_where_there_is_little(shape_hw, expected):
    size, stride = fitting_tiles(shape_hw)
    assert (size, stride) == expected
    if min(shape_hw) >= size:
        tiles = plan_tiles(shape_hw, size, stride, np.zeros((999, 999), bool), size)
        assert len(tiles) <= 1.1 * MOST_TILES
