"""Split an image into tiles that train a segmentation network and tiles that validate it, by ground and not by tile.

Neighboring tiles share houses, light and, where they overlap, pixels. A network validated on neighbors of its training
tiles looks better than it is. So the image is divided into blocks of ground, and whole blocks are held out for
validation. A tile counts only if all its blocks are of one kind: no pixel is in both.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import ParameterError

TRAIN, VALIDATION = "train", "validation"
SUBSETS = (TRAIN, VALIDATION)

BLOCKS_ACROSS = 8
"""Blocks along the image's longer side, unless they would be smaller than a tile."""

SEED = 1671
"""Seed for choosing validation blocks: the same image gives the same split."""


@dataclass(frozen=True)
class Tile:
    """A square piece of an image.

    Attributes:
        subset: ``train`` or ``validation``.
    """

    column: int
    row: int
    subset: str

    @property
    def name(self) -> str:
        """Name of its files, without suffix."""
        return f"{self.column}_{self.row}"


TILE_SIZES = (512, 384, 256, 192, 128)
"""Edges of tiles in pixels, multiples of 32, the largest first: larger tiles show a network more surroundings, and the
pyramid of SemRef's network needs at least the smallest."""

ENOUGH_TILES, MOST_TILES = 24, 2000
"""Tiles that an image should have room for, so that some can be held out; above the second number more hardly help."""


def fitting_tiles(shape_hw: tuple[int, int]) -> tuple[int, int]:
    """Return (edge, stride) in pixels of the tiles for an image: the largest size with enough tiles.

    They overlap by half in a small image, and have gaps in a huge one.
    """
    height, width = shape_hw
    rooms = {size: (height // size) * (width // size) for size in TILE_SIZES}
    size = next((size for size, room in rooms.items() if room >= ENOUGH_TILES), TILE_SIZES[-1])
    if rooms[size] <= MOST_TILES // 4:
        return size, size // 2
    return size, max(size, int((height * width / MOST_TILES) ** 0.5))


def block_size(shape_hw: tuple[int, int], tile_size: int) -> int:
    """Return the edge of a block of ground in pixels: about an eighth of the longer side, in whole tiles."""
    return tile_size * max(1, -(-max(shape_hw) // (BLOCKS_ACROSS * tile_size)))


def validation_blocks(labeled: np.ndarray, fraction: float) -> np.ndarray:
    """Return (R, C) bool: the blocks to hold out, with about ``fraction`` of the labeled pixels.

    Blocks are drawn in a fixed random order; a block is held out if it brings the share nearer to the fraction. At
    least one labeled block stays for training.

    Args:
        labeled: (R, C) labeled pixels of each block.
        fraction: 0 to 1.
    """
    taken = np.zeros(labeled.shape, bool)
    wanted = fraction * labeled.sum()
    order = np.random.default_rng(SEED).permutation(labeled.size)
    candidates = [block for block in order if labeled.flat[block]][:-1]
    for block in candidates:
        held = labeled[taken].sum()
        if abs(held + labeled.flat[block] - wanted) < abs(held - wanted):
            taken.flat[block] = True
    return taken


def plan_tiles(shape_hw: tuple[int, int], tile_size: int, stride: int, held_out: np.ndarray, block: int) -> list[Tile]:
    """Return tiles row by row, without those on blocks of both kinds or beyond the image.

    Args:
        shape_hw: (height, width) of the image, pixels.
        tile_size: Edge of a tile, pixels.
        stride: From tile to tile, pixels.
        held_out: (R, C) bool, the validation blocks.
        block: Edge of a block, pixels.

    Raises:
        ParameterError: The image is smaller than a tile.
    """
    height, width = shape_hw
    if min(shape_hw) < tile_size:
        raise ParameterError(
            "The image has {width} × {height} pixels, less than one tile of {tile_size} × {tile_size}. Label more "
            "ground, or choose a finer resolution or a smaller tile.",
            width=width,
            height=height,
            tile_size=tile_size,
        )
    tiles = []
    for row in range(0, height - tile_size + 1, stride):
        for column in range(0, width - tile_size + 1, stride):
            rows = slice(row // block, (row + tile_size - 1) // block + 1)
            columns = slice(column // block, (column + tile_size - 1) // block + 1)
            covered = held_out[rows, columns]
            if covered.all() or not covered.any():
                tiles.append(Tile(column, row, SUBSETS[int(covered.flat[0])]))
    return tiles
