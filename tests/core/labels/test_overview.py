"""The overview: the most frequent label of every block."""

import numpy as np
import pytest

from semref.core.labels.overview import most_frequent_labels


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
def test_every_block_shows_its_most_frequent_label_and_those_over_the_edge_count_the_pixels_they_have(
    factor, extra_rows, extra_columns
):
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
