import cv2
import numpy as np
import pytest
from made_labels import blobs

from semref.core.landmarks.landmarks import extract_landmarks, minimum_area_px, rows_from_objects, whole_half_pixels


def drawn(*lines):
    """Return labels of a drawing: digits are class values, everything else is unlabeled."""
    return np.array([[int(c) if c.isdigit() else 0 for c in line] for line in lines], np.uint8)


def plain_rows(labels_hw, values, minimum_area):
    """Return rows (value, x, y, area, left, top, right, bottom) of each region, by the shoelace formula."""
    rows = []
    for value in values:
        count, regions = cv2.connectedComponents((labels_hw == value).astype(np.uint8), connectivity=8)
        for region in range(1, count):
            alone = (regions == region).astype(np.uint8)
            contours, _ = cv2.findContours(alone, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
            assert len(contours) == 1
            x, y = contours[0][:, 0].astype(float).T
            cross = x * np.roll(y, -1) - np.roll(x, -1) * y
            area = abs(cross.sum()) / 2
            if area == 0 or area < minimum_area:
                continue
            center_x = ((x + np.roll(x, -1)) * cross).sum() / (3 * cross.sum()) + 0.5
            center_y = ((y + np.roll(y, -1)) * cross).sum() / (3 * cross.sum()) + 0.5
            ys, xs = np.nonzero(alone)
            rows.append((value, center_x, center_y, area, xs.min(), ys.min(), xs.max() + 1, ys.max() + 1))
    return np.array(rows, float).reshape(-1, 8)


def sorted_rows(rows):
    return rows[np.lexsort(np.round(rows, 6).T)]


@pytest.mark.parametrize(("shape", "value"), [((0, 0), 0), ((0, 9), 0), ((20, 30), 0), ((9, 9), 7)])
def test_an_image_without_reference_classes_has_no_objects(shape, value):
    objects = extract_landmarks(np.full(shape, value, np.uint8), [1, 2], 1.0)
    assert len(objects) == 0
    assert objects.centers_xy.shape == (0, 2) and objects.bounds.shape == (0, 4)
    assert (objects.classes.dtype, objects.bounds.dtype, objects.touches_edge.dtype) == (np.uint8, np.int64, bool)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("minimum_area", [0.5, 6.0, 40.0])
def test_objects_are_those_of_a_plain_computation_region_by_region(seed, minimum_area):
    labels = blobs(seed, (60, 70), range(4), (0.1, 0.8, 1.5, 3.0)[seed % 4])
    found = rows_from_objects(extract_landmarks(labels, [1, 2, 3], minimum_area))
    expected = plain_rows(labels, [1, 2, 3], minimum_area)
    assert found.shape == expected.shape
    np.testing.assert_allclose(sorted_rows(found), sorted_rows(expected), rtol=0, atol=1e-9)


def test_a_block_at_columns_4_to_6_has_its_center_at_5_and_a_half():
    labels = np.zeros((20, 20), np.uint8)
    labels[10:13, 4:7] = 1
    objects = extract_landmarks(labels, [1], 1.0)
    assert objects.centers_xy.tolist() == [[5.5, 11.5]]
    assert objects.areas_px.tolist() == [4.0], "a contour runs through the centers of the border pixels"
    assert objects.bounds.tolist() == [[4, 10, 7, 13]]


@pytest.mark.parametrize(
    ("minimum_area", "count"), [(0.5, 1), (3.5, 1), (4.0, 1), (4.0 + 1e-9, 1), (4.001, 0), (4.5, 0), (5.0, 0)]
)
def test_a_region_of_exactly_the_minimum_area_counts(minimum_area, count):
    labels = np.zeros((9, 9), np.uint8)
    labels[3:6, 3:6] = 1
    assert len(extract_landmarks(labels, [1], minimum_area)) == count


LINES = "..... ..1.. .....", "..... .111. .....", "..1.. ..1.. ..1..", "1.... .1... ..1..", ".1.1. ..1.. ....."


@pytest.mark.parametrize("lines", [*LINES, "1", "11111", "1 1"])
def test_pixels_and_lines_have_no_area_and_are_never_objects(lines):
    assert len(extract_landmarks(drawn(*lines.split()), [1], 0.0)) == 0


def test_a_region_in_the_hole_of_another_is_an_object_of_its_own():
    labels = np.ones((2, 2), np.uint8)
    for value in (0, 1, 0, 1):
        labels = np.pad(labels, 1, constant_values=value)
    objects = extract_landmarks(labels, [1], 0.5)
    assert objects.areas_px.tolist() == [81.0, 25.0, 1.0]
    assert objects.centers_xy.tolist() == [[5.0, 5.0]] * 3
    assert objects.touches_edge.tolist() == [True, False, False]


@pytest.mark.parametrize(
    ("row", "column", "touches"), [(5, 5, False), (0, 5, True), (5, 0, True), (7, 5, True), (5, 7, True), (1, 1, False)]
)
def test_an_object_that_reaches_the_border_is_marked(row, column, touches):
    labels = np.zeros((10, 10), np.uint8)
    labels[row : row + 3, column : column + 3] = 1
    assert extract_landmarks(labels, [1], 1.0).touches_edge.tolist() == [touches]


def test_objects_come_by_class_and_then_from_top_to_bottom():
    labels = blobs(3, (100, 100), range(4))
    objects = extract_landmarks(labels, [3, 1, 2], 1.0)
    keys = [(c, top, left) for c, (left, top, _, _) in zip(objects.classes.tolist(), objects.bounds.tolist())]
    assert len(keys) > 20 and keys == sorted(keys)
    again = extract_landmarks(labels.copy(), [1, 2, 3], 1.0)
    assert (rows_from_objects(again) == rows_from_objects(objects)).all()


@pytest.mark.parametrize(
    ("area_m2", "pixel_size", "expected"),
    [(0.0, 1.0, 0.0), (100.0, 1.0, 100.0), (100.0, 0.1, 1e4), (9.0, 0.3, 100.0), (5.0, 2.0, 1.5), (100.0, 10.0, 1.0)],
)
def test_the_minimum_area_in_pixels_is_whole_halves_whatever_the_arithmetic_left(area_m2, pixel_size, expected):
    assert minimum_area_px(area_m2, pixel_size) == expected


@pytest.mark.parametrize(("area", "expected"), [(0.0, 0.0), (100.00000000000001, 100.0), (99.9, 100.0), (0.2, 0.5)])
def test_thresholds_are_rounded_up_to_half_pixels(area, expected):
    assert whole_half_pixels(area) == expected
