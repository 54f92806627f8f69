"""Updating a database after its label map was corrected: the rebuild's answer, from no more of the map than changed."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import Iterator, List, Optional, Sequence, Set, Tuple

import numpy as np

from ..errors import DatabaseError, LabelMapError
from ..geometry.frame import MapFrame
from ..labels.block_hashes import HASHED_BLOCK, BlockHasher, block_hash, blocks_shape, map_hash
from ..labels.counts import count_labels
from ..labels.overview import most_frequent_labels
from ..labels.sources import KeptTiles, LabelSource, PartOfMap
from ..landmarks.catalogue import CatalogueBuilder, measure_region
from ..landmarks.landmarks import Landmarks, minimum_area_px, objects_from_rows, rows_array
from ..landmarks.regions import Region, RegionFinder
from ..windows.describe import describe_windows
from ..windows.distinctiveness import nearest_distances
from ..windows.grid import WindowGrid
from ..windows.topology_vector import MINIMUM_REFERENCES
from .build import map_references
from .model import BuildParameters, MapLandmarks, ReferenceDatabase, Windows

Bounds = Tuple[int, int, int, int]
"""(left, top, right, bottom) in pixels of the label map, right and bottom beyond the last."""


@dataclass(frozen=True)
class DatabaseChanges:
    """What an update changes in a database of N windows.

    windows, distinctiveness: all N as they are now, NaN where there is no distinctiveness; touched: indices of the
    windows that differ from before; removed: indices of the references that are gone; added: the new ones;
    overview: (first column, first row, (h, w) uint8) pieces of the new overview; parameters: as they are now.
    """

    windows: Windows
    distinctiveness: np.ndarray
    touched: np.ndarray
    removed: np.ndarray
    added: MapLandmarks
    overview: Tuple[Tuple[int, int, np.ndarray], ...]
    parameters: BuildParameters


class DatabaseUpdater:
    """Updates a database step by step: iterate ``steps()`` to the end, then take ``changes``.

    A window that shows no changed pixel stays as it is, and so does a landmark without one. Every other
    one is found in the new map alone: the old map is not needed.
    """

    def __init__(
        self,
        source: LabelSource,
        frame: MapFrame,
        database: ReferenceDatabase,
        distinctiveness: np.ndarray,
        areas: Optional[Sequence[Bounds]],
        plugin_version: str,
        threads: int = 1,
    ) -> None:
        """``database``: with the references' bounds; ``distinctiveness``: (N,) of its windows, NaN for none.

        ``areas``: rectangles that hold every changed pixel, parts beyond the map are ignored; None when they are to be
        found by comparing block hashes, which reads the whole map. Blocks that no area touches are taken to be as they
        were and keep their hashes: what changed there is found by the next update without ``areas``. Raises
        DatabaseError for a database that can't be updated, LabelMapError when the map is not of the same pixel grid.
        """
        require_same_grid(source.shape_hw, frame, database)
        self._whole = source
        self._source = KeptTiles(source)
        self._frame = database.parameters.frame
        self._database = database
        self._distinctiveness = distinctiveness
        self._areas = areas
        self._plugin_version = plugin_version
        self._threads = threads
        self._levels = [_Level(database, int(level)) for level in np.unique(database.windows.levels)]
        self.changes: Optional[DatabaseChanges] = None

    @property
    def _minimum_area_px(self) -> float:
        return minimum_area_px(self._database.parameters.minimum_area, self._frame.pixel_size)

    def steps(self) -> Iterator[Tuple[str, float]]:
        """Yields (what is being done, share done 0…1). Raises LabelMapError when no landmark is left."""
        hashes: List[str] = []
        for share in self._hash(hashes):
            yield "Looking for changes", 0.5 * share
        places = self._changed_places(hashes)
        self._check_values(places)
        removed: List[int] = []
        rows: List[tuple] = []
        values = self._database.class_table.reference_values
        for n, value in enumerate(values):
            for share in self._compare_references(value, places, removed, rows):
                yield "Finding landmarks", 0.5 + 0.1 * (n + share) / len(values)
        if len(self._database.references) - len(removed) + len(rows) == 0:
            raise LabelMapError("The corrected map shows no landmark any more; choose another label map.")
        windows = _copied(self._database.windows)
        for share in self._describe(windows, places):
            yield "Describing windows", 0.6 + 0.2 * share
        distinct = self._distinctiveness.copy()
        for share in self._compare_windows(windows, distinct):
            yield "Comparing windows", 0.8 + 0.2 * share
        self.changes = DatabaseChanges(
            windows,
            distinct,
            np.flatnonzero(self._touched(windows, distinct)),
            np.array(sorted(removed), np.int64),
            map_references(objects_from_rows(rows_array(rows), self._source.shape_hw), self._frame),
            tuple(self._overview_piece(place) for place in places),
            replace(
                self._database.parameters,
                map_hash=map_hash(self._source.shape_hw, self._frame.geotransform, hashes),
                block_hashes=tuple(hashes),
                plugin_version=self._plugin_version,
            ),
        )

    # --- where the map changed ---

    def _hash(self, hashes: List[str]) -> Iterator[float]:
        """Fills ``hashes`` with those of the new map; yields the share done."""
        height, width = self._source.shape_hw
        if self._areas is None:
            hasher = BlockHasher(width)
            # One thread hashes a band while this one reads the next.
            with ThreadPoolExecutor(1) as pool:
                hashing = None
                for row in range(0, height, HASHED_BLOCK):
                    labels = self._whole.read(0, row, width, min(HASHED_BLOCK, height - row))
                    if hashing is not None:
                        hashing.result()
                    hashing = pool.submit(hasher.add, labels)
                    yield row / height
                hashing.result()
            hashes += hasher.hashes
            return
        hashes += self._database.parameters.block_hashes
        blocks = sorted(set().union(*(_blocks_of(area, (height, width)) for area in self._areas)))
        for n, block in enumerate(blocks, start=1):
            left, top, right, bottom = _block_bounds(block, (height, width))
            labels = self._source.read(left, top, right - left, bottom - top)
            hashes[block[0] * blocks_shape((height, width))[1] + block[1]] = block_hash(labels)
            yield n / len(blocks)

    def _changed_places(self, hashes: Sequence[str]) -> List[Bounds]:
        """Rectangles apart from each other that hold the changed blocks and, around them, a line of unchanged pixels.

        Whole blocks, also where only a corner of one was said to have changed: its new hash stands for all of it.
        """
        height, width = shape_hw = self._source.shape_hw
        columns = blocks_shape(shape_hw)[1]
        found = []
        for i, (before, now) in enumerate(zip(self._database.parameters.block_hashes, hashes)):
            if before != now:
                left, top, right, bottom = _block_bounds(divmod(i, columns), shape_hw)
                found.append(_common((left - 1, top - 1, right + 1, bottom + 1), (0, 0, width, height)))
        return _joined(found)

    def _check_values(self, places: Sequence[Bounds]) -> None:
        known = {0, *(c.value for c in self._database.class_table)}
        for left, top, right, bottom in places:
            counts = count_labels(self._source.read(left, top, right - left, bottom - top))
            for value in set(np.flatnonzero(counts).tolist()) - known:
                raise LabelMapError(
                    f"The label map has the value {value}, which the database's classes lack; correct it or build a "
                    "new database."
                )

    # --- landmarks ---

    def _compare_references(
        self, value: int, places: Sequence[Bounds], removed: List[int], rows: List[tuple]
    ) -> Iterator[float]:
        """Adds the references of a class that are gone (indices) and new objects (region rows); yields the share."""
        finder = RegionFinder(self._source, value)
        regions: Set[Region] = set()
        for n, place in enumerate(places, start=1):
            regions |= finder.touching(place)
            yield 0.3 * n / len(places)
        new = {}
        for n, region in enumerate(regions, start=1):
            row = measure_region(self._source, value, region.bounds, region.first_pixel, self._minimum_area_px)
            if row is not None:
                new[self._as_stored(row)] = row
            yield 0.3 + 0.6 * n / len(regions)
        references = self._database.references
        reached = (references.classes == value) & _meets_any(references.bounds_px, places)
        crossing = [region for region in regions if not any(_holds(place, region.bounds) for place in places)]
        for k in np.flatnonzero(reached).tolist():
            bounds = tuple(references.bounds_px[k].tolist())
            same = (bounds, *references.positions[k].tolist(), float(references.areas_m2[k]))
            # What is as it was, although it lies in a changed place, stays.
            if new.pop(same, None) is None and not self._stands(bounds, places, crossing, finder, regions):
                removed.append(k)
            yield 0.9
        rows += new.values()

    def _as_stored(self, row: tuple) -> tuple:
        """Bounds, position and area of a region row as the database has them."""
        found = map_references(objects_from_rows(rows_array([row]), self._source.shape_hw), self._frame)
        return tuple(found.bounds_px[0].tolist()), *found.positions[0].tolist(), float(found.areas_m2[0])

    def _stands(
        self,
        bounds: Bounds,
        places: Sequence[Bounds],
        crossing: Sequence[Region],
        finder: RegionFinder,
        regions: Set[Region],
    ) -> bool:
        """Whether an old object whose bounds meet a changed place has no pixel in one.

        Its pixels outside the places, and on their outermost lines, are what they were. So an object with pixels
        both inside and outside shares some with one of the new regions that cross a place's border.
        """
        if any(_holds(place, bounds) for place in places):
            return False
        if not any(_meet(bounds, region.bounds) for region in crossing):
            return True
        left, top, right, _ = bounds
        # Two regions of one class can't have the same bounds: they would cross, and so be one.
        return any(
            region.bounds == bounds and region not in regions for region in finder.starting_in_row(top, left, right)
        )

    # --- windows ---

    def _describe(self, windows: Windows, places: Sequence[Bounds]) -> Iterator[float]:
        """Puts counts and vectors of the windows that show a changed place into ``windows``."""
        parameters, values = self._database.parameters, self._database.class_table.reference_values
        tasks = [(level, place) for level in self._levels for place in places]
        for n, (level, place) in enumerate(tasks, start=1):
            part = level.windows_around(place)
            if part is None:
                continue
            left, top, right, bottom = part
            labels = PartOfMap(self._source, left, top, right - left, bottom - top)
            grid = WindowGrid(right - left, bottom - top, level.grid.size, level.grid.stride)
            objects = _objects(labels, values, self._minimum_area_px)
            for found in describe_windows(
                labels, grid, objects, values, self._minimum_area_px, parameters.references_per_vector, self._threads
            ):
                index = level.index(found.columns + left, found.rows + top)
                windows.counts[index] = found.counts
                windows.vectors[index] = found.vectors
                windows.described[index] = found.counts >= MINIMUM_REFERENCES
                yield n / len(tasks)

    def _compare_windows(self, windows: Windows, distinct: np.ndarray) -> Iterator[float]:
        """Brings ``distinct`` up to date: distances to changed windows, and all distances where the nearest changed."""
        old = self._database.windows
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

    def _touched(self, windows: Windows, distinct: np.ndarray) -> np.ndarray:
        """(N,) bool: which windows differ from what they were."""
        old, before = self._database.windows, self._distinctiveness
        return (
            (old.counts != windows.counts)
            | (old.described != windows.described)
            | (old.vectors != windows.vectors).any(axis=1)
            | ((before != distinct) & ~(np.isnan(before) & np.isnan(distinct)))
        )

    # --- overview ---

    def _overview_piece(self, place: Bounds) -> Tuple[int, int, np.ndarray]:
        factor = self._database.parameters.overview_factor
        height, width = self._source.shape_hw
        left, top = place[0] // factor, place[1] // factor
        right, bottom = min(-(-place[2] // factor) * factor, width), min(-(-place[3] // factor) * factor, height)
        labels = self._source.read(left * factor, top * factor, right - left * factor, bottom - top * factor)
        return left, top, most_frequent_labels(labels, factor)


def require_same_grid(shape_hw: Tuple[int, int], frame: MapFrame, database: ReferenceDatabase) -> None:
    """Raises DatabaseError for a database without what an update needs, LabelMapError for a map on another grid."""
    parameters = database.parameters
    rows, columns = blocks_shape((parameters.map_height_px, parameters.map_width_px))
    if len(parameters.block_hashes) != rows * columns or database.references.bounds_px is None:
        raise DatabaseError(
            f"The database was made by SemRef {parameters.plugin_version}, which kept no block hashes and bounds of "
            "landmarks, so what changed can't be told; build it anew once with “Build reference database”."
        )
    pixel = parameters.pixel_size
    if abs(frame.pixel_size - pixel) > 1e-9 * pixel:
        raise LabelMapError(
            f"The label map has pixels of {frame.pixel_size:g} m, the database was built with {pixel:g} m; rasterize "
            "with the database's pixel size or build a new database."
        )
    size = parameters.map_width_px, parameters.map_height_px
    corner, stored = np.array(frame.origin), np.array(parameters.frame.origin)
    if (shape_hw[1], shape_hw[0]) != size or (np.abs(corner - stored) > 1e-6 * pixel).any():
        raise LabelMapError(
            f"The label map has {shape_hw[1]} × {shape_hw[0]} pixels from {corner[0]:.10g}, {corner[1]:.10g}, the "
            f"database's had {size[0]} × {size[1]} from {stored[0]:.10g}, {stored[1]:.10g}; rasterize with the extent "
            "of the old label map or build a new database."
        )


class _Level:
    """The windows of one level as they lie on the map, whatever their order in the database."""

    def __init__(self, database: ReferenceDatabase, level: int) -> None:
        """Raises DatabaseError when windows are missing."""
        windows, parameters = database.windows, database.parameters
        index = np.flatnonzero(windows.levels == level)
        places = np.array([name.split("_") for name in windows.names[index].tolist()], np.int64)
        size = int(round(windows.sizes[index[0]] / parameters.pixel_size))
        steps = places[places > 0]
        stride = int(steps.min()) if len(steps) else size
        self.grid = WindowGrid(parameters.map_width_px, parameters.map_height_px, size, stride)
        self._index = np.full((len(self.grid.rows), len(self.grid.columns)), -1)
        on_grid = (places % stride == 0).all(axis=1) & (places[:, ::-1] // stride < self._index.shape).all(axis=1)
        self._index[places[on_grid, 1] // stride, places[on_grid, 0] // stride] = index[on_grid]
        if len(index) != self._index.size or (self._index < 0).any():
            raise DatabaseError(
                f"The database has {len(index)} windows of level {level} where its grid has {self._index.size}; "
                "build it again."
            )

    def index(self, columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
        """(M,) indices in the database of the windows with these first pixels."""
        return self._index[rows // self.grid.stride, columns // self.grid.stride]

    def windows_around(self, place: Bounds) -> Optional[Bounds]:
        """What the windows that show a pixel of ``place`` cover together; None when there is none."""
        left, top, right, bottom = place
        size = self.grid.size
        columns = self.grid.columns[(self.grid.columns < right) & (self.grid.columns + size > left)]
        rows = self.grid.rows[(self.grid.rows < bottom) & (self.grid.rows + size > top)]
        if not len(columns) or not len(rows):
            return None
        return int(columns[0]), int(rows[0]), int(columns[-1]) + size, int(rows[-1]) + size


def _copied(windows: Windows) -> Windows:
    return replace(
        windows, counts=windows.counts.copy(), vectors=windows.vectors.copy(), described=windows.described.copy()
    )


def _nearest(windows: Windows, index: np.ndarray, others: np.ndarray) -> np.ndarray:
    """(n,) distances of the windows ``index`` to the nearest of ``others`` that don't overlap them, else infinity."""
    found = np.full(len(index), np.inf)
    parts = [(windows.vectors[k], windows.centers[k], windows.sizes[k]) for k in (index, others)]
    for block, distances in nearest_distances(*parts):
        found[block] = distances
    return found


def _objects(labels: LabelSource, values: Sequence[int], minimum_area: float) -> Landmarks:
    catalogue = CatalogueBuilder(labels, values, minimum_area)
    for steps in (catalogue.bands(), catalogue.crossing()):
        for _ in steps:
            pass
    return catalogue.objects


# --- rectangles ---


def _holds(outer: Bounds, inner: Bounds) -> bool:
    return outer[0] <= inner[0] and outer[1] <= inner[1] and outer[2] >= inner[2] and outer[3] >= inner[3]


def _meet(a: Bounds, b: Bounds) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def _meets_any(bounds: np.ndarray, places: Sequence[Bounds]) -> np.ndarray:
    """(N,) bool: which of the (N, 4) rectangles share a pixel with one of ``places``."""
    found = np.zeros(len(bounds), bool)
    for left, top, right, bottom in places:
        found |= (bounds[:, 0] < right) & (bounds[:, 2] > left) & (bounds[:, 1] < bottom) & (bounds[:, 3] > top)
    return found


def _common(a: Bounds, b: Bounds) -> Bounds:
    return max(a[0], b[0]), max(a[1], b[1]), min(a[2], b[2]), min(a[3], b[3])


def _joined(places: Sequence[Bounds]) -> List[Bounds]:
    """Rectangles of which no two share a pixel; those that do become the one around both."""
    joined: List[Bounds] = []
    waiting = sorted(places)
    while waiting:
        place = waiting.pop()
        meeting = [other for other in joined if _meet(place, other)]
        if meeting:
            joined = [other for other in joined if not _meet(place, other)]
            lefts, tops, rights, bottoms = zip(place, *meeting)
            waiting.append((min(lefts), min(tops), max(rights), max(bottoms)))
        else:
            joined.append(place)
    return sorted(joined)


def _blocks_of(area: Bounds, shape_hw: Tuple[int, int]) -> Set[Tuple[int, int]]:
    """(row, column) of the hashed blocks that share a pixel with ``area``."""
    left, top, right, bottom = _common(area, (0, 0, shape_hw[1], shape_hw[0]))
    if left >= right or top >= bottom:
        return set()
    rows = range(top // HASHED_BLOCK, (bottom - 1) // HASHED_BLOCK + 1)
    columns = range(left // HASHED_BLOCK, (right - 1) // HASHED_BLOCK + 1)
    return {(row, column) for row in rows for column in columns}


def _block_bounds(block: Tuple[int, int], shape_hw: Tuple[int, int]) -> Bounds:
    top, left = block[0] * HASHED_BLOCK, block[1] * HASHED_BLOCK
    return left, top, min(left + HASHED_BLOCK, shape_hw[1]), min(top + HASHED_BLOCK, shape_hw[0])
