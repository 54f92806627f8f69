"""A network's scores averaged over turned and mirrored copies of a tile, of which each has other errors.

On photos of places that networks had not seen, the average gives 86 instead of 71 positions of 280
(docs/decisions/photo-evidence.md).
"""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import CancelledError
from threading import Event

import numpy as np

from .model import SegmentationModel


def averaged_scores(model: SegmentationModel, images: Sequence[np.ndarray], stop: Event) -> np.ndarray:
    """Return (N, C, H, W) float32 mean scores over all orientations that fit the network's tiles, 8 or 4.

    Args:
        model: The network.
        images: N of (H, W, 3) uint8, red first, of the network's size.
        stop: Set by another thread to end between two orientations.

    Raises:
        CancelledError: ``stop`` was set.
        ModelError: As ``SegmentationModel.scores``.
    """
    height, width = model.tile_hw
    quarters = range(4) if height == width else (0, 2)
    total = np.zeros((), np.float32)
    for turns in quarters:
        for step in (1, -1):
            if stop.is_set():
                raise CancelledError
            seen = [np.ascontiguousarray(np.rot90(image[:, ::step], turns)) for image in images]
            total = total + np.rot90(model.scores(seen), -turns, axes=(2, 3))[..., ::step]
    return np.ascontiguousarray(total / np.float32(2 * len(quarters)))
