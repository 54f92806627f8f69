"""Updating a database after an edit, against building it anew.

Each edit stands for a correction: a rectangle of 5 to 60 m at a random place inside the annotated area, given one
class or cleared; every tenth edit is ten of them. Each updated database is the next edit's start. Both run as users run
them, on the same GeoTIFF; an update is right when windows, landmarks with their bounds, overview, parameters,
classes and distinctiveness are those of the rebuild. Both get one thread.
"""

from __future__ import annotations

import contextlib
import sqlite3
import sys
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from bench import inputs, page, plugin

PAGE = "benchmarks.md"
EDITS = 200
COMPARED_EVERY = 10
"""Every tenth time the changes are also found by comparing the whole map with the database."""
SEED = 1
SIZES_M = (5, 60)
EDITS_IN_ONE = 10
GOAL = 0.05
"""Share of a rebuild that an update may take."""

SAME = (
    "SELECT * FROM windows ORDER BY fid",
    "SELECT r.geom, r.class, r.class_name, r.area, r.touches_edge, b.first_column, b.first_row, b.end_column, "
    'b.end_row FROM "references" AS r JOIN reference_bounds AS b ON b.fid = r.fid '
    "ORDER BY r.class, b.first_row, b.first_column, b.end_row, b.end_column",
    "SELECT * FROM classes ORDER BY fid",
    "SELECT key, value FROM parameters ORDER BY key",
)


@dataclass
class Tally:
    """Seconds of each run, and how many updates equal the rebuild.

    Attributes:
        rebuilt: Seconds of building anew.
        updated: Seconds of updating with the changed areas given.
        compared: Seconds of updating where the changes had to be found.
        equal: Updates that equal the rebuild.
    """

    rebuilt: list[float] = field(default_factory=list)
    updated: list[float] = field(default_factory=list)
    compared: list[float] = field(default_factory=list)
    equal: int = 0


def measure(run: inputs.Run) -> dict[str, str]:
    """Edits, updates, rebuilds and compares."""
    # Threads would blur what is compared.
    with plugin.one_thread(), tempfile.TemporaryDirectory(dir=run.work) as folder:
        tally = try_edits(run, Path(folder), run.how_many(EDITS, 3))
        counts = counted(Path(folder) / "database.gpkg")
    rebuild = float(np.median(tally.rebuilt))
    rows = []
    for name, seconds in (("with the changed areas", tally.updated), ("by comparing the whole map", tally.compared)):
        if seconds:
            middle = float(np.median(seconds))
            most = np.percentile(seconds, 95)
            rows.append([name, len(seconds), f"{middle:.2f}", f"{most:.2f}", f"{middle / rebuild:.1%}"])
    header = ["update", "runs", "median, s", "95 % within, s", f"median, share of the rebuild ({rebuild:.1f} s)"]
    edits = len(tally.updated)
    text = _ABOUT.format(
        windows=counts[0],
        landmarks=counts[1],
        edits=edits,
        equal=tally.equal,
        goal=GOAL,
        table=page.table(header, rows),
    )
    return {"update": text}


_ABOUT = """\
{windows:,} windows, {landmarks:,} landmarks, one thread. After each of {edits} edits the database was updated and built
anew: **{equal} of {edits} updates equal the rebuild**. Goal: ≤ {goal:.0%} of a rebuild.

{table}"""


def try_edits(run: inputs.Run, folder: Path, edits: int) -> Tally:
    """Edits a copy of the area's label map again and again; the database in ``folder`` follows."""
    from osgeo import gdal

    labels, database, rebuilt = (folder / name for name in ("labels.tif", "database.gpkg", "rebuilt.gpkg"))
    layout = ["TILED=YES", "COMPRESS=DEFLATE"]
    gdal.GetDriverByName("GTiff").CreateCopy(str(labels), gdal.Open(str(run.label_map())), options=layout)
    plugin.run_algorithm("builddatabase", run.build_parameters(labels, run.area.stride, database))
    rng = np.random.default_rng(SEED)
    tally = Tally()
    for n in range(1, edits + 1):
        areas = edit(labels, rng, EDITS_IN_ONE if n % 10 == 0 else 1)
        changed = write_areas(folder / "changed.gpkg", areas, labels)
        given = {"DATABASE": str(database), "LABELS": str(labels), "OUTPUT": str(rebuilt)}
        found = True
        if n % COMPARED_EVERY == 0:
            tally.compared.append(timed("updatedatabase", given))
        given.update(CHANGED=str(changed), OUTPUT=str(folder / "next.gpkg"))
        tally.updated.append(timed("updatedatabase", given))
        (folder / "next.gpkg").replace(database)
        if n % COMPARED_EVERY == 0:
            found = same(database, rebuilt)
        tally.rebuilt.append(timed("builddatabase", run.build_parameters(labels, run.area.stride, rebuilt)))
        tally.equal += found and same(database, rebuilt)
        print(f"\r{n} edits, {tally.equal} equal  ", end="", file=sys.stderr, flush=True)
    return tally


def timed(algorithm: str, parameters: dict) -> float:
    """Seconds of a run."""
    begin = time.perf_counter()
    plugin.run_algorithm(algorithm, parameters)
    return time.perf_counter() - begin


def counted(database: Path) -> list[int]:
    """How many windows and landmarks a database has."""
    with contextlib.closing(sqlite3.connect(database)) as connection:
        questions = "SELECT count(*) FROM windows", 'SELECT count(*) FROM "references"'
        return [connection.execute(question).fetchone()[0] for question in questions]


def edit(labels: Path, rng: np.random.Generator, count: int) -> list[tuple[float, float, float, float]]:
    """Corrects a label map in place; rectangles (west, south, east, north) of what was edited."""
    from osgeo import gdal

    dataset = gdal.Open(str(labels), gdal.GA_Update)
    band = dataset.GetRasterBand(1)
    x0, pixel, _, y0, _, _ = dataset.GetGeoTransform()
    areas: list[tuple[float, float, float, float]] = []
    while len(areas) < count:
        width, height = (int(size / pixel) for size in rng.integers(*SIZES_M, 2))
        column = int(rng.integers(0, dataset.RasterXSize - width))
        row = int(rng.integers(0, dataset.RasterYSize - height))
        around = band.ReadAsArray(column, row, width, height)
        if not around.any():
            continue
        around[:] = rng.choice(np.append(np.unique(around), (1, 2, 3, 4, 5)))
        band.WriteArray(around, column, row)
        west, north = x0 + column * pixel, y0 - row * pixel
        areas.append((west, north - height * pixel, west + width * pixel, north))
    dataset.FlushCache()
    return areas


def write_areas(path: Path, areas: list, labels: Path) -> Path:
    """A GeoPackage of rectangles in the label map's CRS."""
    from osgeo import gdal, ogr, osr

    path.unlink(missing_ok=True)
    source = ogr.GetDriverByName("GPKG").CreateDataSource(str(path))
    layer = source.CreateLayer("changed", osr.SpatialReference(gdal.Open(str(labels)).GetProjection()), ogr.wkbPolygon)
    for west, south, east, north in areas:
        feature = ogr.Feature(layer.GetLayerDefn())
        ring = f"{west} {south}, {east} {south}, {east} {north}, {west} {north}, {west} {south}"
        feature.SetGeometry(ogr.CreateGeometryFromWkt(f"POLYGON (({ring}))"))
        layer.CreateFeature(feature)
    return path


def same(first: Path, second: Path) -> bool:
    """Whether two databases have the same content, whatever the fids of their references."""
    from osgeo import gdal

    contents = []
    for path in (first, second):
        with contextlib.closing(sqlite3.connect(path)) as connection:
            contents.append([connection.execute(sql).fetchall() for sql in SAME])
    overviews = [gdal.Open(f"GPKG:{path}:overview").ReadAsArray() for path in (first, second)]
    return contents[0] == contents[1] and np.array_equal(*overviews)
