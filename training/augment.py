"""Augment photos without changing their classes: rotation, flip, scale, light, color, blur, noise."""

from __future__ import annotations

import cv2
import numpy as np

from .tiles import IGNORED

SCALES = (0.6, 2.0)  # tile pixels per pixel of the piece
QUARTER_TURNS = 0.4  # share of pieces rotated by a multiple of 90°, which keeps pixels sharp
BLUR, NOISE = 0.3, 0.3  # shares of pieces with blur and with noise
LARGEST_BLUR_PX, LARGEST_NOISE = 1.5, 0.04


def random_piece(rng: np.random.Generator, image: np.ndarray, labels: np.ndarray, size: int, scales=SCALES):
    """Return a rotated, flipped, scaled piece of a tile, (size, size, 3) float32 and (size, size) uint8.

    Outside the tile the image is mirrored and the labels are IGNORED.
    """
    height, width = labels.shape
    scale = np.exp(rng.uniform(*np.log(scales)))
    angle = rng.integers(4) * np.pi / 2 if rng.uniform() < QUARTER_TURNS else rng.uniform(0, 2 * np.pi)
    reach = min(scale * size / 2, min(height, width) / 2)
    center = rng.uniform((reach, reach), (width - reach, height - reach))
    c, s = scale * np.cos(angle), scale * np.sin(angle)
    flip = rng.choice([-1, 1])
    matrix = np.array([[flip * c, -s], [flip * s, c]])
    offset = center - 0.5 - matrix @ np.full(2, (size - 1) / 2)
    inverse = np.column_stack([matrix, offset])
    flags = cv2.WARP_INVERSE_MAP
    piece = cv2.warpAffine(image, inverse, (size, size), flags=flags | cv2.INTER_LINEAR, borderMode=cv2.BORDER_REFLECT)
    marks = cv2.warpAffine(labels, inverse, (size, size), flags=flags | cv2.INTER_NEAREST, borderValue=IGNORED)
    return piece, marks


def random_light(rng: np.random.Generator, image: np.ndarray, strength: float = 1.0) -> np.ndarray:
    """Vary exposure, contrast, gamma, saturation and white balance, and sometimes add blur and noise.

    Args:
        image: (H, W, 3) float32 in 0…1.
        strength: Factor for all changes of light and color, not for blur and noise.

    Returns:
        (H, W, 3) float32 in 0…1.
    """
    image = image * np.float32(np.exp(strength * rng.normal(0, 0.2)))
    image = image * np.exp(strength * rng.normal(0, 0.06, 3)).astype(np.float32)
    middle = image.mean()
    contrast, shift = np.exp(strength * rng.normal(0, 0.2)), strength * rng.normal(0, 0.05)
    image = (image - middle) * np.float32(contrast) + middle + np.float32(shift)
    grey = image.mean(axis=2, keepdims=True)
    image = grey + (image - grey) * np.float32(np.exp(strength * rng.normal(0, 0.25)))
    image = np.clip(image, 0, 1) ** np.float32(np.exp(strength * rng.normal(0, 0.15)))
    if rng.uniform() < BLUR:
        image = cv2.GaussianBlur(image, (0, 0), rng.uniform(0.3, LARGEST_BLUR_PX))
    if rng.uniform() < NOISE:
        image = image + rng.standard_normal(image.shape, np.float32) * np.float32(rng.uniform(0, LARGEST_NOISE))
    return np.clip(image, 0, 1)
