import re

import numpy as np
import pytest

from semref.core.errors import WindowError
from semref.core.windows import distinctiveness as module
from semref.core.windows.distinctiveness import nearest_distances
from semref.core.windows.grid import WindowGrid, centered_square


@pytest.mark.parametrize(
    ("width", "height", "size", "stride", "columns", "rows"),
    [
        (1, 1, 1, 1, [0], [0]),
        (30, 30, 30, 30, [0], [0]),
        (59, 30, 30, 30, [0], [0]),
        (60, 30, 30, 30, [0, 30], [0]),
        (40, 33, 30, 5, [0, 5, 10], [0]),
        (10, 12, 9, 1, [0, 1], [0, 1, 2, 3]),
    ],
)
def test_only_windows_completely_on_the_map_count(width, height, size, stride, columns, rows):
    grid = WindowGrid(width, height, size, stride)
    assert (grid.columns.tolist(), grid.rows.tolist()) == (columns, rows)
    assert len(grid) == len(columns) * len(rows)


@pytest.mark.parametrize(
    ("width", "height", "stride", "sentence"),
    [
        (100, 100, 31, "The stride (31 px) is larger than the window (30 px)"),
        (0, 0, 10, "The window (30 px) is larger than the map (0 × 0 px)"),
        (29, 100, 10, "The window (30 px) is larger than the map (29 × 100 px)"),
        (100, 29, 10, "The window (30 px) is larger than the map (100 × 29 px)"),
    ],
)
def test_a_stride_larger_than_the_window_and_a_window_larger_than_the_map_are_refused(width, height, stride, sentence):
    with pytest.raises(WindowError, match=f"^{re.escape(sentence)}"):
        WindowGrid(width, height, 30, stride)


@pytest.mark.parametrize(
    ("shape_hw", "square"),
    [((0, 0), (0, 0, 0)), ((0, 9), (4, 0, 0)), ((8, 8), (0, 0, 8)), ((8, 13), (2, 0, 8)), ((13, 8), (0, 2, 8))],
)
def test_the_largest_square_is_in_the_middle_of_an_image(shape_hw, square):
    assert centered_square(shape_hw) == square


NEARLY = 1e-12


def all_at_once(vectors, centers, sizes):
    found = np.full(len(vectors), -1.0)
    windows = vectors, centers, sizes
    for block, distances in nearest_distances(windows, windows):
        assert (found[block] == -1).all() and len(distances) == block.stop - block.start
        found[block] = distances
    return found


def plain(vectors, centers, sizes):
    found = []
    for vector, center, size in zip(vectors.astype(float), centers, sizes):
        nearest = float("inf")
        for other, other_center, other_size in zip(vectors.astype(float), centers, sizes):
            reach = (size + other_size) / 2
            if abs(center[0] - other_center[0]) >= reach or abs(center[1] - other_center[1]) >= reach:
                nearest = min(nearest, float(np.linalg.norm(vector - other)))
        found.append(nearest)
    return found


def random_windows(seed, count, extent=1000.0, sizes=(100.0,)):
    rng = np.random.default_rng(seed)
    vectors = rng.random((count, 30)).astype(np.float32)
    return vectors, rng.uniform(0, extent, (count, 2)), rng.choice(sizes, count)


@pytest.mark.parametrize(("count", "block"), [(0, 512), (1, 512), (2, 512), (40, 1), (150, 7), (150, 64), (200, 512)])
@pytest.mark.parametrize("sizes", [(100.0,), (50.0, 100.0, 300.0)], ids=["one level", "three levels"])
def test_distances_equal_a_plain_loop_over_all_pairs(monkeypatch, count, block, sizes):
    monkeypatch.setattr(module, "BLOCK", block)
    windows = random_windows(count, count, sizes=sizes)
    np.testing.assert_allclose(all_at_once(*windows), plain(*windows), rtol=0, atol=NEARLY)


@pytest.mark.parametrize("pixel_size", [1.0, 0.1, 0.3])
@pytest.mark.parametrize("axis", [0, 1])
def test_windows_side_by_side_share_no_area_whatever_the_coordinates(pixel_size, axis):
    """Map coordinates of six digits before the point cause rounding errors in the windows' centers."""
    count = 60
    first_px = np.arange(count) * 128
    centers = np.full((count, 2), 5216789.3)
    centers[:, axis] = 642123.7 + (first_px + 64) * pixel_size
    vectors = np.repeat(np.eye(30, dtype=np.float32), 2, axis=0)  # neighbors 0–1, 2–3, … are equal
    found = all_at_once(vectors, centers, np.full(count, 128 * pixel_size))
    assert found.tolist() == [0] * count
