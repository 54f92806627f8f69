"""Landmarks found tile by tile, in any order, equal those of the whole map."""

import cv2
import numpy as np
import pytest

from semref.core.labels.sources import ArrayLabels
from semref.core.landmarks.landmarks import extract_landmarks, objects_from_rows, rows_array, rows_from_objects
from semref.core.landmarks.tiles import crossing_regions, measure_region, tile_landmarks

VALUES = (2, 5, 9)


def blobs(scale, seed):
    noise = np.random.default_rng(seed).random((4, 70, 90)).astype(np.float32)
    smooth = np.stack([cv2.GaussianBlur(layer, (0, 0), scale) for layer in noise])
    return np.array((0, *VALUES), np.uint8)[smooth.argmax(axis=0)]


def specks():
    return np.random.default_rng(1).choice(np.array((0, *VALUES), np.uint8), (70, 90))


def diagonals():
    """Return regions that continue in the next tile only at corners."""
    rows, columns = np.indices((70, 90))
    return np.where((rows // 3 + columns // 3) % 5 == 0, 5, np.where(rows % 20 == 0, 2, 0)).astype(np.uint8)


MAPS = {"blobs": blobs(2.0, 0), "crumbs": blobs(0.8, 3), "specks": specks(), "diagonals": diagonals()}


def by_tiles(labels, width, height, minimum_area=1.0):
    found = [
        tile_landmarks(labels[y : y + height, x : x + width], (x, y), labels.shape, VALUES, minimum_area)
        for y in range(0, labels.shape[0], height)
        for x in range(0, labels.shape[1], width)
    ][::-1]
    source = ArrayLabels(labels)
    measured = (measure_region(source, value, region, minimum_area) for value, region in crossing_regions(found))
    crossing = rows_array([row for row in measured if row is not None])
    return objects_from_rows(np.concatenate([crossing, *(tile.rows for tile in found)]), labels.shape)


@pytest.mark.parametrize(
    "width, height",
    [(90, 70), (16, 16), (7, 90), (90, 5), pytest.param(1, 1, marks=pytest.mark.slow), (31, 2), (2, 33)],
)
@pytest.mark.parametrize("name", MAPS)
def test_tiles_of_any_size_give_the_landmarks_of_the_whole_to_the_last_bit(name, width, height):
    found, whole = by_tiles(MAPS[name], width, height), extract_landmarks(MAPS[name], VALUES, 1.0)
    assert len(whole) > 3
    np.testing.assert_array_equal(rows_from_objects(found), rows_from_objects(whole))


def test_a_tile_has_no_neighbors_beyond_the_edge_of_the_map():
    found = tile_landmarks(np.full((8, 8), 5, np.uint8), (0, 0), (8, 8), VALUES, 1.0)
    assert len(found.rows) == 1 and not len(found.pieces) and not len(found.runs)
