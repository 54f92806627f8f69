"""Record the results before a flight: trials of a database, its map of expected success, and the report of a route."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from . import dumps
from .areas import write_geojson
from .recorder import Recorder

TRIALS, TRIALS_OF_MAP = 16, 4
"""Of the evaluation by landmarks, which has a report, and by map correlation: reports take a hundred more images."""


def record(recorder: Recorder, places: dict[str, Any]) -> None:
    """Records rows, reports' figures and JSON."""
    area = places.get("liechtenstein", places["sample"])
    _evaluate(recorder, area)
    outputs = _outputs(recorder, "database")
    parameters = {"DATABASE": area.database, "SPACING": 800, "TRIALS": 20 if recorder.quick else 120, "SEED": 3}
    recorder.run("assessed/database", "assessdatabase", {**parameters, **outputs})
    _put(recorder, "assessed/database", outputs)
    _route(recorder, places["sample"])


def _evaluate(recorder: Recorder, area) -> None:
    outputs, numbers = _outputs(recorder, "evaluated_landmarks"), recorder.path("assessment/landmarks.json")
    parameters = {"DATABASE": area.database, "LABELS": area.labels, "SEED": 7}
    more = {"METHODS": [1, 2], "TRIALS": 4 if recorder.quick else TRIALS, "JSON": numbers, **outputs}
    recorder.run("evaluated/landmarks", "evaluatelocalization", {**parameters, **more})
    _put(recorder, "evaluated/landmarks", outputs)
    recorder.put("evaluated/landmarks/json", json.loads(Path(numbers).read_text(encoding="utf-8")))
    if recorder.quick:
        return
    rows = recorder.path("assessment/evaluated_map.gpkg")
    parameters.update(METHODS=[0, 3], TRIALS=TRIALS_OF_MAP, OUTPUT=rows)
    recorder.run("evaluated/map", "evaluatelocalization", parameters)
    recorder.put_layer("evaluated/map", rows)


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


def _outputs(recorder: Recorder, name: str) -> dict[str, str]:
    return {
        "OUTPUT": recorder.path(f"assessment/{name}.gpkg"),
        "REPORT": recorder.path(f"assessment/{name}.html"),
    }


def _put(recorder: Recorder, what: str, outputs: dict[str, str]) -> None:
    recorder.put_layer(what, outputs["OUTPUT"])
    recorder.put(f"{what}/report", dumps.report_numbers(outputs["REPORT"]))
