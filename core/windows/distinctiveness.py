"""Distinctiveness of windows: the distance to the nearest vector of a window that does not overlap."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

BLOCK = 512
"""Windows compared at a time with as many others: their scores, 1 MB, stay in the processor's cache."""

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
    vectors, other_vectors = windows[0], others[0]
    if not len(vectors):
        return
    if not len(other_vectors):
        yield slice(0, len(vectors)), np.full(len(vectors), np.inf)
        return
    squares = np.einsum("ij,ij->i", other_vectors, other_vectors)
    blur = _score_error(vectors, squares)
    # One product of matrices gives the scores: squared distances without the square of the window's own vector.
    own = np.column_stack([-2 * vectors, np.ones(len(vectors), np.float32)]), *windows[1:]
    theirs = np.column_stack([other_vectors, squares]), *others[1:]
    tiles = [slice(first, first + BLOCK) for first in range(0, len(squares), BLOCK)]
    for first in range(0, len(vectors), BLOCK):
        block = np.arange(first, min(first + BLOCK, len(vectors)))
        lowest, places = np.empty((len(block), len(tiles)), np.float32), np.empty((len(block), len(tiles)), np.int64)
        for number, tile in enumerate(tiles):
            score = _scores(_part(own, block), _part(theirs, tile))
            place = score.argmin(axis=1)
            lowest[:, number], places[:, number] = score[np.arange(len(block)), place], tile.start + place
        best = np.arange(len(block)), lowest.argmin(axis=1)
        found = lowest[best]
        distances = _distances(vectors[block], other_vectors[places[best]])
        distances[np.isinf(found)] = np.inf
        # The product form loses digits in differences of squares: all possible nearest ones are measured again.
        limit = np.where(np.isfinite(distances) & (distances > 0), found + blur, -np.inf).astype(np.float32)
        for number in np.flatnonzero((lowest <= limit[:, None]).any(axis=0)):
            near = np.flatnonzero(lowest[:, number] <= limit)
            score = _scores(_part(own, block[near]), _part(theirs, tiles[number]))
            rows, columns = np.nonzero(score <= limit[near, None])
            for part in range(0, len(rows), _PAIRS_AT_ONCE):
                row, column = near[rows[part : part + _PAIRS_AT_ONCE]], columns[part : part + _PAIRS_AT_ONCE]
                measured = _distances(vectors[first + row], other_vectors[tiles[number].start + column])
                np.minimum.at(distances, row, measured)
        yield slice(first, first + len(block)), distances


def _part(windows: _Windows, which: np.ndarray | slice) -> _Windows:
    factors, centers, sizes = windows
    return factors[which], centers[which], sizes[which]


def _scores(windows: _Windows, others: _Windows) -> np.ndarray:
    """Return (n, m) float32 scores, infinity for two windows that overlap; factors of the scores replace vectors."""
    (factors, centers, sizes), (other_factors, other_centers, other_sizes) = windows, others
    score = factors @ other_factors.T
    reach = (sizes.max() + other_sizes.max()) / 2
    apart = centers.min(axis=0) - other_centers.max(axis=0), other_centers.min(axis=0) - centers.max(axis=0)
    if (np.maximum(*apart) < reach).all():
        reaches = (sizes[:, None] / 2 + other_sizes / 2) * _TOUCHING
        overlap = np.True_
        for axis in range(2):
            distances = centers[:, None, axis] - other_centers[:, axis]
            overlap = overlap & (np.abs(distances, out=distances) < reaches)
        np.copyto(score, np.inf, where=overlap)
    return score


def _distances(vectors: np.ndarray, others: np.ndarray) -> np.ndarray:
    difference = vectors.astype(np.float64) - others
    return np.sqrt(np.einsum("ij,ij->i", difference, difference))


def _score_error(vectors: np.ndarray, squares: np.ndarray) -> float:
    """Return the largest difference of two scores from rounding sums of products in single precision (Higham)."""
    own = np.einsum("ij,ij->i", vectors, vectors).max(initial=0.0)
    largest = max(float(own), float(squares.max()))
    return 9 * vectors.shape[1] * 2.0**-24 * largest
