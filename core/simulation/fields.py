"""Random fields with correlated neighbors, which shift boundaries and parts of a map.

Every function uses its random generator, so that a seed repeats a field.
"""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

WAVES = 96
"""Plane waves for each kernel of a correlated field."""


def smooth_noise(shape_hw: tuple[int, ...], length_px: float, rng: np.random.Generator) -> np.ndarray:
    """Return (H, W) float32 of variance 1, similar over about ``length_px``: white noise on a coarse grid, enlarged."""
    small = tuple(max(int(np.ceil(size / max(length_px, 1.0))) + 1, 2) for size in shape_hw)
    field = rng.normal(size=small).astype(np.float32)
    field = cv2.resize(field, (shape_hw[1], shape_hw[0]), interpolation=cv2.INTER_CUBIC)
    return field / max(float(field.std()), 1e-6)


def correlated_shifts(
    points_xy: np.ndarray, kernels: Sequence[tuple[float, float]], rng: np.random.Generator
) -> np.ndarray:
    """Return shifts of points, standard normal along each axis and similar for near points: a Gaussian random field.

    The correlation of points at a distance d is the sum of share · exp(−d / length) over the kernels. Each kernel is a
    sum of plane waves with random directions and with wavelengths from the kernel's spectrum (random Fourier features,
    Rahimi and Recht 2007), so that the time does not depend on the extent of a field.

    Args:
        points_xy: (n, 2), anywhere
        kernels: (length in the unit of the points, share of the variance); shares below 1 in total reduce the variance.

    Returns:
        (n, 2) shifts along both axes, independent of each other.
    """
    shifts = np.zeros((len(points_xy), 2))
    for length, share in kernels:
        for axis in range(2):
            # The spectrum of an exponential kernel in the plane is Student's with one degree of freedom.
            waves = rng.normal(size=(2, WAVES)) / np.abs(rng.normal(size=WAVES)).clip(1e-6) / length
            phases = rng.uniform(0, 2 * np.pi, WAVES)
            shifts[:, axis] += np.sqrt(2 * share / WAVES) * np.cos(points_xy @ waves + phases).sum(axis=1)
    return shifts


def correlated_field(
    shape_hw: tuple[int, ...], kernels: Sequence[tuple[float, float]], step_px: int, rng: np.random.Generator
) -> np.ndarray:
    """Return ``correlated_shifts`` for all pixels of an image, computed every ``step_px`` and interpolated.

    Args:
        kernels: As in ``correlated_shifts``, lengths in pixels.
        step_px: Between computed places.

    Returns:
        (2, H, W) float32: shifts along columns and along rows.
    """
    height, width = (-(-size // step_px) + 1 for size in shape_hw)
    columns, rows = np.meshgrid(np.arange(width), np.arange(height))
    coarse = correlated_shifts(step_px * np.column_stack([columns.ravel(), rows.ravel()]), kernels, rng)
    at = [np.arange(size, dtype=np.float32) / step_px for size in shape_hw]
    at_rows, at_columns = np.meshgrid(*at, indexing="ij")
    planes = coarse.T.reshape(2, height, width).astype(np.float32)
    return np.stack([cv2.remap(plane, at_columns, at_rows, cv2.INTER_LINEAR) for plane in planes])
