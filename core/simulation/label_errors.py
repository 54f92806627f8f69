"""Add simulated errors to label images, in the order in which errors happen.

Landmarks are missed, mislabeled or spurious; roofs lean; boundaries and neighborhoods move; background gets other
classes. A value of 0 skips a step. Every function uses its random generator, so that a seed repeats an image.

Example:
    >>> noise = LabelNoise(missed=0.2, spurious=0.2, mislabeled=0.05, jitter=1.0)   # lengths in m
    >>> labels_hw = spoil_labels(labels_hw, noise.in_pixels(pixel_size), rng, (1, 2, 3), donor_hw)
"""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from ..labels.class_table import UNLABELED
from .displacement import displace, with_leaning_roofs
from .noise import LabelNoise
from .regions import ClassRegion, fill_from_around, regions_of

PLACES_TRIED = 20
"""A spurious landmark is dropped if this many random places have no room for it."""


def spoil_labels(  # noqa: PLR0913 - an image, how it is spoiled, and what is known of its classes
    labels_hw: np.ndarray,
    noise: LabelNoise,
    rng: np.random.Generator,
    class_values: Sequence[int],
    donor_hw: np.ndarray | None = None,
    minimum_area_px: float = 1.0,
) -> np.ndarray:
    """Return a label image with the errors of a network or an annotator.

    Args:
        labels_hw: (H, W) uint8; not changed.
        noise: In pixels of the image.
        class_values: Classes of landmarks; landmarks are missed, added and mislabeled only there.
        donor_hw: Labels of another place at the same scale; its landmarks are the spurious ones. None without any.
        minimum_area_px: Smaller regions are no landmarks.

    Returns:
        (H, W) uint8. Random classes are those of the image, so that an image of one class does not change.
    """
    labels = labels_hw.copy()
    if not labels.size:
        return labels
    labels = with_changed_landmarks(labels, noise, rng, class_values, donor_hw, minimum_area_px)
    labels = displace(labels, noise, rng)
    return with_mislabeled_background(labels, noise.background, rng, class_values, minimum_area_px)


def with_changed_landmarks(  # noqa: PLR0913 - as spoil_labels
    labels_hw: np.ndarray,
    noise: LabelNoise,
    rng: np.random.Generator,
    class_values: Sequence[int],
    donor_hw: np.ndarray | None,
    minimum_area_px: float,
) -> np.ndarray:
    """Return labels with missed, mislabeled, spurious and leaning landmarks.

    Missed landmarks get the nearest label of no landmark; spurious ones do not touch others.
    """
    if donor_hw is None and not noise.changes_landmarks:
        return with_leaning_roofs(labels_hw, noise, rng, class_values, minimum_area_px)
    regions = regions_of(labels_hw, class_values, minimum_area_px)
    missed = rng.random(len(regions)) < noise.missed
    missed &= np.array([region.area_px < noise.missed_below for region in regions], bool)
    classes = mislabel(np.array([r.value for r in regions]), np.unique(class_values), noise.mislabeled, rng)
    count = rng.binomial(len(regions), min(noise.spurious, 1.0))
    spoiled, lost = labels_hw.copy(), np.zeros(labels_hw.shape, bool)
    for region, is_missed, value in zip(regions, missed, classes):
        if is_missed:
            lost[region.box] |= region.mask
        else:
            spoiled[region.box][region.mask] = value
    spoiled = fill_from_around(spoiled, lost, ~np.isin(labels_hw, class_values))
    if donor_hw is not None:
        _draw_spurious(spoiled, regions_of(donor_hw, class_values, minimum_area_px), count, rng, class_values)
    return with_leaning_roofs(spoiled, noise, rng, class_values, minimum_area_px)


def _draw_spurious(
    labels_hw: np.ndarray, donors: list[ClassRegion], count: int, rng: np.random.Generator, class_values: Sequence[int]
) -> None:
    """Draw ``count`` of the donors into ``labels_hw`` itself, each with a margin of a pixel to other landmarks."""
    taken = np.isin(labels_hw, class_values)
    for number in rng.integers(0, len(donors), count if donors else 0):
        mask = np.pad(donors[number].mask, 1)
        around = cv2.dilate(mask.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
        rows, columns = (whole - part + 1 for whole, part in zip(labels_hw.shape, mask.shape))
        if rows < 1 or columns < 1:
            continue
        for top, left in zip(rng.integers(0, rows, PLACES_TRIED), rng.integers(0, columns, PLACES_TRIED)):
            box = np.s_[top : top + mask.shape[0], left : left + mask.shape[1]]
            if not (taken[box] & around).any():
                labels_hw[box][mask] = donors[number].value
                taken[box] |= mask
                break


def with_mislabeled_background(
    labels_hw: np.ndarray, share: float, rng: np.random.Generator, class_values: Sequence[int], minimum_area_px: float
) -> np.ndarray:
    """Return labels with another class in a share of the regions outside the classes of landmarks."""
    if share <= 0:
        return labels_hw
    others = np.setdiff1d(np.unique(labels_hw), [UNLABELED, *class_values])
    if len(others) < 2:
        return labels_hw
    regions = regions_of(labels_hw, others.tolist(), minimum_area_px)
    classes = mislabel(np.array([region.value for region in regions]), others, share, rng)
    spoiled = labels_hw.copy()
    for region, value in zip(regions, classes):
        spoiled[region.box][region.mask] = value
    return spoiled


def mislabel(classes: np.ndarray, known: np.ndarray, share: float, rng: np.random.Generator) -> np.ndarray:
    """Return classes with a share of them changed to any other known class."""
    if len(known) < 2:
        return classes
    step = rng.integers(1, len(known), len(classes))
    other = known[(np.searchsorted(known, classes) + step) % len(known)]
    return np.where(rng.random(len(classes)) < share, other, classes).astype(np.uint8)
