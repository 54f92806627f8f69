"""Displace parts of an image against the map: boundaries, neighborhoods, classes, leaning roofs."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from ..landmarks.landmarks import class_mask
from .fields import correlated_field, smooth_noise
from .noise import JITTER_LENGTH_PX, LabelNoise
from .regions import fill_from_around, regions_of

FIELD_STEP_PX = 8
"""Displacements are computed at every eighth pixel, because they change slowly."""


def displace(labels_hw: np.ndarray, noise: LabelNoise, rng: np.random.Generator) -> np.ndarray:
    """Return a label image with boundary jitter, displaced ground and class offsets.

    Args:
        labels_hw: (H, W) uint8
        noise: In pixels.

    Returns:
        (H, W) uint8, resampled once, so that boundary jitter keeps shifts of less than a pixel.
    """
    if not (noise.jitter or noise.displaced or noise.class_shifts):
        return labels_hw
    columns, rows = np.meshgrid(*(np.arange(size, dtype=np.float32) for size in labels_hw.shape[::-1]))
    if noise.jitter > 0:
        length = noise.jitter_length or JITTER_LENGTH_PX
        columns += noise.jitter * smooth_noise(labels_hw.shape, length, rng)
        rows += noise.jitter * smooth_noise(labels_hw.shape, length, rng)
    if noise.displaced > 0:
        shifts = correlated_field(labels_hw.shape, noise.displaced_kernels, FIELD_STEP_PX, rng)
        columns += noise.displaced * shifts[0]
        rows += noise.displaced * shifts[1]
    moved = _read(labels_hw, columns, rows)
    values = [value for value, *_ in noise.class_shifts]
    lost = np.isin(moved, values)
    moved = fill_from_around(moved, lost, ~lost)
    for value, right, down in noise.class_shifts:
        moved[_read(class_mask(labels_hw, value), columns - np.float32(right), rows - np.float32(down)) > 0] = value
    return moved


def with_leaning_roofs(
    labels_hw: np.ndarray,
    noise: LabelNoise,
    rng: np.random.Generator,
    class_values: Sequence[int],
    minimum_area_px: float,
) -> np.ndarray:
    """Return a label image with raised landmarks that lean away from its center, as seen from straight above.

    Args:
        labels_hw: (H, W) uint8
        noise: Amount of leaning, and its classes.
        class_values: Classes that lean unless the noise has its own.
        minimum_area_px: Smaller regions do not move.

    Returns:
        (H, W) uint8. Each region moves by whole pixels; the pixels it leaves get the label around them.
    """
    values = noise.leaning_classes or tuple(class_values)
    regions = regions_of(labels_hw, values, minimum_area_px) if noise.leaning > 0 else []
    if not regions:
        return labels_hw
    shape = np.array(labels_hw.shape)
    firsts = np.array([[part.start for part in region.box] for region in regions])
    lengths = np.array([region.mask.shape for region in regions])
    away = firsts + lengths / 2 - shape / 2
    moves = np.rint(leaning_shifts(away, noise, rng)).astype(np.int64)
    leaning, lost = labels_hw.copy(), np.zeros(labels_hw.shape, bool)
    for region in regions:
        lost[region.box] |= region.mask
    leaning = fill_from_around(leaning, lost, ~lost)
    for region, (first_row, first_column), (down, right) in zip(regions, firsts, moves):
        rows, columns = np.nonzero(region.mask)
        rows, columns = rows + first_row + down, columns + first_column + right
        inside = (rows >= 0) & (columns >= 0) & (rows < shape[0]) & (columns < shape[1])
        leaning[rows[inside], columns[inside]] = region.value
    return leaning


def leaning_shifts(away: np.ndarray, noise: LabelNoise, rng: np.random.Generator) -> np.ndarray:
    """Return (n, 2) shifts of raised landmarks of random height at (n, 2) offsets from the image's center."""
    return noise.leaning * np.exp(noise.leaning_spread * rng.normal(size=len(away)))[:, None] * away


def _read(image_hw: np.ndarray, columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
    return cv2.remap(image_hw, columns, rows, cv2.INTER_NEAREST, borderMode=cv2.BORDER_REPLICATE)
