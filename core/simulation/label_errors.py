"""Add simulated errors to label images, in the order in which errors happen.

Landmarks are missed, mislabeled or spurious; roofs lean; near landmarks merge, long ones split; thin parts vanish;
boundaries and neighborhoods move; background and patches get other classes. A value of 0 skips a step. Every function
uses its random generator, so that a seed repeats an image.

Example:
    >>> noise = LabelNoise(missed=0.2, spurious=0.2, mislabeled=0.05, jitter=1.0)   # lengths in m
    >>> labels_hw = spoil_labels(labels_hw, noise.in_pixels(pixel_size), rng, (1, 2, 3), donor_hw)
"""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from ..labels.class_table import UNLABELED
from ..landmarks.landmarks import class_mask
from .displacement import displace, with_leaning_roofs
from .fields import smooth_noise
from .noise import LabelNoise
from .regions import ClassRegion, fill_from_around, nearest_zero, regions_of

MERGED_LENGTH_PX = 100.0
"""Size of the parts of an image in which landmarks merge, if they do so in a share of it."""

PLACES_TRIED = 20
"""A spurious landmark is dropped if this many random places have no room for it."""

LARGEST_KERNEL_PX = 61
"""Largest ellipse of morphology; limits the time on very fine images."""


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
        rng: A seeded one repeats the image.
        class_values: Classes of landmarks; landmarks are missed, added, mislabeled, merged and split only there.
        donor_hw: Labels of another place at the same scale; its landmarks are the spurious ones. None without any.
        minimum_area_px: Smaller regions are no landmarks.

    Returns:
        (H, W) uint8. Random classes are those of the image, so that an image of one class does not change.
    """
    labels = labels_hw.copy()
    if not labels.size:
        return labels
    if donor_hw is not None or noise.changes_landmarks:
        labels = _with_changed_landmarks(labels, noise, rng, class_values, donor_hw, minimum_area_px)
    labels = with_leaning_roofs(labels, noise, rng, class_values, minimum_area_px)
    for value in class_values:
        labels = _merge(labels, value, noise, rng)
        labels = _split(labels, value, noise, rng)
    labels = displace(_without_thin_parts(labels, noise.thin), noise, rng)
    labels = _with_mislabeled_background(labels, noise.background, rng, class_values, minimum_area_px)
    return _with_swapped_patches(labels, noise, rng)


def _with_changed_landmarks(  # noqa: PLR0913 - as spoil_labels
    labels_hw: np.ndarray,
    noise: LabelNoise,
    rng: np.random.Generator,
    class_values: Sequence[int],
    donor_hw: np.ndarray | None,
    minimum_area_px: float,
) -> np.ndarray:
    """Missed landmarks get the nearest label of no landmark; spurious ones do not touch others."""
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
    return spoiled


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


def _with_mislabeled_background(
    labels_hw: np.ndarray,
    share: float,
    rng: np.random.Generator,
    class_values: Sequence[int],
    minimum_area_px: float,
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


def _merge(labels_hw: np.ndarray, value: int, noise: LabelNoise, rng: np.random.Generator) -> np.ndarray:
    """Return labels with gaps between regions of a class filled, in a share of the image (morphological closing)."""
    kernel = _ellipse(noise.merge_gap)
    if kernel is None:
        return labels_hw
    closed = cv2.morphologyEx(
        class_mask(labels_hw, value), cv2.MORPH_CLOSE, kernel, borderType=cv2.BORDER_REPLICATE
    ).astype(bool)
    if noise.merge_share < 1:
        field = smooth_noise(labels_hw.shape, MERGED_LENGTH_PX, rng)
        closed &= field <= np.quantile(field, noise.merge_share)
    return np.where(closed, np.uint8(value), labels_hw)


def _split(labels_hw: np.ndarray, value: int, noise: LabelNoise, rng: np.random.Generator) -> np.ndarray:
    """Return labels with long regions of a class cut across, in their middle third, into the label around."""
    if noise.split <= 0:
        return labels_hw
    mask = class_mask(labels_hw, value)
    contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    cuts = np.zeros_like(mask)
    for contour, is_cut in zip(contours, rng.random(len(contours)) < noise.split):
        corners = cv2.boxPoints(cv2.minAreaRect(contour))
        edges = np.roll(corners, -1, axis=0) - corners
        lengths = np.hypot(edges[:, 0], edges[:, 1])
        longest = int(lengths.argmax())
        if not is_cut or lengths[longest] < noise.split_length:
            continue
        at = corners[longest] + edges[longest] * rng.uniform(1 / 3, 2 / 3)
        start, end = (tuple(int(v) for v in np.rint(point)) for point in (at, at + edges[(longest + 1) % 4]))
        cv2.line(cuts, start, end, 1, max(1, int(round(noise.split_gap))))
    return fill_from_around(labels_hw, (cuts & mask) > 0, labels_hw != value)


def _without_thin_parts(labels_hw: np.ndarray, width_px: float) -> np.ndarray:
    """Return labels without parts narrower than ``width_px``, which get the nearest remaining class (opening)."""
    kernel = _ellipse(width_px)
    if kernel is None:
        return labels_hw
    kept = np.zeros(labels_hw.shape, bool)
    for value in np.unique(labels_hw):
        mask = (labels_hw == value).astype(np.uint8)
        kept |= cv2.morphologyEx(mask, cv2.MORPH_OPEN, kernel, borderType=cv2.BORDER_REPLICATE) > 0
    return fill_from_around(labels_hw, ~kept, kept)


def _with_swapped_patches(labels_hw: np.ndarray, noise: LabelNoise, rng: np.random.Generator) -> np.ndarray:
    """Return labels with patches of random classes of the image (possibly the right ones) on a share of the area.

    The patches are cells around random points, with irregular boundaries. Whole cells are selected in random order up
    to the share.
    """
    if noise.patches <= 0:
        return labels_hw
    height, width = labels_hw.shape
    values = np.unique(labels_hw)
    if len(values) < 2:
        return labels_hw
    size_px = max(noise.patch_size, 1.0)
    count = int(np.ceil(4 * height * width / size_px**2))
    points = np.full((height, width), 255, np.uint8)
    points[rng.integers(0, height, count), rng.integers(0, width, count)] = 0
    wandering = LabelNoise(jitter=size_px / 10, jitter_length=0.3 * size_px)
    cells = displace(nearest_zero(points).astype(np.float32), wandering, rng).astype(int)
    areas = np.bincount(cells.ravel())
    order = rng.permutation(len(areas))
    taken = np.zeros(len(areas), bool)
    taken[order[np.cumsum(areas[order]) <= noise.patches * height * width]] = True
    classes = rng.choice(values, len(areas)).astype(np.uint8)
    return np.where(taken[cells], classes[cells], labels_hw).astype(np.uint8)


def _ellipse(diameter_px: float) -> np.ndarray | None:
    """Return a structuring element of about that diameter, odd to avoid shifts; None if it has no effect."""
    size = min(2 * int(round((diameter_px - 1) / 2)) + 1, LARGEST_KERNEL_PX)
    return None if size < 3 else cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
