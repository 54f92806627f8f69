"""The window grid: windows on a map, and refused sizes."""

import re

import pytest

from semref.core.errors import WindowError
from semref.core.windows.grid import WindowGrid, centered_square, window_name


def refuses(sentence):
    return pytest.raises(WindowError, match=f"^{re.escape(sentence)}$")


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


def test_a_stride_larger_than_the_window_is_refused():
    with refuses(
        "The stride (31 px) is larger than the window (30 px), so windows would leave gaps; "
        "choose a stride up to the window size."
    ):
        WindowGrid(100, 100, 30, 31)


@pytest.mark.parametrize(("width", "height"), [(0, 0), (29, 100), (100, 29)])
def test_a_window_larger_than_the_map_is_refused(width, height):
    with refuses(
        f"The window (30 px) is larger than the map ({width} × {height} px); choose a smaller window or a larger map."
    ):
        WindowGrid(width, height, 30, 10)


def test_windows_are_named_after_their_first_pixel_column_first():
    assert window_name(5950, 2100) == "5950_2100"


@pytest.mark.parametrize(
    ("shape_hw", "square"),
    [((0, 0), (0, 0, 0)), ((0, 9), (4, 0, 0)), ((8, 8), (0, 0, 8)), ((8, 13), (2, 0, 8)), ((13, 8), (0, 2, 8))],
)
def test_the_largest_square_is_in_the_middle_of_an_image(shape_hw, square):
    assert centered_square(shape_hw) == square
