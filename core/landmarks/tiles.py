"""Landmarks of one tile of a map, with the data at its seams that joins regions across tiles exactly.

Tiles (or bands) can be processed in any order and on many machines; ``crossing_regions`` joins their regions.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from ..labels.sources import LabelSource
from .border_following import follow_outer_border
from .joining import connected_components, touching_runs
from .landmarks import NO_ROWS, class_mask, contour_row, outer_contours, rows_array, shift_row, shift_rows

PATCH_PIXELS = 16_000_000
"""A region that crosses tiles is read in one piece up to this many pixels; the border of a larger one is followed."""

NO_PIECES = np.empty((0, 7), np.int64)
NO_RUNS = np.empty((0, 6), np.int64)

_TOP, _BOTTOM, _LEFT, _RIGHT = range(4)


@dataclass(frozen=True)
class Region:
    """An 8-connected region of a map.

    Attributes:
        bounds: (left, top, right, bottom), pixels; right and bottom are exclusive.
        first_pixel: (column, row) of its first pixel in raster order.
    """

    bounds: tuple[int, int, int, int]
    first_pixel: tuple[int, int]


def whole_region(pieces: Sequence[Region]) -> Region:
    """Return the union of pieces of a region."""
    lefts, tops, rights, bottoms = zip(*(piece.bounds for piece in pieces))
    first_pixel = min((piece.first_pixel for piece in pieces), key=lambda pixel: (pixel[1], pixel[0]))
    return Region((min(lefts), min(tops), max(rights), max(bottoms)), first_pixel)


@dataclass(frozen=True)
class TileLandmarks:
    """Landmarks and cut regions of one tile, in the map's pixels.

    Attributes:
        rows: (N, 8) float64 rows of the landmarks that are completely inside the tile.
        pieces: (P, 7) int64 regions that touch a side where the map continues: class, left, top, right, bottom,
            column and row of the first pixel in raster order.
        runs: (R, 6) int64 runs of their pixels along these sides: class, whether the side is a column (1) or a row
            (0), number of that column or row, first pixel along it, last pixel + 1, number of the piece.
    """

    rows: np.ndarray
    pieces: np.ndarray
    runs: np.ndarray


def tile_landmarks(
    labels_hw: np.ndarray, first: tuple[int, int], map_hw: tuple[int, int], values: Sequence[int], minimum_area: float
) -> TileLandmarks:
    """Find the landmarks of one tile.

    Args:
        labels_hw: (h, w) uint8.
        first: (column, row) of its first pixel on the map.
        map_hw: (height, width) of the map.
        minimum_area: Of a landmark, pixels.
    """
    rows, pieces, runs = [NO_ROWS], [NO_PIECES], [NO_RUNS]
    for value in values:
        mask = class_mask(labels_hw, value)
        sides = _open_sides(mask, first, map_hw)
        whole, cut = _divided(mask, sides)
        found = (contour_row(contour, value, minimum_area) for contour in whole)
        rows.append(shift_rows(rows_array([row for row in found if row is not None]), *first))
        base = sum(map(len, pieces))
        pieces.append(_pieces(cut, value, first))
        runs += [_runs(mask, cut, side, value, first, base) for side in sides]
    return TileLandmarks(np.concatenate(rows), np.concatenate(pieces), np.concatenate(runs))


def crossing_regions(tiles: Iterable[TileLandmarks]) -> list[tuple[int, Region]]:
    """Return class and region of each that crosses tiles; ``measure_region`` measures it.

    Args:
        tiles: All tiles of the map; their rows are not needed.
    """
    pieces, _, components = join_tiles(tiles)
    return joined_regions(pieces, components)


def join_tiles(tiles: Iterable[TileLandmarks]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return all pieces and runs of tiles, numbered consecutively, and the (P,) int64 region of each piece."""
    pieces, runs, count = [NO_PIECES], [NO_RUNS], 0
    for tile in tiles:
        pieces.append(tile.pieces)
        runs.append(tile.runs + np.array([0, 0, 0, 0, 0, count]))
        count += len(tile.pieces)
    every = np.concatenate(runs)
    return np.concatenate(pieces), every, connected_components(count, _links(every))


def joined_regions(pieces: np.ndarray, components: np.ndarray) -> list[tuple[int, Region]]:
    """Return class and region of each component of pieces, see ``join_tiles``."""
    joined: dict[int, list[int]] = {}
    for piece, component in enumerate(components.tolist()):
        joined.setdefault(component, []).append(piece)
    numbers = pieces.tolist()
    return [
        (numbers[members[0]][0], whole_region([_region(numbers[n]) for n in members])) for members in joined.values()
    ]


def measure_region(
    source: LabelSource, value: int, region: Region, minimum_area_px: float, patch_pixels: int = PATCH_PIXELS
) -> tuple | None:
    """Measure one region.

    Args:
        minimum_area_px: Smaller regions are not landmarks.
        patch_pixels: A region is read in one piece up to this many pixels; the border of a larger one is followed.

    Returns:
        Its row (class, center x, y, area, left, top, right, bottom); None if it is too small.
    """
    left, top, right, bottom = region.bounds
    # A polygon through pixel centers is never larger than its bounding box.
    if (right - left) * (bottom - top) < minimum_area_px:
        return None
    if (right - left) * (bottom - top) > patch_pixels:
        return follow_outer_border(source, value, region.first_pixel, minimum_area_px)
    mask = class_mask(source.read(left, top, right - left, bottom - top), value)
    start = np.array([region.first_pixel[0] - left, region.first_pixel[1] - top])
    for contour in outer_contours(mask):
        if (contour[:, 0] == start).all(axis=1).any():
            row = contour_row(contour, value, minimum_area_px)
            return None if row is None else shift_row(row, left, top)
    return None


def _region(piece: list[int]) -> Region:
    _, left, top, right, bottom, column, row = piece
    return Region((left, top, right, bottom), (column, row))


def _links(runs: np.ndarray) -> np.ndarray:
    """Return (L, 2) numbers of pieces of one class that touch across a seam, also at a corner."""
    links = [np.empty((0, 2), np.int64)]
    for value in np.unique(runs[:, 0]):
        for direction in (0, 1):
            some = runs[(runs[:, 0] == value) & (runs[:, 1] == direction)]
            # In reading order: along each line of pixels, line after line.
            some = some[np.lexsort((some[:, 3], some[:, 2]))]
            links.append(some[:, 5][touching_runs(some[:, 2], some[:, 3], some[:, 4])])
    return np.concatenate(links)


def _open_sides(mask: np.ndarray, first: tuple[int, int], map_hw: tuple[int, int]) -> list[int]:
    """Return the sides with pixels of the class where the map continues."""
    (height, width), (column, row) = mask.shape, first
    goes_on = row > 0, row + height < map_hw[0], column > 0, column + width < map_hw[1]
    return [side for side in range(4) if goes_on[side] and _line(mask, side).any()]


def _line(mask: np.ndarray, side: int) -> np.ndarray:
    return (mask[0], mask[-1], mask[:, 0], mask[:, -1])[side]


def _divided(mask: np.ndarray, sides: list[int]) -> tuple[list, list]:
    """Return contours of the regions inside the tile, and of those that touch one of the sides."""
    contours = outer_contours(mask)
    if not sides:
        return contours, []
    height, width = mask.shape
    whole: list[np.ndarray] = []
    cut: list[np.ndarray] = []
    for contour in contours:
        left, top, across, down = cv2.boundingRect(contour)
        reached = top == 0, top + down == height, left == 0, left + across == width
        (cut if any(reached[side] for side in sides) else whole).append(contour)
    return whole, cut


def _pieces(contours: list, value: int, first: tuple[int, int]) -> np.ndarray:
    """Return (P, 7) pieces, see ``TileLandmarks``."""
    found = []
    for contour in contours:
        left, top, across, down = cv2.boundingRect(contour)
        points = contour[:, 0]
        begin = int(points[points[:, 1] == top, 0].min())
        found.append((value, left, top, left + across, top + down, begin, top))
    return np.array(found, np.int64).reshape(-1, 7) + np.array([0, *first * 3])


def _runs(  # noqa: PLR0913 - the data of a run
    mask: np.ndarray, contours: list, side: int, value: int, first: tuple[int, int], base: int
) -> np.ndarray:
    """Return (R, 6) runs of set pixels along one side, see ``TileLandmarks``.

    A contour turns at both ends of such a run, so ``CHAIN_APPROX_SIMPLE`` keeps these points: they identify its region.
    """
    is_column = side in (_LEFT, _RIGHT)
    across, along = (0, 1) if is_column else (1, 0)
    place = {_TOP: 0, _BOTTOM: mask.shape[0] - 1, _LEFT: 0, _RIGHT: mask.shape[1] - 1}[side]
    line = _line(mask, side)
    owner = np.full(len(line), -1, np.int64)
    for index, points in enumerate(_points(contours)):
        owner[points[points[:, across] == place, along]] = base + index
    steps = np.diff(np.concatenate([[0], (line > 0).astype(np.int8), [0]]))
    starts, stops = np.flatnonzero(steps == 1), np.flatnonzero(steps == -1)
    found = np.empty((len(starts), 6), np.int64)
    found[:, :3] = value, is_column, place + first[across]
    found[:, 3], found[:, 4], found[:, 5] = starts + first[along], stops + first[along], owner[starts]
    return found[found[:, 5] >= 0]


def _points(contours: list) -> Iterator[np.ndarray]:
    """Yield the (n, 2) points (column, row) of each contour."""
    for contour in contours:
        yield contour[:, 0]
