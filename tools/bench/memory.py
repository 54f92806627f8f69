"""Peak memory of building, for maps that grow: it must not grow with them."""

from __future__ import annotations

import math
import shutil

import numpy as np

from bench import child, inputs, page

PAGE = "benchmarks.md"
GOAL_BYTES = 1.5e9

GRIDS = ((1, 1), (2, 2), (4, 2), (4, 4), (8, 2))
"""Copies of the area side by side and one above the other."""

SMALLEST_MAP = 300_000_000
"""A smaller area is repeated until its map has about this many pixels, so that the maps compare."""


def measure(run: inputs.Run) -> dict[str, str]:
    folder = run.work / "memory"
    folder.mkdir(exist_ok=True)
    labels = inputs.read_labels(run.label_map())
    factor = max(1, round(math.sqrt(SMALLEST_MAP / labels.size))) if not run.quick else 1
    rows = [["QGIS started and stopped", "", "", "", page.size(child.run_in_child()["peak_bytes"])]]
    for across, down in GRIDS[: 2 if run.quick else None]:
        path = folder / f"{across}x{down}.tif"
        height, width = labels.shape[0] * down * factor, labels.shape[1] * across * factor
        columns = np.arange(width) % labels.shape[1]
        repeated = lambda rows: labels[rows % labels.shape[0]][:, columns]  # noqa: E731
        inputs.write_labels(path, run.label_map(), width, height, repeated)
        database = folder / "map.gpkg"
        found = child.run_in_child("builddatabase", run.build_parameters(path, run.area.stride, database))
        rows.append(
            [
                f"{width:,} × {height:,}",
                f"{width * height / 1e9:.2f}",
                _counts(found["log"]),
                f"{found['seconds']:.0f}",
                page.size(found["peak_bytes"]),
            ]
        )
        path.unlink()
        database.unlink()
    shutil.rmtree(folder)
    header = ["map (pixels)", "Gpx", "windows / landmarks", "s", "peak memory (RSS)"]
    return {"memory": _ABOUT.format(goal=page.size(GOAL_BYTES), table=page.table(header, rows))}


_ABOUT = """\
`semref:builddatabase`, window and stride as above, each in a process of its own (`VmHWM` at its end; QGIS and
libraries included). Larger maps are copies of the area side by side in one GeoTIFF. Goal: ≤ {goal} whatever the map's
size. Times are whole runs, once each, for information.

{table}"""


def _counts(log: list[str]) -> str:
    line = next((line for line in log if "landmarks." in line and "windows" in line), "")
    return line.rstrip(".").replace(" windows, ", " / ").replace(" landmarks", "")
