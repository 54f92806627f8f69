"""Memory, time and file size of `python -m cluster build` for sparse maps of 10⁸ … 10¹¹ pixels."""

from __future__ import annotations

import json
import math
import os
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from osgeo import gdal, osr

from bench import child, inputs, page

PAGE = "benchmarks.md"
AREA = "Maps made for the purpose."
ROOT = Path(__file__).resolve().parents[2]
GOAL_BYTES = 1.5e9

EXPONENTS = (8, 9, 10, 11)
"""Of ten, of the pixels; `--only 8,9` takes some."""

IN_QGIS = "QGIS"
"""`--only QGIS` takes the builds in QGIS alone."""

_ISLAND, _APART = 1024, 16_384
"""Edge of a settlement and from one to the next, pixels; each lies on a seam of tiles."""

_HOUSES, _SEED = 60, 20261122
_LOOKED_EVERY_S = 0.2
_SETTINGS = ("--reference-classes", "building;water", "--window-size", "1280", "--stride", "350", "--local", "1")


@dataclass(frozen=True)
class Built:
    """One build: pixels, seconds, bytes of memory and files."""

    pixels: int
    seconds: float
    processor: float
    starting: int
    worker: int
    database: int
    windows: int
    landmarks: int


def measure(run: inputs.Run) -> dict[str, str]:
    sections = {}
    if IN_QGIS not in run.only:
        sections["large builds"] = _by_cluster(run)
    if IN_QGIS in run.only or not run.only:
        sections["large builds in QGIS"] = _in_qgis(run)
    return sections


def _by_cluster(run: inputs.Run) -> str:
    chosen = [n for n in EXPONENTS if str(n) in run.only] if run.only else EXPONENTS[: 1 if run.quick else None]
    found = []
    for exponent in chosen:
        path = sparse_map(run.work / f"sparse_{exponent}.tif", 10**exponent)
        found.append(_built(path, run.work / f"sparse_{exponent}.gpkg"))
        print(found[-1], file=sys.stderr, flush=True)
    rows = [_row(built) for built in found]
    header = ["map, pixels", "windows / landmarks", "s", "processor s", "memory, starting process", "memory, worker"]
    table = page.table([*header, "database", "B / pixel"], rows)
    about = _ABOUT.format(goal=page.size(GOAL_BYTES), table=table, apart=_APART / 1000)
    return f"{about}\n\n{_exponents(found)}" if len(found) > 1 else about


_ABOUT = """\
`python -m cluster build … --local 1` of maps with a settlement of 60 houses and ponds every {apart:.1f} km and nothing
between (GeoTIFF, 1 m, sparse and compressed), window 1280 m, stride 350 m. Memory is the largest resident one (`VmHWM`,
libraries and mapped files included). Goal: ≤ {goal} whatever the map's size.

{table}"""


def _in_qgis(run: inputs.Run) -> str:
    rows = []
    for exponent in EXPONENTS[: 1 if run.quick else None]:
        path, target = sparse_map(run.work / f"sparse_{exponent}.tif", 10**exponent), run.work / "sparse_in_qgis.gpkg"
        parameters = {"LABELS": str(path), "REFERENCE_CLASSES": "building;water", "DATABASE": str(target)}
        parameters |= {"WINDOW_SIZE": 1280, "STRIDE": 350, "MINIMUM_AREA": 100}
        done = child.run_in_child("builddatabase", parameters)
        counts = next(line for line in done["log"] if "landmarks" in line).rstrip(".")
        rows.append([f"{10**exponent:.1e}", counts, f"{done['seconds']:.0f}", f"{done['processor_seconds']:.0f}"])
        rows[-1] += [page.size(done["peak_bytes"]), page.size(target.stat().st_size)]
        target.unlink()
        print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    header = ["map, pixels", "windows, landmarks", "s", "processor s", "memory", "database"]
    return f"{_ABOUT_QGIS}\n\n{page.table(header, rows)}"


_ABOUT_QGIS = """\
The same maps by `semref:builddatabase`, each in a process of its own (`VmHWM` at its end; QGIS and libraries
included). Goal: ≤ 1.50 GB whatever the map's size."""


def sparse_map(path: Path, pixels: int) -> Path:
    """A label map of about as many pixels, kept from run to run."""
    if path.exists():
        return path
    from semref.core.labels.class_table import ClassTable, LandCoverClass
    from semref.storage.label_map_file import CLASS_TABLE_ITEM

    edge = math.isqrt(pixels - 1) + 1
    options = ["TILED=YES", "COMPRESS=DEFLATE", "SPARSE_OK=TRUE", "BLOCKXSIZE=512", "BLOCKYSIZE=512", "BIGTIFF=YES"]
    made = gdal.GetDriverByName("GTiff").Create(str(path), edge, edge, 1, gdal.GDT_Byte, options)
    srs = osr.SpatialReference()
    srs.ImportFromEPSG(3035)
    made.SetProjection(srs.ExportToWkt())
    made.SetGeoTransform((4_000_000, 1, 0, 3_000_000, 0, -1))
    table = ClassTable((LandCoverClass(1, "building", "#c03020"), LandCoverClass(2, "water", "#3060c0")))
    made.SetMetadataItem(CLASS_TABLE_ITEM, table.to_csv())
    island = _settlement()
    # Half an island from the seams of tiles, which lie every 8192 pixels.
    for row in range(8192 - _ISLAND // 2, edge - _ISLAND, _APART):
        for column in range(8192 - _ISLAND // 2, edge - _ISLAND, _APART):
            made.GetRasterBand(1).WriteArray(np.rot90(island, (row + column) // _APART % 4), column, row)
    made.FlushCache()
    return path


def _settlement() -> np.ndarray:
    """(1024, 1024) uint8 houses and ponds."""
    random, labels = np.random.default_rng(_SEED), np.zeros((_ISLAND, _ISLAND), np.uint8)
    for n in range(_HOUSES):
        column, row = random.integers(0, _ISLAND - 60, 2)
        width, height = random.integers(12, 50, 2)
        labels[row : row + height, column : column + width] = 1 + (n % 5 == 0)
    return labels


def _built(path: Path, target: Path) -> Built:
    target.unlink(missing_ok=True)
    before, begin = os.times(), time.perf_counter()
    order = [sys.executable, "-m", "cluster", "build", str(path), "--database", str(target), *_SETTINGS, "--json"]
    with open(f"{target}.log", "w+", encoding="utf-8") as log:
        process = subprocess.Popen(order, cwd=ROOT, stdout=log)
        peaks = _watched(process)
        taken, after = time.perf_counter() - begin, os.times()
        log.seek(0)
        last = json.loads(log.read().splitlines()[-1])
    if process.returncode:
        raise RuntimeError(f"python -m cluster ended with {process.returncode}: {last}")
    pixels = math.prod((lambda file: (file.RasterXSize, file.RasterYSize))(gdal.Open(str(path))))
    processor = sum(after[2:4]) - sum(before[2:4])
    own = peaks.pop(process.pid)
    size, counts = target.stat().st_size, (last["windows"], last["references"])
    target.unlink()
    return Built(pixels, taken, processor, own, max(peaks.values()), size, *counts)


def _watched(process: subprocess.Popen) -> dict[int, int]:
    """Largest resident memory in bytes of a process and all that it starts, by number, until it ends."""
    import psutil

    peaks = {process.pid: 0}
    while process.poll() is None:
        try:
            running = [process.pid, *(child.pid for child in psutil.Process(process.pid).children(recursive=True))]
        except psutil.Error:
            break
        for number in running:
            peaks[number] = max(peaks.get(number, 0), _peak(number))
        time.sleep(_LOOKED_EVERY_S)
    process.wait()
    return peaks


def _peak(number: int) -> int:
    try:
        text = Path(f"/proc/{number}/status").read_text(encoding="ascii", errors="replace")
    except OSError:
        return 0
    return next((int(line.split()[1]) * 1024 for line in text.splitlines() if line.startswith("VmHWM:")), 0)


def _row(built: Built) -> list[str]:
    return [
        f"{built.pixels:.1e}",
        f"{built.windows:,} / {built.landmarks:,}",
        f"{built.seconds:.0f}",
        f"{built.processor:.0f}",
        page.size(built.starting),
        page.size(built.worker),
        page.size(built.database),
        f"{built.database / built.pixels:.4f}",
    ]


def _exponents(found: list[Built]) -> str:
    """How each grows with pixels, from the last two maps and from the first to the last."""
    told = []
    for name, title in (("processor", "processor time"), ("starting", "memory"), ("database", "database")):
        values = [getattr(built, name) for built in found]
        powers = [_power(found[n].pixels, values[n], found[-1].pixels, values[-1]) for n in (0, -2)]
        told.append(f"{title} {powers[0]:.2f} (last step {powers[1]:.2f})")
    return f"Exponents against pixels: {', '.join(told)}."


def _power(pixels: float, value: float, more_pixels: float, more_value: float) -> float:
    return math.log(more_value / value) / math.log(more_pixels / pixels)
