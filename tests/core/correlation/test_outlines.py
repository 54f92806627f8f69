"""Outlines: the edges of a photo against those of the map's classes."""

import cv2
import numpy as np
import pytest
from made_patches import PRIOR, error_m, view

from semref.core.correlation.class_pyramid import EvidenceLevel
from semref.core.correlation.outlines import agreement, map_edges, photo_edges
from semref.core.correlation.solver import localize
from semref.core.labels.class_shares import ClassShares

EDGE = 64
WHOLE = np.ones((EDGE, EDGE), np.float32)


def houses(seed: int = 3) -> np.ndarray:
    """Return (EDGE, EDGE) float32: 1 on the roofs of 20 houses."""
    rng, plane = np.random.default_rng(seed), np.zeros((EDGE, EDGE), np.float32)
    for center in rng.uniform(4, EDGE - 4, (20, 2)):
        box = cv2.boxPoints((center.tolist(), rng.uniform(4, 9, 2).tolist(), float(rng.uniform(0, 90))))
        cv2.fillPoly(plane, [np.rint(box * 8).astype(np.int32)], 1.0, cv2.LINE_AA, 3)
    return plane


def photographed(plane: np.ndarray, contrast: float = 1.0) -> EvidenceLevel:
    """Return a photo of houses in gray and noise, without labels of any use."""
    rng = np.random.default_rng(4)
    gray = 120 + 30 * contrast * plane + rng.normal(0, 6, plane.shape)
    picture = np.repeat(np.clip(gray, 0, 255).astype(np.uint8)[..., None], 3, axis=2)
    return EvidenceLevel(np.zeros((EDGE, EDGE, 1), np.float32), WHOLE, (1.0, 1.0), picture)


def compared(image: EvidenceLevel, plane: np.ndarray, known: np.ndarray = WHOLE) -> float:
    return agreement(photo_edges(image), map_edges(plane[..., None], known))


@pytest.mark.parametrize("contrast", [1.0, -1.0, 0.5])
def test_the_edges_of_a_photo_agree_with_the_map_of_its_place_only(contrast):
    image, plane = photographed(houses(), contrast), houses()
    right = compared(image, plane)
    wrong = [compared(image, other) for other in (plane[:, ::-1], plane.T, np.rot90(plane), houses(5), houses(6))]
    assert right > 10 and right > compared(image, np.roll(plane, 2, axis=1)) > 8
    assert max(wrong) < 5 and compared(image, np.roll(plane, 9, axis=1)) < 5


def test_a_uniform_photo_or_map_has_no_edges_and_labels_have_no_photo():
    nothing = np.zeros((EDGE, EDGE), np.float32)
    assert compared(photographed(nothing), nothing) == 0
    assert photo_edges(EvidenceLevel(WHOLE[..., None], WHOLE, (1.0, 1.0))) is None


def test_where_the_map_or_the_photo_ends_is_no_outline():
    known = WHOLE.copy()
    known[:, 40:] = 0
    assert np.abs(map_edges((WHOLE * known)[..., None], known)).max() < 0.05
    picture = (200 * known[..., None].repeat(3, axis=2)).astype(np.uint8)
    assert np.abs(photo_edges(EvidenceLevel(WHOLE[..., None], known, (1.0, 1.0), picture))).max() < 0.1


def test_the_photo_confirms_the_place_that_poor_labels_suggest_and_no_other(labels, pyramid):
    center = 1500.0, 1000.0
    seen = view(labels, center, 33.0, 1.0)
    rng = np.random.default_rng(7)
    values = np.arange(1, 7, dtype=np.uint8)
    # Labels of blocks of 35 × 35 pixels, most of them wrong: some agreement, and no position.
    blocks = seen[17::35, 17::35]
    blocks = np.where(rng.random(blocks.shape) < 0.75, rng.integers(1, 7, blocks.shape), blocks).astype(np.uint8)
    poor = cv2.resize(blocks, seen.shape[::-1], interpolation=cv2.INTER_NEAREST)
    planes = (cv2.resize(poor, (280, 280), interpolation=cv2.INTER_NEAREST)[..., None] == values) * np.uint8(255)
    grays = np.array([0, 90, 110, 130, 100, 140, 120], np.uint8)[seen]
    picture = np.repeat(cv2.resize(grays, (280, 280), interpolation=cv2.INTER_AREA)[..., None], 3, axis=2)
    alone, shown, mirrored = (
        localize(poor, pyramid, PRIOR, shares=ClassShares(values, planes, one))
        for one in (None, picture, np.ascontiguousarray(picture[:, ::-1]))
    )
    assert not alone.is_fix and not mirrored.is_fix
    assert shown.is_fix and error_m(shown.best, center) < 3 < error_m(alone.best, center)
    assert alone.peaks.outlines is None and shown.peaks.outlines > 5
