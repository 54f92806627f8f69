"""Class offsets of a prediction, and differences between pieces of ground."""

import numpy as np
import pytest

from semref.core.landmarks.class_shifts import PieceShift, class_shifts, piece_shifts
from semref.core.simulation.label_errors import spoil_labels
from semref.core.simulation.noise import LabelNoise

HOUSE, POND, FIELD = 1, 2, 3


def ground(rng, size=400):
    """Return houses and ponds on a field, apart from each other."""
    labels = np.full((size, size), FIELD, np.uint8)
    for row in range(10, size - 30, 32):
        for column in range(10, size - 30, 32):
            top, left = row + rng.integers(0, 6), column + rng.integers(0, 6)
            height, width = rng.integers(9, 18, 2)
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


def test_what_no_other_image_shows_is_no_pair(rng):
    true = ground(rng)
    assert piece_shifts(true, np.full_like(true, FIELD), (HOUSE, POND)) == []


def test_only_pieces_that_disagree_have_a_spread(rng):
    def pieces(between):
        drawn = 0.7 - 0.2j + between * (rng.normal(size=60) + 1j * rng.normal(size=60))
        drawn += 0.1 * (rng.normal(size=60) + 1j * rng.normal(size=60))
        return [PieceShift(HOUSE, 20, complex(shift), 0.01) for shift in drawn]

    (alike,), (apart,) = class_shifts(pieces(0.0)), class_shifts(pieces(0.5))
    assert alike.shift == pytest.approx(0.7 - 0.2j, abs=0.1) and alike.spread < 0.08
    assert apart.spread == pytest.approx(0.5, rel=0.25) and apart.deviation == pytest.approx(0.5 / 60**0.5, rel=0.25)
    assert (apart.pairs, apart.pieces) == (1200, 60)
