"""Distinctiveness of windows: the distance to the nearest vector of a window that does not overlap."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

BLOCK = 1024
"""Windows compared at a time, if their distances fit into _BLOCK_BYTES; several threads may do so at once."""

_BLOCK_BYTES = 12_000_000

_PAIRS_AT_ONCE = 100_000

_Windows = tuple[np.ndarray, np.ndarray, np.ndarray]

_TOUCHING = 1 - 1e-6
"""Factor that keeps adjacent windows from overlapping because large map coordinates are rounded."""


def nearest_distances(windows: _Windows, others: _Windows) -> Iterator[tuple[slice, np.ndarray]]:
    """Compare windows with others, block by block. Distances depend on the two vectors only, exactly.

    Two windows overlap if their squares share area.

    Args:
        windows: Vectors (N, 3·X) float32, centers (N, 2) map x, y, and sizes (N,), edges in map units.
        others: The same for the windows to compare with.

    Yields:
        A slice of n windows, and their (n,) float64 distances; infinity if every other window overlaps.
    """
    vectors, centers, sizes = windows
    other_vectors, other_centers, other_sizes = others
    if not len(vectors):
        return
    if not len(other_vectors):
        yield slice(0, len(vectors)), np.full(len(vectors), np.inf)
        return
    step = max(1, min(BLOCK, _BLOCK_BYTES // (4 * len(other_vectors))))
    half, other_half = sizes / 2, other_sizes / 2
    squares = np.einsum("ij,ij->i", other_vectors, other_vectors)
    blur = _score_error(vectors, squares)
    # Windows of one area are neighbors in y, so only a band of the others can overlap a block.
    for first in range(0, len(vectors), step):
        block = slice(first, min(first + step, len(vectors)))
        score = vectors[block] @ other_vectors.T
        score *= -2.0
        score += squares
        near = np.flatnonzero(
            (other_centers[:, 1] + other_half > (centers[block, 1] - half[block]).min())
            & (other_centers[:, 1] - other_half < (centers[block, 1] + half[block]).max())
        )
        reach = (half[block, None] + other_half[None, near]) * _TOUCHING
        overlap = (np.abs(centers[block, None, 0] - other_centers[None, near, 0]) < reach) & (
            np.abs(centers[block, None, 1] - other_centers[None, near, 1]) < reach
        )
        rows, columns = np.nonzero(overlap)
        score[rows, near[columns]] = np.inf
        nearest = score.argmin(axis=1)
        found = score[np.arange(len(nearest)), nearest]
        # The product form loses digits in differences of squares: all possible nearest ones are measured again.
        distances = _distances(vectors[block], other_vectors[nearest])
        distances[np.isinf(found)] = np.inf
        limit = np.where(np.isfinite(distances) & (distances > 0), found + blur, -np.inf).astype(score.dtype)
        rows, columns = np.nonzero(score <= limit[:, None])
        for part in range(0, len(rows), _PAIRS_AT_ONCE):
            row, column = rows[part : part + _PAIRS_AT_ONCE], columns[part : part + _PAIRS_AT_ONCE]
            np.minimum.at(distances, row, _distances(vectors[first + row], other_vectors[column]))
        yield block, distances


def _distances(vectors: np.ndarray, others: np.ndarray) -> np.ndarray:
    difference = vectors.astype(np.float64) - others
    return np.sqrt(np.einsum("ij,ij->i", difference, difference))


def _score_error(vectors: np.ndarray, squares: np.ndarray) -> float:
    """Return the largest error of a score from rounding sums of products in single precision (Higham)."""
    own = np.einsum("ij,ij->i", vectors, vectors).max(initial=0.0)
    largest = max(float(own), float(squares.max()))
    return 8 * vectors.shape[1] * 2.0**-24 * largest
