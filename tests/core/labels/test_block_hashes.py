import hashlib

import numpy as np
import pytest

from semref.core.labels import block_hashes
from semref.core.labels.block_hashes import BlockHasher, block_hash, map_hash
from semref.core.labels.overview import most_frequent_labels


@pytest.fixture(autouse=True)
def small_blocks(monkeypatch):
    monkeypatch.setattr(block_hashes, "HASHED_BLOCK", 32)


def hashes_in_bands(labels_hw, rows):
    hasher = BlockHasher(labels_hw.shape[1])
    for first in range(0, len(labels_hw), rows):
        hasher.add(labels_hw[first : first + rows])
    return hasher.hashes


@pytest.mark.parametrize("rows", [1, 7, 32, 100])
def test_blocks_have_the_same_hashes_in_whatever_bands_rows_come(rows):
    labels = np.random.default_rng(3).integers(0, 5, (70, 90), dtype=np.uint8)
    # Blocks of one value, of one value until the last row, and of two halves.
    labels[:32, :32] = labels[:32, 32:64] = labels[32:48, :32] = 4
    labels[31, 40] = labels[48:64, :32] = 0
    places = [(row, column) for row in range(0, 70, 32) for column in (0, 32, 64)]
    expected = [block_hash(labels[row : row + 32, column : column + 32]) for row, column in places]
    assert hashes_in_bands(labels, rows) == tuple(expected) and len(set(expected)) == 9


def test_a_block_is_known_by_its_bytes():
    labels = np.arange(12, dtype=np.uint8).reshape(3, 4)
    assert block_hash(labels) == hashlib.blake2b(bytes(range(12)), digest_size=8).hexdigest()


def test_shape_place_and_labels_of_a_map_are_part_of_its_hash():
    place = (600000.0, 1.0, 0.0, 5200000.0, 0.0, -1.0)
    known = map_hash((70, 90), place, ["a", "b"])
    others = {
        map_hash((90, 70), place, ["a", "b"]),
        map_hash((70, 90), (0.0, *place[1:]), ["a", "b"]),
        map_hash((70, 90), place, ["b", "a"]),
    }
    assert len({known, *others}) == 4
    assert map_hash((70, 90), list(place), ("a", "b")) == known


def plain_overview(labels_hw, factor):
    height, width = labels_hw.shape
    return [
        [int(np.bincount(labels_hw[y : y + factor, x : x + factor].ravel()).argmax()) for x in range(0, width, factor)]
        for y in range(0, height, factor)
    ]


def random_labels(seed, height, width, count=7):
    rng = np.random.default_rng(seed)
    coarse = rng.choice(256, count, replace=False).astype(np.uint8)[rng.integers(0, count, (height, width))]
    return np.kron(coarse, np.ones((2, 2), np.uint8))[:height, :width].copy()


@pytest.mark.parametrize("factor", range(1, 21))
@pytest.mark.parametrize(("extra_rows", "extra_columns"), [(0, 0), (0, 1), (1, 0), (1, 1), (2, 3), (-1, -1)])
def test_every_block_shows_the_most_frequent_label_of_the_pixels_that_it_has(factor, extra_rows, extra_columns):
    height, width = max(1, 3 * factor + extra_rows), max(1, 4 * factor + extra_columns)
    labels = random_labels(100 + factor, height, width, 4)
    found = most_frequent_labels(labels, factor)
    assert found.dtype == np.uint8 and found.tolist() == plain_overview(labels, factor)


@pytest.mark.parametrize(("count", "label"), [(0, 9), (7, 9), (8, 5), (9, 5), (16, 5)])
def test_of_equally_frequent_labels_the_smallest_wins(count, label):
    block = np.full(16, 9, np.uint8)
    block[:count] = 5
    assert most_frequent_labels(block.reshape(4, 4), 4).tolist() == [[label]]


def test_a_map_wider_than_a_vector_register_is_reduced_right_everywhere():
    labels = random_labels(8, 24, 1030, 30)
    for factor in (2, 3, 4, 8):
        assert most_frequent_labels(labels, factor).tolist() == plain_overview(labels, factor)
