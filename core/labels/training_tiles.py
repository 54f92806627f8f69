"""Which tiles of an image train a segmentation network and which validate it: apart by place, not by tile.

Neighboring tiles share houses, light and, where they overlap, pixels; a network validated on neighbors of what it has
seen looks better than it is. So the image is divided into blocks of ground, whole blocks are set aside for validation,
and a tile counts only when it lies wholly on blocks of one kind: no pixel is in both.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import ParameterError

TRAIN, VALIDATION = "train", "validation"
SUBSETS = (TRAIN, VALIDATION)

BLOCKS_ACROSS = 8
"""Blocks along the image's longer side, where they are not smaller than a tile."""

SEED = 1671
"""Of the choice of validation blocks: the same image gives the same split."""


@dataclass(frozen=True)
class Tile:
    """A square piece of an image.

    Attributes:
        column: Of its first pixel.
        row: Of its first pixel.
        subset: ``train`` or ``validation``.
    """

    column: int
    row: int
    subset: str

    @property
    def name(self) -> str:
        """Of its files, without suffix."""
        return f"{self.column}_{self.row}"


TILE_SIZES = (512, 384, 256, 192, 128)
"""Edges of tiles in pixels, multiples of 32, the largest first: a network sees more around a place in larger ones, and
the pyramid of ours has nothing left of smaller ones."""

ENOUGH_TILES, MOST_TILES = 24, 2000
"""Tiles that an image should have room for, so that some can be set aside; and beyond which more teach little."""


def fitting_tiles(shape_hw: tuple[int, int]) -> tuple[int, int]:
    """Return (edge, stride) in pixels of the tiles that suit an image: the largest of which it has room for enough.

    They overlap by half where the image is small, and lie apart where it is huge.
    """
    height, width = shape_hw
    rooms = {size: (height // size) * (width // size) for size in TILE_SIZES}
    size = next((size for size, room in rooms.items() if room >= ENOUGH_TILES), TILE_SIZES[-1])
    if rooms[size] <= MOST_TILES // 4:
        return size, size // 2
    return size, max(size, int((height * width / MOST_TILES) ** 0.5))


def block_size(shape_hw: tuple[int, int], tile_size: int) -> int:
    """Edge of a block of ground in pixels: about an eighth of the longer side, in whole tiles so that few straddle."""
    return tile_size * max(1, -(-max(shape_hw) // (BLOCKS_ACROSS * tile_size)))


def validation_blocks(labeled: np.ndarray, fraction: float) -> np.ndarray:
    """Return (R, C) bool: the blocks set aside, so that they hold about ``fraction`` of the labeled pixels.

    Blocks are drawn in a fixed random order; one is taken when the share comes nearer to the fraction by it. At least
    one labeled block stays for training.

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
    """Tiles row by row, without those that lie on blocks of both kinds; none reaches beyond the image.

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
            "The image has {width} × {height} pixels, less than a tile of {tile_size} pixels; label more ground, or "
            "choose a finer resolution or a smaller tile.",
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
