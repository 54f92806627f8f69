"""Distinctiveness of windows: the distance to the nearest vector of a window that does not overlap."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

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
    blocks = _blocks(np.column_stack([-2 * vectors, np.ones(len(vectors), np.float32)]), *windows[1:])
    tiles = _blocks(np.column_stack([other_vectors, squares]), *others[1:])
    for first, block in zip(range(0, len(vectors), BLOCK), blocks):
        every = np.arange(len(block.sizes))
        lowest, places = np.empty((len(every), len(tiles)), np.float32), np.empty((len(every), len(tiles)), np.int64)
        for number, tile in enumerate(tiles):
            score = _scores(block, every, tile)
            place = score.argmin(axis=1)
            lowest[:, number], places[:, number] = score[every, place], number * BLOCK + place
        best = every, lowest.argmin(axis=1)
        found = lowest[best]
        distances = _distances(vectors[first + every], other_vectors[places[best]])
        distances[np.isinf(found)] = np.inf
        # The product form loses digits in differences of squares: all possible nearest ones are measured again.
        limit = np.where(np.isfinite(distances) & (distances > 0), found + blur, -np.inf).astype(np.float32)
        for number in np.flatnonzero((lowest <= limit[:, None]).any(axis=0)):
            near = np.flatnonzero(lowest[:, number] <= limit)
            score = _scores(block, near, tiles[number])
            rows, columns = np.nonzero(score <= limit[near, None])
            for part in range(0, len(rows), _PAIRS_AT_ONCE):
                row, column = near[rows[part : part + _PAIRS_AT_ONCE]], columns[part : part + _PAIRS_AT_ONCE]
                measured = _distances(vectors[first + row], other_vectors[number * BLOCK + column])
                np.minimum.at(distances, row, measured)
        yield slice(first, first + len(every)), distances


class _Block(NamedTuple):
    """Some windows: factors of the scores, centers and sizes, with the extremes of centers and sizes."""

    factors: np.ndarray
    centers: np.ndarray
    sizes: np.ndarray
    first: np.ndarray
    last: np.ndarray
    smallest: float
    largest: float


def _blocks(factors: np.ndarray, centers: np.ndarray, sizes: np.ndarray) -> list[_Block]:
    found = []
    for first in range(0, len(sizes), BLOCK):
        f, c, s = (values[first : first + BLOCK] for values in (factors, centers, sizes))
        found.append(_Block(f, c, s, c.min(axis=0), c.max(axis=0), s.min(), s.max()))
    return found


def _scores(block: _Block, which: np.ndarray, other: _Block) -> np.ndarray:
    """Return (n, m) float32 scores of n windows of a block and another block, infinity for two that overlap."""
    score = block.factors[which] @ other.factors.T
    below, above = block.first - other.last, other.first - block.last
    least, most = (_TOUCHING / 2 * (block[n] + other[n]) for n in (-2, -1))
    if (np.maximum(below, above) < most).all():
        reaches = most if least == most else _TOUCHING / 2 * (block.sizes[which, None] + other.sizes)
        overlap = np.True_
        # Along an axis on which the blocks are this close, all pairs overlap.
        for axis in np.flatnonzero(np.minimum(below, above) <= -least):
            distances = block.centers[which, None, axis] - other.centers[:, axis]
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
