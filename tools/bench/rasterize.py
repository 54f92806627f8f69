"""semref:rasterizeannotation against the gdal_rasterize program, same grid, same order, same kind of file."""

from __future__ import annotations

import shutil
import subprocess

import numpy as np

from bench import child, inputs, page, plugin, timing

PAGE = "benchmarks.md"
GOAL = 1.2

OURS, GDAL, GDAL_THREADS, WHOLE = "algorithm", "gdal_rasterize", "gdal_rasterize, all CPUs", "whole process"


def measure(run: inputs.Run) -> dict[str, str]:
    program = shutil.which("gdal_rasterize")
    if program is None:
        return {"rasterize": "Not measured: the program gdal_rasterize (Debian: gdal-bin) is not here."}
    folder = run.work / "rasterize"
    folder.mkdir(exist_ok=True)
    ours, plain, threaded = (folder / f"{name}.tif" for name in ("ours", "gdal", "gdal_threads"))
    parameters = run.rasterize_parameters(ours)
    whole_parameters = run.rasterize_parameters(folder / "whole.tif")
    candidates = {
        OURS: lambda: _nothing(plugin.run_algorithm("rasterizeannotation", parameters)),
        GDAL: lambda: _gdal_rasterize(program, run, plain, ()),
        GDAL_THREADS: lambda: _gdal_rasterize(program, run, threaded, ("-co", "NUM_THREADS=ALL_CPUS")),
        WHOLE: lambda: child.run_in_child("rasterizeannotation", whole_parameters)["whole"],
    }
    seconds = timing.take_turns(candidates, run.repetitions)
    labels = inputs.read_labels(ours)
    unequal = int((labels != inputs.read_labels(plain)).sum())
    rows = []
    for name, path in ((OURS, ours), (WHOLE, ours), (GDAL, plain), (GDAL_THREADS, threaded)):
        against = [timing.ratios(seconds[name], seconds[other]).text() for other in (GDAL, GDAL_THREADS)]
        rows.append([_TITLES[name], f"{np.median(seconds[name]):.2f}", *against, page.size(path.stat().st_size)])
    height, width = labels.shape
    shutil.rmtree(folder)
    return {"rasterize": _text(rows, width, height, unequal, run.repetitions)}


_TITLES = {
    OURS: "`semref:rasterizeannotation` in a running QGIS",
    WHOLE: "the same with starting and stopping Python and QGIS",
    GDAL: "`gdal_rasterize`",
    GDAL_THREADS: "`gdal_rasterize -co NUM_THREADS=ALL_CPUS`",
}


def _text(rows, width: int, height: int, unequal: int, repetitions: int) -> str:
    header = ["", "median s", "× `gdal_rasterize`", "× the same, all CPUs", "file"]
    table = page.table(header, rows)
    return _ABOUT.format(width=width, height=height, unequal=unequal, goal=GOAL, table=table, turns=repetitions)


_ABOUT = """\
{width} × {height} pixels, {unequal} of them unlike `gdal_rasterize`'s. Goal: ≤ {goal} ×.

{table}

Ratios: median (least–most) of {turns} turns. The algorithm's time is all it does in a QGIS that runs (reading,
checking and repairing polygons, counting classes, writing class table and colors); `gdal_rasterize`'s is its process
from start to end: `-tap -tr 1 1 -ot Byte -co TILED=YES -co COMPRESS=DEFLATE -sql "… ORDER BY zorder"`. Our writer
compresses one strip while the next is burnt. Given all CPUs, `gdal_rasterize` writes its tiles several times, as time
and file size tell."""


def _gdal_rasterize(program: str, run: inputs.Run, output, more: tuple[str, ...]) -> None:
    layer = run.area.annotation.stem
    pixel = str(inputs.PIXEL_SIZE)
    command = [
        program,
        "-q",
        "-a",
        "class_id",
        "-sql",
        f'SELECT class_id FROM "{layer}" ORDER BY zorder',
        "-tap",
        "-tr",
        pixel,
        pixel,
        "-ot",
        "Byte",
        "-co",
        "TILED=YES",
        "-co",
        "COMPRESS=DEFLATE",
        *more,
        str(run.area.annotation),
        str(output),
    ]
    output.unlink(missing_ok=True)
    subprocess.run(command, check=True)


def _nothing(_: object) -> None:
    """A candidate that returns None is timed from outside."""
