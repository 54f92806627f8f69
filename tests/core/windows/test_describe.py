import math

import cv2
import made_labels
import numpy as np
import pytest

from semref.core.landmarks.landmarks import extract_landmarks
from semref.core.windows.describe import describe_windows
from semref.core.windows.grid import WindowGrid

VALUES = (2, 5, 9)
WITHIN_FLOAT32 = 2e-6
SLOW = pytest.mark.slow


# The plain computation follows only the description of the published method.


def plain_objects(labels_hw, values, minimum_area):
    """Return [(x, y, value)] of the regions with at least `minimum_area`, in pixel coordinates."""
    found = []
    for value in values:
        mask = (labels_hw == value).astype(np.uint8)
        contours, hierarchy = cv2.findContours(mask, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
        for contour, links in zip(contours, hierarchy[0] if len(contours) else ()):
            area = cv2.contourArea(contour)
            if links[3] >= 0 or area == 0 or area < minimum_area:
                continue
            m = cv2.moments(contour)
            found.append((m["m10"] / m["m00"] + 0.5, m["m01"] / m["m00"] + 0.5, value))
    return found


def plain_vector(objects, size, values, references_per_vector):
    """Return the vector as 3·X floats; differences below a millionth count as ties."""
    polar = []
    for x, y, value in objects:
        x, y = x - size / 2, y - size / 2
        distance = round(math.hypot(x, y), 6)
        angle = round(math.degrees(math.atan2(y, x)), 6) % 360 if distance else 0.0
        polar.append((distance, angle, (sorted(values).index(value) + 1) / len(values)))
    kept = sorted(sorted(polar)[:references_per_vector], key=lambda p: (p[1], p[0]))
    farthest = max(range(len(kept)), key=lambda k: kept[k][0])
    kept = kept[farthest:] + kept[:farthest]
    ratios = [distance / (kept[0][0] or 1) for distance, _, _ in kept]
    differences = [(following[1] - this[1]) % 360 for this, following in zip(kept, kept[1:] + kept[:1])]
    largest = max(differences) or 1
    rows = (ratios, [d / largest for d in differences], [rank for _, _, rank in kept])
    return [number for row in rows for number in row + [0.0] * (references_per_vector - len(row))]


def plain_windows(labels_hw, size, stride, minimum_area, references_per_vector):
    """Return {(column, row): (count, vector)} of every window on the map."""
    height, width = labels_hw.shape
    windows = {}
    for row in range(0, height - size + 1, stride):
        for column in range(0, width - size + 1, stride):
            window = np.ascontiguousarray(labels_hw[row : row + size, column : column + size])
            objects = plain_objects(window, VALUES, minimum_area)
            vector = [0.0] * (3 * references_per_vector)
            if len(objects) >= 3:
                vector = plain_vector(objects, size, VALUES, references_per_vector)
            windows[column, row] = len(objects), vector
    return windows


def described_windows(labels_hw, size, stride, minimum_area, references_per_vector=10):
    height, width = labels_hw.shape
    objects = extract_landmarks(labels_hw, VALUES, minimum_area)
    grid = WindowGrid(width, height, size, stride)
    found = describe_windows(labels_hw, grid, objects, VALUES, minimum_area, references_per_vector)
    assert found.vectors.dtype == np.float32
    names = list(zip(found.columns.tolist(), found.rows.tolist()))
    assert names == [(column, row) for row in grid.rows.tolist() for column in grid.columns.tolist()]
    return {name: (int(found.counts[k]), found.vectors[k]) for k, name in enumerate(names)}


def assert_same(found, expected):
    assert found.keys() == expected.keys()
    names = sorted(expected)
    counts = [[windows[name][0] for name in names] for windows in (found, expected)]
    assert counts[0] == counts[1]
    vectors = [np.array([windows[name][1] for name in names], np.float64) for windows in (found, expected)]
    np.testing.assert_allclose(vectors[0], vectors[1], rtol=0, atol=WITHIN_FLOAT32)


# Maps that are hard in different ways.


def nothing(seed, height, width):
    return np.zeros((height, width), np.uint8)


def blobs(seed, height, width, scale=1.5):
    return made_labels.blobs(seed, (height, width), (0, *VALUES), scale)


def specks(seed, height, width):
    """Return a random class at each pixel: lines, diagonals, single pixels, regions that touch at corners."""
    return np.random.default_rng(seed).choice(np.array((0, *VALUES), np.uint8), (height, width))


def snakes(seed, height, width):
    return made_labels.snakes(seed, (height, width), VALUES)


def rings(seed, height, width):
    """Return rings in rings of one class, with islands between: regions in holes of regions."""
    rng = np.random.default_rng(seed)
    labels = np.zeros((height, width), np.uint8)
    for _ in range(8):
        center = int(rng.integers(0, width)), int(rng.integers(0, height))
        value = int(rng.choice(VALUES))
        for radius in range(int(rng.integers(8, 30)), 2, -4):
            cv2.circle(labels, center, radius, value, -1)
            cv2.circle(labels, center, radius - 2, 0, -1)
    return labels


def corners(seed, height, width, step=8):
    """Return blocks around the corners of windows: ending at, on and over the borders."""
    rng = np.random.default_rng(seed)
    labels = np.zeros((height, width), np.uint8)
    for row in range(0, height, step):
        for column in range(0, width, step):
            left, top, right, bottom = rng.integers(0, 4, 4)
            block = np.s_[max(row - top, 0) : row + bottom, max(column - left, 0) : column + right]
            labels[block] = rng.choice(VALUES)
    return labels


def combs(seed, height, width):
    """Return combs with teeth of 2 pixels: one region, but many in a window without the back."""
    labels = np.zeros((height, width), np.uint8)
    for n, top in enumerate(range(1, height - 20, 20)):
        labels[top : top + 18, (n + seed) % 3 :: 3] = labels[top : top + 18, (n + seed + 1) % 3 :: 3] = VALUES[n % 3]
        labels[top + (0 if n % 2 else 15) :, :][:3] = VALUES[n % 3]
    return labels


MAPS = (nothing, blobs, specks, snakes, rings, corners, combs)
each_map = pytest.mark.parametrize("make_map", MAPS, ids=[make.__name__ for make in MAPS])


@pytest.mark.slow
@each_map
@pytest.mark.parametrize(
    ("size", "stride"),
    [pytest.param(32, 1, marks=SLOW), pytest.param(24, 3, marks=SLOW), (33, 7), (32, 8), (20, 20), (48, 5)],
)
def test_windows_are_described_as_the_plain_computation_describes_each_by_itself(make_map, size, stride):
    side = (44, 52) if stride == 1 else (79, 101)
    labels = make_map(size + stride, *side)
    expected = plain_windows(labels, size, stride, 4.0, 10)
    found = described_windows(labels, size, stride, 4.0)
    assert_same(found, expected)


@pytest.mark.parametrize("minimum_area", [0.5, 1.0, 12.5, 60.0])
@pytest.mark.parametrize("references_per_vector", [3, 4, 25])
def test_vector_length_and_minimum_area_are_those_of_the_plain_computation(minimum_area, references_per_vector):
    labels = snakes(7, 80, 90)
    expected = plain_windows(labels, 40, 9, minimum_area, references_per_vector)
    found = described_windows(labels, 40, 9, minimum_area, references_per_vector)
    assert_same(found, expected)


def test_regular_plots_are_described_in_the_window_as_in_the_image_cut_there():
    """Equal triangles in rows have tied distances, and coordinates in thirds, which no float stores exactly."""
    labels = np.zeros((160, 160), np.uint8)
    for row in range(3, 150, 12):
        for column in range(3, 150, 12):
            cv2.fillPoly(labels, [np.array([[column, row], [column + 5, row], [column, row + 5]], np.int32)], 5)
    found = described_windows(labels, 60, 12, 4.0)
    assert_same(found, plain_windows(labels, 60, 12, 4.0, 10))
