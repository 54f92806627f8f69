"""A map of 1996 and images of 2018: LCDB Christchurch, every method, by how many objects are in view."""

from __future__ import annotations

import csv
import math
import sys
from collections.abc import Sequence
from functools import partial
from pathlib import Path

import numpy as np

from bench import inputs, kept, page, plugin
from bench.ground import ANY, COLUMNS, GOAL, Ground, Wanted, cells
from semref.core.evaluation.trial import RIGHT_SHARE, Trial
from semref.core.localization import Method
from semref.storage.database.reader import read_database

PAGE = "benchmarks.md"
AREA = "LCDB v5.0 Christchurch, 2,232 polygons."
SEED = 2018
COUNT = 60
QUICK_COUNT = 3
FOOTPRINTS_M = (3_200.0, 6_400.0, 12_800.0)
SCALES = (0.8, 1.25)
LEAST_LABELED = 0.7
NEAR_SHARE = 0.25
"""Of the footprint: all that a method can do which names a window a quarter apart."""

SOURCE = "lcdb5_christchurch/lcdb5_christchurch.gpkg"
PIXEL_SIZE_M = 10.0
MINIMUM_AREA_M2 = 5_000.0
NOT_LAND = 255
"""LCDB's code of it is 0, which means unlabeled in a label map."""

YEARS = (1996, 2001, 2008, 2012, 2018)
BEFORE, AFTER = YEARS[0], YEARS[-1]

PATCHES = (
    "Urban Parkland/Open Space",
    "Surface Mine or Dump",
    "Lake or Pond",
    "Orchard, Vineyard or Other Perennial Crop",
    "Gorse and/or Broom",
    "Broadleaved Indigenous Hardwoods",
    "Deciduous Hardwoods",
    "Exotic Forest",
)
"""Reference classes: those that lie as separate patches in what fills the map (settlement, pasture, cropland)."""

GROUPS = ((0, 9), (10, 19), (20, 39), (40, 10**9))
SAME_GROUND, NOISY, SAME_DATE, MIRRORED = "2018", "2018, 20 / 20 / 5 %", "1996", "2018, mirrored"
SHARES = {SAME_GROUND: 1.0, NOISY: 1.0, SAME_DATE: 0.5, MIRRORED: 0.5}
"""Kinds of images, with their share of the count."""

METHODS = (Method.CONSTELLATION, Method.MAP_CORRELATION, Method.AUTOMATIC, Method.TOPOLOGY_VECTOR)


def measure(run: inputs.Run) -> dict[str, str]:
    if not (run.data / SOURCE).exists():
        return {"two dates": f"Not measured: the real data {SOURCE} is not here."}
    count = run.how_many(COUNT, QUICK_COUNT)
    before, after = (inputs.read_labels(label_map(run, year)) for year in (BEFORE, AFTER))
    rows: list[list[str]] = []
    by_landmarks = {kind: {method: [] for method in METHODS} for kind in (SAME_GROUND, NOISY)}
    for number, footprint in enumerate(FOOTPRINTS_M[1:2] if run.quick else FOOTPRINTS_M):
        for kind, part in SHARES.items():
            name = f"{footprint / 1000:g} km, {kind}"
            if not run.wants(name):
                continue
            labels = before if kind == SAME_DATE else after
            measured = partial(_tried, run, labels, footprint, kind, number)
            found = kept.trials(run, "two_dates", name, math.ceil(part * count), measured)
            for method, trials in zip(METHODS, zip(*found)):
                rows.append([*cells(trials, f"{name}, {method}"), _near(trials)])
                print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
                if kind in by_landmarks:
                    by_landmarks[kind][method] += trials
    text = [_about(count, before, after), page.table([*COLUMNS, "near"], rows)]
    for kind, by_method in by_landmarks.items():
        text += [f"Images of {kind}, by the number of whole landmarks in view:", _by_landmarks(by_method)]
    return {"two dates": "\n\n".join(text)}


def _tried(
    run: inputs.Run, labels: np.ndarray, footprint: float, kind: str, number: int, part: int, size: int
) -> list[list[Trial]]:
    """A part of the images, each given to every one of METHODS."""
    content = read_database(str(database(run, footprint)), with_overview=True)
    ground = Ground(labels, content, size_px=round(footprint / PIXEL_SIZE_M))
    wanted = Wanted(SCALES, landmarks=ANY, labeled=LEAST_LABELED, is_mirrored=kind == MIRRORED)
    rng = np.random.default_rng([SEED, number, list(SHARES).index(kind), part])
    found = []
    for _ in range(size):
        image = ground.draw(wanted, rng)
        if kind == NOISY:
            image = ground.spoiled(image, GOAL, rng)
        found.append([ground.try_image(image, method) for method in METHODS])
    return found


def _near(trials: Sequence[Trial]) -> str:
    """Fixes that are at least near, of images that can be right."""
    if not trials[0].query.can_be_right:
        return "–"
    return page.rate(sum(t.is_fix and t.error_share <= NEAR_SHARE for t in trials), len(trials))


def _by_landmarks(found: dict[Method, list[Trial]]) -> str:
    rows = []
    for low, high in GROUPS:
        row = [f"{low}–{high}" if high < 10**9 else f"≥ {low}"]
        for trials in found.values():
            chosen = [t for t in trials if low <= t.landmarks <= high]
            wrong = sum(t.is_wrong for t in chosen)
            row.append(f"{page.rate(sum(t.is_right for t in chosen), len(chosen))}; {wrong} wrong" if chosen else "–")
        rows.append(row)
    return page.table(["landmarks", *(f"{method}: right" for method in found)], rows)


def _about(count: int, before: np.ndarray, after: np.ndarray) -> str:
    land = (before > 0) & (after > 0)
    return _ABOUT.format(
        pixel=PIXEL_SIZE_M,
        low=SCALES[0],
        high=SCALES[1],
        ragged=GOAL.jitter,
        changed=100 * (before != after)[land].mean(),
        area=MINIMUM_AREA_M2,
        labeled=100 * LEAST_LABELED,
        count=count,
        right=100 * RIGHT_SHARE,
        near=100 * NEAR_SHARE,
    )


_ABOUT = """\
LCDB v5.0 Christchurch (CC BY 4.0, Landcare Research NZ), {pixel:g} m pixels: the database is made of the map of 1996,
label images are cut from the map of 2018 at any place and heading, scale {low:g}–{high:g}, with no other noise
(“2018”) or with 20 % of the landmarks missed, 20 % spurious, 5 % mislabeled and boundaries moved by σ {ragged:g} px
(“20 / 20 / 5 %”); {changed:.1f} % of the land has another class. Reference classes are those that lie as patches, of
at least {area:,.0f} m² (`PATCHES` in `tools/bench/two_dates.py`). At least {labeled:g} % of each image is land.
{count} images a row (half as many of “1996” and “mirrored”), the same ones for every method, any number of landmarks in
view. “1996”: images of the database's own date, to see what the years cost; “mirrored” images lie nowhere. Right:
within {right:g} % of the footprint; near: fixes within {near:g} %, which is all that topology vectors (windows a
quarter of the footprint apart) can do. Times: processor, one core. Boundaries that did not change are the very same
in both maps (LCDB is revised, not redrawn): maps from two hands will differ more."""


def label_map(run: inputs.Run, year: int) -> Path:
    """Label map of a date; values are LCDB's own class codes, the same at every date."""
    path = run.work / f"lcdb_{year}.tif"
    if not path.exists():
        parameters = {
            "INPUT": str(run.data / SOURCE),
            "CLASS_FIELD": f"Name_{year}",
            "CLASS_TABLE": str(_class_table(run)),
            "PIXEL_SIZE": PIXEL_SIZE_M,
            "OUTPUT": str(path),
        }
        plugin.run_algorithm("rasterizeannotation", parameters)
    return path


def database(run: inputs.Run, window_m: float, year: int = BEFORE) -> Path:
    """Database of a date with windows as large as the images, every quarter of a window."""
    path = run.work / f"lcdb_{year}_{window_m:g}.gpkg"
    if not path.exists():
        parameters = {
            "LABELS": str(label_map(run, year)),
            "WINDOW_SIZE": window_m,
            "STRIDE": window_m / 4,
            "MINIMUM_AREA": MINIMUM_AREA_M2,
            "DATABASE": str(path),
        }
        plugin.run_algorithm("builddatabase", parameters)
    return path


def _class_table(run: inputs.Run) -> Path:
    from osgeo import ogr

    path = run.work / "lcdb_classes.csv"
    layer = ogr.Open(str(run.data / SOURCE))
    found = set()
    for feature in layer.GetLayer(0):
        for year in YEARS:
            found.add((int(feature.GetField(f"Class_{year}")), feature.GetField(f"Name_{year}")))
    with path.open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["value", "name", "role"])
        rows.writerows(
            [value or NOT_LAND, name, "reference" if name in PATCHES else "background"] for value, name in sorted(found)
        )
    return path
