"""Objects of a map read band by band equal those of the whole map."""

import cv2
import numpy as np
import pytest

from semref.core.labels.sources import ArrayLabels
from semref.core.landmarks import border_following
from semref.core.landmarks.landmarks import extract_landmarks, objects_from_rows, rows_array, rows_from_objects
from semref.core.landmarks.tiles import crossing_regions, measure_region, tile_landmarks

VALUES = (2, 5, 9)
WIDTH = 90


def catalogue(labels_hw, band_rows, patch_pixels=10**9, minimum_area=1.0):
    source = ArrayLabels(labels_hw)
    bands = [
        tile_landmarks(labels_hw[first : first + band_rows], (0, first), labels_hw.shape, VALUES, minimum_area)
        for first in range(0, len(labels_hw), band_rows)
    ]
    crossing = (measure_region(source, *found, minimum_area, patch_pixels) for found in crossing_regions(bands))
    rows = rows_array([row for row in crossing if row is not None])
    return objects_from_rows(np.concatenate([rows, *(band.rows for band in bands)]), labels_hw.shape)


def assert_equal_to_the_whole(objects, labels_hw, minimum_area=1.0):
    whole = extract_landmarks(labels_hw, VALUES, minimum_area)
    found, expected = (rows[np.lexsort(np.round(rows, 6).T)] for rows in map(rows_from_objects, (objects, whole)))
    assert found.shape == expected.shape
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-8)
    assert objects.touches_edge.sum() == whole.touches_edge.sum()


def drawn(*lines):
    """Return labels of a drawing: everything but dots is class 5."""
    return np.array([[0 if c == "." else 5 for c in line] for line in lines], np.uint8)


# Maps that are hard in different ways.


def nothing():
    return np.zeros((60, WIDTH), np.uint8)


def one_region():
    return np.full((60, WIDTH), 5, np.uint8)


def blobs(scale, seed=0):
    noise = np.random.default_rng(seed).random((4, 80, WIDTH)).astype(np.float32)
    smooth = np.stack([cv2.GaussianBlur(layer, (0, 0), scale) for layer in noise])
    return np.array((0, *VALUES), np.uint8)[smooth.argmax(axis=0)]


def specks(seed=1):
    return np.random.default_rng(seed).choice(np.array((0, *VALUES), np.uint8), (80, WIDTH))


def snakes(seed=2):
    rng = np.random.default_rng(seed)
    labels = blobs(1.0, seed)
    for thickness in (1, 1, 1, 2, 3):
        points = np.stack([rng.integers(0, WIDTH, 12), rng.integers(0, 80, 12)], axis=1).astype(np.int32)
        cv2.polylines(labels, [points], False, int(rng.choice(VALUES)), thickness)
    return labels


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
    labels = np.zeros((80, WIDTH), np.uint8)
    labels[2:36, 3:87:4] = labels[2:36, 4:87:4] = labels[34:36, 3:87] = 2
    labels[40:78, 3:87:4] = labels[40:78, 4:87:4] = labels[40:42, 3:87] = 2
    return labels


def nested_rings():
    labels = np.zeros((80, WIDTH), np.uint8)
    for n, inset in enumerate(range(1, 38, 3)):
        cv2.rectangle(labels, (inset, inset), (WIDTH - 1 - inset, 79 - inset), VALUES[n // 4 % 3], 1 + n % 2)
    return labels


def lines():
    """Return lines one pixel wide without area, and some that enclose area."""
    labels = np.zeros((80, WIDTH), np.uint8)
    labels[:, ::6] = 5
    labels[5:70, 2] = labels[70, 2:6] = 9
    cv2.line(labels, (30, 0), (80, 79), 2, 1)
    cv2.circle(labels, (60, 30), 20, 9, 1)
    return labels


MAPS = {
    "nothing": nothing,
    "one region": one_region,
    "small blobs": lambda: blobs(1.0),
    "blobs": lambda: blobs(2.5),
    "large blobs": lambda: blobs(8.0),
    "specks": specks,
    "snakes": snakes,
    "spiral": spiral,
    "combs": combs,
    "nested rings": nested_rings,
    "lines": lines,
}
each_map = pytest.mark.parametrize("make_map", MAPS.values(), ids=MAPS)


@pytest.mark.slow
@each_map
@pytest.mark.parametrize("patch_pixels", [10**9, 0, 400], ids=["patched", "traced", "both"])
def test_bands_of_any_height_give_the_objects_of_the_whole_map(make_map, patch_pixels):
    labels = make_map()
    for band_rows in (1, 7, 79, 200):
        assert_equal_to_the_whole(catalogue(labels, band_rows, patch_pixels), labels)


@each_map
@pytest.mark.parametrize("minimum_area", [0.5, 12.0, 100.0])
def test_the_minimum_area_is_that_of_the_whole_region(make_map, minimum_area):
    labels = make_map()
    for patch_pixels in (10**9, 0):
        found = catalogue(labels, 9, patch_pixels, minimum_area)
        assert_equal_to_the_whole(found, labels, minimum_area)


@pytest.mark.parametrize("seed", range(8))
def test_random_maps_turned_and_mirrored_give_the_objects_of_the_whole_map(seed):
    labels = snakes(seed) if seed % 2 else blobs(1.5, seed)
    for turned in (labels, labels[::-1], labels[:, ::-1], labels.T):
        turned = np.ascontiguousarray(turned)
        assert_equal_to_the_whole(catalogue(turned, 5 + seed, 0 if seed % 3 else 10**9), turned)


@pytest.mark.parametrize("patch_pixels", [10**9, 0], ids=["patched", "traced"])
@pytest.mark.parametrize(
    "lines",
    [
        ("##...##", "##...##", "##...##", "#######", "#######"),
        ("#######", "#######", "##...##", "##...##", "##...##"),
        ("##.....", "##...##", "##...##", "#######", "......."),
        (".....##", "##...##", "##...##", "#######", "##....."),
        ("##.....", "##.....", "..##...", "..##...", "....##."),
        ("##.##.##", "##.##.##", "#..#..##", "########", "#..#...#"),
        ("#######", "#.....#", "#.###.#", "#.###.#", "#.....#", "#######"),
        ("..#..", ".#.#.", "#...#", ".#.#.", "..#.."),
    ],
    ids=["U", "arch", "J", "late start", "corners", "comb", "island", "diamond"],
)
def test_parts_that_join_only_in_another_band_are_one_object(lines, patch_pixels):
    labels = np.pad(drawn(*lines), 1)
    for band_rows in (1, 2, 3, 4):
        assert_equal_to_the_whole(catalogue(labels, band_rows, patch_pixels, 0.5), labels, 0.5)


@pytest.mark.parametrize("shape", [(1, 1), (1, 40), (40, 1), (2, 2), (300, 3), (3, 300)])
def test_maps_of_any_shape_can_be_read_in_bands(shape):
    labels = np.random.default_rng(shape[0]).choice(np.array((0, 5, 5, 5), np.uint8), shape)
    for band_rows in (1, 2, 50):
        assert_equal_to_the_whole(catalogue(labels, band_rows, 0, 0.5), labels, 0.5)


def test_what_is_traced_is_equal_across_the_blocks_it_is_read_in(monkeypatch):
    monkeypatch.setattr(border_following, "_REACH", 5)
    for labels in (snakes(4), spiral(), one_region()):
        assert_equal_to_the_whole(catalogue(labels, 11, 0), labels)
