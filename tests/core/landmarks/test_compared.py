"""Comparing noisy labels with the originals recovers the noise."""

import numpy as np
import pytest

from semref.core.landmarks.compared import LandmarkErrors, piece_errors
from semref.core.simulation.label_errors import spoil_labels
from semref.core.simulation.noise import LabelNoise

HOUSE, POND, FIELD = 1, 2, 3
CLASSES = (HOUSE, POND)
AREA_PX = 50


def ground(rng, size=500, is_sparse=False):
    """Return houses and ponds on a field, apart from each other."""
    labels = np.full((size, size), FIELD, np.uint8)
    for row in range(10, size - 40, 40):
        for column in range(10, size - 40, 40):
            if is_sparse and rng.random() < 0.5:
                continue
            top, left = row + rng.integers(0, 6), column + rng.integers(0, 6)
            height, width = rng.integers(12, 22, 2)
            labels[top : top + height, left : left + width] = rng.choice([HOUSE, HOUSE, POND])
    return labels


def errors(noise, pieces=6):
    """Return the errors of several pieces of ground, of all classes together."""
    rng = np.random.default_rng(7)
    total = LandmarkErrors()
    for _ in range(pieces):
        true = ground(rng, is_sparse=True)
        predicted = spoil_labels(true, noise, rng, CLASSES, donor_hw=ground(rng))
        for one in piece_errors(true, predicted, CLASSES, AREA_PX).values():
            total += one
    return total


def test_what_agrees_has_no_errors():
    found = errors(LabelNoise())
    assert found.annotated > 250
    assert (found.missed, found.misnamed, found.invented) == (0, 0, 0) and found.ragged_px() == 0


@pytest.mark.parametrize("share", [0.1, 0.3])
@pytest.mark.parametrize(("name", "attribute"), [("missed", "missed"), ("mislabeled", "misnamed")])
def test_shares_of_landmarks_that_were_spoiled_are_found(name, attribute, share):
    found = errors(LabelNoise(**{name: share}, jitter=0.5))
    others = {"missed", "misnamed"} - {attribute}
    assert getattr(found, attribute) / found.annotated == pytest.approx(share, abs=0.06)
    assert all(getattr(found, other) / found.annotated < 0.02 for other in others)


def test_landmarks_that_were_added_are_found():
    found = errors(LabelNoise(spurious=0.2, jitter=0.5))
    # Some overlap others, and hide or enlarge them.
    assert 0.1 < found.invented / found.annotated < 0.25


@pytest.mark.parametrize("jitter", [0.7, 1.5, 2.5])
def test_boundary_jitter_is_measured(jitter):
    assert errors(LabelNoise(jitter=jitter)).ragged_px() == pytest.approx(jitter, rel=0.3)


def test_unannotated_ground_is_not_counted_as_spurious():
    rng = np.random.default_rng(3)
    predicted = ground(rng)
    (houses, ponds) = piece_errors(np.zeros_like(predicted), predicted, CLASSES, AREA_PX).values()
    assert houses == ponds == LandmarkErrors() and houses.ragged_px() is None
