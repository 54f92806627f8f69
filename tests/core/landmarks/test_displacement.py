import numpy as np
import pytest

from semref.core.landmarks.class_shifts import PieceShift, class_shifts, piece_shifts
from semref.core.landmarks.compared import LandmarkErrors, piece_errors
from semref.core.landmarks.displacement import correlations_of, displacement_of
from semref.core.simulation.fields import correlated_shifts
from semref.core.simulation.label_errors import spoil_labels
from semref.core.simulation.noise import LabelNoise

KERNELS = ((60.0, 0.4), (2000.0, 0.4))


def piece(points, offsets, corner=0j):
    return PieceShift(1, len(points), 0j, 1.0, points, offsets, corner)


def points_of(rng, count, size=3000.0):
    return rng.uniform(0, size, (count, 2)) @ (1, 1j)


def test_deviation_and_share_moved_are_those_of_the_offsets():
    rng = np.random.default_rng(1)
    offsets = 2.0 * (rng.normal(size=4000) + 1j * rng.normal(size=4000))
    offsets[:3000] = 0.02
    found = displacement_of([piece(points_of(rng, 4000), offsets)], pixel_size=0.5)
    assert (found.pairs, found.moved) == (4000, pytest.approx(0.25, abs=0.01))
    assert found.moved_deviation == pytest.approx(1.0, rel=0.05)
    assert found.deviation == pytest.approx(0.5, rel=0.05)
    assert all(abs(share) < 0.15 for _, _, share in found.correlations)


def test_correlations_are_those_of_the_field():
    rng = np.random.default_rng(2)
    total = []
    for _ in range(40):
        points = points_of(rng, 400)
        offsets = correlated_shifts(np.column_stack([points.real, points.imag]), KERNELS, rng) @ (1, 1j)
        offsets += 0.2**0.5 * (rng.normal(size=400) + 1j * rng.normal(size=400))
        total.append([share for _, _, share in correlations_of(points, offsets)])
    found = np.mean(total, axis=0)
    middles = np.array([20, 46, 93, 190, 385, 770, 1520])
    wanted = sum(share * np.exp(-middles / length) for length, share in KERNELS)
    np.testing.assert_allclose(found[:5], wanted[:5], atol=0.15)
    assert found[0] > found[3] > found[6]


def test_pieces_are_placed_by_their_corners():
    near, far = piece(np.arange(40) + 0j, np.ones(40) + 0j), piece(np.arange(40) + 0j, -np.ones(40) + 0j, 1500 + 0j)
    ranges = {low: share for low, _, share in displacement_of([near, far]).correlations}
    assert ranges[0] == pytest.approx(1) and ranges[1000] == pytest.approx(-1)


def test_pairs_of_label_images_have_their_places_and_offsets():
    true = np.zeros((200, 200), np.uint8)
    for row in range(10, 170, 40):
        for column in range(10, 170, 40):
            true[row : row + 12, column : column + 12] = 1
    found = displacement_of(piece_shifts(true, np.roll(true, (2, 3), (0, 1)), (1,), 100 + 0j), 2.0)
    assert (found.pairs, found.moved) == (16, 1.0)
    assert found.deviation == pytest.approx(2.0 * abs(3 + 2j) / 2**0.5)


def test_maps_without_common_landmarks_have_no_displacement(rng):
    assert displacement_of([]) is None
    same = displacement_of([piece(np.zeros(5, complex), np.zeros(5, complex))])
    assert (same.moved, same.deviation, same.correlations) == (0.0, 0.0, ())
    true = ground(rng)
    assert piece_shifts(true, np.full_like(true, FIELD), (HOUSE, POND)) == []


HOUSE, POND, FIELD = 1, 2, 3


def ground(rng, size=500, is_sparse=False):
    labels = np.full((size, size), FIELD, np.uint8)
    for row in range(10, size - 40, 40):
        for column in range(10, size - 40, 40):
            if is_sparse and rng.random() < 0.5:
                continue
            top, left = row + rng.integers(0, 6), column + rng.integers(0, 6)
            height, width = rng.integers(12, 22, 2)
            labels[top : top + height, left : left + width] = rng.choice([HOUSE, HOUSE, POND])
    return labels


@pytest.fixture
def rng():
    return np.random.default_rng(4)


@pytest.mark.parametrize("shift", [(0.0, 0.0), (1.0, -2.0), (3.0, 3.0)])
def test_a_class_that_is_shifted_is_found_and_the_other_is_not(rng, shift):
    true = ground(rng)
    noise = LabelNoise(jitter=1.0, missed=0.2, class_shifts=((HOUSE, *shift),))
    predicted = spoil_labels(true, noise, rng, (HOUSE, POND))
    found = {piece.value: piece for piece in piece_shifts(true, predicted, (HOUSE, POND))}
    assert found[HOUSE].pairs > 40 and found[POND].pairs > 15
    assert abs(found[HOUSE].shift - complex(*shift)) < 0.35 and abs(found[POND].shift) < 0.35
    assert abs(found[HOUSE].shift - complex(*shift)) < 4 * np.sqrt(found[HOUSE].variance)


def test_only_pieces_that_disagree_have_a_spread(rng):
    def pieces(between):
        drawn = 0.7 - 0.2j + between * (rng.normal(size=60) + 1j * rng.normal(size=60))
        drawn += 0.1 * (rng.normal(size=60) + 1j * rng.normal(size=60))
        return [PieceShift(HOUSE, 20, complex(shift), 0.01) for shift in drawn]

    (alike,), (apart,) = class_shifts(pieces(0.0)), class_shifts(pieces(0.5))
    assert alike.shift == pytest.approx(0.7 - 0.2j, abs=0.1) and alike.spread < 0.08
    assert apart.spread == pytest.approx(0.5, rel=0.25) and apart.deviation == pytest.approx(0.5 / 60**0.5, rel=0.25)
    assert (apart.pairs, apart.pieces) == (1200, 60)


CLASSES = (HOUSE, POND)
AREA_PX = 50


def errors(noise, pieces=6):
    rng = np.random.default_rng(7)
    total = LandmarkErrors()
    for _ in range(pieces):
        true = ground(rng, is_sparse=True)
        predicted = spoil_labels(true, noise, rng, CLASSES, donor_hw=ground(rng))
        for one in piece_errors(true, predicted, CLASSES, AREA_PX).values():
            total += one
    return total


def test_what_agrees_has_no_errors_and_landmarks_that_were_added_are_found():
    found = errors(LabelNoise())
    assert found.annotated > 250
    assert (found.missed, found.misnamed, found.invented) == (0, 0, 0) and found.ragged_px() == 0
    found = errors(LabelNoise(spurious=0.2, jitter=0.5))
    # Some overlap others, and hide or enlarge them.
    assert 0.1 < found.invented / found.annotated < 0.25


@pytest.mark.parametrize("share", [0.1, 0.3])
@pytest.mark.parametrize(("name", "attribute"), [("missed", "missed"), ("mislabeled", "misnamed")])
def test_shares_of_landmarks_that_were_spoiled_are_found(name, attribute, share):
    found = errors(LabelNoise(**{name: share}, jitter=0.5))
    others = {"missed", "misnamed"} - {attribute}
    assert getattr(found, attribute) / found.annotated == pytest.approx(share, abs=0.06)
    assert all(getattr(found, other) / found.annotated < 0.02 for other in others)


@pytest.mark.parametrize("jitter", [0.7, 1.5, 2.5])
def test_boundary_jitter_is_measured(jitter):
    assert errors(LabelNoise(jitter=jitter)).ragged_px() == pytest.approx(jitter, rel=0.3)


def test_unannotated_ground_is_not_counted_as_spurious():
    rng = np.random.default_rng(3)
    predicted = ground(rng)
    (houses, ponds) = piece_errors(np.zeros_like(predicted), predicted, CLASSES, AREA_PX).values()
    assert houses == ponds == LandmarkErrors() and houses.ragged_px() is None
