"""Building a database against the plain per-window OpenCV loop: same vectors, how much faster."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np

from bench import inputs, page, plain_build, timing

PAGE = "benchmarks.md"
GOALS = {"sparse": 3.0, "dense": 10.0}
SAMPLED_WINDOWS = 2000
SEED = 1671


@dataclass
class Plain:
    """Seconds of the parts of the plain computation; `share` of the windows were computed."""

    reading: float = 0.0
    references: float = 0.0
    windows: float = 0.0
    share: float = 1.0
    reference_count: int = 0

    @property
    def whole(self) -> float:
        return self.reading + self.references + self.windows / self.share


class Comparison:
    """One stride: runs both computations and compares their vectors."""

    def __init__(self, run: inputs.Run, stride: float, sampled: int | None) -> None:
        self._path = run.label_map()
        self._area, self._stride = run.area, stride
        self._sampled = sampled
        self._rng = np.random.default_rng(SEED)
        self.database = None
        self.compared = 0
        self.unequal_counts = 0
        self.largest_difference = 0.0
        self.plain: list[Plain] = []
        self.parts: list[tuple[float, float]] = []
        self.overviews: list[float] = []

    def ours(self, threads: int) -> float:
        """Seconds of core's building: reading, landmarks, overview, hash, windows, vectors."""
        cv2.setNumThreads(threads)
        begin = time.perf_counter()
        builder = self._builder(threads)
        parts = {}
        with _timed_overview() as overview:
            for what, _ in builder.steps():
                parts[what] = time.perf_counter() - begin
        whole = time.perf_counter() - begin
        self.database = builder.database
        first = parts["Finding landmarks"]
        self.parts.append((first, whole - first))
        self.overviews.append(sum(overview))
        return whole

    def plainly(self) -> float:
        """Seconds of the plain loop over all windows, scaled up when only a sample of them was computed."""
        cv2.setNumThreads(1)
        found = Plain()
        size, stride = (int(v / inputs.PIXEL_SIZE) for v in (self._area.window_size, self._stride))
        classes = self.database.class_table.reference_values
        minimum_area = inputs.MINIMUM_AREA / inputs.PIXEL_SIZE**2
        begin = time.perf_counter()
        labels = inputs.read_labels(self._path)
        found.reading = time.perf_counter() - begin
        found.reference_count = len(plain_build.regions(labels, classes, minimum_area)[0])
        found.references = time.perf_counter() - begin - found.reading
        height, width = labels.shape
        grid = [(c, r) for r in range(0, height - size + 1, stride) for c in range(0, width - size + 1, stride)]
        if self._sampled and self._sampled < len(grid):
            found.share = self._sampled / len(grid)
            chosen = np.sort(self._rng.choice(len(grid), self._sampled, replace=False))
            grid = [grid[i] for i in chosen]
        begin = time.perf_counter()
        vectors, counts = plain_build.windows(labels, grid, size, classes, minimum_area)
        found.windows = time.perf_counter() - begin
        self.plain.append(found)
        self._compare(grid, vectors, counts, found.reference_count)
        return found.whole

    def _builder(self, threads: int):
        from osgeo import gdal

        from semref.core.database.build import BuildSettings, DatabaseBuilder
        from semref.core.geometry.frame import MapFrame
        from semref.storage.rasters import GdalLabels, HeldLabels
        from semref.storage.text_tables import read_class_table

        dataset = gdal.Open(str(self._path))
        frame = MapFrame(dataset.GetProjection(), tuple(dataset.GetGeoTransform()))
        table = read_class_table(str(self._area.class_table)).with_references(inputs.REFERENCE_CLASSES)
        settings = BuildSettings(self._area.window_size, self._stride, inputs.MINIMUM_AREA, threads=threads)
        held = HeldLabels(GdalLabels(str(self._path)))
        for _ in held.steps():
            pass
        return DatabaseBuilder(held.source, frame, table, settings, "bench")

    def _compare(self, grid, vectors: np.ndarray, counts: np.ndarray, reference_count: int) -> None:
        windows = self.database.windows
        place = {name: i for i, name in enumerate(windows.names.tolist())}
        index = np.array([place[f"{column}_{row}"] for column, row in grid])
        self.compared += len(index)
        self.unequal_counts += int((windows.counts[index] != counts).sum())
        self.unequal_counts += abs(len(self.database.references) - reference_count)
        self.largest_difference = max(self.largest_difference, float(np.abs(windows.vectors[index] - vectors).max()))


@contextlib.contextmanager
def _timed_overview() -> Iterator[list[float]]:
    """A list that fills with the seconds core spends on reducing the map for the overview."""
    from semref.core.database import build as core_build

    reduce, seconds = core_build.most_frequent_labels, []

    def timed(*arguments):
        begin = time.perf_counter()
        reduced = reduce(*arguments)
        seconds.append(time.perf_counter() - begin)
        return reduced

    core_build.most_frequent_labels = timed
    try:
        yield seconds
    finally:
        core_build.most_frequent_labels = reduce


def measure(run: inputs.Run) -> dict[str, str]:
    rows, notes = [], []
    strides = {"sparse": run.area.stride, "dense": run.area.dense_stride}
    for kind, stride in strides.items():
        sampled = SAMPLED_WINDOWS if kind == "dense" and not run.quick else None
        comparison = Comparison(run, stride, 200 if run.quick else sampled)
        comparison.ours(1)  # so that the first turn finds the files in the cache, too
        comparison.parts.clear()
        comparison.overviews.clear()
        seconds = _take_turns(comparison, run.repetitions)
        rows.append(_row(run, stride, comparison, seconds, GOALS[kind]))
        notes.append(_note(run, stride, comparison, seconds))
    header = [
        "window / stride",
        "windows",
        "goal",
        "× faster, 1 thread",
        "2 threads",
        "same work, 1 thread",
        "2 threads",
        "largest difference of vectors",
        "unequal counts",
    ]
    body = f"{page.table(header, rows)}\n\n" + "\n".join(f"- {note}" for note in notes)
    return {"build": f"{_ABOUT.format(turns=run.repetitions)}\n\n{body}"}


ONE, TWO, PLAIN, ONE_SAME, TWO_SAME = "1 thread", "2 threads", "plain loop", "1, no overview", "2, no overview"


def _take_turns(comparison: Comparison, repetitions: int) -> dict[str, list[float]]:
    """Seconds of the plain loop and of ours with 1 and 2 threads, whole and without the overview."""
    without: dict[str, list[float]] = {ONE_SAME: [], TWO_SAME: []}

    def ours(threads: int, name: str) -> float:
        whole = comparison.ours(threads)
        without[name].append(whole - comparison.overviews[-1])
        return whole

    candidates = {ONE: lambda: ours(1, ONE_SAME), PLAIN: comparison.plainly, TWO: lambda: ours(2, TWO_SAME)}
    return {**timing.take_turns(candidates, repetitions), **without}


_ABOUT = """\
Times faster than the plain loop of `tools/bench/plain_build.py` (one thread, one window after another: mask,
`cv2.findContours`, areas, moments, sorting, vector; the whole map once for `references`): median (least–most) of
{turns} turns. Both read the same GeoTIFF. Ours also makes the overview and the map's hash, which the plain loop does
not; “same work” leaves the overview's time out. Distinctiveness is apart, below; writing is in none of these
figures."""


def _row(run, stride, comparison: Comparison, seconds, goal: float) -> list[str]:
    faster = [timing.ratios(seconds[PLAIN], seconds[name]).text(1) for name in (ONE, TWO, ONE_SAME, TWO_SAME)]
    return [
        f"{run.area.window_size:g} / {stride:g} m",
        f"{len(comparison.database.windows):,}",
        f"≥ {goal:g}",
        *faster,
        f"{comparison.largest_difference:.1e} in {comparison.compared:,} windows",
        str(comparison.unequal_counts),
    ]


def _note(run, stride, comparison: Comparison, seconds) -> str:
    reading = np.median([p.reading for p in comparison.plain])
    references = np.median([p.references for p in comparison.plain])
    windows = np.median([p.windows / p.share for p in comparison.plain])
    share, database = comparison.plain[0].share, comparison.database
    scaled = f" (scaled up from {round(share * len(database.windows)):,} random windows a turn)" if share < 1 else ""
    first, rest = (np.median(part) for part in zip(*comparison.parts))
    overview = np.median(comparison.overviews)
    begin = time.perf_counter()
    for _ in _distinctiveness(database.windows):
        pass
    distinct = time.perf_counter() - begin
    return (
        f"Stride {stride:g} m, median seconds: ours {np.median(seconds[ONE]):.1f} with 1 thread, "
        f"{np.median(seconds[TWO]):.1f} with 2 (landmarks and hash {first - overview:.1f}, overview "
        f"{overview:.1f}, windows and vectors {rest:.1f}, medians over both); plain loop: reading {reading:.1f}, "
        f"references {references:.1f}, windows and vectors {windows:.1f}{scaled}. "
        f"Distinctiveness of {int(database.windows.described.sum()):,} vectors: {distinct:.1f} s, once."
    )


def _distinctiveness(windows):
    from semref.core.windows.distinctiveness import distinctiveness

    index = windows.described
    return distinctiveness(windows.vectors[index], windows.centers[index], windows.sizes[index])
