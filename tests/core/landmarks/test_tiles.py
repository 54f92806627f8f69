import cv2
import numpy as np
import pytest
from made_labels import blobs, snakes

from semref.core.labels.sources import ArrayLabels
from semref.core.landmarks import border_following
from semref.core.landmarks.landmarks import extract_landmarks, objects_from_rows, rows_array, rows_from_objects
from semref.core.landmarks.tiles import crossing_regions, measure_region, tile_landmarks

VALUES = (2, 5, 9)
SHAPE = HEIGHT, WIDTH = 80, 90
PATCHED, TRACED = 10**9, 0
"""Largest number of pixels of a region across tiles that is read as a patch; the border of larger ones is followed."""


def by_tiles(labels_hw, width, height, minimum_area, patch_pixels):
    found = [
        tile_landmarks(labels_hw[y : y + height, x : x + width], (x, y), labels_hw.shape, VALUES, minimum_area)
        for y in range(0, labels_hw.shape[0], height)
        for x in range(0, labels_hw.shape[1], width)
    ][::-1]
    source = ArrayLabels(labels_hw)
    measured = (measure_region(source, *region, minimum_area, patch_pixels) for region in crossing_regions(found))
    crossing = rows_array([row for row in measured if row is not None])
    return objects_from_rows(np.concatenate([crossing, *(tile.rows for tile in found)]), labels_hw.shape)


def assert_tiles_are_the_whole(labels_hw, width, height, minimum_area=1.0, patch_pixels=PATCHED):
    found = by_tiles(labels_hw, width, height, minimum_area, patch_pixels)
    whole = extract_landmarks(labels_hw, VALUES, minimum_area)
    np.testing.assert_array_equal(rows_from_objects(found), rows_from_objects(whole))
    np.testing.assert_array_equal(found.touches_edge, whole.touches_edge)


# Maps that are hard in different ways.


def specks():
    return np.random.default_rng(1).choice(np.array((0, *VALUES), np.uint8), SHAPE)


def spiral():
    """Return one long line that crosses each band many times, with islands between its turns."""
    labels = np.zeros((WIDTH, WIDTH), np.uint8)
    angles = np.linspace(0, 10 * np.pi, 400)
    points = 45 + np.stack([np.cos(angles), np.sin(angles)], axis=1) * (4 + angles * 1.2)[:, None]
    cv2.polylines(labels, [np.round(points).astype(np.int32)], False, 5, 2)
    labels[43:47, 43:47] = 9
    return labels


def combs():
    """Return teeth up and teeth down: joined only in the last band, or only in the first."""
    labels = np.zeros(SHAPE, np.uint8)
    labels[2:36, 3:87:4] = labels[2:36, 4:87:4] = labels[34:36, 3:87] = 2
    labels[40:78, 3:87:4] = labels[40:78, 4:87:4] = labels[40:42, 3:87] = 2
    return labels


def nested_rings():
    labels = np.zeros(SHAPE, np.uint8)
    for n, inset in enumerate(range(1, 38, 3)):
        cv2.rectangle(labels, (inset, inset), (WIDTH - 1 - inset, 79 - inset), VALUES[n // 4 % 3], 1 + n % 2)
    return labels


def lines():
    """Return lines one pixel wide without area, and some that enclose area."""
    labels = np.zeros(SHAPE, np.uint8)
    labels[:, ::6] = 5
    labels[5:70, 2] = labels[70, 2:6] = 9
    cv2.line(labels, (30, 0), (80, 79), 2, 1)
    cv2.circle(labels, (60, 30), 20, 9, 1)
    return labels


def diagonals():
    """Return regions that continue in the next tile only at corners."""
    rows, columns = np.indices(SHAPE)
    return np.where((rows // 3 + columns // 3) % 5 == 0, 5, np.where(rows % 20 == 0, 2, 0)).astype(np.uint8)


MAPS = {
    "nothing": np.zeros(SHAPE, np.uint8),
    "one region": np.full(SHAPE, 5, np.uint8),
    "small blobs": blobs(0, SHAPE, (0, *VALUES), 1.0),
    "blobs": blobs(0, SHAPE, (0, *VALUES), 2.5),
    "large blobs": blobs(0, SHAPE, (0, *VALUES), 8.0),
    **{make.__name__: make() for make in (specks, spiral, combs, nested_rings, lines, diagonals)},
    "snakes": snakes(2, SHAPE),
}
each_map = pytest.mark.parametrize("labels", MAPS.values(), ids=MAPS)
each_way = pytest.mark.parametrize("patch_pixels", [PATCHED, TRACED, 400], ids=["patched", "traced", "both"])


@pytest.mark.slow
@each_map
@each_way
def test_tiles_of_any_size_give_the_landmarks_of_the_whole_map(labels, patch_pixels):
    for width, height in ((90, 1), (90, 7), (90, 79), (200, 200), (16, 16), (7, 90), (31, 2)):
        assert_tiles_are_the_whole(labels, width, height, 1.0, patch_pixels)


@pytest.mark.slow
def test_tiles_of_one_pixel_give_the_landmarks_of_the_whole_map():
    assert_tiles_are_the_whole(MAPS["specks"], 1, 1)


@each_map
@pytest.mark.parametrize("minimum_area", [0.5, 12.0, 100.0])
def test_the_minimum_area_is_that_of_the_whole_region(labels, minimum_area):
    for patch_pixels in (PATCHED, TRACED):
        assert_tiles_are_the_whole(labels, 90, 9, minimum_area, patch_pixels)


@pytest.mark.parametrize("seed", range(8))
def test_random_maps_turned_and_mirrored_give_the_landmarks_of_the_whole_map(seed):
    labels = snakes(seed, SHAPE) if seed % 2 else blobs(seed, SHAPE, (0, *VALUES))
    for turned in (labels, labels[::-1], labels[:, ::-1], labels.T):
        assert_tiles_are_the_whole(np.ascontiguousarray(turned), 90, 5 + seed, 1.0, TRACED if seed % 3 else PATCHED)


DRAWN = {
    "U": ("##...##", "##...##", "##...##", "#######", "#######"),
    "arch": ("#######", "#######", "##...##", "##...##", "##...##"),
    "J": ("##.....", "##...##", "##...##", "#######", "......."),
    "late start": (".....##", "##...##", "##...##", "#######", "##....."),
    "corners": ("##.....", "##.....", "..##...", "..##...", "....##."),
    "comb": ("##.##.##", "##.##.##", "#..#..##", "########", "#..#...#"),
    "island": ("#######", "#.....#", "#.###.#", "#.###.#", "#.....#", "#######"),
    "diamond": ("..#..", ".#.#.", "#...#", ".#.#.", "..#.."),
}


@each_way
@pytest.mark.parametrize("drawing", DRAWN.values(), ids=DRAWN)
def test_parts_that_join_only_in_another_band_are_one_object(drawing, patch_pixels):
    labels = np.pad(np.array([[0 if c == "." else 5 for c in line] for line in drawing], np.uint8), 1)
    for rows in (1, 2, 3, 4):
        assert_tiles_are_the_whole(labels, 90, rows, 0.5, patch_pixels)


@pytest.mark.parametrize("shape", [(1, 1), (1, 40), (40, 1), (2, 2), (300, 3), (3, 300)])
def test_maps_of_any_shape_can_be_read_in_bands(shape):
    labels = np.random.default_rng(shape[0]).choice(np.array((0, 5, 5, 5), np.uint8), shape)
    for rows in (1, 2, 50):
        assert_tiles_are_the_whole(labels, 300, rows, 0.5, TRACED)


@pytest.mark.parametrize("reach", [3, 5])
def test_what_is_traced_is_equal_across_the_blocks_it_is_read_in(monkeypatch, reach):
    monkeypatch.setattr(border_following, "_REACH", reach)
    for name in ("snakes", "spiral", "one region"):
        assert_tiles_are_the_whole(MAPS[name], 90, 11, 1.0, TRACED)


def test_a_tile_has_no_neighbors_beyond_the_edge_of_the_map():
    found = tile_landmarks(np.full((8, 8), 5, np.uint8), (0, 0), (8, 8), VALUES, 1.0)
    assert len(found.rows) == 1 and not len(found.pieces) and not len(found.runs)
