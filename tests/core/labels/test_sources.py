"""Pieces of a map show what the map shows."""

import numpy as np
import pytest

from semref.core.labels.sources import ArrayLabels, PartOfMap, RollingRows

LABELS = np.random.default_rng(1).integers(0, 9, (150, 190)).astype(np.uint8)


def test_a_part_is_a_map_of_its_own():
    part = PartOfMap(ArrayLabels(LABELS), 20, 30, 100, 90)
    assert part.shape_hw == (90, 100)
    np.testing.assert_array_equal(part.read(3, 4, 50, 60), LABELS[34:94, 23:73])


@pytest.mark.parametrize(("height", "step"), [(1, 1), (40, 7), (40, 90), (150, 1)])
def test_rolling_rows_show_each_strip_and_read_each_row_once(height, step):
    read = []

    class Watched(ArrayLabels):
        def read(self, column, row, width, height):
            read.extend(range(row, row + height))
            return super().read(column, row, width, height)

    rolling = RollingRows(Watched(LABELS), 10, 50, height)
    for row in range(0, len(LABELS) - height + 1, step):
        np.testing.assert_array_equal(rolling.strip(row), LABELS[row : row + height, 10:60])
    assert len(read) == len(set(read))
