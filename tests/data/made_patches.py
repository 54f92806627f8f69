"""A made map of patches and houses, images of it, and errors of positions."""

from dataclasses import replace

import cv2
import numpy as np
from made_labels import patches

from benchmarks.network_errors import NetworkNoise, spoil
from semref.core.geometry.frame import MapFrame
from semref.core.localization import Prior

ORIGIN = 500_000.0, 5_200_000.0
FRAME = MapFrame.at(ORIGIN, 4.0)
PRIOR = Prior(pixel_size_range=(0.7, 1.4))
_NETWORK = NetworkNoise(missed_below=200.0, split_length=40.0)
MODEST = replace(_NETWORK, merge_gap=6, split=0.2, jitter=3, jitter_length=9, patches=0.15, thin=4, missed=0.15)
STRONG = replace(_NETWORK, merge_gap=10, split=0.4, jitter=6, jitter_length=18, patches=0.35, thin=8, missed=0.4)
"""Errors of a usable and of a poor network, in meters."""


def made_map(seed: int, width: int = 2600, height: int = 2000) -> np.ndarray:
    """Return (height, width) uint8 patches of classes 2 to 6 around random points, rows of houses (1), border of 0."""
    rng = np.random.default_rng(seed)
    labels = patches(rng, (height // 4, width // 4), 500, first=2)
    labels = cv2.resize(labels, (width, height), interpolation=cv2.INTER_NEAREST)
    for x, y in rng.uniform(0, 1, (400, 2)) * (width - 40, height - 30):
        labels[int(y) : int(y) + 14, int(x) : int(x) + 22] = 1
    labels[:, :150] = 0
    return labels


def view(labels, center, heading_deg, pixel, size_wh=(560, 560)):
    """Return the image of a camera above ``center`` (map pixels); its top points ``heading_deg`` clockwise from up."""
    turn = np.radians(heading_deg)
    matrix = pixel * np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    offset = np.array(center) - matrix @ (np.array(size_wh) / 2 - 0.5) - 0.5
    flags = cv2.INTER_NEAREST | cv2.WARP_INVERSE_MAP
    return cv2.warpAffine(labels, np.column_stack([matrix, offset]), size_wh, flags=flags)


def spoiled(labels_hw, noise, seed):
    """Add the errors of a network; houses are class 1."""
    return spoil(labels_hw, noise, np.random.default_rng(seed), (1,))


def error_m(place, center) -> float:
    return float(np.hypot(place.position[0] - ORIGIN[0] - center[0], ORIGIN[1] - center[1] - place.position[1]))
