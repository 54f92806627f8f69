"""Features of an image."""

import numpy as np
import pytest

from semref.core.errors import ImageError
from semref.core.flight.pixel_features import CORNERS, WORKING_EDGE, even_contrast, label_features, photo_features


def speckled(shape, seed=0):
    return np.random.default_rng(seed).integers(0, 255, shape).astype(np.uint8)


def test_large_images_are_looked_at_in_a_smaller_version():
    features = photo_features(speckled((900, 1600, 3)))
    assert features.picture_hw.shape == (900 * WORKING_EDGE // 1600, WORKING_EDGE)
    assert features.scale == 1600 / WORKING_EDGE
    assert 0 < len(features.points) <= CORNERS


def test_corners_are_measured_from_the_center():
    picture = np.zeros((201, 301), np.uint8)
    picture[90:111, 140:161] = 255
    points = photo_features(picture).points
    assert len(points)
    assert np.abs(points).max() < 40
    assert np.abs(points.mean(axis=0)).max() < 2


def test_exposure_leaves_the_even_picture_as_it_is():
    picture = speckled((80, 80)) // 3 + 40
    assert np.abs(even_contrast(picture).astype(int) - even_contrast(2 * picture - 30)).mean() < 6


def test_corners_are_only_where_the_image_has_texture():
    is_known = np.zeros((200, 300), bool)
    is_known[:, :150] = True
    assert photo_features(speckled((200, 300)), is_known).points[:, 0].max() <= 1


@pytest.mark.parametrize(
    "image",
    [np.zeros((0, 5), np.uint8), np.zeros((4, 4), np.float32), np.zeros((4, 4, 4), np.uint8), np.zeros(9, np.uint8)],
)
def test_what_is_no_image_is_refused(image):
    with pytest.raises(ImageError):
        photo_features(image)
    with pytest.raises(ImageError):
        label_features(image if image.ndim != 3 else image.astype(np.int32))
