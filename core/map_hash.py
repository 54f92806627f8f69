"""What a label map is known by: a hash of every block and, made of these, one of the whole map."""

from __future__ import annotations

import hashlib
from typing import List, Sequence, Tuple

import numpy as np

HASHED_BLOCK = 512
"""Edge of a block in pixels; 300 km² at 1 m are some thousand blocks."""

_HASH_BYTES = 8
"""Enough to tell a block from what it was before: a change goes unseen with odds of 1 to 2⁶⁴."""


class BlockHasher:
    """Hashes a map while its rows come by from top to bottom: ``add`` them all, then take ``hashes``."""

    def __init__(self, width: int) -> None:
        self._columns = range(0, width, HASHED_BLOCK)
        self._row = 0
        self._open: List = []
        self._done: List[str] = []

    def add(self, labels_hw: np.ndarray) -> None:
        """The next rows of the map, (h, W) uint8, any number of them."""
        first = 0
        while first < len(labels_hw):
            if self._row % HASHED_BLOCK == 0:
                self._close()
                self._open = [hashlib.blake2b(digest_size=_HASH_BYTES) for _ in self._columns]
            last = min(len(labels_hw), first + HASHED_BLOCK - self._row % HASHED_BLOCK)
            for pixels, column in zip(self._open, self._columns):
                pixels.update(np.ascontiguousarray(labels_hw[first:last, column:column + HASHED_BLOCK]))
            self._row += last - first
            first = last

    @property
    def hashes(self) -> Tuple[str, ...]:
        """One a block, row by row."""
        self._close()
        return tuple(self._done)

    def _close(self) -> None:
        self._done += [pixels.hexdigest() for pixels in self._open]
        self._open = []


def block_hash(labels_hw: np.ndarray) -> str:
    """Hash of one block, (h, w) uint8."""
    return hashlib.blake2b(np.ascontiguousarray(labels_hw), digest_size=_HASH_BYTES).hexdigest()


def blocks_shape(shape_hw: Tuple[int, int]) -> Tuple[int, int]:
    """(rows, columns) of the blocks of a map of ``shape_hw`` pixels."""
    return -(-shape_hw[0] // HASHED_BLOCK), -(-shape_hw[1] // HASHED_BLOCK)


def map_hash(shape_hw: Tuple[int, int], geotransform: Sequence[float], hashes: Sequence[str]) -> str:
    """SHA-256 of a map's shape, place and block hashes."""
    place = repr((tuple(shape_hw), tuple(geotransform)))
    return hashlib.sha256((place + "".join(hashes)).encode("ascii")).hexdigest()
