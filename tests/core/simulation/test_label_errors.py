import cv2
import numpy as np
import pytest
from made_labels import squares
from made_patches import MODEST, STRONG

from benchmarks.network_errors import NetworkNoise, spoil
from semref.core.landmarks.landmarks import extract_landmarks
from semref.core.simulation.displacement import displace, with_leaning_roofs
from semref.core.simulation.label_errors import spoil_labels
from semref.core.simulation.noise import USUAL, LabelNoise

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
    make = spoil if isinstance(noise, NetworkNoise) else spoil_labels
    return make(labels_hw, noise, np.random.default_rng(seed), values, donor, minimum_area_px)


def buildings(labels_hw) -> int:
    return cv2.connectedComponents((labels_hw == BUILDING).astype(np.uint8))[0] - 1


@pytest.mark.parametrize("noise", [LabelNoise(), USUAL])
def test_an_image_without_pixels_stays_one(noise):
    assert spoiled(np.zeros((0, 0), np.uint8), noise).shape == (0, 0)


def test_the_same_seed_gives_the_same_labels_and_the_input_stays(village):
    before = village.copy()
    one, again, other = (spoiled(village, STRONG.in_pixels(0.5), seed) for seed in (7, 7, 8))
    np.testing.assert_array_equal(one, again)
    assert (one != other).any()
    np.testing.assert_array_equal(village, before)


def test_near_houses_are_merged(village):
    assert buildings(village) == 7
    assert buildings(spoiled(village, NetworkNoise(merge_gap=25))) == 1


def test_houses_are_merged_in_the_share_of_the_image_asked_for():
    labels = np.full((600, 600), FIELD, np.uint8)
    for top in range(10, 580, 24):
        for left in range(10, 580, 24):
            labels[top : top + 18, left : left + 18] = BUILDING
    whole, half, none = (
        (spoiled(labels, NetworkNoise(merge_gap=9, merge_share=share)) != labels).sum() for share in (1.0, 0.5, 0.0)
    )
    assert 0.3 * whole < half < 0.7 * whole and none == 0


def test_long_houses_are_split_by_the_class_around_them(village):
    village[100:115, 30:250] = BUILDING
    labels = spoiled(village, NetworkNoise(split=1.0, split_length=100.0))
    assert buildings(labels) == buildings(village) + 1
    assert set(np.unique(labels[100:115, 30:250])) == {BUILDING, FIELD}


def test_only_landmarks_below_the_area_are_missed(village):
    village[100:140, 30:250] = BUILDING
    assert buildings(spoiled(village, LabelNoise(missed=1.0, missed_below=500.0))) == 1
    assert buildings(spoiled(village, LabelNoise(missed=1.0))) == 0


def test_boundaries_move_as_far_and_over_the_length_asked_for(village):
    labels = spoiled(village, LabelNoise(jitter=6.0, jitter_length=18.0), 3)
    shore = (labels[210:] == WATER).argmax(axis=1)
    assert 3 < np.sqrt(np.mean((shore - 300.0) ** 2)) < 12
    near, far = (
        (spoiled(village, LabelNoise(jitter=3.0, jitter_length=length), 3)[210:] == WATER).argmax(axis=1)
        for length in (8.0, 60.0)
    )
    assert np.abs(np.diff(far)).mean() < 0.5 * np.abs(np.diff(near)).mean()


@pytest.mark.parametrize("share", [0.15, 0.35])
def test_patches_cover_the_share_asked_for_but_for_those_that_drew_the_right_class(village, share):
    changed = (spoiled(village, NetworkNoise(patches=share, patch_size=30.0)) != village).mean()
    assert 0.5 * share < changed <= share


@pytest.mark.parametrize("noise", [MODEST, STRONG])
def test_an_image_of_one_class_stays_what_it_is(noise):
    labels = np.full((50, 60), FIELD, np.uint8)
    np.testing.assert_array_equal(spoiled(labels, noise), labels)


def spoiled_squares(noise, seed=0, donor=None):
    return spoiled(squares(), noise, seed, (1, 2), squares() if donor is None else donor)


def count_landmarks(labels_hw) -> int:
    return len(extract_landmarks(labels_hw, (1, 2), 1))


def test_missed_landmarks_become_the_class_around_them():
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


def test_mislabeled_landmarks_keep_their_shape():
    labels = spoiled_squares(LabelNoise(mislabeled=0.2))
    np.testing.assert_array_equal(labels == 7, squares() == 7)
    changed = extract_landmarks(np.where(labels != squares(), labels, 0).astype(np.uint8), (1, 2), 1)
    assert 8 <= len(changed) <= 32


def test_background_gets_other_background_if_there_is_any_and_landmarks_stay():
    labels = squares()
    labels[:, 200:] = np.where(labels[:, 200:] == 7, 8, labels[:, 200:])
    found = spoiled(labels, LabelNoise(background=1.0), values=(1, 2))
    np.testing.assert_array_equal(found == 8, labels == 7)
    np.testing.assert_array_equal(found == 1, labels == 1)
    np.testing.assert_array_equal(spoiled(squares(), LabelNoise(background=1.0), values=(1, 2)), squares())


def moves(labels_hw, value):
    """Return (n, 2) displacements of the squares of a class."""
    before, after = (extract_landmarks(each, (value,), 50).centers_xy for each in (squares(), labels_hw))
    return np.array([center - before[np.hypot(*(before - center).T).argmin()] for center in after])


def test_a_class_is_shifted_and_what_it_leaves_is_filled():
    labels = displace(squares(), LabelNoise(class_shifts=((2, 3.0, -2.0),)), np.random.default_rng(0))
    np.testing.assert_allclose(moves(labels, 2), np.tile([3.0, -2.0], (50, 1)))
    assert not moves(labels, 1).any()
    assert set(np.unique(labels)) == {1, 2, 7} and (labels != 7).sum() == (squares() != 7).sum()


def test_shifts_of_less_than_a_pixel_remain_where_boundaries_jitter():
    off = []
    for seed in range(8):
        noise = LabelNoise(jitter=1.5, class_shifts=((2, 0.4, 0.0),))
        off.append(moves(displace(squares(), noise, np.random.default_rng(seed)), 2).mean(axis=0))
    assert np.mean(off, axis=0) == pytest.approx((0.4, 0.0), abs=0.15)


def test_roofs_lean_away_from_the_center_by_that_share():
    noise = LabelNoise(leaning=0.02, leaning_spread=0.0, leaning_classes=(2,))
    labels = with_leaning_roofs(squares(), noise, np.random.default_rng(0), (1, 2), 1)
    before = extract_landmarks(squares(), (2,), 50).centers_xy
    np.testing.assert_allclose(moves(labels, 2), 0.02 * (before - 200), atol=0.51)
    assert not moves(labels, 1).any()


def test_displaced_neighborhoods_move_together():
    noise = LabelNoise(displaced=3.0, displaced_kernels=((2000.0, 1.0),))
    means, spreads = [], []
    for seed in range(12):
        off = moves(displace(squares(), noise, np.random.default_rng(seed)), 1)
        means.append(off.mean(axis=0))
        spreads.append(off.std(axis=0).mean())
    assert np.std(means) == pytest.approx(3.0, rel=0.4) and np.mean(spreads) < 2.0
