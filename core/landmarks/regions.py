"""Regions of a map that reach into given places; only the tiles that the regions continue into are read."""

from __future__ import annotations

from collections.abc import Generator, Sequence

import numpy as np

from ..labels.sources import LabelSource
from .landmarks import NO_ROWS
from .tiles import Region, TileLandmarks, join_tiles, joined_regions, tile_landmarks

TILE = 512
"""Edge of the tiles in which regions are followed, in pixels. The first tile starts half a tile before the map, so that
a hashed block with a line of pixels around it overlaps four tiles, not nine."""

Bounds = tuple[int, int, int, int]
"""(left, top, right, bottom), pixels; right and bottom are exclusive."""


class ReachingRegions:
    """Finds the regions of one class with a pixel in some places.

    Each place is a tile of its own, so that the pieces in it are the wanted ones. Neighboring tiles, without the places
    in them, are read until no wanted region continues.
    """

    def __init__(
        self, source: LabelSource, value: int, places: Sequence[Bounds], minimum_area: float, tile_px: int = TILE
    ) -> None:
        """Read nothing yet.

        Args:
            places: Disjoint rectangles on the map.
            minimum_area: Of a landmark, pixels.
            tile_px: See TILE.
        """
        self._source, self._value, self._minimum_area = source, value, minimum_area
        self._places, self._size = list(places), tile_px
        self._boxes: list[Bounds] = []
        self._tiles: list[TileLandmarks] = []

    def steps(self) -> Generator[int, None, tuple[np.ndarray, set[Region]]]:
        """Read the map; yield the number of pieces read after each of them.

        Returns:
            (N, 8) rows of the landmarks that are completely inside a place, and the regions of any size that continue
            outside of their place.
        """
        for place in self._places:
            self._read(place)
            yield len(self._tiles)
        rows = np.concatenate([NO_ROWS, *(tile.rows for tile in self._tiles)])
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
                    yield len(self._tiles)
        return rows, {region for _, region in joined_regions(pieces[wanted], components[wanted])}

    def _read(self, box: Bounds) -> None:
        left, top, right, bottom = box
        labels = self._source.read(left, top, right - left, bottom - top)
        self._boxes.append(box)
        self._tiles.append(
            tile_landmarks(labels, (left, top), self._source.shape_hw, (self._value,), self._minimum_area)
        )

    def _beyond(self, runs: np.ndarray, wanted: np.ndarray) -> set[tuple[int, int]]:
        """Return (column, row) of the tiles that contain pixels next to the wanted runs."""
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
        """Return the column (or row) of tiles that contains a column (or row) of pixels."""
        return (place + self._size // 2) // self._size

    def _bounds(self, cell: tuple[int, int]) -> Bounds:
        """Return the part of a tile inside the map."""
        (left, top), (height, width) = (number * self._size - self._size // 2 for number in cell), self._source.shape_hw
        return max(left, 0), max(top, 0), min(left + self._size, width), min(top + self._size, height)


def _without(box: Bounds, places: Sequence[Bounds]) -> list[Bounds]:
    """Return rectangles that cover a box without the places in it."""
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
