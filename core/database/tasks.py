"""Independent tasks of a build, and their runner: threads of this process, or Dask's workers.

Each task reads one piece of the label map and returns plain arrays. ``build_by_tasks`` defines the tasks and combines
their results.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, wait
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
"""Tasks at a time in one process: each uses some ten megabytes of memory."""

TASKS_A_THREAD = 2
"""Tasks of a thread that run or wait, so that a long task does not stop the others."""

CHECKED_EVERY_S = 0.2

Box = tuple[int, int, int, int]
"""Column, row, width, height of a piece of the map, pixels."""


class Runner(Protocol):
    """Runs tasks, here or elsewhere."""

    def __call__(self, task: str, calls: Iterable[tuple], shared: tuple = ()) -> Iterator[Any]:
        """Yield the result of each call in the order of the calls; callers take all of them.

        Args:
            task: A key of ``TASKS``.
            calls: Arguments of each call, consumed when another call can start.
            shared: First arguments of every call.
        """


def scan(
    source: LabelSource, values: Sequence[int], minimum_area: float, factor: int, box: Box
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, list[str]]:
    """Return the data of one tile: landmark rows, pieces and runs (``TileLandmarks``), overview, block hashes."""
    column, row, width, height = box
    labels = source.read(column, row, width, height)
    found = tile_landmarks(labels, (column, row), source.shape_hw, values, minimum_area)
    hasher = BlockHasher(width)
    hasher.add(labels)
    return found.rows, found.pieces, found.runs, most_frequent_labels(labels, factor), list(hasher.hashes)


def measure(source: LabelSource, minimum_area: float, regions: np.ndarray) -> np.ndarray:
    """Return (N, 8) rows of regions across tiles.

    Args:
        minimum_area: Of a landmark, pixels.
        regions: (R, 7) int64 class, left, top, right, bottom, column and row of the first pixel.
    """
    found = (
        measure_region(source, value, Region((left, top, right, bottom), (column, row)), minimum_area)
        for value, left, top, right, bottom, column, row in regions.tolist()
    )
    return rows_array([row for row in found if row is not None])


def describe(  # noqa: PLR0913 - settings of vectors and windows
    source: LabelSource,
    values: Sequence[int],
    minimum_area: float,
    references_per_vector: int,
    box: Box,
    window: tuple[int, int],
    near: np.ndarray | None = None,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return columns, rows, counts and vectors (``DescribedWindows``) of the windows in one piece.

    Args:
        minimum_area: Of a landmark, pixels.
        box: The piece; its first window starts with it.
        window: (size, stride), pixels.
        near: (N, 8) rows of the landmarks that overlap the piece; None to search them in the piece only.
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
    """Return (last − first,) distances of some windows to the nearest vector elsewhere, infinity without one."""
    some = vectors[first:last], centers[first:last], sizes[first:last]
    found = [distances for _, distances in nearest_distances(some, (vectors, centers, sizes))]
    return np.concatenate([np.empty(0), *found])


TASKS: dict[str, Callable] = {"scan": scan, "measure": measure, "describe": describe, "compare": compare}


class Threads:
    """Runs tasks in threads of this process: a ``Runner``."""

    def __init__(self, source: LabelSource, count: int = 1, check: Callable[[], None] = lambda: None) -> None:
        """Start nothing yet.

        Args:
            source: The label map; one thread at a time reads from it.
            count: Number of tasks at a time, at most MOST_THREADS.
            check: Called every CHECKED_EVERY_S seconds; an exception from it ends the work.
        """
        self._source = source
        self._count = min(count, MOST_THREADS)
        self._check = check

    def __call__(self, task: str, calls: Iterable[tuple], shared: tuple = ()) -> Iterator[Any]:
        """Yield the result of each call in the order of the calls; raise what a task raises."""
        source, waiting = _InTurns(self._source), iter(calls)
        running: deque[Future] = deque()
        pool = ThreadPoolExecutor(self._count)
        try:
            while True:
                for arguments in islice(waiting, TASKS_A_THREAD * self._count - len(running)):
                    running.append(pool.submit(TASKS[task], source, *shared, *arguments))
                if not running:
                    return
                if wait([running[0]], CHECKED_EVERY_S).done:
                    yield running.popleft().result()
                self._check()
        finally:
            # A cancel does not wait for running tasks, which can't read the map any more.
            source.has_ended = True
            for future in running:
                future.cancel()
            pool.shutdown(wait=False)


class _InTurns:
    """A label map that one thread at a time can read, until the work has ended."""

    def __init__(self, source: LabelSource) -> None:
        self._source = source
        self._lock = threading.Lock()
        self.has_ended = False

    @property
    def shape_hw(self) -> tuple[int, int]:
        """(height, width) in pixels."""
        return self._source.shape_hw

    def read(self, column: int, row: int, width: int, height: int) -> np.ndarray:
        """Read (height, width) uint8 labels. Raises RuntimeError, which nobody catches, once the work has ended."""
        with self._lock:
            if self.has_ended:
                raise RuntimeError("the work has ended")
            return self._source.read(column, row, width, height)
