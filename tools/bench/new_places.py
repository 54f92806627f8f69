"""Places that nothing was tuned on, by the steps of docs/guide/own_area.md: OpenStreetMap → database → evaluation.

No constant of a method, no setting and no test was chosen on them; what is told of each place is what a person gets who
follows the guide there with the algorithms' defaults.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from osgeo import ogr

from bench import inputs, page, plugin

PAGE = "benchmarks.md"
AREA = "swellendam and osm_belgrade."
COUNT, QUICK_COUNT = 200, 4
MIRRORED_PERCENT = 25
METHODS = {0: "automatic", 2: "constellation", 3: "map correlation", 1: "topology vector"}
TRIED = (0, 1)


@dataclass(frozen=True)
class Place:
    """A place: its layers of OpenStreetMap, and what the model *Annotation to reference database* is given."""

    name: str
    layers: tuple[str, ...]
    given: dict[str, object]


PLACES = (
    Place(
        "Swellendam, buildings alone",
        ("swellendam/training_data.gpkg|layername=buildings",),
        {
            "PIXEL_SIZE": 1,
            "REFERENCE_CLASSES": "building",
            "WINDOW_SIZE": 600,
            "STRIDE": 150,
            "MINIMUM_AREA": 50,
            "OTHER_GROUND": True,
        },
    ),
    Place(
        "Belgrade, land use and nature",
        ("osm_belgrade/landuse.shp", "osm_belgrade/natural.shp"),
        {
            "PIXEL_SIZE": 5,
            "REFERENCE_CLASSES": "water;bare_land;forest",
            "WINDOW_SIZE": 6000,
            "STRIDE": 1500,
            "MINIMUM_AREA": 1500,
        },
    ),
)
COLUMNS = (
    "place, method",
    "windows tried",
    "right",
    "wrong",
    "false accepts",
    "in the 95 % ellipse",
    "median error, 95 % radius",
)


def measure(run: inputs.Run) -> dict[str, str]:
    """Builds each place's database and evaluates it."""
    count = run.how_many(COUNT, QUICK_COUNT)
    rows = []
    for place in PLACES:
        if not run.wants(place.name) or not is_here(run, place):
            continue
        database, labels = built(run, place)
        rows += _rows(place.name, database, labels, run.work / f"{_file(place)}_trials.gpkg", count)
    if not rows:
        return {"new places": "Not measured: the real data is not here."}
    return {"new places": f"{_ABOUT.format(count=count, mirrored=MIRRORED_PERCENT)}\n\n{page.table(COLUMNS, rows)}"}


_ABOUT = """\
Polygons of OpenStreetMap, classified by *Classify OpenStreetMap* and its own rules, made a database by *Annotation to
reference database*, and tried by *Evaluate localization* with its defaults: {count} images a place, {mirrored} % of
them mirrored – a fix of those is a false accept –, at any heading, 0.8–1.25 of a window, off the windows, 20 / 20 / 5 %
of the landmarks missed, invented and misnamed, map displaced, lens, tilt. Images are cut from the database's own map,
around windows with three landmarks or more. Right: within 2 % of the image's edge; the topology vector: the nearest
window."""


def is_here(run: inputs.Run, place: Place) -> bool:
    """Whether the place's layers are among the real data."""
    return all((run.data / layer.partition("|")[0]).exists() for layer in place.layers)


def _file(place: Place) -> str:
    return place.name.partition(",")[0].lower()


def built(run: inputs.Run, place: Place) -> tuple[str, str]:
    """Paths of database and label map, by the steps of the guide."""
    import processing

    work, paths = run.work, [run.data / layer for layer in place.layers]
    source = str(paths[0])
    if len(paths) > 1:
        merged = {"LAYERS": [str(path) for path in paths], "OUTPUT": str(work / f"{_file(place)}_merged.gpkg")}
        source = processing.run("native:mergevectorlayers", merged)["OUTPUT"]
    classified = {"INPUT": source, "OUTPUT": str(work / f"{_file(place)}_classes.gpkg")}
    annotation = plugin.run_algorithm("classifyopenstreetmap", classified).results["OUTPUT"]
    given = {"INPUT": annotation, "CLASS_FIELD": "class", "PRIORITY_FIELD": "priority", **place.given}
    database, labels = str(work / f"{_file(place)}.gpkg"), str(work / f"{_file(place)}.tif")
    outputs = {"build:Reference database": database, "rasterize:Label map": labels}
    plugin.run_algorithm("annotationtodatabase", {**given, **outputs})
    return database, labels


def _rows(name: str, database: str, labels: str, output: Path, count: int) -> list[list[str]]:
    """A row of each method tried."""
    given = {"DATABASE": database, "LABELS": labels, "TRIALS": count, "MIRRORED": MIRRORED_PERCENT}
    done = plugin.run_algorithm(
        "evaluatelocalization", {**given, "METHODS": list(TRIED), "OUTPUT": str(output), "REPORT": None}
    )
    said = next((line for line in done.log if line.startswith("Images lie around")), "")
    source = ogr.Open(str(output))
    trials = [feature.items() for feature in source.GetLayer(0)]
    print(name, *done.log[-3:], sep="\n  ", file=sys.stderr, flush=True)
    return [
        _row(name, METHODS[number], said, [one for one in trials if one["method"] == METHODS[number]])
        for number in TRIED
    ]


def _row(name: str, method: str, said: str, trials: Sequence[dict]) -> list[str]:
    of_map = [one for one in trials if one["kind"] == "map"]
    mirrored = [one for one in trials if one["kind"] == "mirrored"]
    fixes = [one for one in of_map if one["status"] == "fix"]
    right = [one for one in fixes if one["right"]]
    told = [one for one in right if one["radius_ratio"] is not None]
    held = sum(one["radius_ratio"] <= 1 for one in told)
    errors = [f"{np.median([one[key] for one in told]):.1f} m" for key in ("error", "error_95")] if told else ["–"]
    return [
        f"{name}, {method}",
        _windows(said),
        page.rate(len(right), len(of_map)),
        page.rate(len(fixes) - len(right), len(of_map)),
        page.rate(sum(one["status"] == "fix" for one in mirrored), len(mirrored)),
        page.rate(held, len(told)),
        ", ".join(errors),
    ]


def _windows(said: str) -> str:
    """“913 of 7,946”, of the sentence that the algorithm says."""
    words = said.removeprefix("Images lie around ").removeprefix("all ").split(" windows")[0]
    return words or "–"
