"""Writing and opening databases of 10⁴ to 10⁷ landmarks: time, memory, bytes.

    python tools/bench/large_databases.py write SOURCE COUNT DATABASE
    python tools/bench/large_databases.py open DATABASE

does one of these in a process of its own, as the benchmark does, and prints JSON.
"""

from __future__ import annotations

import json
import math
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

if __name__ == "__main__":
    sys.path[0] = str(Path(__file__).resolve().parents[1])
    from plugin_package import load_plugin_package

    load_plugin_package()

import numpy as np

from bench import inputs, page
from bench.child import peak_bytes

PAGE = "benchmarks.md"
SIZES = (10_000, 100_000, 1_000_000, 10_000_000)
OVERVIEW_FACTOR = 64
"""Pixels of the label map along one of the overview's: it is not what is measured here."""


def measure(run: inputs.Run) -> dict[str, str]:
    source, rows, landmarks, seconds = run.database(run.area.stride), [], [], []
    for size in SIZES[:1] if run.quick else [size for size in SIZES if run.wants(f"10^{round(math.log10(size))}")]:
        path = run.work / f"large_{size}.gpkg"
        written = _in_child("write", str(source), str(size), str(path))
        opened, again = _in_child("open", str(path)), _in_child("open", str(path))
        kept, bytes_of = page.cached_size("columns"), path.stat().st_size
        path.unlink()
        rows.append(
            [
                f"{opened['landmarks']:,} / {opened['windows']:,}",
                f"{written['processor']:.1f}",
                page.size(written["peak"]),
                page.size(bytes_of),
                f"{bytes_of / opened['landmarks']:.0f}",
                *_both(opened, again),
                kept,
            ]
        )
        landmarks.append(opened["landmarks"])
        seconds.append((written["processor"], opened["processor"], again["processor"]))
        print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    parts = _ABOUT, page.table(_HEADER, rows), _exponents(landmarks, seconds)
    return {"large databases": "\n\n".join(filter(None, parts))}


_OPENED = ("memory that takes", "opened again, processor s", "memory that takes", "in the cache")

_HEADER = [
    *("landmarks / windows", "written, processor s", "memory, all of the process", "file", "B a landmark"),
    *("opened first, processor s", *_OPENED),
]

_ABOUT = """\
Databases of the area's landmarks and windows, repeated side by side, with an overview of 64 m: written by the writer
of builds, and opened as localizing opens them, each in a process of its own: first row by row, every table checked
against its checksum, then again, by the columns that the first stored of a large one in
the [cache](file-formats.md#cache). Memory is the largest resident one (`VmHWM`); of writing with what
is written, of opening less that before it; of a mapped file the pages count that the system may take back."""


def _exponents(landmarks: list[int], seconds: list[tuple[float, float]]) -> str:
    if len(landmarks) < 2:
        return ""
    ratio = math.log(landmarks[-1] / landmarks[-2])
    told = (math.log(last / before) / ratio for before, last in zip(*seconds[-2:]))
    return "Exponents of the last step: written {:.2f}, opened first {:.2f}, again {:.2f}.".format(*told)


def _both(first: dict, again: dict) -> list[str]:
    """Time and memory of opening first and again."""
    seconds = f"{first['processor']:.2f}", f"{again['processor']:.3f}"
    memory = [page.size(opened["peak"] - opened["before"]) for opened in (first, again)]
    return [seconds[0], memory[0], seconds[1], memory[1]]


def _in_child(*order: str) -> dict:
    done = subprocess.run([sys.executable, __file__, *order], capture_output=True, text=True, check=False)
    if done.returncode:
        raise RuntimeError(f"{order} failed:\n{done.stderr}")
    return json.loads(done.stdout.splitlines()[-1])


def written(source: str, count: int, target: str) -> dict:
    """Writes a database of so many landmarks."""
    from semref.core.database.model import MapLandmarks, Windows, first_pixels_of
    from semref.storage.database.reader import read_database
    from semref.storage.database.writer import DatabaseWriter

    of = read_database(source, with_bounds=True)
    own, windows, parameters = of.references, of.windows, of.parameters
    copies = -(-count // len(own))
    side = math.ceil(math.sqrt(copies))
    width, height = parameters.map_width_px, parameters.map_height_px
    large = replace(
        parameters,
        map_width_px=width * side,
        map_height_px=height * side,
        overview_factor=OVERVIEW_FACTOR,
        block_hashes=(),
    )
    across, down = np.arange(copies) % side, np.arange(copies) // side
    pixels = np.column_stack([across * width, down * height])
    meters = pixels * (parameters.pixel_size, -parameters.pixel_size)

    def beside(places: np.ndarray, away: np.ndarray) -> np.ndarray:
        return (places[None] + away[:, None]).reshape(-1, places.shape[1])

    def again(column: np.ndarray) -> np.ndarray:
        return np.tile(column, (copies, *[1] * (column.ndim - 1)))

    landmarks = MapLandmarks(
        beside(own.positions, meters)[:count],
        again(own.classes)[:count],
        again(own.areas_m2)[:count],
        again(own.touches_edge)[:count],
        beside(own.required_bounds, np.tile(pixels, 2))[:count],
    )
    centers, sizes = beside(windows.centers, meters), again(windows.sizes)
    columns = (windows.counts, windows.vectors, windows.described, windows.distinctiveness)
    many = Windows(
        first_pixels_of(centers, sizes, large.frame), again(windows.levels), sizes, centers, *map(again, columns)
    )
    database = replace(of, windows=many, references=landmarks, parameters=large)
    overview = np.zeros(large.overview_frame.shape_hw, np.uint8)
    Path(target).unlink(missing_ok=True)
    begin, nowhere = time.process_time(), np.zeros(len(many))
    for _ in DatabaseWriter(target, database, nowhere, nowhere, overview, {}).steps():
        pass
    return {"processor": time.process_time() - begin, "peak": peak_bytes()}


def opened(path: str) -> dict:
    """Opens a database, or a set."""
    from semref.storage.database.reader import read_database

    before, begin = peak_bytes(), time.process_time()
    found = read_database(path)
    seconds = time.process_time() - begin
    told = {"landmarks": len(found.references), "windows": len(found.windows), "processor": seconds}
    return {**told, "before": before, "peak": peak_bytes()}


if __name__ == "__main__":
    done = written(sys.argv[2], int(sys.argv[3]), sys.argv[4]) if sys.argv[1] == "write" else opened(sys.argv[2])
    print(json.dumps(done))
