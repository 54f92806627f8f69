"""One build by a plain loop, by one process and by Dask's workers, one of them killed: same bytes, how long, what Dask
costs; and the index of many landmarks, built and opened."""

from __future__ import annotations

import contextlib
import gc
import json
import os
import signal
import sqlite3
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from datetime import datetime, timezone
from pathlib import Path

import numpy as np

from bench import inputs, page
from bench.build import Comparison
from bench.catalogue_sizes import tiled
from bench.ground import Ground
from semref.storage.database import schema

PAGE = "benchmarks.md"
ROOT = Path(__file__).resolve().parents[2]
WORKERS = (1, 2, 4)
EMPTY_TASKS = 500
INDEXED = (10**4, 10**5, 10**6, 10**7)
GOALS_S = {10**6: 0.5, 10**7: 2}
"""Of opening an index of so many landmarks."""
CLUSTER_OF = 100
"""Workers that the measured times of tasks are laid out on."""


@dataclass
class Built:
    """One build: seconds from its start, seconds of processors, and of each task where it was done by tasks."""

    title: str
    seconds: float
    processor: float
    path: Path
    working: float = 0.0
    tasks: dict[str, list[float]] = field(default_factory=dict)


def measure(run: inputs.Run) -> dict[str, str]:
    stride = run.area.stride
    labels = run.label_map()
    comparison = Comparison(run, stride, 200 if run.quick else None)
    one = [_one_process(run, threads) for threads in (1, 2)]
    comparison.ours(1)
    plain = comparison.plainly()
    dask = [_by_dask(run, count) for count in (WORKERS[:2] if run.quick else WORKERS)]
    killed = _by_dask(run, 2, is_one_killed=True)
    rows = [["plain loop, no overview, nothing written", f"{plain:.1f}", f"{plain:.1f}", "", "", ""]]
    for built in [*one, *dask, killed]:
        first = one[0] if built in one else dask[0]
        same = "yes" if built.path.read_bytes() == first.path.read_bytes() else "**no**"
        working = f"{built.working:.1f}" if built.working else ""
        ratio = f"{one[0].seconds / (built.working or built.seconds):.2f}"
        rows.append([built.title, f"{built.seconds:.1f}", f"{built.processor:.1f}", working, ratio, same])
    header = [
        "built by",
        "s",
        "processor s",
        "s without starting",
        "× one process, 1 thread",
        "same bytes as the first of its kind",
    ]
    table = page.table(header, rows)
    rows_same = "have the same rows" if _rows(one[0].path) == _rows(dask[0].path) else "**have other rows**"
    about = _ABOUT.format(cores=os.cpu_count(), table=table, rows_same=rows_same)
    lines = [about, _overhead(labels), _laid_out(run)]
    return {"cluster": "\n\n".join(lines), "stored index": _indexes(run)}


_ABOUT = """\
One build of the same label map, whole: reading, landmarks, overview, hashes, windows, distinctiveness, writing; once
each, on {cores} cores that other work shares, so processor time stands beside. “Without starting”: from the first task
on, workers being there. Bytes are compared with the first of one process and of Dask; between them windows, landmarks,
classes and overview {rows_same}, while each notes where it comes from.

{table}"""


def _rows(path: Path) -> list[list[tuple]]:
    """What a database holds, without its parameters and notes."""
    with contextlib.closing(sqlite3.connect(path)) as connection:
        names = (schema.WINDOWS, schema.REFERENCES, schema.BOUNDS, schema.CLASSES, schema.OVERVIEW)
        return [connection.execute(f'SELECT * FROM "{name}"').fetchall() for name in names]


def _settings(run: inputs.Run) -> dict[str, str]:
    return {
        "--reference-classes": ";".join(inputs.REFERENCE_CLASSES),
        "--window-size": f"{run.area.window_size:g}",
        "--stride": f"{run.area.stride:g}",
        "--minimum-area": f"{inputs.MINIMUM_AREA:g}",
    }


def _one_process(run: inputs.Run, threads: int) -> Built:
    """What ``semref:builddatabase`` does, dated and styled as the cluster does."""
    import cv2

    from semref.core.database.build import BuildSettings, DatabaseBuilder
    from semref.storage.database.styles import plain_styles
    from semref.storage.database.writer import DatabaseWriter
    from semref.storage.map_frames import label_map_frame, longitudes_latitudes
    from semref.storage.metadata import plugin_metadata
    from semref.storage.rasters import GdalLabels, HeldLabels, RasterFile, class_table_of_map

    path, target = str(run.label_map()), run.work / f"cluster_{threads}_threads.gpkg"
    target.unlink(missing_ok=True)
    cv2.setNumThreads(threads)
    begin, processor = time.perf_counter(), time.process_time()
    labels = GdalLabels(path)
    table = class_table_of_map(labels, RasterFile(path)).with_references(inputs.REFERENCE_CLASSES)
    settings = BuildSettings(run.area.window_size, run.area.stride, inputs.MINIMUM_AREA, threads=threads)
    held = HeldLabels(labels)
    _exhaust(held.steps())
    frame, version = label_map_frame(labels, path), plugin_metadata()["version"]
    builder = DatabaseBuilder(held.source, frame, table, settings, version)
    _exhaust(builder.steps())
    _exhaust(builder.compare_windows())
    database = builder.database
    moment = datetime.fromtimestamp(os.stat(path).st_mtime, timezone.utc).strftime("%Y-%m-%dT%H:%M:%S.000Z")
    degrees = longitudes_latitudes(database.windows.centers, database.parameters.crs)
    writer = DatabaseWriter(str(target), database, *degrees, builder.overview, plain_styles(table), moment)
    _exhaust(writer.steps())
    taken = time.perf_counter() - begin, time.process_time() - processor
    return Built(f"one process, {threads} thread{'s' * (threads > 1)}", *taken, target)


def _exhaust(steps: Iterator) -> None:
    for _ in steps:
        pass


def _by_dask(run: inputs.Run, count: int, is_one_killed: bool = False) -> Built:
    """`python -m cluster build` in processes of its own."""
    target = run.work / f"cluster_{count}_workers{'_killed' * is_one_killed}.gpkg"
    options = [part for pair in _settings(run).items() for part in pair]
    order = ["build", str(run.label_map()), "--database", str(target), *options, "--local", str(count), "--json"]
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    before, begin, first = os.times(), time.perf_counter(), 0.0
    process = subprocess.Popen(
        [sys.executable, "-m", "cluster", *order], cwd=ROOT, stdout=subprocess.PIPE, text=True, env=environment
    )
    waiting = is_one_killed
    for line in process.stdout:
        event = json.loads(line)
        if event["event"] == "step":
            first = first or time.perf_counter()
            if waiting and event["text"] == "Describing windows":
                waiting = False
                _kill_one_worker(process.pid)
    if process.wait():
        raise RuntimeError(f"python -m cluster ended with {process.returncode}")
    end, after = time.perf_counter(), os.times()
    title = f"Dask, {count} worker{'s' * (count > 1)}{', one killed in the middle' * is_one_killed}"
    return Built(title, end - begin, sum(after[2:4]) - sum(before[2:4]), target, end - first)


def _kill_one_worker(parent: int) -> None:
    import psutil

    for child in psutil.Process(parent).children(recursive=True):
        if "spawn_main" in " ".join(child.cmdline()):
            child.send_signal(signal.SIGKILL)
            return


def _overhead(labels: Path) -> str:
    """What a task costs that does nothing."""
    from semref.cluster.engine import DaskRunner, connected

    lines = []
    for count in (1, 2):
        with connected(None, count, None, lambda _: None) as client:
            runner = DaskRunner(client, str(labels))
            empty = np.zeros((0, 3), np.float32), np.zeros((0, 2)), np.zeros(0)
            _exhaust(runner("compare", [(0, 0)], empty))
            begin, processor = time.perf_counter(), time.process_time()
            _exhaust(runner("compare", [(0, 0)] * EMPTY_TASKS, empty))
            taken = time.perf_counter() - begin, time.process_time() - processor
            milliseconds = [1000 * value / EMPTY_TASKS for value in taken]
            lines.append(f"{milliseconds[0]:.1f} ms with {count} ({milliseconds[1]:.1f} ms of the starting process)")
    return f"A task that does nothing takes {', '.join(lines)}: what the engine costs, {EMPTY_TASKS} tasks one run."


class _Timed:
    """Does tasks here and tells how long each took."""

    def __init__(self, path: Path) -> None:
        from semref.storage.rasters import GdalLabels

        self._labels = GdalLabels(str(path))
        self.seconds: dict[str, list[float]] = {}

    def __call__(self, task: str, calls, shared=()):
        from semref.core.database.parts import TASKS

        for number, arguments in enumerate(calls):
            begin = time.process_time()
            result = TASKS[task](self._labels, *shared, *arguments)
            self.seconds.setdefault(task, []).append(time.process_time() - begin)
            yield number, result


def _laid_out(run: inputs.Run) -> str:
    """The measured tasks on 100 workers, each given to the first that is free."""
    from semref.core.database.build import BuildSettings
    from semref.core.database.parts import PartsBuilder
    from semref.storage.map_frames import label_map_frame
    from semref.storage.rasters import GdalLabels, RasterFile, class_table_of_map

    path = str(run.label_map())
    labels = GdalLabels(path)
    table = class_table_of_map(labels, RasterFile(path)).with_references(inputs.REFERENCE_CLASSES)
    settings = BuildSettings(run.area.window_size, run.area.stride, inputs.MINIMUM_AREA)
    timed = _Timed(run.label_map())
    begin = time.process_time()
    _exhaust(PartsBuilder(label_map_frame(labels, path), table, settings, "bench", timed, lambda *_: None).steps())
    whole = time.process_time() - begin
    counts = ", ".join(f"{name} {len(some)} ({np.mean(some):.2f} s each)" for name, some in timed.seconds.items())
    inside = sum(map(sum, timed.seconds.values()))
    spans = {workers: sum(_span(some, workers) for some in timed.seconds.values()) for workers in (2, 10, CLUSTER_OF)}
    told = ", ".join(f"{inside / span:.1f} × with {workers}" for workers, span in spans.items())
    return (
        f"Tasks of this map: {counts}; {whole - inside:.2f} s of processor lie between them. Laid out on workers that "
        f"cost nothing, stage after stage: {told} (simulated; a map of so few tasks can't feed more)."
    )


def _span(seconds: list[float], workers: int) -> float:
    """When the last of the tasks is done, each given to the worker that is free first."""
    free = np.zeros(workers)
    for taken in seconds:
        free[free.argmin()] += taken
    return float(free.max())


def _indexes(run: inputs.Run) -> str:
    from semref.core.constellation import cached
    from semref.core.constellation.index import build_index
    from semref.core.constellation.settings import CONSTELLATION

    ground, rows = Ground.of(run), []
    for size in INDEXED[:2] if run.quick else INDEXED:
        references = tiled(ground, size)
        begin = time.process_time()
        built = build_index(references, 1.0)
        building = time.process_time() - begin
        bytes_of = sum(getattr(built, name).nbytes for name in ("neighbors", "keys", "triangles", "fine"))
        with _at_least(cached, 0):
            cached.cached_index(references, 1.0, CONSTELLATION)
            begin, wall = time.process_time(), time.perf_counter()
            opened = cached.cached_index(references, 1.0, CONSTELLATION)
            opening = time.process_time() - begin, time.perf_counter() - wall
        names = ("points", "ranks", "log_areas", "densities", "neighbors", "keys", "triangles", "fine", "by_easting")
        same = all(np.array_equal(getattr(built, name), getattr(opened, name)) for name in names)
        rows.append([f"{len(built):,}", f"{building:.2f}", f"{opening[0]:.3f}", f"{opening[1]:.3f}"])
        rows[-1] += [f"≤ {GOALS_S[size]}" if size in GOALS_S else "", page.cached_size("index")]
        rows[-1] += [page.size(bytes_of), "yes" if same else "**no**"]
        del built, opened
        gc.collect()
    header = ["landmarks", "built, processor s", "opened, processor s", "opened, s", "goal, s", "file"]
    return f"{_ABOUT_INDEX}\n\n{page.table([*header, 'memory that need not be filled', 'same to the last bit'], rows)}"


_ABOUT_INDEX = """\
The constellation's index of the area with altered copies of itself beside it (as in *catalogue sizes*): built, and
opened from the cache; the file was in memory. Opening hashes the landmarks, checks the arrays and maps them;
the nearest-neighbor trees of classes are made by the first query."""


@contextlib.contextmanager
def _at_least(cached, count: int) -> Iterator[None]:
    before = cached.FEWEST
    cached.FEWEST = count
    try:
        yield
    finally:
        cached.FEWEST = before
