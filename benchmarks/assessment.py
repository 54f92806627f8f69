"""Compare the success that *Assess reference database* expects with the positions of other images."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from benchmarks.accuracy import Row, measure, records, rows_of
from benchmarks.maps import World, run_algorithm
from benchmarks.results import Table, rate


def run(world: World, name: str, scenario: dict[str, Any], only: Sequence[str]) -> list[Table]:
    """Assess the database of each row, localize its images, and compare them square by square."""
    found = measure(rows_of(scenario), only, lambda row: compared(world, name, row, scenario["assumed"]))
    scores = ["Brier score", "Brier score of the mean"]
    columns = ["images", "right fixes, expected", "right fixes", "wrong fixes", *scores]
    curves = [
        {"columns": ["expected", "mean", f"right: {row}"], "rows": curve(*pairs)} for row, (_, pairs) in found.items()
    ]
    return [{"columns": columns, "rows": [[row, *cells] for row, (cells, _) in found.items()]}, *curves]


def compared(world: World, name: str, row: Row, assumed: dict[str, float]) -> tuple[list[str], tuple[np.ndarray, ...]]:
    """Return the cells of a row; and the expected success of each image and whether its position is right, (N,)."""
    squares, some = assessed(world, row.database, assumed), records(world, name, row)
    # A place is in the square with the nearest center.
    expected = np.array([squares[np.abs(squares[:, :2] - one["place"]).max(axis=1).argmin(), 2] for one in some])
    right = np.array([one["right"] for one in some])
    scores = [f"{((guess - right) ** 2).mean():.3f}" for guess in (expected, right.mean())]
    wrong = sum(one["wrong"] for one in some)
    return [f"{100 * expected.mean():.1f} %", rate(right.sum(), len(some)), rate(wrong, len(some)), *scores], (
        expected,
        right,
    )


def assessed(world: World, name: str, assumed: dict[str, float]) -> np.ndarray:
    """Return (S, 3) x and y of the center of each square, and its expected success."""
    from osgeo import ogr

    path = world.work / f"{name}_squares.gpkg"
    run_algorithm("assessdatabase", {"DATABASE": str(world.database(name)), **assumed, "OUTPUT": str(path)})
    data, rows = ogr.Open(str(path)), []
    for feature in data.GetLayer(0):
        center = feature.GetGeometryRef().Centroid()
        rows.append((center.GetX(), center.GetY(), feature.GetField("success")))
    return np.array(rows)


def curve(expected: np.ndarray, right: np.ndarray) -> list[list[str]]:
    """Return rows by tenths of the expected success."""
    tenths = np.minimum((10 * expected).astype(int), 9)
    return [
        [
            f"{10 * tenth}–{10 * tenth + 10} %",
            f"{100 * expected[some].mean():.1f} %",
            rate(right[some].sum(), some.sum()),
        ]
        for tenth in range(10)
        if (some := tenths == tenth).any()
    ]
