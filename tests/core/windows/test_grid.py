"""The window grid: windows on a map, and refused sizes."""

import re

import pytest

from semref.core.errors import WindowError
from semref.core.windows.grid import WindowGrid, centered_square, window_name


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


def test_windows_are_named_after_their_first_pixel_column_first():
    assert window_name(5950, 2100) == "5950_2100"


@pytest.mark.parametrize(
    ("shape_hw", "square"),
    [((0, 0), (0, 0, 0)), ((0, 9), (4, 0, 0)), ((8, 8), (0, 0, 8)), ((8, 13), (2, 0, 8)), ((13, 8), (0, 2, 8))],
)
def test_the_largest_square_is_in_the_middle_of_an_image(shape_hw, square):
    assert centered_square(shape_hw) == square
