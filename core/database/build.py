"""Build a reference database from a label map by tasks; the result is exactly the same with any ``Runner``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import gcd

import numpy as np

from .. import limits
from ..errors import LabelMapError, WindowError
from ..geometry.error_settings import MAP_ACCURACY
from ..geometry.frame import MapFrame
from ..labels.block_hashes import HASHED_BLOCK, blocks_shape, map_hash
from ..labels.class_table import ClassTable
from ..labels.overview import OVERVIEW_FACTOR, HeldOverview, OverviewSink
from ..labels.sources import LabelSource
from ..landmarks.landmarks import BOTTOM, LEFT, NO_ROWS, RIGHT, TOP, Landmarks, objects_from_rows, rows_from_objects
from ..landmarks.landmarks import minimum_area_px as area_px
from ..landmarks.tiles import TileLandmarks, crossing_regions
from ..steps import Steps, result_of
from ..windows.describe import DescribedWindows
from ..windows.grid import WindowGrid, whole_pixels
from ..windows.topology_vector import MINIMUM_REFERENCES, REFERENCES_PER_VECTOR
from .model import MapLandmarks, ReferenceDatabase, Windows
from .parameters import BuildParameters
from .tasks import Box, Runner, Threads

TILE_WIDTH, TILE_PIXELS = 8192, 17_000_000
"""Of a tile in which landmarks are searched: 17 MB of labels and twice that for masks."""

STRIP_PIXELS = 64_000_000
"""Of a row of windows; wider maps are described in several blocks of columns, in order in the database."""

SHARED_HEIGHT = 0.5
"""Windows that start within this share of a window's height are described by one task, because they share cuts."""

REGIONS_A_TASK = 200
"""Regions across tiles that one task measures."""

COMPARED_A_TASK = 4096
"""Windows that one task compares with all others."""


@dataclass(frozen=True)
class BuildSettings:
    """Settings of a build.

    Attributes:
        window_size: Edge of a window of level 1, map units.
        stride: Distance between windows, map units.
        minimum_area: Of a landmark, m².
        levels: Multipliers of the window size.
        references_per_vector: Largest number of landmarks in a vector.
        overview_factor: Edge of an overview pixel, pixels of the label map.
        map_accuracy: Standard deviation along each axis of the positions of landmarks on the map, map units.

    Raises:
        WindowError: A value can't be used.
    """

    window_size: float
    stride: float
    minimum_area: float
    levels: tuple[float, ...] = (1.0,)
    references_per_vector: int = REFERENCES_PER_VECTOR
    overview_factor: int = OVERVIEW_FACTOR
    map_accuracy: float = MAP_ACCURACY

    def __post_init__(self) -> None:
        if not all(0 <= length < limits.LENGTH for length in (self.window_size, self.stride)):
            raise WindowError(
                "The windows have an edge of {window_size:g} m and a stride of {stride:g} m; both must be above 0.",
                window_size=self.window_size,
                stride=self.stride,
            )
        if not self.minimum_area > 0:
            raise WindowError(
                "The minimum area is {minimum_area:g} m²; it must be more than 0.", minimum_area=self.minimum_area
            )
        if self.references_per_vector < MINIMUM_REFERENCES:
            raise WindowError(
                "A vector of {count} landmarks is too short; use at least {least}.",
                count=self.references_per_vector,
                least=MINIMUM_REFERENCES,
            )
        if not self.levels or not all(0 < level < limits.LENGTH for level in self.levels):
            raise WindowError("The levels must be positive multipliers of the window size, for example 1;2.")
        # Repeated levels count once.
        object.__setattr__(self, "levels", tuple(dict.fromkeys(self.levels)))


def build_by_tasks(  # noqa: PLR0913 - the map, settings, runner and sink of the overview
    frame: MapFrame,
    table: ClassTable,
    settings: BuildSettings,
    plugin_version: str,
    run: Runner,
    overview: OverviewSink,
) -> Steps[ReferenceDatabase]:
    """Build a database without its overview.

    Args:
        overview: Receives the pieces of the overview, in any order.

    Raises:
        WindowError: The windows don't fit the map.
        ClassTableError: No class is a reference class.
        LabelMapError: The map has no landmark.
    """
    table = table.require_references()
    grids = level_grids(frame.shape_hw, frame.pixel_size, settings)
    values, minimum_area = tuple(sorted(table.reference_values)), area_px(settings.minimum_area, frame.pixel_size)
    found, hashes = yield from _scan(run, frame.shape_hw, (values, minimum_area, settings.overview_factor), overview)
    rows = yield from _join(run, found, minimum_area)
    objects = objects_from_rows(rows, frame.shape_hw)
    if not len(objects):
        raise LabelMapError(
            "The map has no region of {references} with at least {minimum_area:g} m²; choose other reference classes "
            "or a smaller minimum area.",
            references=[c.name for c in table.references],
            minimum_area=settings.minimum_area,
        )
    described = yield from _describe(run, grids, objects, (values, minimum_area, settings.references_per_vector))
    windows = windows_of(described, frame)
    distinct = yield from _compare(run, windows)
    parameters = parameters_of(frame, table, settings, plugin_version, tuple(hashes))
    windows = replace(windows, distinctiveness=distinct)
    return ReferenceDatabase(windows, map_references(objects, frame), table, parameters, None)


def _scan(
    run: Runner, shape_hw: tuple[int, int], shared: tuple[tuple[int, ...], float, int], overview: OverviewSink
) -> Steps[tuple[list[TileLandmarks], list[str]]]:
    """Return the landmarks of each tile, and the hashes of all blocks, row by row."""
    *_, factor = shared
    boxes = tile_boxes(shape_hw, factor)
    tiles: list[TileLandmarks] = []
    blocks = np.empty(blocks_shape(shape_hw), object)
    for result, box in zip(run("scan", ((box,) for box in boxes), shared), boxes):
        rows, pieces, runs, reduced, some = result
        column, row, width, height = box
        tiles.append(TileLandmarks(rows, pieces, runs))
        overview(column // factor, row // factor, reduced)
        down, across = blocks_shape((height, width))
        top, left = row // HASHED_BLOCK, column // HASHED_BLOCK
        blocks[top : top + down, left : left + across] = np.array(some, object).reshape(down, across)
        yield "Finding landmarks", 0.3 * len(tiles) / len(boxes)
    return tiles, blocks.ravel().tolist()


def _join(run: Runner, found: list[TileLandmarks], minimum_area: float) -> Steps[np.ndarray]:
    """Return (N, 8) rows of all landmarks, also of the regions across tiles."""
    regions = np.array(
        [(value, *region.bounds, *region.first_pixel) for value, region in crossing_regions(found)], np.int64
    ).reshape(-1, 7)
    # One task reads neighbors, mostly from one piece of the file.
    regions = regions[np.lexsort((regions[:, 1], regions[:, 2] // HASHED_BLOCK))]
    calls = [(regions[first : first + REGIONS_A_TASK],) for first in range(0, len(regions), REGIONS_A_TASK)]
    rows = [NO_ROWS, *(tile.rows for tile in found)]
    for done, measured in enumerate(run("measure", calls, (minimum_area,)), start=1):
        rows.append(measured)
        yield "Joining landmarks", 0.3 + 0.1 * done / len(calls)
    return np.concatenate(rows)


def _describe(
    run: Runner, grids: Sequence[WindowGrid], objects: Landmarks, shared: tuple[tuple[int, ...], float, int]
) -> Steps[list[tuple[int, WindowGrid, DescribedWindows]]]:
    """Return the described windows of all levels, in the order of a database."""
    rows, done, total = rows_from_objects(objects), 0, sum(map(len, grids))
    described: list[tuple[int, WindowGrid, DescribedWindows]] = []
    for level, grid in enumerate(grids, start=1):
        calls = ((box, (grid.size, grid.stride), _reaching(rows, box)) for box in window_boxes(grid))
        for part in run("describe", calls, shared):
            described.append((level, grid, DescribedWindows(*part)))
            done += len(described[-1][2].counts)
            yield "Describing windows", 0.4 + 0.4 * done / total
    return described


def _compare(run: Runner, windows: Windows) -> Steps[np.ndarray]:
    """Return the distinctiveness; NaN for windows without a vector, or without another one to compare."""
    distinct = np.full(len(windows), np.nan)
    index = np.flatnonzero(windows.described)
    shared = windows.vectors[index], windows.centers[index], windows.sizes[index]
    stretches = [(n, min(n + COMPARED_A_TASK, len(index))) for n in range(0, len(index), COMPARED_A_TASK)]
    for distances, (first, last) in zip(run("compare", stretches, shared), stretches):
        distinct[index[first:last]] = np.where(np.isinf(distances), np.nan, distances)
        yield "Comparing windows", 0.8 + 0.2 * last / len(index)
    return distinct


def build_from_labels(
    source: LabelSource, frame: MapFrame, table: ClassTable, settings: BuildSettings, plugin_version: str
) -> ReferenceDatabase:
    """Build a database, including its overview, in one call.

    Args:
        frame: Grid of the map, of any shape.

    Raises:
        LabelMapError: The map has no landmark.
        WindowError: The windows don't fit the map.
        ClassTableError: No class is a reference class.
    """
    frame = frame.of_shape(source.shape_hw)
    overview = HeldOverview(frame.reduced(settings.overview_factor).shape_hw)
    steps = build_by_tasks(frame, table, settings, plugin_version, Threads(source), overview.put)
    return replace(result_of(steps), overview=overview.labels)


def windows_of(described: Sequence[tuple[int, WindowGrid, DescribedWindows]], frame: MapFrame) -> Windows:
    """Return the windows of a database from described windows with their level and its grid, in this order."""
    first_pixels = np.concatenate([np.column_stack([w.columns, w.rows]) for _, _, w in described])
    counts = np.concatenate([w.counts for _, _, w in described])
    repeats = [len(w.counts) for _, _, w in described]
    sizes_px = np.repeat([grid.size for _, grid, _ in described], repeats)
    return Windows(
        first_pixels=first_pixels,
        levels=np.repeat([level for level, _, _ in described], repeats),
        sizes=sizes_px * frame.pixel_size,
        centers=frame.to_map(first_pixels + sizes_px[:, None] / 2),
        counts=counts,
        vectors=np.concatenate([w.vectors for _, _, w in described]),
        described=counts >= MINIMUM_REFERENCES,
    )


def parameters_of(
    frame: MapFrame, table: ClassTable, settings: BuildSettings, plugin_version: str, block_hashes: tuple[str, ...]
) -> BuildParameters:
    """Return the parameters that a database stores about its build; ``frame`` has the map's shape."""
    (height, width), pixel = frame.shape_hw, frame.pixel_size
    return BuildParameters(
        crs=frame.crs,
        geotransform=frame.geotransform,
        map_width_px=width,
        map_height_px=height,
        pixel_size=pixel,
        window_size=whole_pixels(settings.window_size, pixel) * pixel,
        stride=whole_pixels(settings.stride, pixel) * pixel,
        levels=settings.levels,
        references_per_vector=settings.references_per_vector,
        minimum_area=settings.minimum_area,
        overview_factor=settings.overview_factor,
        map_hash=map_hash((height, width), frame.geotransform, block_hashes),
        class_table_hash=table.digest(),
        plugin_version=plugin_version,
        block_hashes=block_hashes,
        map_accuracy=settings.map_accuracy,
    )


def map_references(objects: Landmarks, frame: MapFrame) -> MapLandmarks:
    """Return the landmarks of a map (pixels) in map units."""
    areas = objects.areas_px * frame.pixel_size**2
    return MapLandmarks(frame.to_map(objects.centers_xy), objects.classes, areas, objects.touches_edge, objects.bounds)


def tile_boxes(shape_hw: tuple[int, int], factor: int) -> list[Box]:
    """Return the tiles of a map; their edges are multiples of hashed blocks and of overview pixels.

    Tiles are as wide as the map if a row of blocks then fits, because files store rows of pixels or rows of tiles.

    Args:
        shape_hw: (height, width) of the map, pixels.
    """
    height, width = shape_hw
    unit = HASHED_BLOCK * factor // gcd(HASHED_BLOCK, factor)
    across = width if width * unit <= TILE_PIXELS else max(TILE_WIDTH // unit, 1) * unit
    down = max(TILE_PIXELS // across // unit, 1) * unit
    return [
        (column, row, min(across, width - column), min(down, height - row))
        for row in range(0, height, down)
        for column in range(0, width, across)
    ]


def window_boxes(grid: WindowGrid) -> list[Box]:
    """Return pieces of the map for one task each, in the order of a database's windows; each starts with a window."""
    across = max(1, (STRIP_PIXELS // grid.size - grid.size) // grid.stride + 1)
    down = int(SHARED_HEIGHT * grid.size) // grid.stride + 1
    found = []
    for columns in (grid.columns[first : first + across] for first in range(0, len(grid.columns), across)):
        width = int(columns[-1] - columns[0]) + grid.size
        for rows in (grid.rows[first : first + down] for first in range(0, len(grid.rows), down)):
            found.append((int(columns[0]), int(rows[0]), width, int(rows[-1] - rows[0]) + grid.size))
    return found


def _reaching(rows: np.ndarray, box: Box) -> np.ndarray:
    """Return the landmarks (N, 8) that overlap a piece."""
    column, row, width, height = box
    inside = (rows[:, RIGHT] > column) & (rows[:, LEFT] < column + width)
    inside &= (rows[:, BOTTOM] > row) & (rows[:, TOP] < row + height)
    return rows[inside]


def level_grids(shape_hw: tuple[int, int], pixel_size: float, settings: BuildSettings) -> list[WindowGrid]:
    """Return one grid per level; window and stride grow together.

    Raises:
        WindowError: A level doesn't fit the map.
    """
    height, width = shape_hw
    return [
        WindowGrid(
            width,
            height,
            whole_pixels(settings.window_size * level, pixel_size),
            whole_pixels(settings.stride * level, pixel_size),
        )
        for level in settings.levels
    ]
