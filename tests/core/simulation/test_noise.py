"""Noise: every step does what it says, as much as it is asked for, and a seed repeats it."""

import math

import cv2
import numpy as np
import pytest

from semref.core.errors import ParameterError
from semref.core.landmarks.landmarks import Landmarks, extract_landmarks
from semref.core.simulation.noise import (
    MODEST,
    STRONG,
    USUAL,
    LabelNoise,
    joined,
    spoil_labels,
    spoil_landmarks,
    with_moved_boundaries,
)

BUILDING, FIELD, ROAD, WATER = 1, 2, 3, 4


@pytest.fixture
def village():
    labels = np.full((400, 500), FIELD, np.uint8)
    labels[:, 300:] = WATER
    labels[200:203, :300] = ROAD
    for column in range(20, 280, 40):
        labels[60:80, column : column + 20] = BUILDING
    return labels


def spoiled(labels_hw, noise, seed=1, values=(BUILDING,), donor=None, minimum_area_px=1.0):
    return spoil_labels(labels_hw, noise, np.random.default_rng(seed), values, donor, minimum_area_px)


def buildings(labels_hw) -> int:
    return cv2.connectedComponents((labels_hw == BUILDING).astype(np.uint8))[0] - 1


# --- the noise itself ---


@pytest.mark.parametrize("wrong", [{"jitter": -1.0}, {"patches": 1.5}, {"missed": math.nan}, {"jitter": math.inf}])
def test_noise_that_cannot_be_is_refused_by_name(wrong):
    with pytest.raises(ParameterError, match=next(iter(wrong))):
        LabelNoise(**wrong)


def test_lengths_and_areas_are_told_in_pixels():
    noise = LabelNoise(missed=0.2, jitter=3.0, jitter_length=9.0, missed_below=200.0, merge_gap=6.0).in_pixels(0.5)
    assert (noise.missed, noise.jitter, noise.jitter_length) == (0.2, 6.0, 18.0)
    assert (noise.missed_below, noise.merge_gap) == (800.0, 12.0)
    assert USUAL.in_pixels(0.5).jitter_length is None and USUAL.in_pixels(0.5).missed_below == math.inf


# --- labels ---


@pytest.mark.parametrize("noise", [LabelNoise(), STRONG])
def test_an_image_without_pixels_stays_one(noise):
    assert spoiled(np.zeros((0, 0), np.uint8), noise).shape == (0, 0)


def test_no_noise_changes_nothing(village):
    np.testing.assert_array_equal(spoiled(village, LabelNoise()), village)


def test_the_same_seed_gives_the_same_labels_and_the_input_stays(village):
    before = village.copy()
    np.testing.assert_array_equal(
        spoiled(village, STRONG.in_pixels(0.5), 7), spoiled(village, STRONG.in_pixels(0.5), 7)
    )
    assert (spoiled(village, STRONG.in_pixels(0.5), 7) != spoiled(village, STRONG.in_pixels(0.5), 8)).any()
    np.testing.assert_array_equal(village, before)


def test_near_houses_are_merged(village):
    assert buildings(village) == 7
    assert buildings(spoiled(village, LabelNoise(merge_gap=25))) == 1


def test_houses_are_merged_in_the_share_of_the_image_asked_for():
    labels = np.full((600, 600), FIELD, np.uint8)
    for top in range(10, 580, 24):
        for left in range(10, 580, 24):
            labels[top : top + 18, left : left + 18] = BUILDING
    whole, half, none = (
        (spoiled(labels, LabelNoise(merge_gap=9, merge_share=share)) != labels).sum() for share in (1.0, 0.5, 0.0)
    )
    assert 0.3 * whole < half < 0.7 * whole and none == 0


def test_long_houses_are_split_into_what_lies_around(village):
    village[100:115, 30:250] = BUILDING
    labels = spoiled(village, LabelNoise(split=1.0, split_length=100.0))
    assert buildings(labels) == buildings(village) + 1
    assert set(np.unique(labels[100:115, 30:250])) == {BUILDING, FIELD}


def test_only_landmarks_below_the_area_are_missed(village):
    village[100:140, 30:250] = BUILDING
    assert buildings(spoiled(village, LabelNoise(missed=1.0, missed_below=500.0))) == 1
    assert buildings(spoiled(village, LabelNoise(missed=1.0))) == 0


def test_thin_roads_are_lost_and_wide_classes_stay(village):
    labels = spoiled(village, LabelNoise(thin=6.0))
    assert not (labels == ROAD).any()
    assert buildings(labels) == 7


def test_boundaries_move_as_far_as_asked_for(village):
    labels = spoiled(village, LabelNoise(jitter=6.0, jitter_length=18.0), 3)
    shore = (labels[210:] == WATER).argmax(axis=1)
    assert 3 < np.sqrt(np.mean((shore - 300.0) ** 2)) < 12


def test_boundaries_move_alike_over_the_length_asked_for(village):
    near, far = (
        (spoiled(village, LabelNoise(jitter=3.0, jitter_length=length), 3)[210:] == WATER).argmax(axis=1)
        for length in (8.0, 60.0)
    )
    assert np.abs(np.diff(far)).mean() < 0.5 * np.abs(np.diff(near)).mean()


@pytest.mark.parametrize("share", [0.15, 0.35])
def test_patches_cover_the_share_asked_for_but_for_those_that_drew_the_right_class(village, share):
    changed = (spoiled(village, LabelNoise(patches=share, patch_size=30.0)) != village).mean()
    assert 0.5 * share < changed <= share


@pytest.mark.parametrize("noise", [MODEST, STRONG])
def test_an_image_of_one_class_stays_what_it_is(noise):
    labels = np.full((50, 60), FIELD, np.uint8)
    np.testing.assert_array_equal(spoiled(labels, noise), labels)


# --- landmarks drawn into labels ---


def squares(size=400):
    """100 squares of classes 1 and 2 on class 7."""
    labels = np.full((size, size), 7, np.uint8)
    for top in range(10, size - 20, 40):
        for left in range(10, size - 20, 40):
            labels[top : top + 20, left : left + 20] = 1 + (top // 40 + left // 40) % 2
    return labels


def spoiled_squares(noise, seed=0, donor=None):
    return spoiled(squares(), noise, seed, (1, 2), squares() if donor is None else donor)


def count_landmarks(labels_hw) -> int:
    return len(extract_landmarks(labels_hw, (1, 2), 1))


def test_missed_landmarks_become_what_lies_around_them():
    labels = spoiled_squares(LabelNoise(missed=0.3))
    assert set(np.unique(labels)) == {1, 2, 7}
    assert 55 <= count_landmarks(labels) <= 85
    assert (spoiled_squares(LabelNoise(missed=1.0)) == 7).all()


def test_spurious_landmarks_look_like_those_of_the_donor_and_touch_no_other():
    donor = np.full((400, 400), 7, np.uint8)
    donor[100:105, 100:108] = 2
    labels = spoiled_squares(LabelNoise(spurious=0.3), donor=donor)
    added = extract_landmarks(np.where(labels != squares(), labels, 0).astype(np.uint8), (1, 2), 1)
    assert 15 <= len(added) <= 45 and set(added.classes) == {2} and set(added.areas_px) == {28}
    assert count_landmarks(labels) == 100 + len(added)


def test_without_a_donor_nothing_is_spurious():
    assert count_landmarks(spoiled(squares(), LabelNoise(spurious=0.5), values=(1, 2))) == 100


def test_mislabeled_landmarks_keep_their_shape():
    labels = spoiled_squares(LabelNoise(mislabeled=0.2))
    np.testing.assert_array_equal(labels == 7, squares() == 7)
    changed = extract_landmarks(np.where(labels != squares(), labels, 0).astype(np.uint8), (1, 2), 1)
    assert 8 <= len(changed) <= 32


def test_regions_smaller_than_a_landmark_are_left_alone():
    labels = np.full((50, 50), 7, np.uint8)
    labels[10:13, 10:13] = 1
    noise = LabelNoise(missed=1.0)
    np.testing.assert_array_equal(spoiled(labels, noise, values=(1, 2), donor=labels, minimum_area_px=10), labels)


# --- landmarks alone ---


NONE = extract_landmarks(np.zeros((10, 10), np.uint8), (1,), 1)
SIZE = 1000, 1000


def many_landmarks(count=4000):
    rng = np.random.default_rng(5)
    centers = rng.uniform(100, 900, (count, 2))
    bounds = np.column_stack([centers - 5, centers + 5]).astype(np.int64)
    classes = np.ones(count, np.uint8)
    classes[: count // 2] = 2
    return Landmarks(centers, classes, np.full(count, 100.0), bounds, np.zeros(count, bool))


def spoiled_landmarks(noise, landmarks=None, seed=1):
    landmarks = many_landmarks() if landmarks is None else landmarks
    return spoil_landmarks(landmarks, noise, np.random.default_rng(seed), landmarks, SIZE)


def test_noise_on_no_landmarks_gives_none():
    assert len(spoiled_landmarks(LabelNoise(0.5, 0.5, 0.5, center=1.0, log_area=0.1), NONE)) == 0
    assert len(with_moved_boundaries(NONE, LabelNoise(jitter=2.0), np.random.default_rng(0))) == 0


@pytest.mark.parametrize(("noise", "left"), [(LabelNoise(missed=0.2), 3200), (LabelNoise(spurious=0.4), 5600)])
def test_shares_of_missed_and_spurious_landmarks_are_as_asked_for(noise, left):
    assert len(spoiled_landmarks(noise)) == pytest.approx(left, abs=150)


def test_centers_areas_and_classes_change_as_asked_for():
    landmarks = many_landmarks()
    found = spoiled_landmarks(LabelNoise(mislabeled=0.1, center=2.0, log_area=0.1), landmarks)
    assert (found.centers_xy - landmarks.centers_xy).std() == pytest.approx(2.0, rel=0.05)
    assert np.log(found.areas_px / landmarks.areas_px).std() == pytest.approx(0.1, rel=0.05)
    assert (found.classes != landmarks.classes).mean() == pytest.approx(0.1, abs=0.02)


def test_the_same_seed_spoils_landmarks_alike():
    noise = LabelNoise(0.2, 0.2, 0.1, center=1.0, log_area=0.1)
    one, other = (spoiled_landmarks(noise, many_landmarks(50), 4) for _ in range(2))
    np.testing.assert_array_equal(one.centers_xy, other.centers_xy)


def test_moved_boundaries_move_centers_as_they_do_in_labels():
    noise = LabelNoise(jitter=2.0)
    seen = extract_landmarks(spoiled(squares(), noise, 9, (1, 2)), (1, 2), 50)
    before = extract_landmarks(squares(), (1, 2), 50)
    off = np.array([before.centers_xy[np.hypot(*(before.centers_xy - c).T).argmin()] - c for c in seen.centers_xy])
    moved = with_moved_boundaries(before, noise, np.random.default_rng(1))
    assert (moved.centers_xy - before.centers_xy).std() == pytest.approx(off.std(), rel=0.4)


def test_joined_landmarks_follow_each_other():
    both = joined(many_landmarks(3), many_landmarks(2))
    assert len(both) == 5 and both.bounds.shape == (5, 4)
