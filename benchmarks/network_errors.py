"""Errors of networks that the plugin does not simulate: merged, cut and lost landmarks, wrong patches."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np

from semref.core.landmarks.landmarks import class_mask
from semref.core.simulation.displacement import displace
from semref.core.simulation.fields import smooth_noise
from semref.core.simulation.label_errors import with_changed_landmarks, with_mislabeled_background
from semref.core.simulation.noise import LabelNoise
from semref.core.simulation.regions import fill_from_around, nearest_zero

MERGED_LENGTH_PX = 100.0
"""Size of the parts of an image in which landmarks merge, if they do so in a share of it."""

LARGEST_KERNEL_PX = 61
"""Largest ellipse of morphology; limits the time on very fine images."""


@dataclass(frozen=True)
class NetworkNoise(LabelNoise):
    """Errors of the labels of an image. Lengths are in m, or in pixels after ``in_pixels``.

    Attributes:
        merge_gap: Gaps between landmarks of a class up to this width are filled.
        merge_share: Share of the image in which gaps are filled.
        split: Probability that a landmark is cut across.
        split_length: Only longer landmarks are cut.
        split_gap: Width of the cut.
        thin: Narrower parts of any class are lost.
        patches: Share of the area that gets random classes, in whole patches.
        patch_size: Approximate edge of such a patch.
    """

    merge_gap: float = 0.0
    merge_share: float = 1.0
    split: float = 0.0
    split_length: float = 0.0
    split_gap: float = 3.0
    thin: float = 0.0
    patches: float = 0.0
    patch_size: float = 80.0

    def in_pixels(self, pixel_size: float) -> NetworkNoise:
        lengths = ("merge_gap", "split_length", "split_gap", "thin", "patch_size")
        return replace(super().in_pixels(pixel_size), **{name: getattr(self, name) / pixel_size for name in lengths})


def spoil(
    labels_hw: np.ndarray,
    noise: NetworkNoise,
    rng: np.random.Generator,
    class_values: Sequence[int],
    donor_hw: np.ndarray | None = None,
    minimum_area_px: float = 1.0,
) -> np.ndarray:
    """Return a label image with the errors of a network, as ``spoil_labels`` with some more errors."""
    labels = with_changed_landmarks(labels_hw.copy(), noise, rng, class_values, donor_hw, minimum_area_px)
    for value in class_values:
        labels = _merge(labels, value, noise, rng)
        labels = _split(labels, value, noise, rng)
    labels = displace(_without_thin_parts(labels, noise.thin), noise, rng)
    labels = with_mislabeled_background(labels, noise.background, rng, class_values, minimum_area_px)
    return _with_swapped_patches(labels, noise, rng)


def _merge(labels_hw: np.ndarray, value: int, noise: NetworkNoise, rng: np.random.Generator) -> np.ndarray:
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


def _split(labels_hw: np.ndarray, value: int, noise: NetworkNoise, rng: np.random.Generator) -> np.ndarray:
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


def _with_swapped_patches(labels_hw: np.ndarray, noise: NetworkNoise, rng: np.random.Generator) -> np.ndarray:
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
