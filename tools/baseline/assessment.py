"""What is told before a flight: trials of a database, its map of expected success, what to expect along a route."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict

from . import dumps
from .areas import write_geojson
from .recorder import Recorder

EVALUATIONS = {"landmarks": ([1, 2], 16), "map": ([3], 2)}
"""METHODS and TRIALS of each evaluation."""


def record(recorder: Recorder, places: Dict[str, Any]) -> None:
    """Records rows, reports' figures and JSON."""
    area = places.get("liechtenstein", places["sample"])
    for name, (methods, trials) in EVALUATIONS.items():
        if recorder.quick and name != "landmarks":
            continue
        outputs = _outputs(recorder, f"evaluated_{name}")
        numbers = recorder.path(f"assessment/{name}.json")
        parameters = {"DATABASE": area.database, "LABELS": area.labels, "METHODS": methods, "JSON": numbers}
        parameters.update(TRIALS=4 if recorder.quick else trials, SEED=7, **outputs)
        recorder.run(f"evaluated/{name}", "evaluatelocalization", parameters)
        _put(recorder, f"evaluated/{name}", outputs)
        recorder.put(f"evaluated/{name}/json", json.loads(Path(numbers).read_text(encoding="utf-8")))
    outputs = _outputs(recorder, "database")
    parameters = {"DATABASE": area.database, "SPACING": 800, "TRIALS": 20 if recorder.quick else 120, "SEED": 3}
    recorder.run("assessed/database", "assessdatabase", {**parameters, **outputs})
    _put(recorder, "assessed/database", outputs)
    _route(recorder, places["sample"])


def _route(recorder: Recorder, sample) -> None:
    left, pixel, _, top, _, _ = sample.geotransform()
    corners = ((500, 500), (2500, 900), (2600, 2300), (800, 2500))
    line = ", ".join(f"{left + column * pixel} {top - row * pixel}" for column, row in corners)
    route = recorder.path("assessment/route.geojson")
    write_geojson(route, f"LINESTRING({line})", sample.epsg())
    outputs = _outputs(recorder, "route")
    parameters = {"DATABASE": sample.database, "ROUTE": route, "SPACING": 400, "SPEED": 20, "TRIALS": 4, "SEED": 3}
    parameters.update(MISSED=40, INVENTED=40, THRESHOLD=95)
    if not recorder.quick:
        parameters["SHIFT"] = 150
    recorder.run("assessed/route", "assessroute", {**parameters, **outputs})
    _put(recorder, "assessed/route", outputs)


def _outputs(recorder: Recorder, name: str) -> Dict[str, str]:
    return {
        "OUTPUT": recorder.path(f"assessment/{name}.gpkg"),
        "REPORT": recorder.path(f"assessment/{name}.html"),
    }


def _put(recorder: Recorder, what: str, outputs: Dict[str, str]) -> None:
    recorder.put_layer(what, outputs["OUTPUT"])
    recorder.put(f"{what}/report", dumps.report_numbers(outputs["REPORT"]))
