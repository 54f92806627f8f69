import math

import numpy as np
import pytest
from made_labels import squares

from semref.core.errors import ParameterError
from semref.core.landmarks.landmarks import Landmarks, extract_landmarks
from semref.core.simulation.label_errors import spoil_labels
from semref.core.simulation.landmark_errors import spoil_landmarks, with_moved_boundaries
from semref.core.simulation.noise import USUAL, LabelNoise

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
    seen = extract_landmarks(spoil_labels(squares(), noise, np.random.default_rng(9), (1, 2)), (1, 2), 50)
    before = extract_landmarks(squares(), (1, 2), 50)
    off = np.array([before.centers_xy[np.hypot(*(before.centers_xy - c).T).argmin()] - c for c in seen.centers_xy])
    moved = with_moved_boundaries(before, noise, np.random.default_rng(1))
    assert (moved.centers_xy - before.centers_xy).std() == pytest.approx(off.std(), rel=0.4)


def test_a_shifted_class_is_shifted_as_one():
    landmarks = many_landmarks(50)
    off = spoiled_landmarks(LabelNoise(class_shifts=((2, 3.0, -1.0),)), landmarks).centers_xy - landmarks.centers_xy
    np.testing.assert_allclose(off[landmarks.classes == 2], np.tile([3.0, -1.0], (25, 1)))
    assert not off[landmarks.classes == 1].any()


def test_leaning_landmarks_are_farther_from_the_center_by_that_share():
    landmarks = many_landmarks()
    noise = LabelNoise(leaning=0.01, leaning_spread=0.0, leaning_classes=(2,))
    off = spoiled_landmarks(noise, landmarks).centers_xy - landmarks.centers_xy
    leans = landmarks.classes == 2
    np.testing.assert_allclose(off[leans], 0.01 * (landmarks.centers_xy[leans] - 500))
    assert not off[~leans].any()


def test_near_landmarks_are_displaced_alike_and_far_ones_less():
    landmarks, far, near = many_landmarks(300), [], []
    noise = LabelNoise(displaced=2.0, displaced_kernels=((100.0, 1.0),))
    away = np.hypot(*(landmarks.centers_xy[:, None] - landmarks.centers_xy).transpose(2, 0, 1))
    for seed in range(30):
        off = spoiled_landmarks(noise, landmarks, seed).centers_xy - landmarks.centers_xy
        products = (off[:, None] * off).mean(axis=2)
        near.append(products[(away > 0) & (away < 20)].mean())
        far.append(products[away > 400].mean())
    assert np.mean(near) == pytest.approx(4 * 0.88, rel=0.25) and abs(np.mean(far)) < 1.0


@pytest.mark.parametrize("wrong", [{"jitter": -1.0}, {"leaning": 1.5}, {"missed": math.nan}, {"jitter": math.inf}])
def test_impossible_noise_is_refused_by_name(wrong):
    with pytest.raises(ParameterError, match=next(iter(wrong))):
        LabelNoise(**wrong)


def test_lengths_areas_and_shared_errors_are_converted_to_pixels():
    noise = LabelNoise(missed=0.2, jitter=3.0, jitter_length=9.0, missed_below=200.0).in_pixels(0.5)
    assert (noise.missed, noise.jitter, noise.jitter_length) == (0.2, 6.0, 18.0)
    assert noise.missed_below == 800.0
    assert USUAL.in_pixels(0.5).jitter_length is None and USUAL.in_pixels(0.5).missed_below == math.inf
    noise = LabelNoise(displaced=1.0, displaced_kernels=((10.0, 1.0),), class_shifts=((3, 1.0, -2.0),)).in_pixels(0.5)
    assert (noise.displaced, noise.displaced_kernels, noise.class_shifts) == (2.0, ((20.0, 1.0),), ((3, 2.0, -4.0),))
