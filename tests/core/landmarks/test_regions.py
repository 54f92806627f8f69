"""A region is found whole from any place in it, in tiles of any size."""

import cv2
import numpy as np
import pytest

from semref.core.labels.sources import ArrayLabels
from semref.core.landmarks.regions import Region, RegionFinder, whole_region


def winding():
    """A line that crosses the map, a ring and a speck, all of class 5."""
    labels = np.zeros((120, 150), np.uint8)
    cv2.polylines(labels, [np.array([(0, 5), (140, 20), (10, 60), (149, 110)], np.int32)], False, 5, 2)
    cv2.circle(labels, (40, 95), 12, 5, 2)
    labels[60, 120] = 5
    # To the last row as well: with tiles of 12 and 16 the map ends where a tile does.
    labels[100:, 149] = 5
    return labels


@pytest.mark.parametrize("tile", [7, 12, 16, 30, 1000])
def test_the_region_at_each_pixel_has_its_bounds_and_its_first_pixel(tile):
    labels = winding()
    finder = RegionFinder(ArrayLabels(labels), 5, tile)
    count, parts, boxes, _ = cv2.connectedComponentsWithStats((labels == 5).astype(np.uint8), connectivity=8)
    assert len(finder.touching((0, 0, 150, 120))) == count - 1 == 3
    for n in range(1, count):
        rows, columns = np.nonzero(parts == n)
        left, top, width, height = boxes[n, :4].tolist()
        expected = Region((left, top, left + width, top + height), (int(columns[0]), int(rows[0])))
        for k in range(0, len(rows), 37):
            x, y = int(columns[k]), int(rows[k])
            assert finder.touching((x, y, x + 1, y + 1)) == {expected}


@pytest.mark.parametrize("tile", [7, 30, 1000])
@pytest.mark.parametrize("left", [0, 33])
def test_each_run_of_a_row_gives_the_region_that_it_belongs_to(tile, left):
    labels = winding()
    finder = RegionFinder(ArrayLabels(labels), 5, tile)
    _, parts, _, _ = cv2.connectedComponentsWithStats((labels == 5).astype(np.uint8), connectivity=8)
    firsts = {n: tuple(np.argwhere(parts == n)[0][::-1].tolist()) for n in range(1, parts.max() + 1)}
    for row in (17, 60, 90):
        here = parts[row, left:140]
        runs = [n for n, before in zip(here.tolist(), [0, *here[:-1].tolist()]) if n and not before]
        found = [region.first_pixel for region in finder.starting_in_row(row, left, 140)]
        assert found == [firsts[n] for n in runs]
        assert len(found) >= 1


def test_pieces_make_the_region_around_all_that_begins_where_the_first_does():
    pieces = [Region((5, 8, 9, 9), (6, 8)), Region((2, 4, 6, 8), (4, 4)), Region((1, 4, 3, 6), (2, 4))]
    assert whole_region(pieces) == Region((1, 4, 9, 9), (2, 4))
