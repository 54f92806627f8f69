"""*Set up an area* on a real place: a map of buildings and photos without a position, in one command."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.child import run_in_child
from benchmarks.maps import NoDataError, World
from benchmarks.results import Table, rate

SEED, MOST_EMPTY, RIGHT_SHARE = 5, 0.05, 0.02
"""Seed of the crops; largest share of a crop without image; a position is right within this share of the width."""


def set_up(world: World, scenario: dict[str, Any]) -> list[Table]:
    """Cut photos from orthophotos, run *Set up an area* without training, and compare the positions with the truth."""
    rows = []
    for place in scenario["places"]:
        image, annotation = world.data / place["image"], world.data / place["map"]
        if not image.exists():
            raise NoDataError(f"{image.name} is not here.")
        folder = world.work / f"setup_{image.stem}"
        # Results of an earlier run would be used again.
        results = folder / f"results_{len(list(folder.glob('results_*')))}"
        truth, width_m = cut_photos(image, folder / "photos", place["edge"], world.count or scenario["count"])
        given = {"PHOTOS": [str(folder / "photos")], "PHOTO_WIDTH": width_m, "ANNOTATION": str(annotation)}
        seconds = run_in_child("setuparea", {**given, "MINUTES": 0, "FOLDER": str(results)})["whole"]
        found = positions(results / "positions.gpkg")
        errors = [math.dist(found[name], truth[name]) for name in found]
        right = sum(error <= RIGHT_SHARE * width_m for error in errors)
        error = f"{np.median(errors):.2f}, {max(errors):.2f} m" if errors else "–"
        name, wrong = f"{image.stem}, {width_m:.0f} m", str(len(errors) - right)
        rows.append([name, f"{seconds:.0f}", rate(right, len(truth)), wrong, error])
    return [{"columns": ["photos", "s", "right", "wrong", "median, largest error"], "rows": rows}]


def cut_photos(image: Path, folder: Path, edge: int, count: int) -> tuple[dict[str, tuple[float, float]], float]:
    """Write square crops as JPEG files without a georeference; return their true centers and their width in m."""
    from osgeo import gdal

    gdal.UseExceptions()
    folder.mkdir(parents=True, exist_ok=True)
    source, rng, truth = gdal.Open(str(image)), np.random.default_rng(SEED), {}
    left, pixel, _, top, _, _ = source.GetGeoTransform()
    while len(truth) < count:
        column, row = (int(rng.integers(size - edge)) for size in (source.RasterXSize, source.RasterYSize))
        bands = source.ReadAsArray(column, row, edge, edge)[:3]
        if (bands.max(axis=0) == 0).mean() > MOST_EMPTY:
            continue
        memory = gdal.GetDriverByName("MEM").Create("", edge, edge, 3)
        memory.WriteRaster(0, 0, edge, edge, bands.tobytes())
        path = folder / f"photo_{len(truth):02d}.jpg"
        gdal.GetDriverByName("JPEG").CreateCopy(str(path), memory)
        truth[path.name] = (left + pixel * (column + edge / 2), top - pixel * (row + edge / 2))
    return truth, edge * pixel


def positions(path: Path) -> dict[str, tuple[float, float]]:
    """Return the position of each photo that has one."""
    from osgeo import ogr

    layer = ogr.Open(str(path))
    rows = [row for row in layer.GetLayer(0) if row["status"] == "fix"]
    return {Path(row["image"]).name: (row["x"], row["y"]) for row in rows}
