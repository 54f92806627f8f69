"""Add simulated errors to landmarks when only a database is available."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np

from ..landmarks.landmarks import Landmarks
from .displacement import leaning_shifts
from .fields import correlated_shifts
from .label_errors import mislabel
from .noise import JITTER_LENGTH_PX, LabelNoise

CENTER_SHARE, CENTER_LENGTHS = 0.66, 7.5
"""Boundaries moved by σ move the center of a landmark of size s = √area by CENTER_SHARE · σ / √(1 + s / (CENTER_LENGTHS
· JITTER_LENGTH_PX)) along each axis. Measured on Liechtenstein 2021 with σ of 1, 2 and 3 px, s of 10 to 150 px."""

AREA_SHARE = 1.8
"""The same boundaries change ln area with a standard deviation of AREA_SHARE · σ / s; measured on the same images."""

SAMPLING_AREA = 0.05
"""Standard deviation of ln area from turning and sampling an image; measured on the same images."""


def spoil_landmarks(
    landmarks: Landmarks, noise: LabelNoise, rng: np.random.Generator, population: Landmarks, size_px: tuple[int, int]
) -> Landmarks:
    """Return landmarks of an image with missed, spurious and mislabeled ones and errors of centers and areas.

    Args:
        noise: In pixels of the image; errors that only labels can show are ignored.
        population: Source of class and area (px²) of spurious landmarks, which are anywhere in the image.
        size_px: (width, height) of the image.

    Returns:
        The remaining landmarks, then the spurious ones.
    """
    kept = landmarks.select(rng.random(len(landmarks)) >= noise.missed)
    count = rng.binomial(len(landmarks), min(noise.spurious, 1.0)) if len(population) else 0
    both = concatenate(kept, _spurious(population, count, rng, size_px))
    centers = both.centers_xy + rng.normal(0, noise.center, both.centers_xy.shape)
    centers += _shared_shifts(both, noise, rng, size_px)
    areas = both.areas_px * np.exp(rng.normal(0, noise.log_area, len(both)))
    classes = mislabel(both.classes, np.unique(population.classes), noise.mislabeled, rng)
    return replace(both, centers_xy=centers, classes=classes, areas_px=areas)


def _shared_shifts(
    landmarks: Landmarks, noise: LabelNoise, rng: np.random.Generator, size_px: tuple[int, int]
) -> np.ndarray:
    """Return (n, 2) shifts that landmarks near each other, of one class, or on one side of the image share."""
    shifts = np.zeros(landmarks.centers_xy.shape)
    if noise.displaced > 0:
        shifts += noise.displaced * correlated_shifts(landmarks.centers_xy, noise.displaced_kernels, rng)
    for value, right, down in noise.class_shifts:
        shifts[landmarks.classes == value] += right, down
    if noise.leaning > 0:
        leaning = leaning_shifts(landmarks.centers_xy - np.array(size_px) / 2, noise, rng)
        leans = np.isin(landmarks.classes, noise.leaning_classes or np.unique(landmarks.classes))
        shifts[leans] += leaning[leans]
    return shifts


def with_moved_boundaries(landmarks: Landmarks, noise: LabelNoise, rng: np.random.Generator) -> Landmarks:
    """Return landmarks with the centers and areas of moved boundaries and resampled images."""
    sizes = np.sqrt(landmarks.areas_px)
    deviation = CENTER_SHARE * noise.jitter / np.sqrt(1 + sizes / (CENTER_LENGTHS * JITTER_LENGTH_PX))
    centers = landmarks.centers_xy + rng.normal(0, 1, landmarks.centers_xy.shape) * deviation[:, None]
    spread = np.hypot(AREA_SHARE * noise.jitter / sizes, SAMPLING_AREA)
    areas = landmarks.areas_px * np.exp(rng.normal(0, 1, len(landmarks)) * spread)
    return replace(landmarks, centers_xy=centers, areas_px=areas)


def concatenate(one: Landmarks, other: Landmarks) -> Landmarks:
    """Return both, the first ones first."""
    names = (field.name for field in fields(Landmarks))
    return Landmarks(*(np.concatenate([getattr(one, name), getattr(other, name)]) for name in names))


def _spurious(population: Landmarks, count: int, rng: np.random.Generator, size_px: tuple[int, int]) -> Landmarks:
    drawn = population.select(rng.integers(0, max(len(population), 1), count))
    centers = rng.uniform((0, 0), size_px, (count, 2))
    half = np.sqrt(drawn.areas_px)[:, None] / 2
    bounds = np.column_stack([np.floor(centers - half), np.ceil(centers + half)]).astype(np.int64)
    bounds = np.clip(bounds, 0, np.array([*size_px, *size_px], np.int64))
    touches = (bounds[:, :2] <= 0).any(axis=1) | (bounds[:, 2:] >= np.array(size_px)).any(axis=1)
    return replace(drawn, centers_xy=centers, bounds=bounds, touches_edge=touches)
