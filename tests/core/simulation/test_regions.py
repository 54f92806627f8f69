"""Regions of label images: found by class and size, and filled from around."""

import numpy as np

from semref.core.simulation.regions import filled_from_around, nearest_zero, regions_of


def test_regions_come_class_after_class_and_small_ones_are_left_out():
    labels = np.zeros((20, 20), np.uint8)
    labels[2:6, 3:8], labels[10:12, 10:12], labels[15, 15] = 2, 1, 1
    found = regions_of(labels, (1, 2), 4)
    assert [(region.value, region.area_px) for region in found] == [(1, 4), (2, 20)]
    assert found[1].box == (slice(2, 6), slice(3, 8)) and found[1].mask.all()


def test_lost_pixels_get_the_nearest_label_of_the_sources():
    labels = np.array([[1, 1, 5, 5, 2, 2]], np.uint8)
    lost = labels == 5
    np.testing.assert_array_equal(filled_from_around(labels, lost, ~lost), [[1, 1, 1, 2, 2, 2]])


def test_the_nearest_zero_is_counted_in_order_of_rows():
    np.testing.assert_array_equal(nearest_zero(np.array([[0, 255, 255, 0]], np.uint8)), [[0, 0, 1, 1]])
