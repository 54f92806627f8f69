import numpy as np
import pytest

from semref.core.correlation.class_pyramid import FULL, MapPyramid, class_fractions, class_space, evidence_of
from semref.core.correlation.settings import CORRELATION
from semref.core.geometry.frame import MapFrame

FRAME = MapFrame.at((1000.0, 2000.0), 4.0)


def test_a_map_without_labels_has_no_channels():
    assert MapPyramid(np.zeros((40, 40), np.uint8), FRAME).space.channels == 0


def test_fractions_count_the_pixels_of_each_class_also_of_a_raster_of_one_pixel():
    labels = np.array([[1, 1, 2, 2], [1, 2, 2, 0]], np.uint8)
    fractions = class_fractions(labels, (1, 2), (2, 1))
    assert fractions.shape == (1, 2, 2)
    assert np.abs(fractions / FULL - [[[0.75, 0.25], [0.0, 0.75]]]).max() <= 1 / FULL
    assert class_fractions(np.full((1, 1), 2, np.uint8), (1, 2), (1, 1)).tolist() == [[[0, FULL]]]


def test_unlabeled_pixels_are_evidence_for_nothing():
    fractions = np.zeros((2, 2, 2), np.uint8)
    fractions[0] = [[FULL, 0], [0, FULL]]
    space = class_space(fractions, np.array([1, 2], np.uint8), CORRELATION.rarity_exponent)
    evidence, known = evidence_of(fractions, space)
    assert known.tolist() == [[1, 1], [0, 0]]
    assert np.abs(evidence[1]).max() == 0 and np.abs(evidence[0]).min() > 0.1


def test_evidence_is_zero_on_average_over_the_map():
    rng = np.random.default_rng(1)
    labels = rng.integers(1, 5, (64, 64)).astype(np.uint8)
    level, left, top = MapPyramid(labels, FRAME).crop(16.0, (0, 0, 256, 256))
    assert (left, top, *level.evidence.shape[:2]) == (0, 0, 16, 16)
    assert np.abs(level.evidence.mean(axis=(0, 1))).max() < 0.01


@pytest.mark.parametrize("pixel_m", [4.0, 8.0, 16.0, 32.0])
def test_a_crop_equals_the_same_part_of_the_whole_level(pixel_m):
    labels = np.random.default_rng(2).integers(0, 4, (61, 83)).astype(np.uint8)
    pyramid = MapPyramid(labels, FRAME)
    whole, _, _ = pyramid.crop(pixel_m, (0, 0, *pyramid.size_m))
    part, left, top = pyramid.crop(pixel_m, (130.0, 70.0, 260.0, 190.0))
    column, row = int(left / pixel_m), int(top / pixel_m)
    height, width = part.known.shape
    assert left <= 130 and top <= 70 and left + width * pixel_m >= 260 and top + height * pixel_m >= 190
    assert np.array_equal(part.evidence, whole.evidence[row : row + height, column : column + width])
