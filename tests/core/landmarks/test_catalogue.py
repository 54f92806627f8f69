"""The objects of a whole map, read band by band, are those of the map in one piece."""

import cv2
import numpy as np
import pytest

from semref.core.labels.sources import ArrayLabels, RollingRows
from semref.core.landmarks import border_following
from semref.core.landmarks.catalogue import CatalogueBuilder
from semref.core.landmarks.landmarks import extract_landmarks, rows_from_objects

VALUES = (2, 5, 9)
WIDTH = 90


def catalogue(labels_hw, band_rows, patch_pixels=10**9, minimum_area=1.0, band_multiple=1):
    builder = CatalogueBuilder(
        ArrayLabels(labels_hw),
        VALUES,
        minimum_area,
        band_pixels=band_rows * labels_hw.shape[1],
        patch_pixels=patch_pixels,
        band_multiple=band_multiple,
    )
    bands = list(builder.bands())
    assert len(bands) == builder.band_count
    left = list(builder.crossing())
    assert left == list(range(len(left) - 1, -1, -1))
    return builder.objects


def assert_equal_to_the_whole(objects, labels_hw, minimum_area=1.0):
    whole = extract_landmarks(labels_hw, VALUES, minimum_area)
    found, expected = (rows[np.lexsort(np.round(rows, 6).T)] for rows in map(rows_from_objects, (objects, whole)))
    assert found.shape == expected.shape
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-8)
    assert objects.touches_edge.sum() == whole.touches_edge.sum()


def drawn(*lines):
    """Labels from a drawing of class 5: everything but dots."""
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
    """One long line that crosses each band many times, with islands between its turns."""
    labels = np.zeros((WIDTH, WIDTH), np.uint8)
    angles = np.linspace(0, 10 * np.pi, 400)
    points = 45 + np.stack([np.cos(angles), np.sin(angles)], axis=1) * (4 + angles * 1.2)[:, None]
    cv2.polylines(labels, [np.round(points).astype(np.int32)], False, 5, 2)
    labels[43:47, 43:47] = 9
    return labels


def combs():
    """Teeth up and teeth down: joined only in the last band, or only in the first."""
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
    """Lines of one pixel, which have no area, beside some that enclose some."""
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


@pytest.mark.parametrize(
    ("band_rows", "multiple", "rows"), [(1, 1, 1), (1, 4, 4), (10, 4, 8), (10, 20, 20), (999, 4, 80)]
)
def test_band_heights_are_multiples_of_what_is_asked(band_rows, multiple, rows):
    labels = blobs(2.0)
    builder = CatalogueBuilder(ArrayLabels(labels), VALUES, 1.0, band_pixels=band_rows * WIDTH, band_multiple=multiple)
    bands = list(builder.bands())
    assert [first for first, _ in bands] == list(range(0, 80, rows))
    assert (np.concatenate([band for _, band in bands]) == labels).all()
    assert_equal_to_the_whole(catalogue(labels, band_rows, band_multiple=multiple), labels)


def test_what_is_traced_is_equal_across_the_blocks_it_is_read_in(monkeypatch):
    monkeypatch.setattr(border_following, "_REACH", 5)
    for labels in (snakes(4), spiral(), one_region()):
        assert_equal_to_the_whole(catalogue(labels, 11, 0), labels)


def test_a_map_is_read_once_but_for_what_crosses_bands():
    labels = np.zeros((100, 100), np.uint8)
    labels[10:15, 10:15] = labels[18:23, 50:60] = 5
    pieces = []

    class Watched(ArrayLabels):
        def read(self, *piece):
            pieces.append(piece)
            return super().read(*piece)

    builder = CatalogueBuilder(Watched(labels), VALUES, 1.0, band_pixels=2000)
    list(builder.bands())
    assert pieces == [(0, row, 100, 20) for row in range(0, 100, 20)]
    list(builder.crossing())
    assert pieces[5:] == [(50, 18, 10, 5)]
    assert_equal_to_the_whole(builder.objects, labels)


@pytest.mark.parametrize(("height", "stride"), [(1, 1), (7, 3), (40, 40), (80, 1), (50, 9)])
def test_rolling_rows_show_the_map_and_read_each_row_once(height, stride):
    labels = np.random.default_rng(0).integers(0, 256, (700, 30), dtype=np.uint8)
    read_rows = []

    class Watched(ArrayLabels):
        def read(self, column, row, width, height):
            read_rows.extend(range(row, row + height))
            return super().read(column, row, width, height)

    rolling = RollingRows(Watched(labels), 4, 20, height)
    for row in range(0, 700 - height + 1, stride):
        assert (rolling.strip(row) == labels[row : row + height, 4:24]).all()
    assert read_rows == list(range(len(read_rows)))
