"""The tasks of a build, which need nothing of each other, and what has them done: threads here, or Dask's workers.

Each task reads one piece of the label map and gives plain arrays. ``DatabaseBuilder`` states which tasks there are,
takes what they give in any order, and puts it together.
"""

from __future__ import annotations

import threading
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from itertools import islice
from typing import Any, Callable, Protocol

import numpy as np

from ..labels.block_hashes import BlockHasher
from ..labels.overview import most_frequent_labels
from ..labels.sources import LabelSource
from ..landmarks.landmarks import extract_landmarks, objects_from_rows, rows_array, shift_rows
from ..landmarks.tiles import Region, measure_region, tile_landmarks
from ..windows.describe import describe_windows
from ..windows.distinctiveness import nearest_distances
from ..windows.grid import WindowGrid

MOST_THREADS = 8
"""Tasks that are done at a time in one process: each holds some ten megabytes of the map."""

CHECKED_EVERY_S = 0.2

Box = tuple[int, int, int, int]
"""Column, row, width, height of a piece of the map, pixels."""


class Runner(Protocol):
    """Has tasks done, here or elsewhere."""

    def __call__(self, task: str, calls: Iterable[tuple], shared: tuple = ()) -> Iterator[tuple[int, Any]]:
        """Yield the number of a call and what it gave, as they are done.

        Args:
            task: A key of ``TASKS``.
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
    """Return (N, 8) rows of regions that cross tiles.

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
    near: np.ndarray | None = None,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Columns, rows, counts and vectors (``DescribedWindows``) of the windows in one piece.

    Args:
        source: The label map.
        values: Classes of landmarks.
        minimum_area: Of a landmark, pixels.
        references_per_vector: Landmarks that a vector holds at most.
        box: The piece; its first window begins with it.
        window: (size, stride), pixels.
        near: (N, 8) rows of the landmarks that reach into the piece; None to find them in the piece alone.
    """
    column, row, width, height = box
    labels = source.read(*box)
    if near is None:
        objects = extract_landmarks(labels, values, minimum_area)
    else:
        objects = objects_from_rows(shift_rows(near, -column, -row), (height, width))
    grid = WindowGrid(width, height, *window)
    found = describe_windows(labels, grid, objects, values, minimum_area, references_per_vector)
    return found.columns + column, found.rows + row, found.counts, found.vectors


def compare(
    _: LabelSource, vectors: np.ndarray, centers: np.ndarray, sizes: np.ndarray, first: int, last: int
) -> np.ndarray:
    """Return (last − first,) distances of some windows to the nearest vector elsewhere, infinity where there is none."""
    some = vectors[first:last], centers[first:last], sizes[first:last]
    found = [distances for _, distances in nearest_distances(some, (vectors, centers, sizes))]
    return np.concatenate([np.empty(0), *found])


TASKS: dict[str, Callable] = {"scan": scan, "measure": measure, "describe": describe, "compare": compare}


class Threads:
    """Has tasks done by threads of this process: a ``Runner``."""

    def __init__(self, source: LabelSource, count: int = 1, check: Callable[[], None] = lambda: None) -> None:
        """Start nothing.

        Args:
            source: The label map; one thread at a time reads from it.
            count: Tasks that are done at a time, at most MOST_THREADS.
            check: Called every CHECKED_EVERY_S seconds; what it raises ends the work.
        """
        self._source = source
        self._count = min(count, MOST_THREADS)
        self._check = check

    def __call__(self, task: str, calls: Iterable[tuple], shared: tuple = ()) -> Iterator[tuple[int, Any]]:
        """Yield the number of a call and what it gave, as they are done; raises what a task raises."""
        source, waiting = _InTurns(self._source), enumerate(calls)
        running: dict[Future, int] = {}
        pool = ThreadPoolExecutor(self._count)
        try:
            while True:
                for number, arguments in islice(waiting, self._count + 1 - len(running)):
                    running[pool.submit(TASKS[task], source, *shared, *arguments)] = number
                if not running:
                    return
                for future in wait(running, CHECKED_EVERY_S, FIRST_COMPLETED).done:
                    yield running.pop(future), future.result()
                self._check()
        finally:
            # Who canceled does not wait for tasks; they read no more of the map.
            source.has_ended = True
            for future in running:
                future.cancel()
            pool.shutdown(wait=False)


class _InTurns:
    """A label map that one thread at a time reads from, and none any more when the work has ended."""

    def __init__(self, source: LabelSource) -> None:
        self._source = source
        self._lock = threading.Lock()
        self.has_ended = False

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) in pixels."""
        return self._source.shape_hw

    def read(self, column: int, row: int, width: int, height: int) -> np.ndarray:
        """Return (height, width) uint8 labels. Raises RuntimeError once the work has ended, which nobody waits for."""
        with self._lock:
            if self.has_ended:
                raise RuntimeError("the work has ended")
            return self._source.read(column, row, width, height)
