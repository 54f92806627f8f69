"""How unlike a window is all windows elsewhere: the distance to the nearest vector of one that doesn't overlap it."""

from __future__ import annotations

from typing import Iterator, Tuple

import numpy as np

BLOCK = 1024
"""Windows compared at a time; 1024 × 10⁵ distances in single precision take 400 MB at most."""

_BLOCK_BYTES = 32_000_000

_TOUCHING = 1 - 1e-6
"""Windows side by side share no area, though rounding of large map coordinates may let them overlap by a hair."""


def distinctiveness(vectors: np.ndarray, centers: np.ndarray, sizes: np.ndarray) -> Iterator[Tuple[slice, np.ndarray]]:
    """Yields (slice of windows, (n,) float64 distances); infinity where every other window overlaps.

    ``vectors``: (N, 3·X) float32; ``centers``: (N, 2) map coordinates; ``sizes``: (N,) edge lengths in map units.
    Two windows overlap when their squares share area.
    """
    count = len(vectors)
    step = max(1, min(BLOCK, _BLOCK_BYTES // max(4 * count, 1)))
    half = sizes / 2
    squares = np.einsum("ij,ij->i", vectors, vectors)
    # Windows of one area are neighbours in y, so only a band of the others can overlap a block.
    for first in range(0, count, step):
        block = slice(first, min(first + step, count))
        score = vectors[block] @ vectors.T
        score *= -2.0
        score += squares
        near = np.flatnonzero(
            (centers[:, 1] + half > (centers[block, 1] - half[block]).min())
            & (centers[:, 1] - half < (centers[block, 1] + half[block]).max())
        )
        reach = (half[block, None] + half[None, near]) * _TOUCHING
        overlap = (np.abs(centers[block, None, 0] - centers[None, near, 0]) < reach) & (
            np.abs(centers[block, None, 1] - centers[None, near, 1]) < reach
        )
        rows, columns = np.nonzero(overlap)
        score[rows, near[columns]] = np.inf
        nearest = score.argmin(axis=1)
        found = score[np.arange(len(nearest)), nearest]
        # Squares of differences cancel badly in the product form; the one distance that counts is taken anew.
        difference = vectors[block].astype(np.float64) - vectors[nearest]
        distances = np.sqrt(np.einsum("ij,ij->i", difference, difference))
        yield block, np.where(np.isinf(found), np.inf, distances)
