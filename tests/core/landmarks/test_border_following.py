"""Following a border gives the same measures as OpenCV on the whole map."""

import cv2
import numpy as np
import pytest

from semref.core.labels.sources import ArrayLabels
from semref.core.landmarks import border_following
from semref.core.landmarks.border_following import follow_outer_border
from semref.core.landmarks.landmarks import extract_landmarks, rows_from_objects


def winding():
    """Return a line across the map, a ring and a speck, all of class 5."""
    labels = np.zeros((120, 150), np.uint8)
    cv2.polylines(labels, [np.array([(0, 5), (140, 20), (10, 60), (149, 110)], np.int32)], False, 5, 2)
    cv2.circle(labels, (40, 95), 12, 5, 2)
    labels[60, 120] = 5
    return labels


def blobs(seed):
    noise = cv2.GaussianBlur(np.random.default_rng(seed).normal(size=(80, 90)), (0, 0), 2.0)
    return np.where(noise > 0, 5, 0).astype(np.uint8)


@pytest.mark.parametrize("reach", [3, 256])
@pytest.mark.parametrize("labels", [winding(), blobs(1), blobs(2)], ids=["winding", "blobs", "other blobs"])
def test_following_a_border_measures_what_opencv_does(monkeypatch, labels, reach):
    monkeypatch.setattr(border_following, "_REACH", reach)
    rows = rows_from_objects(extract_landmarks(labels, (5,), 1.0)).tolist()
    assert rows
    for row in rows:
        left, top, right = (int(row[n]) for n in (4, 5, 6))
        numbers = cv2.connectedComponents((labels == 5).astype(np.uint8))[1]
        starts = left + np.flatnonzero(labels[top, left:right] == 5)
        # Another region may begin in the same row and box.
        extents = [np.flatnonzero((numbers == numbers[top, x]).any(axis=0)) for x in starts]
        first = next(int(x) for x, e in zip(starts, extents) if (e[0], e[-1] + 1) == (left, right))
        assert follow_outer_border(ArrayLabels(labels), 5, (first, top), 1.0) == tuple(row)


@pytest.mark.parametrize("pixels", [[(60, 120)], [(60, 120), (60, 121)], [(60, 120), (61, 121)]])
def test_pixels_and_lines_have_no_area(pixels):
    labels = np.zeros((120, 150), np.uint8)
    for row, column in pixels:
        labels[row, column] = 5
    assert follow_outer_border(ArrayLabels(labels), 5, (120, 60), 0.0) is None


@pytest.mark.parametrize(("minimum_area", "is_found"), [(9.0, True), (9.5, False)])
def test_a_region_below_the_minimum_area_is_left_out(minimum_area, is_found):
    labels = np.zeros((9, 9), np.uint8)
    labels[5:9, 5:9] = 5
    found = follow_outer_border(ArrayLabels(labels), 5, (5, 5), minimum_area)
    assert found == ((5, 7.0, 7.0, 9.0, 5, 5, 9, 9) if is_found else None)
