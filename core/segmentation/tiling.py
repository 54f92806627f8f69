"""Segment images tile by tile: the scores of overlapping tiles are blended, so that no seam is visible."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from functools import partial
from threading import Event

import cv2
import numpy as np

from ..errors import ImageError
from ..labels.class_table import UNLABELED
from ..labels.image_source import ImageSource
from .certainty import LABELS_ALONE, NO_DATA, SAMPLED_PX, Certainty, Sureness, percents
from .model import SegmentationModel, averaged_scores

MINIMUM_EDGE_PX = 8
"""Smallest edge of an image that a network can segment."""


@dataclass(frozen=True)
class SegmentedRows:
    """Complete rows of the image.

    Attributes:
        labels_hw: (rows, W) uint8.
        percent_hw: (rows, W) uint8, certainty of the label, 0…100, 255 without data; None if not requested.
        percents_chw: (C, rows, W) uint8, the same of each of the model's channels.
        sure: Mean certainty of the labels of these rows.
    """

    first: int
    labels_hw: np.ndarray
    percent_hw: np.ndarray | None = None
    percents_chw: np.ndarray | None = None
    sure: Sureness = field(default_factory=Sureness)


@dataclass(frozen=True)
class _Tile:
    """A tile: ``image`` of the network's size; ``has_data`` None if all pixels have."""

    column: int
    row: int
    image: np.ndarray
    has_data: np.ndarray | None

    @property
    def is_empty(self) -> bool:
        return self.has_data is not None and not self.has_data.any()


@dataclass(frozen=True)
class Tiles:
    """Tiles of an image that are processed together: all, or those of a block.

    Attributes:
        columns: First pixels of the columns of tiles, including those that only overlap the block.
        rows: First pixels of the rows of tiles, in the same way.
        box: (left, top, right, bottom) of the pixels that they complete.
    """

    columns: Sequence[int]
    rows: Sequence[int]
    box: tuple[int, int, int, int]

    def block(self, tile_hw: tuple[int, int], first: tuple[int, int], count: int) -> Tiles:
        """Return a part of the tiles with the necessary seams; its pixels are equal to those from all tiles.

        Args:
            tile_hw: (height, width) of a tile.
            first: Column and row number of the block's first tile.
            count: Largest number of its tiles along each axis.
        """
        parts = (self.columns, first[0], tile_hw[1], self.box[2]), (self.rows, first[1], tile_hw[0], self.box[3])
        (columns, left, right), (rows, top, bottom) = (_with_seam(*part, count) for part in parts)
        return Tiles(columns, rows, (left, top, right, bottom))


def _with_seam(
    starts: Sequence[int], first: int, size: int, length: int, count: int
) -> tuple[tuple[int, ...], int, int]:
    """Return starts of the tiles that overlap a block's part of an axis, its first pixel, and its last pixel + 1."""
    begin = starts[first]
    end = starts[first + count] if first + count < len(starts) else length
    return tuple(start for start in starts if begin - size < start < end), begin, end


def tiles_of(model: SegmentationModel, shape_hw: tuple[int, int], overlap: float) -> Tiles:
    """Return all tiles of an image of that (height, width); raises ImageError if it has only a few pixels."""
    height, width = shape_hw
    if min(height, width) < MINIMUM_EDGE_PX:
        raise ImageError(
            "The image has {width} × {height} pixels at the model's resolution; segmentation needs at least {least} × "
            "{least}.",
            width=width,
            height=height,
            least=MINIMUM_EDGE_PX,
        )
    columns, rows = (tile_starts(length, tile, overlap) for length, tile in zip((width, height), model.tile_hw[::-1]))
    return Tiles(tuple(columns), tuple(rows), (0, 0, width, height))


def segment(  # noqa: PLR0913 - a network, an image, and what is wanted of it
    model: SegmentationModel,
    source: ImageSource,
    values: Sequence[int],
    overlap: float,
    wanted: Certainty = LABELS_ALONE,
    tiles: Tiles | None = None,
    is_thorough: bool = False,
) -> Iterator[tuple[float, SegmentedRows | None]]:
    """Yield, tile by tile, the share done (0…1) and the rows that it completes, or None.

    A tile's weight decreases over the overlap towards its border, where a network sees the least of the surroundings.
    Each pixel gets the class with the highest weighted sum of scores; the weights need no normalization, because they
    are equal for all classes of a pixel. Pixels without data become 0, and the network does not process tiles without
    any. Memory is needed for two groups of tiles more than the model processes at a time, the scores in the overlap of
    two rows of tiles, and the requested outputs of one row of tiles.

    Args:
        values: (C,) class value of each of the model's channels.
        overlap: Smallest overlap of neighboring tiles, as a share of a tile.
        wanted: Outputs in addition to labels.
        tiles: A block of the image's tiles; rows have the columns of its box, and are numbered as in the image. None
            for all tiles.
        is_thorough: Whether to average all orientations of a tile, which takes 8 times as long.

    Raises:
        ImageError: The image has only a few pixels.
        Exception: What ``source`` and ``model`` raise.
    """
    tiles = tiles_of(model, source.shape_hw, overlap) if tiles is None else tiles
    places = [(column, row) for row in tiles.rows for column in tiles.columns]
    blending = _Blending(model, tiles, np.asarray(values, np.uint8), overlap, wanted)
    groups = [places[n : n + model.tiles_at_once] for n in range(0, len(places), model.tiles_at_once)]
    done, stop = 0, Event()
    scores_of = partial(averaged_scores, model, stop=stop) if is_thorough else model.scores
    # While these tiles are blended here, the network processes the next ones, and those after them are read.
    with ThreadPoolExecutor(1) as reader, ThreadPoolExecutor(model.runs_at_once) as network:

        def look_at(places: Sequence[tuple[int, int]]) -> Future:
            reading = reader.submit(_read_tiles, source, places, model.tile_hw)
            return network.submit(_look, scores_of, reading)

        waiting = model.runs_at_once + 1
        ahead = [look_at(group) for group in groups[:waiting]]
        try:
            for number in range(len(groups)):
                seen = ahead.pop(0).result()
                if number + waiting < len(groups):
                    ahead.append(look_at(groups[number + waiting]))
                for tile, scores in seen:
                    finished = blending.add(tile, scores)
                    done += 1
                    yield done / len(places), finished
        finally:
            # A caller that stops must not wait for tiles that are not started.
            stop.set()
            for future in ahead:
                future.cancel()


def _look(scores_of: Callable[[list], np.ndarray], reading: Future) -> list[tuple[_Tile, np.ndarray | None]]:
    """Return tiles with their (C, H, W) scores, None for tiles without data."""
    tiles = reading.result()
    with_data = [tile.image for tile in tiles if not tile.is_empty]
    found = iter(scores_of(with_data) if with_data else ())
    return [(tile, None if tile.is_empty else next(found)) for tile in tiles]


def tile_starts(length: int, tile: int, overlap: float) -> list[int]:
    """Return first pixels of tiles that cover ``length`` pixels, evenly spread, with at least that overlap.

    A single 0 if the length fits into one tile. No tile extends beyond the end.
    """
    if length <= tile:
        return [0]
    step = max(1, int(tile * (1 - overlap)))
    count = -(-(length - tile) // step) + 1
    return [round(n * (length - tile) / (count - 1)) for n in range(count)]


def nearest_labels(labels_hw: np.ndarray, shape_hw: tuple[int, int]) -> np.ndarray:
    """Return (H, W) uint8 labels resized to another (height, width): each pixel gets the label at its center."""
    if labels_hw.shape == tuple(shape_hw):
        return labels_hw
    rows, columns = (
        ((np.arange(size) + 0.5) * old / size).astype(np.intp) for size, old in zip(shape_hw, labels_hw.shape)
    )
    return labels_hw[rows][:, columns]


class _Blending:
    """Sums of weighted scores, stored only where another tile will still add to them."""

    def __init__(
        self, model: SegmentationModel, tiles: Tiles, values: np.ndarray, overlap: float, wanted: Certainty
    ) -> None:
        columns, rows, (_, _, right, bottom), tile_hw = tiles.columns, tiles.rows, tiles.box, model.tile_hw
        self._tiles = tiles
        self._next_column = dict(zip(columns, [*columns[1:], right]))
        self._next_row = dict(zip(rows, [*rows[1:], bottom]))
        # Columns are relative to the first tile.
        self._width = right - columns[0]
        self._values = values
        ramps = [_ramp(size, overlap) for size in tile_hw]
        self._weights = ramps[0][:, None] * ramps[1]
        self._model, self._wanted = model, wanted
        # Tiles are in rows and columns, so the sum of a pixel's weights is a product of two sums.
        starts = ([start - some[0] for start in some] for some in (rows, columns))
        self._row_sums, self._column_sums = map(_weight_sums, starts, ramps, (bottom - rows[0], self._width))
        # Weighted sums to which tiles of this row or the next one will add: beside, above and below.
        self._left = np.zeros((len(values), tile_hw[0], 0), np.float32)
        self._above = self._below = np.zeros((len(values), 0, self._width), np.float32)
        self._rows = SegmentedRows(0, np.empty((0, self._width), np.uint8))

    def add(self, tile: _Tile, scores: np.ndarray | None) -> SegmentedRows | None:
        """Add a tile's (C, tile height, tile width) scores, None without data; return the rows that it completes."""
        next_row = self._next_row[tile.row]
        rows = next_row - tile.row
        begin = tile.column - self._tiles.columns[0]
        if begin == 0:
            self._begin_row(tile.row, rows, is_last=next_row == self._tiles.box[3])
        if scores is None:
            scores = np.zeros((len(self._values), *self._weights.shape), np.float32)
        for channel in scores:
            cv2.multiply(channel, self._weights, dst=channel)
        scores[:, :, : self._left.shape[2]] += self._left
        # No later tile of this row adds to pixels left of the next tile.
        last = self._next_column[tile.column] - self._tiles.columns[0]
        columns = last - begin
        complete = scores[:, :, :columns]
        complete[:, : self._above.shape[1]] += self._above[:, :, begin:last]
        best = _best_channel(complete[:, :rows])
        no_data = None if tile.has_data is None else ~tile.has_data[:rows, :columns]
        labels = self._rows.labels_hw[:, begin:last]
        labels[:] = self._values[best]
        if no_data is not None:
            labels[no_data] = UNLABELED
        left, top, _, _ = self._tiles.box
        if self._model.has_scores and tile.column >= left and tile.row >= top:
            self._sample_certainty(tile, complete[:, :rows], best, no_data)
        if self._wanted.is_wanted:
            self._store_certainty(tile, complete[:, :rows], best, no_data)
        self._below[:, :, begin:last] = complete[:, rows : rows + self._below.shape[1]]
        self._left = scores[:, :, columns:]
        return self._finished() if last == self._width and tile.row >= top else None

    def _finished(self) -> SegmentedRows:
        """Return the rows without the columns that other blocks complete; blocks have no percents."""
        first = self._tiles.box[0] - self._tiles.columns[0]
        return replace(self._rows, labels_hw=self._rows.labels_hw[:, first:])

    def _sample_certainty(self, tile: _Tile, sums: np.ndarray, best: np.ndarray, no_data: np.ndarray | None) -> None:
        """Add the certainty at a few pixels of complete (C, rows, columns) sums of scores, which takes little time."""
        few = slice(None, None, SAMPLED_PX)
        _, rows, columns = sums.shape
        begin, top = tile.column - self._tiles.columns[0], tile.row - self._tiles.rows[0]
        across = self._column_sums[begin : begin + columns][few]
        weights = self._row_sums[top : top + rows][few, None] * across
        probable = self._model.probabilities(sums[:, few, few] / weights)
        of_label = np.take_along_axis(probable, best[None, few, few].astype(np.intp), axis=0)[0]
        self._rows.sure.add(of_label if no_data is None else of_label[~no_data[few, few]])

    def _store_certainty(self, tile: _Tile, sums: np.ndarray, best: np.ndarray, no_data: np.ndarray | None) -> None:
        """Store percents of complete (C, rows, columns) sums of scores with the highest channel ``best``."""
        _, rows, columns = sums.shape
        begin, top = tile.column - self._tiles.columns[0], tile.row - self._tiles.rows[0]
        part = slice(begin, begin + columns)
        weights = self._row_sums[top : top + rows, None] * self._column_sums[part]
        found = percents(self._model.probabilities(sums / weights))
        if no_data is not None:
            found[:, no_data] = NO_DATA
        if self._rows.percents_chw is not None:
            self._rows.percents_chw[:, :, part] = found
        if self._rows.percent_hw is not None:
            self._rows.percent_hw[:, part] = np.take_along_axis(found, best[None].astype(np.intp), axis=0)[0]

    def _begin_row(self, first: int, rows: int, is_last: bool) -> None:
        channels, tile_height = len(self._values), len(self._weights)
        self._left = np.zeros((channels, tile_height, 0), np.float32)
        self._above = self._below
        self._below = np.empty((channels, 0 if is_last else tile_height - rows, self._width), np.float32)
        shape_hw = rows, self._width
        self._rows = SegmentedRows(
            first,
            np.empty(shape_hw, np.uint8),
            np.empty(shape_hw, np.uint8) if self._wanted.of_label else None,
            np.empty((channels, *shape_hw), np.uint8) if self._wanted.of_each else None,
        )


def _ramp(size: int, overlap: float) -> np.ndarray:
    """Return (size,) float32 weights: 1 in the middle, decreasing like a cosine over the overlap to almost 0."""
    from_end = np.minimum(np.arange(size), np.arange(size)[::-1]) + 0.5
    share = np.minimum(from_end / max(1.0, size * overlap), 1)
    return (np.sin(share * np.pi / 2) ** 2).astype(np.float32)


def _weight_sums(starts: Sequence[int], ramp: np.ndarray, length: int) -> np.ndarray:
    """Return (length,) float32 sums of the weights of all tiles that begin at ``starts``, along an axis."""
    sums = np.zeros(length, np.float32)
    for start in starts:
        covered = sums[start : start + len(ramp)]
        covered += ramp[: len(covered)]
    return sums


def _best_channel(scores: np.ndarray) -> np.ndarray:
    """Return (H, W) uint8 index of the highest of (C, H, W) scores, the first of equal ones; faster than np.argmax."""
    best = scores[0]
    channel = np.zeros(best.shape, np.uint8)
    for number in range(1, len(scores)):
        # 255 where this channel is higher, else 0; the minimum of that and the number, which exceeds all before.
        higher = cv2.compare(scores[number], best, cv2.CMP_GT)
        cv2.max(channel, cv2.min(higher, number, dst=higher), dst=channel)
        best = cv2.max(best, scores[number])
    return channel


def _read_tiles(source: ImageSource, places: Sequence[tuple[int, int]], tile_hw: tuple[int, int]) -> list[_Tile]:
    return [_read_tile(source, column, row, tile_hw) for column, row in places]


def _read_tile(source: ImageSource, column: int, row: int, tile_hw: tuple[int, int]) -> _Tile:
    """Return a tile of the network's size; a smaller image is continued by reflection."""
    height, width = (min(tile, size) for tile, size in zip(tile_hw, source.shape_hw))
    image, has_data = source.read(column, row, width, height)
    if has_data is not None and has_data.all():
        has_data = None
    if (height, width) != tile_hw:
        below, right = tile_hw[0] - height, tile_hw[1] - width
        image = cv2.copyMakeBorder(image, 0, below, 0, right, cv2.BORDER_REFLECT_101)
    return _Tile(column, row, image, has_data)


TILES_A_BLOCK = 8
"""Tiles along each axis: the seams add a ninth, and each block returns 10 MB of labels."""

Found = tuple[np.ndarray, float, int]
"""(h, w) uint8 labels of a block, and sum and number of sampled probabilities of its labels."""


def segment_blocks(
    tiles: Tiles, tile_hw: tuple[int, int], segment: Callable[[Iterable[tuple]], Iterator[Found]]
) -> Iterator[tuple[float, SegmentedRows]]:
    """Segment block by block, with threads or workers: the rows are equal to those of ``segment``.

    Yields the share done (0…1) and each row of tiles, from top to bottom.

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
