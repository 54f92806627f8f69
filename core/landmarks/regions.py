"""Regions of a map that reach into a few places, reading no more of the map than they go on to."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ..labels.sources import LabelSource
from .landmarks import NO_ROWS
from .tiles import Region, TileLandmarks, join_tiles, joined_regions, tile_landmarks

TILE = 512
"""Edge of the pieces in which regions are followed, in pixels. They begin half a tile before the map does, so that a
hashed block with a line of pixels around it lies in four of them, not in nine."""

Bounds = tuple[int, int, int, int]
"""(left, top, right, bottom), pixels; the last two lie beyond it."""


class ReachingRegions:
    """Finds the regions of one class with a pixel in some places: iterate ``steps()`` to the end.

    Each place is a tile of its own, so that its pieces are what is wanted. Where they go on, the tiles beyond are read
    without the places in them, until no wanted region goes on.

    Attributes:
        rows: (N, 8) rows of the landmarks that lie in a place whole.
        regions: Those that go on outside of their place, of any size.
    """

    def __init__(
        self, source: LabelSource, value: int, places: Sequence[Bounds], minimum_area: float, tile_px: int = TILE
    ) -> None:
        """Read nothing yet.

        Args:
            source: The label map.
            places: Apart from each other, on the map.
            minimum_area: Of a landmark, pixels.
            tile_px: See TILE.
        """
        self._source, self._value, self._minimum_area = source, value, minimum_area
        self._places, self._size = list(places), tile_px
        self._boxes: list[Bounds] = []
        self._tiles: list[TileLandmarks] = []
        self.rows = NO_ROWS
        self.regions: set[Region] = set()

    def steps(self) -> Iterator[None]:
        """Yield after each piece that was read."""
        for place in self._places:
            self._read(place)
            yield
        self.rows = np.concatenate([NO_ROWS, *(tile.rows for tile in self._tiles)])
        seeds, read = sum(len(tile.pieces) for tile in self._tiles), set[tuple[int, int]]()
        while True:
            pieces, runs, components = join_tiles(self._tiles)
            wanted = np.isin(components, components[:seeds])
            onward = self._beyond(runs, wanted) - read
            if not onward:
                break
            read |= onward
            for cell in sorted(onward):
                for box in _without(self._bounds(cell), self._places):
                    self._read(box)
                    yield
        self.regions = {region for _, region in joined_regions(pieces[wanted], components[wanted])}

    def _read(self, box: Bounds) -> None:
        left, top, right, bottom = box
        labels = self._source.read(left, top, right - left, bottom - top)
        self._boxes.append(box)
        self._tiles.append(
            tile_landmarks(labels, (left, top), self._source.shape_hw, (self._value,), self._minimum_area)
        )

    def _beyond(self, runs: np.ndarray, wanted: np.ndarray) -> set[tuple[int, int]]:
        """Return (column, row) of the tiles that pixels beside the wanted runs lie in."""
        boxes = np.repeat(np.array(self._boxes).reshape(-1, 4), [len(tile.runs) for tile in self._tiles], axis=0)
        chosen = wanted[runs[:, 5]]
        found = set()
        for (_, is_column, line, start, stop, _), box in zip(runs[chosen].tolist(), boxes[chosen].tolist()):
            first, last = (box[0], box[2] - 1) if is_column else (box[1], box[3] - 1)
            outside = [line - 1] * (line == first) + [line + 1] * (line == last)
            for across in map(self._tile_of, outside):
                for along in range(self._tile_of(start - 1), self._tile_of(stop) + 1):
                    found.add((across, along) if is_column else (along, across))
        height, width = self._source.shape_hw
        last = self._tile_of(width - 1), self._tile_of(height - 1)
        return {cell for cell in found if 0 <= cell[0] <= last[0] and 0 <= cell[1] <= last[1]}

    def _tile_of(self, place: int) -> int:
        """Return the column (or row) of tiles that a column (or row) of pixels lies in."""
        return (place + self._size // 2) // self._size

    def _bounds(self, cell: tuple[int, int]) -> Bounds:
        """Return of a tile, as far as it lies on the map."""
        (left, top), (height, width) = (number * self._size - self._size // 2 for number in cell), self._source.shape_hw
        return max(left, 0), max(top, 0), min(left + self._size, width), min(top + self._size, height)


def _without(box: Bounds, places: Sequence[Bounds]) -> list[Bounds]:
    """Rectangles that cover a box but for the places in it."""
    parts = [box]
    for place in places:
        parts = [rest for part in parts for rest in _rest(part, place)]
    return parts


def _rest(part: Bounds, place: Bounds) -> list[Bounds]:
    left, top, right, bottom = part
    inner = max(left, place[0]), max(top, place[1]), min(right, place[2]), min(bottom, place[3])
    if inner[0] >= inner[2] or inner[1] >= inner[3]:
        return [part]
    around = (
        (left, top, right, inner[1]),
        (left, inner[1], inner[0], inner[3]),
        (inner[2], inner[1], right, inner[3]),
        (left, inner[3], right, bottom),
    )
    return [one for one in around if one[0] < one[2] and one[1] < one[3]]
