import tracemalloc

import numpy as np
import pytest
from made_models import brightest_color, metadata, painted, write_model

from semref.core.errors import ImageError
from semref.core.labels.image_source import ArrayImage
from semref.core.segmentation import tiling
from semref.core.segmentation.certainty import LABELS_ALONE, Certainty, Sureness, softmax
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.tiling import segment, tile_starts, tiles_of

VALUES = (1, 2, 3)


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    return SegmentationModel(str(write_model(tmp_path_factory.mktemp("model") / "m.onnx")), 1)


def labels_of(steps) -> np.ndarray:
    rows = [rows for _, rows in steps if rows is not None]
    assert [r.first for r in rows] == np.cumsum([0, *(len(r.labels_hw) for r in rows[:-1])]).tolist()
    return np.concatenate([r.labels_hw for r in rows])


def labels_hw(height, width, seed=0):
    return np.random.default_rng(seed).integers(1, 4, (height, width)).astype(np.uint8)


@pytest.mark.parametrize(
    ("length", "tile", "overlap", "wanted"),
    [
        (10, 64, 0.2, [0]),
        (64, 64, 0.2, [0]),
        (65, 64, 0.2, [0, 1]),
        (128, 64, 0, [0, 64]),
        (129, 64, 0, [0, 32, 65]),
        (160, 64, 0.25, [0, 48, 96]),
    ],
)
def test_tiles_are_spread_evenly(length, tile, overlap, wanted):
    assert tile_starts(length, tile, overlap) == wanted


@pytest.mark.parametrize("overlap", [0, 0.1, 0.25, 0.5, 0.75])
def test_tiles_cover_everything_and_overlap_enough(overlap):
    for length in range(1, 700, 7):
        starts = tile_starts(length, 64, overlap)
        assert starts[0] == 0 and starts[-1] == max(0, length - 64)
        assert all(0 < b - a <= max(1, 64 * (1 - overlap)) for a, b in zip(starts, starts[1:]))


@pytest.mark.parametrize("shape", [(8, 8), (64, 64), (65, 63), (64, 200), (201, 64), (157, 331), (9, 400)])
@pytest.mark.parametrize("overlap", [0, 0.25, 0.6])
def test_every_pixel_gets_its_class(model, shape, overlap):
    wanted = labels_hw(*shape)
    found = labels_of(segment(model, ArrayImage(painted(wanted)), VALUES, overlap))
    np.testing.assert_array_equal(found, wanted)


def test_any_number_of_tiles_at_once_gives_the_same(tmp_path):
    wanted = labels_hw(150, 190)
    model = SegmentationModel(str(write_model(tmp_path / "m.onnx", batch="batch")), 1)
    model.tiles_at_once = 5
    hole = np.ones(wanted.shape, bool)
    hole[:100, :100] = False
    found = labels_of(segment(model, ArrayImage(painted(wanted), hole), VALUES, 0.3))
    np.testing.assert_array_equal(found, np.where(hole, wanted, 0))


def test_pixels_without_data_are_0_and_empty_tiles_skip_the_network(model, monkeypatch):
    wanted = labels_hw(128, 256)
    has_data = np.zeros(wanted.shape, bool)
    has_data[:, :70] = True
    given = []
    scores = model.scores
    monkeypatch.setattr(model, "scores", lambda images: given.append(len(images)) or scores(images))
    found = labels_of(segment(model, ArrayImage(painted(wanted), has_data), VALUES, 0))
    np.testing.assert_array_equal(found, np.where(has_data, wanted, 0))
    assert sum(given) == 4  # of 8 tiles


@pytest.mark.parametrize("shape", [(1, 1), (7, 100), (100, 7)])
def test_an_image_of_a_few_pixels_is_refused(model, shape):
    with pytest.raises(ImageError, match=f"{shape[1]} × {shape[0]} pixels at the model's resolution"):
        labels_of(segment(model, ArrayImage(np.zeros((*shape, 3), np.uint8)), VALUES, 0.25))


@pytest.mark.parametrize("wanted", [LABELS_ALONE, Certainty(of_label=True, of_each=True)], ids=["labels", "all"])
def test_memory_does_not_grow_with_the_height_of_the_image(model, wanted):
    def peak(height):
        class Endless:
            shape_hw = height, 300

            def read(self, column, row, width, height):
                return np.zeros((height, width, 3), np.uint8), None

        tracemalloc.start()
        for _ in segment(model, Endless(), VALUES, 0.25, wanted):
            continue
        try:
            return tracemalloc.get_traced_memory()[1]
        finally:
            tracemalloc.stop()

    assert peak(3000) < 1.2 * peak(300) + 100_000


def test_blending_hides_what_a_tile_gets_wrong_at_its_border(tmp_path):
    """Zeros around a tile darken the mean over 15 pixels; with blending, this affects only the image border."""
    red = np.clip(np.random.default_rng(3).normal(155, 15, (200, 200)), 0, 255).astype(np.uint8)
    photo = np.dstack([red, red * 0, red * 0])
    wrong = {}
    for tile, overlap in ((200, 0), (64, 0.5), (64, 0)):
        more = metadata(tile_size=tile, standardization_mean=None, standardization_std=None)
        path = write_model(tmp_path / "m.onnx", brightest_color(15, bias=(0, 0.5, 0)), metadata=more)
        found = labels_of(segment(SegmentationModel(str(path), 1), ArrayImage(photo), VALUES, overlap))
        wrong[tile, overlap] = (found[16:-16, 16:-16] != 1).mean()
    assert wrong[200, 0] == 0
    assert wrong[64, 0.5] < 0.001
    assert wrong[64, 0] > 0.02


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
    monkeypatch.setattr(tiling, "TILES_A_BLOCK", count)
    rng, model = np.random.default_rng(2), Undecided()
    image = ArrayImage(rng.integers(0, 256, (*shape, 3), np.uint8), rng.random(shape) < 0.9)
    tiles = tiles_of(model, shape, overlap)

    def elsewhere(calls):
        for first, size in calls:
            some, sure = tiles.block(model.tile_hw, first, size), Sureness()
            rows = [rows for _, rows in segment(model, image, VALUES, overlap, tiles=some) if rows is not None]
            for one in rows:
                sure.add(one.sure)
            yield np.concatenate([one.labels_hw for one in rows]), sure.total, sure.count

    shares, found = zip(*tiling.segment_blocks(tiles, model.tile_hw, elsewhere))
    wanted = [rows for _, rows in segment(model, image, VALUES, overlap) if rows is not None]
    assert list(shares) == sorted(shares) and shares[-1] == 1
    assert [one.first for one in found] == [one.first for one in wanted]
    for one, other in zip(found, wanted):
        np.testing.assert_array_equal(one.labels_hw, other.labels_hw)
    assert sum(one.sure.count for one in found) == sum(one.sure.count for one in wanted)
    assert sum(one.sure.total for one in found) == pytest.approx(sum(one.sure.total for one in wanted), rel=1e-12)
