"""A build cut into tasks that need nothing of each other, for many processes or machines: the same database, exactly.

Each task reads one piece of the label map and gives plain arrays. ``PartsBuilder`` says which tasks there are, takes
what they give in any order, and puts it together as ``DatabaseBuilder`` does in one process.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from math import gcd
from typing import Any, Protocol

import numpy as np

from ..geometry.frame import MapFrame
from ..labels.block_hashes import HASHED_BLOCK, BlockHasher, blocks_shape
from ..labels.class_table import ClassTable
from ..labels.overview import OverviewSink, most_frequent_labels
from ..labels.sources import LabelSource, PartOfMap
from ..landmarks.catalogue import measure_region
from ..landmarks.landmarks import (
    BOTTOM,
    LEFT,
    NO_ROWS,
    RIGHT,
    TOP,
    Landmarks,
    objects_from_rows,
    rows_array,
    rows_from_objects,
    shift_rows,
)
from ..landmarks.landmarks import minimum_area_px as area_px
from ..landmarks.regions import Region
from ..landmarks.tiles import TileLandmarks, crossing_regions, tile_landmarks
from ..windows.describe import DescribedWindows, column_blocks, describe_windows
from ..windows.distinctiveness import nearest_distances
from ..windows.grid import WindowGrid
from .build import BuildSettings, level_grids, map_references, parameters_of, require_landmarks, windows_of
from .model import ReferenceDatabase

TILE_WIDTH, TILE_PIXELS = 8192, 24_000_000
"""Of a piece that landmarks are looked for in: 24 MB of labels and twice that for masks."""

PART_PIXELS = 32_000_000
"""Of the piece of a map that the windows of one task cover, unless a single window is larger."""

REGIONS_A_TASK = 200
"""Regions that cross tiles and are measured by one task."""

COMPARED_A_TASK = 4096
"""Windows that one task compares with all."""

Box = tuple[int, int, int, int]
"""Column, row, width, height of a piece of the map, pixels."""


class Runner(Protocol):
    """Has tasks done, here or elsewhere."""

    def __call__(self, task: str, calls: Iterable[tuple], shared: tuple = ()) -> Iterator[tuple[int, Any]]:
        """Yields the number of a call and what it gave, as they are done.

        Args:
            task: One of ``TASKS``.
            calls: Arguments of each call, taken when there is room for another.
            shared: Arguments that come first in every call.
        """


def scan(
    source: LabelSource, values: Sequence[int], minimum_area: float, factor: int, box: Box
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, list[str]]:
    """One tile: rows, pieces and runs of its landmarks (``TileLandmarks``), its overview, its block hashes."""
    column, row, width, height = box
    labels = source.read(column, row, width, height)
    found = tile_landmarks(labels, (column, row), source.shape_hw, values, minimum_area)
    hasher = BlockHasher(width)
    hasher.add(labels)
    return found.rows, found.pieces, found.runs, most_frequent_labels(labels, factor), list(hasher.hashes)


def measure(source: LabelSource, minimum_area: float, regions: np.ndarray) -> np.ndarray:
    """(N, 8) rows of regions that cross tiles.

    Args:
        source: The label map.
        minimum_area: Of a landmark, pixels.
        regions: (R, 7) int64 class, left, top, right, bottom, column and row of the first pixel.
    """
    found = (
        measure_region(source, value, Region((left, top, right, bottom), (column, row)), minimum_area)
        for value, left, top, right, bottom, column, row in regions.tolist()
    )
    return rows_array([row for row in found if row is not None])


def describe(  # noqa: PLR0913 - what a window is described by, and where these lie
    source: LabelSource,
    values: Sequence[int],
    minimum_area: float,
    references_per_vector: int,
    box: Box,
    window: tuple[int, int],
    near: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Columns, rows, counts and vectors (``DescribedWindows``) of the windows in one piece.

    Args:
        source: The label map.
        values: Classes of landmarks.
        minimum_area: Of a landmark, pixels.
        references_per_vector: Landmarks that a vector holds at most.
        box: The piece; its first window begins with it.
        window: (size, stride), pixels.
        near: (N, 8) rows of the landmarks that reach into the piece.
    """
    column, row, width, height = box
    grid = WindowGrid(width, height, *window)
    objects = objects_from_rows(shift_rows(near, -column, -row), (height, width))
    found = list(describe_windows(PartOfMap(source, *box), grid, objects, values, minimum_area, references_per_vector))
    columns, rows, counts, vectors = (
        np.concatenate([getattr(some, name) for some in found]) for name in ("columns", "rows", "counts", "vectors")
    )
    return columns + column, rows + row, counts, vectors


def compare(
    _: LabelSource, vectors: np.ndarray, centers: np.ndarray, sizes: np.ndarray, first: int, last: int
) -> np.ndarray:
    """(last − first,) distances of some windows to the nearest vector elsewhere, infinity where there is none."""
    some = vectors[first:last], centers[first:last], sizes[first:last]
    found = [distances for _, distances in nearest_distances(some, (vectors, centers, sizes))]
    return np.concatenate([np.empty(0), *found])


TASKS: dict[str, Callable] = {"scan": scan, "measure": measure, "describe": describe, "compare": compare}


class PartsBuilder:
    """Builds a database by tasks: iterate ``steps()`` to the end, then take ``database``."""

    def __init__(  # noqa: PLR0913 - a map, what is wanted of it, who does it, and where the overview goes
        self,
        frame: MapFrame,
        table: ClassTable,
        settings: BuildSettings,
        plugin_version: str,
        run: Runner,
        overview: OverviewSink,
    ) -> None:
        """Makes the builder; nothing is read yet.

        Args:
            frame: Where the map's pixels lie, and how many it has.
            table: With the reference classes.
            settings: What the user chooses.
            plugin_version: What the database says.
            run: Has tasks done.
            overview: Takes the pieces of the overview, in any order.

        Raises:
            WindowError: The windows don't fit the map.
            ClassTableError: No class is a reference class.
        """
        self._frame = frame
        self._table = table.require_references()
        self._settings = settings
        self._plugin_version = plugin_version
        self._run = run
        self._overview = overview
        self._minimum_area = area_px(settings.minimum_area, frame.pixel_size)
        self._values = tuple(sorted(self._table.reference_values))
        self.grids = level_grids(frame.shape_hw, frame.pixel_size, settings)
        self.database: ReferenceDatabase | None = None

    def steps(self) -> Iterator[tuple[str, float]]:
        """Yields (what is being done, share done 0…1).

        Raises:
            LabelMapError: The map has no landmark.
        """
        found: list[TileLandmarks] = []
        hashes: list[str] = []
        for share in self._scan(found, hashes):
            yield "Finding landmarks", 0.3 * share
        rows = [NO_ROWS, *(tile.rows for tile in found)]
        for share in self._join(found, rows):
            yield "Joining landmarks", 0.3 + 0.1 * share
        joined = objects_from_rows(np.concatenate(rows), self._frame.shape_hw)
        objects = require_landmarks(joined, self._table, self._settings)
        described: list[tuple[int, WindowGrid, DescribedWindows]] = []
        for share in self._describe(objects, described):
            yield "Describing windows", 0.4 + 0.4 * share
        windows, references = windows_of(described, self._frame), map_references(objects, self._frame)
        parameters = parameters_of(self._frame, self._table, self._settings, self._plugin_version, tuple(hashes))
        database = ReferenceDatabase(windows, references, self._table, parameters, None)
        distinct = np.full(len(windows), np.nan)
        for share in self._compare(database, distinct):
            yield "Comparing windows", 0.8 + 0.2 * share
        self.database = replace(database, windows=replace(windows, distinctiveness=distinct))

    def _scan(self, found: list[TileLandmarks], hashes: list[str]) -> Iterator[float]:
        """Looks through the tiles; ``hashes`` become those of all blocks, row by row."""
        factor = self._settings.overview_factor
        boxes = tile_boxes(self._frame.shape_hw, factor)
        tiles: list[TileLandmarks | None] = [None] * len(boxes)
        blocks = np.empty(blocks_shape(self._frame.shape_hw), object)
        shared = self._values, self._minimum_area, factor
        for done, (number, result) in enumerate(self._run("scan", ((box,) for box in boxes), shared), start=1):
            rows, pieces, runs, reduced, some = result
            column, row, width, height = boxes[number]
            tiles[number] = TileLandmarks(rows, pieces, runs)
            self._overview(column // factor, row // factor, reduced)
            down, across = blocks_shape((height, width))
            top, left = row // HASHED_BLOCK, column // HASHED_BLOCK
            blocks[top : top + down, left : left + across] = np.array(some, object).reshape(down, across)
            yield done / len(boxes)
        found += [tile for tile in tiles if tile is not None]
        hashes += blocks.ravel().tolist()

    def _join(self, found: list[TileLandmarks], rows: list[np.ndarray]) -> Iterator[float]:
        """Measures what crosses tiles, and adds it to ``rows``."""
        regions = np.array(
            [(value, *region.bounds, *region.first_pixel) for value, region in crossing_regions(found)], np.int64
        ).reshape(-1, 7)
        # Neighbors are read by one task, and so mostly from one piece of the file.
        regions = regions[np.lexsort((regions[:, 1], regions[:, 2] // HASHED_BLOCK))]
        calls = [(regions[first : first + REGIONS_A_TASK],) for first in range(0, len(regions), REGIONS_A_TASK)]
        for done, (_, measured) in enumerate(self._run("measure", calls, (self._minimum_area,)), start=1):
            rows.append(measured)
            yield done / len(calls)

    def _describe(
        self, objects: Landmarks, described: list[tuple[int, WindowGrid, DescribedWindows]]
    ) -> Iterator[float]:
        """Describes the windows of all levels, in the order of a database."""
        rows, done, total = rows_from_objects(objects), 0, sum(map(len, self.grids))
        shared = self._values, self._minimum_area, self._settings.references_per_vector
        for level, grid in enumerate(self.grids, start=1):
            boxes = window_boxes(grid)
            calls = ((box, (grid.size, grid.stride), _reaching(rows, box)) for box in boxes)
            parts: list[tuple[np.ndarray, ...]] = []
            for _, part in self._run("describe", calls, shared):
                parts.append(part)
                done += len(part[0])
                yield done / total
            described.append((level, grid, _in_order(grid, parts)))

    def _compare(self, database: ReferenceDatabase, distinct: np.ndarray) -> Iterator[float]:
        """Fills in the windows' distinctiveness."""
        windows = database.windows
        index = np.flatnonzero(windows.described)
        shared = windows.vectors[index], windows.centers[index], windows.sizes[index]
        stretches = [(n, min(n + COMPARED_A_TASK, len(index))) for n in range(0, len(index), COMPARED_A_TASK)]
        for done, (number, distances) in enumerate(self._run("compare", stretches, shared), start=1):
            distinct[index[slice(*stretches[number])]] = np.where(np.isinf(distances), np.nan, distances)
            yield done / len(stretches)


def tile_boxes(shape_hw: tuple[int, int], factor: int) -> list[Box]:
    """The tiles of a map, which whole hashed blocks and whole pixels of the overview fit into.

    Args:
        shape_hw: (height, width) of the map, pixels.
        factor: Of the overview.
    """
    height, width = shape_hw
    unit = HASHED_BLOCK * factor // gcd(HASHED_BLOCK, factor)
    across = max(TILE_WIDTH // unit, 1) * unit
    down = max(TILE_PIXELS // min(across, width) // unit, 1) * unit
    return [
        (column, row, min(across, width - column), min(down, height - row))
        for row in range(0, height, down)
        for column in range(0, width, across)
    ]


def window_boxes(grid: WindowGrid) -> list[Box]:
    """Pieces of the map whose windows one task describes; each begins with a window, and none is in two."""
    found = []
    for columns in column_blocks(grid, PART_PIXELS):
        width = int(columns[-1] - columns[0]) + grid.size
        per_part = max(1, (PART_PIXELS // width - grid.size) // grid.stride + 1)
        for first in range(0, len(grid.rows), per_part):
            rows = grid.rows[first : first + per_part]
            found.append((int(columns[0]), int(rows[0]), width, int(rows[-1] - rows[0]) + grid.size))
    return found


def _reaching(rows: np.ndarray, box: Box) -> np.ndarray:
    """Those of the landmarks (N, 8) that reach into a piece."""
    column, row, width, height = box
    inside = (rows[:, RIGHT] > column) & (rows[:, LEFT] < column + width)
    inside &= (rows[:, BOTTOM] > row) & (rows[:, TOP] < row + height)
    return rows[inside]


def _in_order(grid: WindowGrid, parts: list[tuple[np.ndarray, ...]]) -> DescribedWindows:
    """The windows of one grid in the order in which one process describes them: block of columns, row, column."""
    columns, rows, counts, vectors = (np.concatenate(column) for column in zip(*parts))
    firsts = [int(block[0]) for block in column_blocks(grid)]
    order = np.lexsort((columns, rows, np.searchsorted(firsts, columns, side="right")))
    return DescribedWindows(columns[order], rows[order], counts[order], vectors[order])
