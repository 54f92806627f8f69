"""Trials: a view's truth holds pixel by pixel, noise is as large as asked for, and a seed repeats it."""

import numpy as np
import pytest

from semref.core.labels.sources import ArrayLabels
from semref.core.landmarks.landmarks import Landmarks, extract_landmarks
from semref.core.simulation.views import (
    LabelNoise,
    ObjectNoise,
    View,
    cut_view,
    map_coordinates,
    spoil_label_objects,
    spoil_labels,
    spoil_objects,
)


@pytest.fixture
def labels_hw():
    return np.random.default_rng(0).integers(0, 4, (200, 260), dtype=np.uint8)


def blocks(size=400, step=40, side=20):
    labels = np.zeros((size, size), np.uint8)
    for top in range(10, size - side, step):
        for left in range(10, size - side, step):
            labels[top : top + side, left : left + side] = 1 + (top // step + left // step) % 2
    return labels


@pytest.mark.parametrize(("heading", "quarter_turns"), [(0, 0), (90, 1), (180, 2), (270, 3)])
@pytest.mark.parametrize("size", [63, 64])
def test_quarter_turns_lose_no_pixel(labels_hw, heading, quarter_turns, size):
    view = View(70 + size / 2, 40 + size / 2, heading, 1.0, size, size)
    window = labels_hw[40 : 40 + size, 70 : 70 + size]
    np.testing.assert_array_equal(cut_view(ArrayLabels(labels_hw), view), np.rot90(window, quarter_turns))


def test_heading_90_shows_the_east_at_the_top():
    labels = np.zeros((100, 100), np.uint8)
    labels[50, 70] = 9
    seen = cut_view(ArrayLabels(labels), View(50.5, 50.5, 90.0, 1.0, 61, 61))
    assert np.argwhere(seen == 9).tolist() == [[10, 30]]


def test_beyond_the_map_everything_is_unlabeled(labels_hw):
    seen = cut_view(ArrayLabels(labels_hw + 1), View(0, 0, 0.0, 1.0, 40, 20))
    assert not seen[:10].any() and not seen[:, :20].any() and seen[10:, 20:].all()
    assert not cut_view(ArrayLabels(labels_hw), View(-500, -500, 0.0, 1.0, 40, 20)).any()


def test_the_center_of_a_tilted_view_stays_where_it_is():
    view = View(100.0, 120.0, 30.0, 1.5, 80, 60, tilt_deg=10.0, tilt_direction_deg=50.0)
    assert map_coordinates(view, np.array(40.0), np.array(30.0)) == (100.0, 120.0)


def test_a_tilted_camera_sees_farther_where_it_is_tilted_to():
    view = View(0.0, 0.0, 0.0, 1.0, 100, 100, tilt_deg=10.0)
    columns, rows = map_coordinates(view, np.array([50.0, 50.0]), np.array([0.0, 100.0]))
    assert -rows[0] > 55 > 50 > rows[1] and columns == pytest.approx([0, 0])


NO_OBJECTS = extract_landmarks(np.zeros((10, 10), np.uint8), (1,), 1)


def test_noise_on_no_objects_gives_none():
    noise = ObjectNoise(0.5, 0.5, 0.5, 1.0, 0.1)
    assert len(spoil_objects(NO_OBJECTS, noise, np.random.default_rng(0), NO_OBJECTS, (10, 10))) == 0


def many_objects(count=4000):
    rng = np.random.default_rng(5)
    centers = rng.uniform(100, 900, (count, 2))
    bounds = np.column_stack([centers - 5, centers + 5]).astype(np.int64)
    classes = np.ones(count, np.uint8)
    classes[: count // 2] = 2
    return Landmarks(centers, classes, np.full(count, 100.0), bounds, np.zeros(count, bool))


def test_shares_of_missed_and_invented_objects_are_as_asked_for():
    objects = many_objects()
    rng = np.random.default_rng(1)
    assert len(spoil_objects(objects, ObjectNoise(missed=0.2), rng, objects, (1000, 1000))) == pytest.approx(
        3200, abs=120
    )
    assert len(spoil_objects(objects, ObjectNoise(invented=0.4), rng, objects, (1000, 1000))) == pytest.approx(
        5600, abs=150
    )


def test_jitter_and_wrong_classes_are_as_asked_for():
    objects = many_objects()
    spoilt = spoil_objects(
        objects, ObjectNoise(misnamed=0.1, jitter_px=2.0), np.random.default_rng(1), objects, (1000, 1000)
    )
    assert (spoilt.centers_xy - objects.centers_xy).std() == pytest.approx(2.0, rel=0.05)
    assert (spoilt.classes != objects.classes).mean() == pytest.approx(0.1, abs=0.02)


def test_the_same_seed_spoils_alike():
    objects = many_objects(50)
    noise = ObjectNoise(0.2, 0.2, 0.1, 1.0, 0.1)
    one, other = (spoil_objects(objects, noise, np.random.default_rng(4), objects, (1000, 1000)) for _ in range(2))
    np.testing.assert_array_equal(one.centers_xy, other.centers_xy)


def test_split_objects_become_two():
    spoilt = spoil_labels(blocks(), LabelNoise(split=1.0), np.random.default_rng(0), (1, 2))
    before, after = (len(extract_landmarks(labels, (1, 2), 20)) for labels in (blocks(), spoilt))
    assert after == 2 * before


def test_merged_objects_become_fewer():
    labels = np.where(blocks(step=24) > 0, 1, 0).astype(np.uint8)
    spoilt = spoil_labels(labels, LabelNoise(merged=0.5), np.random.default_rng(0), (1,))
    assert len(extract_landmarks(spoilt, (1,), 20)) < 0.8 * len(extract_landmarks(labels, (1,), 20))


def test_ragged_edges_keep_most_of_an_object():
    labels = blocks()
    spoilt = spoil_labels(labels, LabelNoise(ragged_px=1.5), np.random.default_rng(0), (1, 2))
    changed = (spoilt != labels).mean()
    assert 0.01 < changed < 0.2


# --- objects drawn into labels ---


def count_objects(labels, values=(1, 2)):
    return len(extract_landmarks(labels, values, 1))


def squares_on_field(size=400):
    """100 squares of classes 1 and 2 on class 7."""
    labels = blocks(size)
    labels[labels == 0] = 7
    return labels


def spoil(noise, seed=0, donor=None):
    labels = squares_on_field()
    donor = labels if donor is None else donor
    return spoil_label_objects(labels, noise, np.random.default_rng(seed), (1, 2), donor)


def test_without_noise_labels_stay_as_they_are():
    np.testing.assert_array_equal(spoil(ObjectNoise()), squares_on_field())
    nothing = np.zeros((10, 10), np.uint8)
    noise = ObjectNoise(0.5, 0.5, 0.5)
    np.testing.assert_array_equal(
        spoil_label_objects(nothing, noise, np.random.default_rng(0), (1, 2), nothing), nothing
    )


def test_missed_objects_become_what_lies_around_them():
    labels = spoil(ObjectNoise(missed=0.3))
    assert set(np.unique(labels)) == {1, 2, 7}
    assert 55 <= count_objects(labels) <= 85
    assert (spoil(ObjectNoise(missed=1.0)) == 7).all()


def test_invented_objects_look_like_those_of_the_donor_and_touch_no_other():
    donor = np.full((400, 400), 7, np.uint8)
    donor[100:105, 100:108] = 2
    labels = spoil(ObjectNoise(invented=0.3), donor=donor)
    added = labels != squares_on_field()
    objects = extract_landmarks(np.where(added, labels, 0).astype(np.uint8), (1, 2), 1)
    assert 15 <= len(objects) <= 45 and set(objects.classes) == {2} and set(objects.areas_px) == {28}
    assert count_objects(labels) == 100 + len(objects)


def test_misnamed_objects_keep_their_shape():
    labels = spoil(ObjectNoise(misnamed=0.2))
    before = squares_on_field()
    np.testing.assert_array_equal(labels == 7, before == 7)
    changed = extract_landmarks(np.where(labels != before, labels, 0).astype(np.uint8), (1, 2), 1)
    assert 8 <= len(changed) <= 32


def test_objects_smaller_than_the_minimum_are_left_alone():
    labels = np.full((50, 50), 7, np.uint8)
    labels[10:13, 10:13] = 1
    spoilt = spoil_label_objects(labels, ObjectNoise(missed=1.0), np.random.default_rng(0), (1, 2), labels, 10)
    np.testing.assert_array_equal(spoilt, labels)


def test_the_same_seed_gives_the_same_labels():
    noise = ObjectNoise(0.2, 0.2, 0.1)
    np.testing.assert_array_equal(spoil(noise, 3), spoil(noise, 3))
    assert (spoil(noise, 3) != spoil(noise, 4)).any()
