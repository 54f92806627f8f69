"""Measure updating a database after an edit against building it anew, on Liechtenstein 2021; prints Markdown.

    python tools/measure_update.py [--trials 200] [--check-every 1] [--compare-every 10] [--stride 350] [--seed 1]
                                   [--work FOLDER]

Each edit stands for a correction: a rectangle of 5 to 60 m at a random place inside the annotated area, given one class
or cleared; every tenth edit is ten of them. Each updated database is the next edit's start. Both algorithms run as
users run them, on the same GeoTIFF; an update is right when windows, references with their bounds, overview,
parameters, classes and distinctiveness are those of the rebuild. Both get one thread. Every tenth time the changes are
also found by comparing the whole map with the database.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import sqlite3
import sys
import tempfile
import time
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parent)
import numpy as np  # noqa: E402
from bench import inputs, plugin  # noqa: E402

ROOT = Path(__file__).resolve().parents[1]
DATA = Path(os.environ.get("SEMREF_DATA") or ROOT.parent / "shared" / "data")
SIZES_M = (5, 60)
EDITS_IN_ONE = 10

SAME = (
    "SELECT * FROM windows ORDER BY fid",
    "SELECT r.geom, r.class, r.class_name, r.area, r.touches_edge, b.first_column, b.first_row, b.end_column, "
    'b.end_row FROM "references" AS r JOIN reference_bounds AS b ON b.fid = r.fid '
    "ORDER BY r.class, b.first_row, b.first_column, b.end_row, b.end_column",
    "SELECT * FROM classes ORDER BY fid",
    "SELECT key, value FROM parameters ORDER BY key",
)


def main() -> int:
    options = parse()
    if not (DATA / "osm_liechtenstein_2021").exists():
        print(f"measure_update: the real data is not here: {DATA}")
        return 0
    os.environ["OMP_NUM_THREADS"] = "1"
    with contextlib.ExitStack() as stack:
        work = options.work or Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="semref-update-")))
        work.mkdir(parents=True, exist_ok=True)
        stack.enter_context(plugin.qgis())
        from semref.processing.algorithms import build_database, update_database

        # Threads would blur what is compared.
        build_database.worker_threads = update_database.worker_threads = lambda: 1
        measure(options, inputs.Run(inputs.main_area(DATA, work), DATA, work, 1, False), work)
    return 0


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--trials", type=int, default=200)
    parser.add_argument("--check-every", type=int, default=1, help="build anew and compare after every n-th edit")
    parser.add_argument("--compare-every", type=int, default=10, help="update without areas, too, every n-th time")
    parser.add_argument("--stride", type=float, default=350.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--work", type=Path, help="keeps the label map for the next run")
    return parser.parse_args()


def measure(options: argparse.Namespace, run: inputs.Run, work: Path) -> None:
    from osgeo import gdal

    with tempfile.TemporaryDirectory(dir=work) as folder:
        labels = Path(folder) / "labels.tif"
        options_tiff = ["TILED=YES", "COMPRESS=DEFLATE"]
        gdal.GetDriverByName("GTiff").CreateCopy(str(labels), gdal.Open(str(run.label_map())), options=options_tiff)
        database = Path(folder) / "database.gpkg"
        rebuilt, updated, compared = Path(folder) / "rebuilt.gpkg", [], []
        begin = time.perf_counter()
        plugin.run_algorithm("builddatabase", run.build_parameters(labels, options.stride, database))
        rebuilds = [time.perf_counter() - begin]
        rng = np.random.default_rng(options.seed)
        equal = checked = 0
        for n in range(1, options.trials + 1):
            areas = edit(labels, rng, EDITS_IN_ONE if n % 10 == 0 else 1)
            changed = write_areas(Path(folder) / "changed.gpkg", areas, labels)
            given = {"DATABASE": str(database), "LABELS": str(labels), "OUTPUT": str(rebuilt)}
            if options.compare_every and n % options.compare_every == 0:
                begin = time.perf_counter()
                plugin.run_algorithm("updatedatabase", given)
                compared.append(time.perf_counter() - begin)
            begin = time.perf_counter()
            plugin.run_algorithm("updatedatabase", {**given, "CHANGED": str(changed), "OUTPUT": str(database)})
            updated.append(time.perf_counter() - begin)
            found = same(database, rebuilt) if len(compared) * options.compare_every == n else True
            if options.check_every and n % options.check_every == 0:
                begin = time.perf_counter()
                plugin.run_algorithm("builddatabase", run.build_parameters(labels, options.stride, rebuilt))
                rebuilds.append(time.perf_counter() - begin)
                checked += 1
                equal += found and same(database, rebuilt)
            share = np.median(updated) / np.median(rebuilds)
            print(f"\r{n} edits, {equal} of {checked} equal, {share:.1%}  ", end="", file=sys.stderr, flush=True)
        with contextlib.closing(sqlite3.connect(database)) as connection:
            questions = "SELECT count(*) FROM windows", 'SELECT count(*) FROM "references"'
            counts = [connection.execute(question).fetchone()[0] for question in questions]
    print(file=sys.stderr)
    load = os.getloadavg()[1]
    print(
        f"{run.area.sentence} {counts[0]:,} windows, {counts[1]:,} landmarks. {options.trials} edits, each updated; "
        f"after {checked} of them the database was built anew: {equal} of {checked} updates equal the rebuild. Rebuild "
        f"{np.median(rebuilds):.1f} s (median of {len(rebuilds)}). Load at the end {load:.1f}.\n"
    )
    print("| update | runs | median, s | 95 % within, s | median, share of the rebuild |\n|---|---|---|---|---|")
    for name, seconds in (("with the changed areas", updated), ("by comparing the whole map", compared)):
        if seconds:
            share = np.median(seconds) / np.median(rebuilds)
            middle, most = np.median(seconds), np.percentile(seconds, 95)
            print(f"| {name} | {len(seconds)} | {middle:.2f} | {most:.2f} | {share:.1%} |")


def edit(labels: Path, rng: np.random.Generator, count: int) -> list[tuple[float, float, float, float]]:
    """Corrects a label map in place; rectangles (west, south, east, north) of what was edited."""
    from osgeo import gdal

    dataset = gdal.Open(str(labels), gdal.GA_Update)
    band = dataset.GetRasterBand(1)
    x0, pixel, _, y0, _, _ = dataset.GetGeoTransform()
    areas = []
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


if __name__ == "__main__":
    sys.exit(main())
