"""Colors decode to their class and to no other."""

from collections import Counter

import cv2
import numpy as np
import pytest

from sample import classes


def in_range(hsv, entry):
    """Whether an OpenCV HSV color lies in a class's range, where the hue may wrap."""
    low, high = np.array(entry.hsv_min), np.array(entry.hsv_max)
    hue = low[0] <= hsv[0] <= high[0] if low[0] <= high[0] else hsv[0] >= low[0] or hsv[0] <= high[0]
    return bool(hue and np.all(hsv[1:] >= low[1:]) and np.all(hsv[1:] <= high[1:]))


@pytest.mark.parametrize("shift", [-9, 0, 9])
def test_every_color_decodes_to_its_own_class_only(shift):
    for entry in classes.CLASSES:
        rgb = np.clip(np.array(entry.rgb) + shift, 0, 255).astype(np.uint8)
        hsv = cv2.cvtColor(rgb.reshape(1, 1, 3), cv2.COLOR_RGB2HSV)[0, 0]
        assert [c.value for c in classes.CLASSES if in_range(hsv, c)] == [entry.value]


def test_hsv_ranges_of_classes_do_not_overlap():
    def hues(entry):
        low, high = entry.hsv_min[0], entry.hsv_max[0]
        return set(range(low, high + 1)) if low <= high else set(range(low, 181)) | set(range(high + 1))

    counted = Counter(hue for entry in classes.CLASSES for hue in hues(entry))
    assert max(counted.values()) == 1


def test_black_is_in_no_class():
    assert not any(in_range(np.zeros(3), entry) for entry in classes.CLASSES)
