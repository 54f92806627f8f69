"""Hashes of a label map: one for every block and, from these, one for the whole map."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from functools import lru_cache

import numpy as np

HASHED_BLOCK = 512
"""Edge of a block in pixels; 300 km² at 1 m are some thousand blocks."""

_HASH_BYTES = 8
"""Length of a hash: a change goes undetected with odds of 1 to 2⁶⁴."""


class BlockHasher:
    """Hashes the rows of a map as they arrive, from top to bottom: ``add`` them all, then read ``hashes``."""

    def __init__(self, width: int) -> None:
        """Start with the first row; ``width``: of the map, pixels."""
        self._columns = range(0, width, HASHED_BLOCK)
        self._row = 0
        self._open: list[_BlockDigest] = []
        self._done: list[str] = []

    def add(self, labels_hw: np.ndarray) -> None:
        """Add the next rows of the map; ``labels_hw``: (h, W) uint8 labels, any number of rows."""
        first = 0
        while first < len(labels_hw):
            if self._row % HASHED_BLOCK == 0:
                self._close()
                self._open = [_BlockDigest() for _ in self._columns]
            last = min(len(labels_hw), first + HASHED_BLOCK - self._row % HASHED_BLOCK)
            for block, column in zip(self._open, self._columns):
                block.add(labels_hw[first:last, column : column + HASHED_BLOCK])
            self._row += last - first
            first = last

    @property
    def hashes(self) -> tuple[str, ...]:
        """One hash per block, row by row."""
        self._close()
        return tuple(self._done)

    def _close(self) -> None:
        self._done += [block.hexdigest() for block in self._open]
        self._open = []


class _BlockDigest:
    """Hash of one block, updated as its rows arrive in order.

    Many blocks have one class only, or no class beyond the map's border. Their pixels are counted until another value
    occurs, which takes a tenth of the time of hashing, and their hash is cached.
    """

    def __init__(self) -> None:
        self._value = 0
        self._count = 0
        self._pixels: hashlib.blake2b | None = None

    def add(self, labels_hw: np.ndarray) -> None:
        """Add the block's next rows, (h, w) uint8."""
        if self._pixels is None:
            if self._continues(labels_hw):
                self._value, self._count = int(labels_hw[0, 0]), self._count + labels_hw.size
                return
            self._pixels = hashlib.blake2b(_one_value(self._value, self._count), digest_size=_HASH_BYTES)
        self._pixels.update(np.ascontiguousarray(labels_hw).data)

    def hexdigest(self) -> str:
        """Return the hash of the rows so far."""
        return self._pixels.hexdigest() if self._pixels else _hash_of_one_value(self._value, self._count)

    def _continues(self, labels_hw: np.ndarray) -> bool:
        value = self._value if self._count else labels_hw[0, 0]
        # The first row is enough to see that most blocks have several values.
        return bool((labels_hw[0] == value).all() and (labels_hw == value).all())


def block_hash(labels_hw: np.ndarray) -> str:
    """Return the hash of one block, (h, w) uint8."""
    return hashlib.blake2b(np.ascontiguousarray(labels_hw).data, digest_size=_HASH_BYTES).hexdigest()


def _one_value(value: int, count: int) -> bytes:
    return bytes((value,)) * count


@lru_cache(1024)
def _hash_of_one_value(value: int, count: int) -> str:
    return hashlib.blake2b(_one_value(value, count), digest_size=_HASH_BYTES).hexdigest()


def blocks_shape(shape_hw: tuple[int, int]) -> tuple[int, int]:
    """Return (rows, columns) of the blocks of a map of ``shape_hw`` pixels."""
    return -(-shape_hw[0] // HASHED_BLOCK), -(-shape_hw[1] // HASHED_BLOCK)


def map_hash(shape_hw: tuple[int, int], geotransform: Sequence[float], hashes: Sequence[str]) -> str:
    """Return the SHA-256 of a map: its shape, its position and its labels.

    Args:
        shape_hw: (height, width) in pixels.
        geotransform: GDAL's six numbers.
        hashes: Of the map's blocks, row by row.
    """
    place = repr((tuple(shape_hw), tuple(geotransform)))
    return hashlib.sha256((place + "".join(hashes)).encode("ascii")).hexdigest()
