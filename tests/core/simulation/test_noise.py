"""Imitated segmentation errors."""

import cv2
import numpy as np
import pytest

from semref.core.simulation.noise import MODEST, STRONG, LabelNoise, degrade_labels

BUILDING, FIELD, ROAD, WATER = 1, 2, 3, 4


@pytest.fixture
def village():
    labels = np.full((400, 500), FIELD, np.uint8)
    labels[:, 300:] = WATER
    labels[200:203, :300] = ROAD
    for column in range(20, 280, 40):
        labels[60:80, column : column + 20] = BUILDING
    return labels


def buildings(labels) -> int:
    return cv2.connectedComponents((labels == BUILDING).astype(np.uint8))[0] - 1


def test_an_empty_image_stays_empty():
    assert degrade_labels(np.zeros((0, 0), np.uint8), 1.0, STRONG, 1).shape == (0, 0)


def test_no_noise_changes_nothing(village):
    assert np.array_equal(degrade_labels(village, 1.0, LabelNoise(), 1), village)


def test_the_same_seed_gives_the_same_labels_and_the_input_stays(village):
    before = village.copy()
    first, second = (degrade_labels(village, 0.5, STRONG, 7) for _ in range(2))
    assert np.array_equal(first, second)
    assert not np.array_equal(first, degrade_labels(village, 0.5, STRONG, 8))
    assert np.array_equal(village, before)


def test_near_houses_are_merged(village):
    assert buildings(village) == 7
    assert buildings(degrade_labels(village, 1.0, LabelNoise(merge_m=25), 1)) == 1


def test_long_houses_are_split(village):
    village[100:115, 30:250] = BUILDING
    noise = LabelNoise(split_length_m=100, split_share=1.0)
    assert buildings(degrade_labels(village, 1.0, noise, 1)) == buildings(village) + 1


def test_small_objects_are_missed(village):
    noise = LabelNoise(missed_share=1.0, missed_area_m2=500)
    assert buildings(degrade_labels(village, 1.0, noise, 1)) == 0


def test_thin_roads_are_lost_and_wide_classes_stay(village):
    labels = degrade_labels(village, 1.0, LabelNoise(thin_m=6), 1)
    assert not (labels == ROAD).any()
    assert buildings(labels) == 7


def test_edges_move_by_the_meters_asked_for(village):
    labels = degrade_labels(village, 0.5, LabelNoise(edge_m=3), 3)
    shore = (labels[210:] == WATER).argmax(axis=1)
    assert 3 < np.sqrt(np.mean((shore - 300.0) ** 2)) < 12  # 6 px


@pytest.mark.parametrize("share", [0.15, 0.35])
def test_patches_cover_the_share_asked_for_but_for_those_that_drew_the_right_class(village, share):
    labels = degrade_labels(village, 1.0, LabelNoise(patch_share=share, patch_size_m=30), 1)
    changed = (labels != village).mean()
    assert 0.5 * share < changed <= share


def test_an_image_of_one_class_stays_what_it_is():
    labels = np.full((50, 60), FIELD, np.uint8)
    assert np.array_equal(degrade_labels(labels, 1.0, MODEST, 1), labels)


@pytest.mark.parametrize("wrong", [{"edge_m": -1.0}, {"patch_share": 1.5}])
def test_impossible_noise_is_refused(wrong):
    with pytest.raises(ValueError):
        LabelNoise(**wrong)
