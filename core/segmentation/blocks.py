"""Segment an image block by block, with threads or workers; the rows are equal to those of ``tiling.segment``."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterable, Iterator

import numpy as np

from .certainty import Sureness
from .tiling import SegmentedRows, Tiles

TILES_A_BLOCK = 8
"""Tiles along each axis: the seams add a ninth, and each block returns 10 MB of labels."""

Found = tuple[np.ndarray, float, int]
"""(h, w) uint8 labels of a block, and sum and number of sampled probabilities of its labels."""


def segment_blocks(
    tiles: Tiles, tile_hw: tuple[int, int], segment: Callable[[Iterable[tuple]], Iterator[Found]]
) -> Iterator[tuple[float, SegmentedRows]]:
    """Yield the share done (0…1) and each row of tiles, from top to bottom.

    Args:
        tile_hw: (height, width) of a tile.
        segment: Takes (column and row of a block's first tile, ``TILES_A_BLOCK``) of each block, and yields the results
            in their order.
    """
    firsts = [range(0, len(starts), TILES_A_BLOCK) for starts in (tiles.columns, tiles.rows)]
    places = [(column, row) for row in firsts[1] for column in firsts[0]]
    blocks = [tiles.block(tile_hw, place, TILES_A_BLOCK) for place in places]
    found, across = segment((place, TILES_A_BLOCK) for place in places), len(firsts[0])
    for first in range(0, len(blocks), across):
        for rows in _band(tiles, blocks[first : first + across], found):
            yield (rows.first + len(rows.labels_hw)) / tiles.box[3], rows


def _band(tiles: Tiles, blocks: list[Tiles], found: Iterator[Found]) -> Iterator[SegmentedRows]:
    """Yield a row of adjacent blocks as whole rows of tiles."""
    _, top, _, bottom = blocks[0].box
    sure = Sureness()
    # In a temporary file: for an orthophoto of a country it has gigabytes.
    with tempfile.TemporaryFile() as file:
        labels = np.memmap(file, np.uint8, "w+", shape=(bottom - top, tiles.box[2]))
        for block in blocks:
            labels[:, block.box[0] : block.box[2]], total, count = next(found)
            sure.add(Sureness(total, count))
        ends = [*(row for row in tiles.rows if top < row < bottom), bottom]
        for begin, end in zip([top, *ends], ends):
            yield SegmentedRows(begin, np.array(labels[begin - top : end - top]), sure=sure)
            sure = Sureness()
        del labels
