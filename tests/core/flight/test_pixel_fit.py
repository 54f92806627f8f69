from functools import partial

import numpy as np
import pytest

from semref.core.errors import ImageError
from semref.core.flight.pixel_features import CORNERS, WORKING_EDGE, even_contrast, label_features, photo_features
from semref.core.flight.pixel_fit import FLOOR, fit_mapping, homography, pose_of, similarity

TRUE = np.array([0.9, 0.3, 40.0, -25.0])


def places(count, seed=0):
    return np.random.default_rng(seed).uniform(-250, 250, (count, 2))


def test_exact_places_give_the_similarity():
    second = places(40)
    found = fit_mapping(second, similarity(TRUE, second), 2.5)
    assert found.model is similarity
    assert found.parameters == pytest.approx(TRUE)
    assert found.pose()[0] == pytest.approx([40, -25, np.arctan2(0.3, 0.9), np.log(np.hypot(0.9, 0.3))])


def test_places_that_are_wrong_are_left_out():
    second = places(60)
    first = similarity(TRUE, second)
    first[:20] += places(20, 1) / 2
    found = fit_mapping(second, first, 2.5)
    assert found.parameters == pytest.approx(TRUE, abs=1e-2)
    assert found.is_used[20:].all() and found.is_used[:20].sum() <= 2


def test_a_tilt_is_seen():
    second = places(60)
    parameters = np.array([1.0, 0.05, 10.0, -0.02, 0.99, 5.0, 0.02, -0.015])
    found = fit_mapping(second, homography(parameters, second), 2.5)
    assert found.model is homography
    assert found.parameters == pytest.approx(parameters, abs=1e-6)


def test_noise_is_not_taken_for_tilt():
    rng = np.random.default_rng(2)
    for _ in range(20):
        second = rng.uniform(-250, 250, (60, 2))
        assert fit_mapping(second, similarity(TRUE, second) + rng.normal(0, 0.5, (60, 2)), 2.5).model is similarity


def test_the_stated_spread_is_that_of_independent_errors():
    rng = np.random.default_rng(3)
    offs, variances = [], []
    for _ in range(100):
        second = rng.uniform(-250, 0, (50, 2))
        found = fit_mapping(second, similarity(TRUE, second) + rng.normal(0, 0.8, (50, 2)), 4.0)
        pose, covariance = found.pose()
        offs.append(pose - pose_of(partial(similarity, TRUE)))
        variances.append(np.diag(covariance))
    ratio = np.mean(np.square(offs), axis=0) / np.mean(variances, axis=0)
    assert (ratio < 1.25).all() and (ratio > 0.5).all()


def test_errors_that_neighbors_share_widen_the_spread():
    rng = np.random.default_rng(4)
    second = np.array(np.meshgrid(np.arange(-240, 241, 32), np.arange(-240, 241, 32)), float).reshape(2, -1).T
    single, shared = [], []
    blocks = np.unique(np.floor(second / 120), axis=0, return_inverse=True)[1].ravel()
    for _ in range(30):
        errors = rng.normal(0, 0.5, (len(second), 2))
        single.append(fit_mapping(second, second + errors, 2.5).covariance[2, 2])
        shared.append(fit_mapping(second, second + errors[blocks], 2.5).covariance[2, 2])
    assert np.median(shared) > 2.5 * np.median(single)


def test_no_link_is_better_than_the_floor():
    second = places(40)
    covariance = fit_mapping(second, second, 2.5).pose()[1]
    assert (np.sqrt(np.diag(covariance)) >= FLOOR).all()


def test_places_that_agree_on_nothing_fit_nothing():
    assert fit_mapping(places(8), places(8, 9), 2.5) is None


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
