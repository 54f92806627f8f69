"""Updating a database after its label map was corrected: the rebuild's answer, from no more of the map than changed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, replace

import numpy as np

from ..errors import DatabaseError, LabelMapError
from ..geometry.frame import MapFrame
from ..labels.block_hashes import HASHED_BLOCK, BlockHasher, block_hash, blocks_shape, map_hash
from ..labels.overview import most_frequent_labels
from ..labels.sources import LabelSource, count_labels
from ..landmarks.landmarks import minimum_area_px
from ..windows.distinctiveness import nearest_distances
from ..windows.grid import WindowGrid
from ..windows.topology_vector import MINIMUM_REFERENCES
from .build import window_boxes
from .changed_regions import Bounds, ChangedLandmarks, block_bounds, blocks_of, changed_places
from .model import MapLandmarks, ReferenceDatabase, Windows
from .parameters import BuildParameters
from .tasks import Runner


@dataclass(frozen=True)
class DatabaseChanges:
    """What an update changes in a database of N windows.

    Attributes:
        windows: All N as they are now.
        touched: (T,) int64 indices of the windows that differ from before.
        removed: (K,) int64 indices of the landmarks that are gone.
        overview: (first column, first row, (h, w) uint8) pieces of the new overview.
    """

    windows: Windows
    touched: np.ndarray
    removed: np.ndarray
    added: MapLandmarks
    overview: tuple[tuple[int, int, np.ndarray], ...]
    parameters: BuildParameters


class DatabaseUpdater:
    """Updates a database step by step: iterate ``steps()`` to the end, then take ``changes``.

    A window that shows no changed pixel stays as it is, and so does a landmark without one. Every other
    one is found in the new map alone: the old map is not needed.
    """

    def __init__(  # noqa: PLR0913 - two maps and how to go about it; no two of these travel together elsewhere
        self,
        source: LabelSource,
        frame: MapFrame,
        database: ReferenceDatabase,
        areas: Sequence[Bounds] | None,
        plugin_version: str,
        run: Runner,
    ) -> None:
        """Make the updater.

        Args:
            source: The corrected label map; it is asked for the same pieces several times.
            frame: Where its pixels lie.
            database: With the landmarks' bounds and the windows' distinctiveness.
            areas: Rectangles that hold every changed pixel, parts beyond the map are ignored; None when they are to be
                found by comparing block hashes, which reads the whole map. Blocks that no area touches are taken to be
                as they were and keep their hashes: what changed there is found by the next update without ``areas``.
            plugin_version: What the updated database says.
            run: Has windows described.

        Raises:
            DatabaseError: The database can't be updated.
            LabelMapError: The map is not of the same pixel grid.
        """
        require_same_grid(source.shape_hw, frame, database)
        self._source = source
        self._frame = database.parameters.frame
        self._database = database
        self._areas = areas
        self._plugin_version = plugin_version
        self._run = run
        self._levels = [_Level(database, int(level)) for level in np.unique(database.windows.levels)]
        self.changes: DatabaseChanges | None = None

    @property
    def _minimum_area_px(self) -> float:
        return minimum_area_px(self._database.parameters.minimum_area, self._frame.pixel_size)

    def steps(self) -> Iterator[tuple[str, float]]:
        """Yield (what is being done, share done 0…1).

        Raises:
            LabelMapError: No landmark is left, or the map has a value that no class has.
        """
        hashes: list[str] = []
        for share in self._hash(hashes):
            yield "Looking for changes", 0.5 * share
        places = changed_places(self._database.parameters.block_hashes, hashes, self._source.shape_hw)
        self._check_values(places)
        landmarks = ChangedLandmarks(self._source, self._database, places)
        for share in landmarks.steps():
            yield "Finding landmarks", 0.5 + 0.1 * share
        removed, added = landmarks.removed, landmarks.added
        if len(self._database.references) - len(removed) + len(added) == 0:
            raise LabelMapError("The corrected map shows no landmark any more; choose another label map.")
        windows = _copied(self._database.windows)
        for share in self._describe(windows, places):
            yield "Describing windows", 0.6 + 0.2 * share
        for share in self._compare_windows(windows):
            yield "Comparing windows", 0.8 + 0.2 * share
        self.changes = DatabaseChanges(
            windows,
            np.flatnonzero(_differ(self._database.windows, windows)),
            removed,
            added,
            tuple(self._overview_piece(place) for place in places),
            replace(
                self._database.parameters,
                map_hash=map_hash(self._source.shape_hw, self._frame.geotransform, hashes),
                block_hashes=tuple(hashes),
                plugin_version=self._plugin_version,
            ),
        )

    # --- where the map changed ---

    def _hash(self, hashes: list[str]) -> Iterator[float]:
        """Fills ``hashes`` with those of the new map; yields the share done."""
        height, width = self._source.shape_hw
        if self._areas is None:
            hasher = BlockHasher(width)
            # One thread hashes a band while this one reads the next.
            with ThreadPoolExecutor(1) as pool:
                hashing: Future[None] | None = None
                for row in range(0, height, HASHED_BLOCK):
                    labels = self._source.read(0, row, width, min(HASHED_BLOCK, height - row))
                    if hashing is not None:
                        hashing.result()
                    hashing = pool.submit(hasher.add, labels)
                    yield row / height
                if hashing is not None:
                    hashing.result()
            hashes += hasher.hashes
            return
        hashes += self._database.parameters.block_hashes
        blocks = sorted(set().union(*(blocks_of(area, (height, width)) for area in self._areas)))
        for n, block in enumerate(blocks, start=1):
            left, top, right, bottom = block_bounds(block, (height, width))
            labels = self._source.read(left, top, right - left, bottom - top)
            hashes[block[0] * blocks_shape((height, width))[1] + block[1]] = block_hash(labels)
            yield n / len(blocks)

    def _check_values(self, places: Sequence[Bounds]) -> None:
        known = {0, *(c.value for c in self._database.class_table)}
        for left, top, right, bottom in places:
            counts = count_labels(self._source.read(left, top, right - left, bottom - top))
            for value in set(np.flatnonzero(counts).tolist()) - known:
                raise LabelMapError(
                    "The label map has the value {value}, which the database's classes lack; correct it or build a "
                    "new database.",
                    value=value,
                )

    # --- windows ---

    def _describe(self, windows: Windows, places: Sequence[Bounds]) -> Iterator[float]:
        """Puts counts and vectors of the windows that show a changed place into ``windows``."""
        values = self._database.class_table.reference_values
        shared = values, self._minimum_area_px, self._database.parameters.references_per_vector
        tasks = [(level, place) for level in self._levels for place in places]
        for n, (level, place) in enumerate(tasks, start=1):
            part = level.windows_around(place)
            if part is None:
                continue
            left, top, right, bottom = part
            window = level.grid.size, level.grid.stride
            boxes = window_boxes(WindowGrid(right - left, bottom - top, *window))
            calls = (((left + column, top + row, *size), window) for column, row, *size in boxes)
            for _, (columns, rows, counts, vectors) in self._run("describe", calls, shared):
                index = level.index(columns, rows)
                windows.counts[index] = counts
                windows.vectors[index] = vectors
                windows.described[index] = counts >= MINIMUM_REFERENCES
                yield n / len(tasks)

    def _compare_windows(self, windows: Windows) -> Iterator[float]:
        """Brings distinctiveness up to date: distances to changed windows, and all where the nearest changed."""
        old, distinct = self._database.windows, _distinctiveness(windows)
        changed = (old.described != windows.described) | (old.vectors != windows.vectors).any(axis=1)
        if not changed.any():
            return
        distinct[~windows.described] = np.nan
        same = np.flatnonzero(windows.described & ~changed)
        before = _nearest(old, same, np.flatnonzero(changed & old.described))
        yield 0.3
        now = _nearest(windows, same, np.flatnonzero(changed & windows.described))
        yield 0.6
        known = np.where(np.isnan(distinct[same]), np.inf, distinct[same])
        lost = np.isfinite(before) & (before <= known)
        distinct[same] = np.minimum(known, now)
        anew = np.concatenate([np.flatnonzero(windows.described & changed), same[lost]])
        distinct[anew] = _nearest(windows, anew, np.flatnonzero(windows.described))
        distinct[np.isinf(distinct)] = np.nan
        yield 1.0

    # --- overview ---

    def _overview_piece(self, place: Bounds) -> tuple[int, int, np.ndarray]:
        factor = self._database.parameters.overview_factor
        height, width = self._source.shape_hw
        left, top = place[0] // factor, place[1] // factor
        right, bottom = min(-(-place[2] // factor) * factor, width), min(-(-place[3] // factor) * factor, height)
        labels = self._source.read(left * factor, top * factor, right - left * factor, bottom - top * factor)
        return left, top, most_frequent_labels(labels, factor)


def require_same_grid(shape_hw: tuple[int, int], frame: MapFrame, database: ReferenceDatabase) -> None:
    """Refuse a label map that a database can't be updated to.

    Args:
        shape_hw: (height, width) of the label map.
        frame: Where its pixels lie.

    Raises:
        DatabaseError: The database lacks what an update needs.
        LabelMapError: The map is on another grid.
    """
    parameters = database.parameters
    rows, columns = blocks_shape((parameters.map_height_px, parameters.map_width_px))
    if len(parameters.block_hashes) != rows * columns or database.references.bounds_px is None:
        raise DatabaseError(
            "The database was made by SemRef {plugin_version}, which kept no block hashes and bounds of landmarks, so "
            "what changed can't be told; build it anew once with “Build reference database”.",
            plugin_version=parameters.plugin_version,
        )
    pixel = parameters.pixel_size
    if abs(frame.pixel_size - pixel) > 1e-9 * pixel:
        raise LabelMapError(
            "The label map has pixels of {pixel_size:g} m, the database was built with {pixel:g} m; rasterize with "
            "the database's pixel size or build a new database.",
            pixel_size=frame.pixel_size,
            pixel=pixel,
        )
    size = parameters.map_width_px, parameters.map_height_px
    corner, stored = np.array(frame.origin), np.array(parameters.frame.origin)
    if (shape_hw[1], shape_hw[0]) != size or (np.abs(corner - stored) > 1e-6 * pixel).any():
        raise LabelMapError(
            "The label map has {width} × {height} pixels from {x:.10g}, {y:.10g}, the database's had {known_width} × "
            "{known_height} from {known_x:.10g}, {known_y:.10g}; rasterize with the extent of the old label map or "
            "build a new database.",
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
    """The windows of one level as they lie on the map, whatever their order in the database."""

    def __init__(self, database: ReferenceDatabase, level: int) -> None:
        """Make the level's grid from where its windows lie.

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
                "The database has {count} windows of level {level} where its grid has {known}; build it again.",
                count=len(index),
                level=level,
                known=self._index.size,
            )

    def index(self, columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
        """Return (M,) indices in the database of the windows with these first pixels."""
        return self._index[rows // self.grid.stride, columns // self.grid.stride]

    def windows_around(self, place: Bounds) -> Bounds | None:
        """Return what the windows that show a pixel of ``place`` cover together; None when there is none."""
        left, top, right, bottom = place
        size = self.grid.size
        columns = self.grid.columns[(self.grid.columns < right) & (self.grid.columns + size > left)]
        rows = self.grid.rows[(self.grid.rows < bottom) & (self.grid.rows + size > top)]
        if not len(columns) or not len(rows):
            return None
        return int(columns[0]), int(rows[0]), int(columns[-1]) + size, int(rows[-1]) + size


def _copied(windows: Windows) -> Windows:
    """With arrays of its own for what an update changes."""
    names = "counts", "vectors", "described", "distinctiveness"
    return replace(windows, **{name: getattr(windows, name).copy() for name in names})


def _distinctiveness(windows: Windows) -> np.ndarray:
    """Return (N,) distinctiveness of windows that were compared and read whole."""
    if windows.distinctiveness is None:
        raise ValueError("the windows' distinctiveness was not read")
    return windows.distinctiveness


def _differ(old: Windows, new: Windows) -> np.ndarray:
    """Return (N,) bool: which windows are not what they were."""
    before, now = _distinctiveness(old), _distinctiveness(new)
    return (
        (old.counts != new.counts)
        | (old.described != new.described)
        | (old.vectors != new.vectors).any(axis=1)
        | ((before != now) & ~(np.isnan(before) & np.isnan(now)))
    )


def _nearest(windows: Windows, index: np.ndarray, others: np.ndarray) -> np.ndarray:
    """Return (n,) distances of the windows ``index`` to the nearest of ``others`` that don't overlap them, else infinity."""
    found = np.full(len(index), np.inf)
    parts = [(windows.vectors[k], windows.centers[k], windows.sizes[k]) for k in (index, others)]
    for block, distances in nearest_distances(*parts):
        found[block] = distances
    return found
