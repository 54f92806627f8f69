"""Update a database after corrections of its label map: same result as a new build, but reads only changed parts."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from ..errors import DatabaseError, LabelMapError
from ..geometry.frame import MapFrame
from ..labels.block_hashes import HASHED_BLOCK, BlockHasher, block_hash, blocks_shape, map_hash
from ..labels.class_table import ClassTable
from ..labels.overview import most_frequent_labels
from ..labels.sources import LabelSource, count_labels
from ..landmarks.landmarks import minimum_area_px
from ..steps import Steps, part
from ..windows.distinctiveness import nearest_distances
from ..windows.grid import WindowGrid
from ..windows.topology_vector import MINIMUM_REFERENCES
from .build import window_boxes
from .changed_regions import Bounds, block_bounds, blocks_of, changed_landmarks, changed_places
from .model import MapLandmarks, ReferenceDatabase, Windows
from .parameters import BuildParameters
from .tasks import Runner


@dataclass(frozen=True)
class DatabaseChanges:
    """Changes of a database of N windows by an update.

    Attributes:
        windows: All N windows after the update.
        touched: (T,) int64 indices of the changed windows.
        removed: (K,) int64 indices of the removed landmarks.
        overview: (first column, first row, (h, w) uint8) pieces of the new overview.
    """

    windows: Windows
    touched: np.ndarray
    removed: np.ndarray
    added: MapLandmarks
    overview: tuple[tuple[int, int, np.ndarray], ...]
    parameters: BuildParameters


def update_by_tasks(  # noqa: PLR0913 - the map, the database, and how to run
    source: LabelSource,
    frame: MapFrame,
    database: ReferenceDatabase,
    areas: Sequence[Bounds] | None,
    plugin_version: str,
    run: Runner,
) -> Steps[DatabaseChanges]:
    """Update a database.

    Windows and landmarks without a changed pixel stay as they are. The others are computed from the new map only: the
    old map is not needed.

    Args:
        source: The corrected label map; the same pieces are read several times.
        database: With the landmarks' bounds and the windows' distinctiveness.
        areas: Rectangles that contain every changed pixel; parts beyond the map are ignored. None to find changes by
            comparing block hashes, which reads the whole map. Blocks outside the areas count as unchanged and keep
            their hashes; the next update without ``areas`` finds changes in them.
        plugin_version: Version that the updated database states.
        run: Runs the tasks that describe windows.

    Raises:
        DatabaseError: The database can't be updated.
        LabelMapError: The map has another pixel grid or a value without a class, or no landmark is left.
    """
    require_same_grid(source.shape_hw, frame, database)
    old, parameters = database.windows, database.parameters
    levels = [_Level(database, int(level)) for level in np.unique(old.levels)]
    hashes = yield from _hash(source, parameters.block_hashes, areas)
    places = changed_places(parameters.block_hashes, hashes, source.shape_hw)
    _check_values(source, places, database.class_table)
    removed, added = yield from part("Finding landmarks", changed_landmarks(source, database, places), 0.5, 0.6)
    if len(database.references) - len(removed) + len(added) == 0:
        raise LabelMapError("The corrected map has no landmark left; choose another label map.")
    windows = _copied(old)
    yield from _describe(run, levels, places, database, windows)
    yield from _compare(old, windows)
    return DatabaseChanges(
        windows,
        np.flatnonzero(_differ(old, windows)),
        removed,
        added,
        tuple(_overview_piece(source, place, parameters.overview_factor) for place in places),
        replace(
            parameters,
            map_hash=map_hash(source.shape_hw, parameters.frame.geotransform, hashes),
            block_hashes=tuple(hashes),
            plugin_version=plugin_version,
        ),
    )


# --- where the map changed ---


def _hash(source: LabelSource, before: Sequence[str], areas: Sequence[Bounds] | None) -> Steps[list[str]]:
    """Return the block hashes of the new map; those ``before`` outside the areas."""
    height, width = source.shape_hw
    if areas is None:
        hasher = BlockHasher(width)
        # A second thread hashes a band while this one reads the next.
        with ThreadPoolExecutor(1) as pool:
            hashing: Future[None] | None = None
            for row in range(0, height, HASHED_BLOCK):
                labels = source.read(0, row, width, min(HASHED_BLOCK, height - row))
                if hashing is not None:
                    hashing.result()
                hashing = pool.submit(hasher.add, labels)
                yield "Looking for changes", 0.5 * row / height
            if hashing is not None:
                hashing.result()
        return list(hasher.hashes)
    hashes = list(before)
    blocks = sorted(set().union(*(blocks_of(area, (height, width)) for area in areas)))
    for n, block in enumerate(blocks, start=1):
        left, top, right, bottom = block_bounds(block, (height, width))
        labels = source.read(left, top, right - left, bottom - top)
        hashes[block[0] * blocks_shape((height, width))[1] + block[1]] = block_hash(labels)
        yield "Looking for changes", 0.5 * n / len(blocks)
    return hashes


def _check_values(source: LabelSource, places: Sequence[Bounds], table: ClassTable) -> None:
    known = {0, *(c.value for c in table)}
    for left, top, right, bottom in places:
        counts = count_labels(source.read(left, top, right - left, bottom - top))
        for value in set(np.flatnonzero(counts).tolist()) - known:
            raise LabelMapError(
                "The label map has the value {value}, which is not a class of the database; correct the map, or "
                "build a new database.",
                value=value,
            )


# --- windows ---


def _describe(
    run: Runner, levels: Sequence[_Level], places: Sequence[Bounds], database: ReferenceDatabase, windows: Windows
) -> Steps[None]:
    """Update counts and vectors in ``windows`` of the windows that overlap a changed place."""
    parameters = database.parameters
    minimum_area = minimum_area_px(parameters.minimum_area, parameters.frame.pixel_size)
    shared = database.class_table.reference_values, minimum_area, parameters.references_per_vector
    tasks = [(level, place) for level in levels for place in places]
    for n, (level, place) in enumerate(tasks, start=1):
        part = level.windows_around(place)
        if part is None:
            continue
        left, top, right, bottom = part
        window = level.grid.size, level.grid.stride
        boxes = window_boxes(WindowGrid(right - left, bottom - top, *window))
        calls = (((left + column, top + row, *size), window) for column, row, *size in boxes)
        for columns, rows, counts, vectors in run("describe", calls, shared):
            index = level.index(columns, rows)
            windows.counts[index] = counts
            windows.vectors[index] = vectors
            windows.described[index] = counts >= MINIMUM_REFERENCES
            yield "Describing windows", 0.6 + 0.2 * n / len(tasks)


def _compare(old: Windows, windows: Windows) -> Steps[None]:
    """Update the distinctiveness: with distances to changed windows; from all where the nearest one changed."""
    distinct = _distinctiveness(windows)
    changed = (old.described != windows.described) | (old.vectors != windows.vectors).any(axis=1)
    if not changed.any():
        return
    distinct[~windows.described] = np.nan
    same = np.flatnonzero(windows.described & ~changed)
    before = _nearest(old, same, np.flatnonzero(changed & old.described))
    yield "Comparing windows", 0.86
    now = _nearest(windows, same, np.flatnonzero(changed & windows.described))
    yield "Comparing windows", 0.92
    known = np.where(np.isnan(distinct[same]), np.inf, distinct[same])
    lost = np.isfinite(before) & (before <= known)
    distinct[same] = np.minimum(known, now)
    again = np.concatenate([np.flatnonzero(windows.described & changed), same[lost]])
    distinct[again] = _nearest(windows, again, np.flatnonzero(windows.described))
    distinct[np.isinf(distinct)] = np.nan
    yield "Comparing windows", 1.0


# --- overview ---


def _overview_piece(source: LabelSource, place: Bounds, factor: int) -> tuple[int, int, np.ndarray]:
    height, width = source.shape_hw
    left, top = place[0] // factor, place[1] // factor
    right, bottom = min(-(-place[2] // factor) * factor, width), min(-(-place[3] // factor) * factor, height)
    labels = source.read(left * factor, top * factor, right - left * factor, bottom - top * factor)
    return left, top, most_frequent_labels(labels, factor)


def require_same_grid(shape_hw: tuple[int, int], frame: MapFrame, database: ReferenceDatabase) -> None:
    """Refuse a label map that does not fit the database.

    Args:
        shape_hw: (height, width) of the label map.

    Raises:
        DatabaseError: The database lacks data that an update needs.
        LabelMapError: The map has another grid.
    """
    parameters = database.parameters
    rows, columns = blocks_shape((parameters.map_height_px, parameters.map_width_px))
    if len(parameters.block_hashes) != rows * columns or database.references.bounds_px is None:
        raise DatabaseError(
            "SemRef {plugin_version} built the database without block hashes and bounds of landmarks, so changes can't "
            "be found. Build it again once with “Build reference database”.",
            plugin_version=parameters.plugin_version,
        )
    pixel = parameters.pixel_size
    if abs(frame.pixel_size - pixel) > 1e-9 * pixel:
        raise LabelMapError(
            "The label map has pixels of {pixel_size:g} m, but the database was built with {pixel:g} m; rasterize with "
            "the database's pixel size, or build a new database.",
            pixel_size=frame.pixel_size,
            pixel=pixel,
        )
    size = parameters.map_width_px, parameters.map_height_px
    corner, stored = np.array(frame.origin), np.array(parameters.frame.origin)
    if (shape_hw[1], shape_hw[0]) != size or (np.abs(corner - stored) > 1e-6 * pixel).any():
        raise LabelMapError(
            "The label map has {width} × {height} pixels from {x:.10g}, {y:.10g}, but the database's map had "
            "{known_width} × {known_height} from {known_x:.10g}, {known_y:.10g}. Rasterize with the extent of the old "
            "label map, or build a new database.",
            width=shape_hw[1],
            height=shape_hw[0],
            x=corner[0],
            y=corner[1],
            known_width=size[0],
            known_height=size[1],
            known_x=stored[0],
            known_y=stored[1],
        )


class _Level:
    """The windows of one level by their position on the map, in any order in the database."""

    def __init__(self, database: ReferenceDatabase, level: int) -> None:
        """Derive the level's grid from the positions of its windows.

        Raises:
            DatabaseError: Windows are missing.
        """
        windows, parameters = database.windows, database.parameters
        index = np.flatnonzero(windows.levels == level)
        places = windows.first_pixels[index]
        size = int(round(windows.sizes[index[0]] / parameters.pixel_size))
        steps = places[places > 0]
        stride = int(steps.min()) if len(steps) else size
        self.grid = WindowGrid(parameters.map_width_px, parameters.map_height_px, size, stride)
        self._index = np.full((len(self.grid.rows), len(self.grid.columns)), -1)
        on_grid = (places % stride == 0).all(axis=1) & (places[:, ::-1] // stride < self._index.shape).all(axis=1)
        self._index[places[on_grid, 1] // stride, places[on_grid, 0] // stride] = index[on_grid]
        if len(index) != self._index.size or (self._index < 0).any():
            raise DatabaseError(
                "The database has {count} windows of level {level}, but its grid has {known}; build it again.",
                count=len(index),
                level=level,
                known=self._index.size,
            )

    def index(self, columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
        """Return (M,) indices in the database of the windows with these first pixels."""
        return self._index[rows // self.grid.stride, columns // self.grid.stride]

    def windows_around(self, place: Bounds) -> Bounds | None:
        """Return the area that the windows with a pixel of ``place`` cover together; None without any."""
        left, top, right, bottom = place
        size = self.grid.size
        columns = self.grid.columns[(self.grid.columns < right) & (self.grid.columns + size > left)]
        rows = self.grid.rows[(self.grid.rows < bottom) & (self.grid.rows + size > top)]
        if not len(columns) or not len(rows):
            return None
        return int(columns[0]), int(rows[0]), int(columns[-1]) + size, int(rows[-1]) + size


def _copied(windows: Windows) -> Windows:
    """Return a copy with new arrays for the values that an update changes."""
    names = "counts", "vectors", "described", "distinctiveness"
    return replace(windows, **{name: getattr(windows, name).copy() for name in names})


def _distinctiveness(windows: Windows) -> np.ndarray:
    """Return (N,) distinctiveness; raise ValueError if it was not read."""
    if windows.distinctiveness is None:
        raise ValueError("the windows' distinctiveness was not read")
    return windows.distinctiveness


def _differ(old: Windows, new: Windows) -> np.ndarray:
    """Return (N,) bool: which windows changed."""
    before, now = _distinctiveness(old), _distinctiveness(new)
    return (
        (old.counts != new.counts)
        | (old.described != new.described)
        | (old.vectors != new.vectors).any(axis=1)
        | ((before != now) & ~(np.isnan(before) & np.isnan(now)))
    )


def _nearest(windows: Windows, index: np.ndarray, others: np.ndarray) -> np.ndarray:
    """Return (n,) distances of the windows ``index`` to the nearest of ``others`` without overlap, else infinity."""
    found = np.full(len(index), np.inf)
    parts = [(windows.vectors[k], windows.centers[k], windows.sizes[k]) for k in (index, others)]
    for block, distances in nearest_distances(*parts):
        found[block] = distances
    return found
