"""Single regions of a map found from a place in them, reading no more of the map than they reach."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeVar

import cv2
import numpy as np

from ..labels.sources import LabelSource
from .landmarks import class_mask

TILE = 512
"""Edge of the pieces in which a region is followed, in pixels. They begin half a tile before the map does, so that a
hashed block with a line of pixels around it lies in four of them, not in nine."""

_KEPT_TILES = 100
"""Tiles whose numbered parts are kept; 1 MB each."""

_TileKey = tuple[int, int]
_Part = tuple[_TileKey, int]
"""A tile (column, row of tiles) and the number of one connected part in it."""

_Places = TypeVar("_Places", int, np.ndarray)
"""A column or row, or an array of them."""

_AROUND = [(dx, dy) for dy in (-1, 0, 1) for dx in (-1, 0, 1) if (dx, dy) != (0, 0)]


@dataclass(frozen=True)
class Region:
    """An 8-connected region of a map.

    Attributes:
        bounds: (left, top, right, bottom), pixels; the last two lie beyond it.
        first_pixel: (column, row) of its first pixel in raster order.
    """

    bounds: tuple[int, int, int, int]
    first_pixel: tuple[int, int]


def whole_region(pieces: Sequence[Region]) -> Region:
    """The region that the pieces make together."""
    lefts, tops, rights, bottoms = zip(*(piece.bounds for piece in pieces))
    first_pixel = min((piece.first_pixel for piece in pieces), key=lambda pixel: (pixel[1], pixel[0]))
    return Region((min(lefts), min(tops), max(rights), max(bottoms)), first_pixel)


class RegionFinder:
    """Finds the regions of one class. Regions are followed from tile to tile, each once.

    What touches a few changed blocks is wanted here, out of a map that is not read whole: so pieces are not numbered
    and joined all at once as in ``joining``, but followed from those that are asked for.
    """

    def __init__(self, source: LabelSource, value: int, tile_px: int = TILE) -> None:
        self._source = source
        self._value = value
        self._size = tile_px
        self._regions: dict[_Part, Region] = {}
        self._tile = lru_cache(_KEPT_TILES)(self._number_parts)

    def touching(self, bounds: tuple[int, int, int, int]) -> set[Region]:
        """Every region with a pixel inside ``bounds`` (left, top, right, bottom)."""
        left, top, right, bottom = bounds
        found = set()
        for tile_row in range(self._tile_of(top), self._tile_of(bottom - 1) + 1):
            for tile_column in range(self._tile_of(left), self._tile_of(right - 1) + 1):
                parts, _ = self._tile((tile_column, tile_row))
                x0, y0 = self._first_of(tile_column), self._first_of(tile_row)
                inside = parts[max(top - y0, 0) : bottom - y0, max(left - x0, 0) : right - x0]
                found |= {self._region(((tile_column, tile_row), n)) for n in np.unique(inside).tolist() if n}
        return found

    def starting_in_row(self, row: int, left: int, right: int) -> Iterator[Region]:
        """The regions of all runs of the class that begin in this row from column ``left`` to ``right``."""
        mask = class_mask(self._source.read(left, row, right - left, 1), self._value)[0]
        for x in np.flatnonzero(np.diff(mask.astype(np.int8), prepend=0) == 1).tolist():
            key = self._tile_of(left + x), self._tile_of(row)
            parts, _ = self._tile(key)
            yield self._region((key, int(parts[row - self._first_of(key[1]), left + x - self._first_of(key[0])])))

    def _region(self, part: _Part) -> Region:
        if part not in self._regions:
            parts = self._follow(part)
            region = whole_region([self._extent(found) for found in parts])
            self._regions.update(dict.fromkeys(parts, region))
        return self._regions[part]

    def _follow(self, start: _Part) -> set[_Part]:
        found, waiting = {start}, [start]
        while waiting:
            new = self._adjoining(waiting.pop()) - found
            found |= new
            waiting += new
        return found

    def _adjoining(self, part: _Part) -> set[_Part]:
        """Parts of the neighboring tiles that touch this one, be it by a corner."""
        (tile_column, tile_row), number = part
        parts, _ = self._tile((tile_column, tile_row))
        ys, xs = _on_border(parts, number)
        ys, xs = ys + self._first_of(tile_row), xs + self._first_of(tile_column)
        found = set()
        for dx, dy in _AROUND:
            beside_x, beside_y = xs + dx, ys + dy
            tiles_x, tiles_y = self._tile_of(beside_x), self._tile_of(beside_y)
            for neighbor in set(zip(tiles_x.tolist(), tiles_y.tolist())) - {(tile_column, tile_row)}:
                if not self._is_on_map(neighbor):
                    continue
                there = (tiles_x == neighbor[0]) & (tiles_y == neighbor[1])
                others, _ = self._tile(neighbor)
                x, y = beside_x[there] - self._first_of(neighbor[0]), beside_y[there] - self._first_of(neighbor[1])
                on_map = (x >= 0) & (y >= 0) & (x < others.shape[1]) & (y < others.shape[0])
                found |= {(neighbor, n) for n in np.unique(others[y[on_map], x[on_map]]).tolist() if n}
        return found

    def _extent(self, part: _Part) -> Region:
        (tile_column, tile_row), number = part
        parts, boxes = self._tile((tile_column, tile_row))
        x, y, width, height = boxes[number].tolist()
        first = x + int((parts[y, x : x + width] == number).argmax())
        left, top = self._first_of(tile_column), self._first_of(tile_row)
        return Region((left + x, top + y, left + x + width, top + y + height), (left + first, top + y))

    def _tile_of(self, place: _Places) -> _Places:
        """The columns (or rows) of tiles that columns (or rows) of pixels lie in; −1 is the map's edge."""
        return (place + self._size // 2) // self._size

    def _first_of(self, tile: int) -> int:
        """First column (or row) of pixels of a column (or row) of tiles, as far as it lies on the map."""
        return max(tile * self._size - self._size // 2, 0)

    def _is_on_map(self, tile: _TileKey) -> bool:
        height, width = self._source.shape_hw
        return min(tile) >= 0 and self._first_of(tile[0]) < width and self._first_of(tile[1]) < height

    def _number_parts(self, tile: _TileKey) -> tuple[np.ndarray, np.ndarray]:
        """(h, w) int32 part numbers of a tile, 0 for other classes, and (parts, 4) left, top, width, height."""
        height, width = self._source.shape_hw
        left, top = self._first_of(tile[0]), self._first_of(tile[1])
        right, bottom = min(self._first_of(tile[0] + 1), width), min(self._first_of(tile[1] + 1), height)
        labels = self._source.read(left, top, right - left, bottom - top)
        mask = class_mask(labels, self._value)
        _, parts, statistics, _ = cv2.connectedComponentsWithStats(mask, connectivity=8, ltype=cv2.CV_32S)
        return parts, statistics[:, :4]


def _on_border(parts: np.ndarray, number: int) -> tuple[np.ndarray, np.ndarray]:
    """Rows and columns of a part's pixels on the sides of its tile."""
    sides: list[tuple[np.ndarray, np.ndarray]] = []
    last_row, last_column = parts.shape[0] - 1, parts.shape[1] - 1
    for row in {0, last_row}:
        xs = np.flatnonzero(parts[row] == number)
        sides.append((np.full(len(xs), row), xs))
    for column in {0, last_column}:
        ys = np.flatnonzero(parts[:, column] == number)
        sides.append((ys, np.full(len(ys), column)))
    ys, xs = zip(*sides)
    return np.concatenate(ys), np.concatenate(xs)
