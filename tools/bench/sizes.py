"""How many bytes databases take, and what takes them."""

from __future__ import annotations

import contextlib
import sqlite3
from dataclasses import replace
from pathlib import Path

import numpy as np

from bench import inputs, page, plugin

PAGE = "benchmarks.md"

PAPER_GRID = 23, 12
"""Columns and rows of the paper's 276 windows: the only grid of so many that holds 5950_2100 and 3150_3150."""

PAPER_BYTES = 77_500
"""The paper's §4.3: 77.5 KB of vectors."""


def measure(run: inputs.Run) -> dict[str, str]:
    cases = [("the paper's 276 windows", paper_database(run))]
    cases += [(f"{run.area.name}, stride {s:g} m", run.database(s)) for s in _strides(run)]
    if run.area.name != "sample":
        sample = replace(run, area=inputs.sample_area(run.work))
        cases.append((f"sample area, stride {sample.area.stride:g} m", sample.database(sample.area.stride)))
    header = [
        "database",
        "windows",
        "with vector",
        "vectors alone",
        "landmarks",
        "GeoPackage",
        "windows layer",
        "references layer",
        "overview",
    ]
    rows = [[name, *_row(path)] for name, path in cases]
    return {"sizes": f"{_ABOUT.format(paper=page.size(PAPER_BYTES))}\n\n{page.table(header, rows)}"}


_ABOUT = """\
Bytes in thousands. “Vectors alone”: 120 B for each window with a vector (3 × 10 float32); the paper gives
{paper} for its 276 windows. Layers include their spatial index. The first row is a piece from the middle of the same
label map with the paper's grid (23 × 12 windows)."""


def _strides(run: inputs.Run) -> tuple[float, ...]:
    return (run.area.stride,) if run.quick else (run.area.stride, run.area.dense_stride)


def paper_database(run: inputs.Run) -> Path:
    """A database with the paper's grid on a piece of the area's map, which is repeated where it is too small."""
    path = run.work / f"{run.area.name}_paper.gpkg"
    if path.exists():
        return path
    labels = inputs.read_labels(run.label_map())
    width, height = (int(run.area.window_size + (count - 1) * run.area.stride) for count in PAPER_GRID)
    rows, columns = (
        (np.arange(part) + max(0, whole - part) // 2) % whole for whole, part in zip(labels.shape, (height, width))
    )
    piece = run.work / f"{run.area.name}_paper.tif"
    inputs.write_labels(piece, run.label_map(), width, height, lambda chosen: labels[np.ix_(rows[chosen], columns)])
    plugin.run_algorithm("builddatabase", run.build_parameters(piece, run.area.stride, path))
    return path


def _row(path: Path) -> list[str]:
    with contextlib.closing(sqlite3.connect(f"file:{path}?mode=ro&immutable=1", uri=True)) as connection:
        count, vectors, length = connection.execute(
            "SELECT count(*), count(vector), sum(length(vector)) FROM windows"
        ).fetchone()
        landmarks = connection.execute('SELECT count(*) FROM "references"').fetchone()[0]
        layers = [page.size(_layer_bytes(connection, name)) for name in ("windows", "references", "overview")]
    return [
        f"{count:,}",
        f"{vectors:,}",
        page.size(length or 0),
        f"{landmarks:,}",
        page.size(path.stat().st_size),
        *layers,
    ]


def _layer_bytes(connection: sqlite3.Connection, name: str) -> int:
    """Bytes of a table with its spatial index."""
    total = "SELECT sum(pgsize) FROM dbstat WHERE name = ? OR name GLOB ?"
    return connection.execute(total, (name, f"rtree_{name}_*")).fetchone()[0] or 0
