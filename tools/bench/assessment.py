"""Assessments: predicted against measured success, and a route through the area.

semref:assessdatabase predicts from the database alone. Fresh images are cut from the *label map*, anywhere on the
ground, at any heading, spoiled as labels and localized: what was predicted for their square is compared with what came
of them. With `--work` a later run goes on where one was broken off. `--pictures FOLDER` writes the documentation's
pictures.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from bench import inputs, machine, page, plugin
from bench.ground import Ground, Image
from semref.core.assessment.cells import Cells, ground_cells
from semref.core.assessment.summary import brier_score, calibration
from semref.core.evaluation.trial import Query
from semref.core.localization import Method
from semref.core.simulation.label_errors import spoil_labels
from semref.core.simulation.noise import USUAL
from semref.core.simulation.views import View

PAGE = "benchmarks.md"
COUNT, QUICK_COUNT = 1000, 5
LEAST_SIMULATED = 50
"""Images that the assessment simulates are never fewer."""

SPACING, FOOTPRINT = 640.0, 1280.0
NOISE = {"MISSED": 20, "INVENTED": 20, "MISNAMED": 5, "RAGGED": 1}
"""That of ``USUAL``, as the algorithms are told."""

PREDICTED_SEED, FRESH_SEED = 1, 2
ROUTE = (
    (9.5060, 47.0680),
    (9.5250, 47.1030),
    (9.5180, 47.1420),
    (9.5320, 47.2150),
    (9.5720, 47.1750),
    (9.6050, 47.1150),
    (9.5620, 47.0720),
)
"""Longitude, latitude: Balzers, Triesen, Vaduz, Bendern; over the mountains Drei Schwestern, Malbun, Mittagspitz."""


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"assessment": "Not measured: the real data is not here."}
    folder = run.work / f"assessment_{machine.revision().replace(' ', '_')}"
    folder.mkdir(exist_ok=True)
    count = run.how_many(COUNT, QUICK_COUNT)
    simulated = max(count, LEAST_SIMULATED)
    squares = _assessed(run, folder, simulated)
    fresh = _fresh(run, folder, count)
    text = [_ABOUT.format(count=count, simulated=simulated), _compared(squares, fresh), _route(run, folder)]
    if run.pictures:
        from bench import assessment_pictures

        assessment_pictures.write(folder, run.pictures, _calibration(squares, fresh), len(fresh))
    return {"assessment": "\n\n".join(text)}


_ABOUT = """\
Images that show 1,280 m, 20 % of the landmarks missed, 20 % spurious, 5 % mislabeled, boundaries off by 1 m,
automatic. *Assess reference database* saw the database alone and simulated {simulated:,} images; then {count:,}
fresh images were cut from the *label map* anywhere on the ground. The expectation is that of the square an image's
center lies in."""


def _assessed(run: inputs.Run, folder: Path, count: int) -> list[dict]:
    """Rows of semref:assessdatabase, made unless an earlier run left them."""
    target = folder / f"squares_{count}.gpkg"
    if not target.exists():
        parameters = {
            "DATABASE": str(run.database(run.area.stride)),
            "FOOTPRINT": f"{FOOTPRINT:g}",
            "SPACING": SPACING,
            "TRIALS": count,
            "SEED": PREDICTED_SEED,
            "OUTPUT": str(target),
            **NOISE,
        }
        plugin.run_algorithm("assessdatabase", parameters)
    return rows_of(target)


def _fresh(run: inputs.Run, folder: Path, count: int) -> list[dict]:
    """What came of each fresh image, one JSON object a line in a file that a later run continues."""
    path = folder / "fresh.jsonl"
    done = [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []
    if len(done) < count:
        ground = Ground.of(run, half="")
        cells = ground_cells(ground.database, SPACING)
        with path.open("a") as file:
            for number in range(len(done), count):
                done.append(_fresh_image(number, ground, cells))
                file.write(json.dumps(done[-1]) + "\n")
    return done[:count]


def _fresh_image(number: int, ground: Ground, cells: Cells) -> dict:
    rng = np.random.default_rng([FRESH_SEED, number])
    place = cells.centers[rng.integers(len(cells))] + rng.uniform(-SPACING / 2, SPACING / 2, 2)
    references = ground.database.references.positions
    view, other = (_view(*at, rng) for at in (place, references[rng.integers(len(references))]))
    noise = USUAL.in_pixels(view.pixel_size)
    smallest = ground.database.parameters.minimum_area / view.pixel_size**2
    labels = spoil_labels(ground.cut(view), noise, rng, ground.spoiled_values, ground.cut(other), smallest)
    trial = ground.try_image(Image(Query(view), labels), Method.AUTOMATIC)
    at = {"x": view.x, "y": view.y}
    return {**at, "right": trial.is_right, "wrong": trial.is_wrong, "error": trial.error if trial.is_right else None}


def _view(x: float, y: float, rng: np.random.Generator) -> View:
    size = round(FOOTPRINT / inputs.PIXEL_SIZE)
    return View(float(x), float(y), float(rng.uniform(0, 360)), FOOTPRINT / size, size, size)


def rows_of(path: Path) -> list[dict]:
    """Attributes of each feature, with the center of its geometry's extent as ``at``."""
    from osgeo import ogr

    dataset, rows = ogr.Open(str(path)), []
    for feature in dataset.GetLayer(0):
        left, right, bottom, top = feature.GetGeometryRef().GetEnvelope()
        rows.append({**feature.items(), "at": ((left + right) / 2, (bottom + top) / 2)})
    return rows


def _predicted(squares: list[dict], fresh: list[dict]) -> list[dict]:
    """The square of each image."""
    centers = np.array([row["at"] for row in squares])
    return [squares[int(np.abs(centers - (one["x"], one["y"])).max(axis=1).argmin())] for one in fresh]


def _calibration(squares: list[dict], fresh: list[dict]) -> list:
    expected = np.array([square["success"] for square in _predicted(squares, fresh)])
    return calibration(expected, np.array([one["right"] for one in fresh], bool))


def _compared(squares: list[dict], fresh: list[dict]) -> str:
    """Predicted against measured success."""
    own = _predicted(squares, fresh)
    expected = np.array([square["success"] for square in own])
    right = np.array([one["right"] for one in fresh], bool)
    errors = [(square["error"], one["error"]) for square, one in zip(own, fresh) if one["right"] and square["error"]]
    told, met = np.median(np.array(errors or [(np.nan, np.nan)]), axis=0)
    good, base = np.mean([row["success"] >= 0.9 for row in squares]), float(right.mean())
    rows = [
        ["right fixes", f"{expected.mean():.1%}", page.rate(int(right.sum()), len(fresh))],
        ["wrong fixes", "–", page.rate(sum(one["wrong"] for one in fresh), len(fresh))],
        ["median error of right fixes", f"{told:.2f} m", f"{met:.2f} m"],
        ["Brier score", f"{brier_score(expected, right):.4f}", f"always the mean: {base * (1 - base):.4f}"],
    ]
    bins = [
        [f"{one.low:.0%}–{one.high:.0%}", f"{one.at:.1%}", page.rate(one.rate.successes, one.rate.trials)]
        for one in _calibration(squares, fresh)
    ]
    mean = np.mean([row["success"] for row in squares])
    return "\n\n".join(
        [
            f"{len(squares)} squares of {SPACING:g} m, {good:.1%} of the ground at 90 % or more, mean {mean:.1%}.",
            page.table(["", "expected", "measured"], rows),
            page.table(["predicted", "mean prediction", "right (95 %)"], bins),
        ]
    )


def _route(run: inputs.Run, folder: Path) -> str:
    """A route up the Rhine valley and over the mountains."""
    plan, target = folder / "route.plan", folder / "route.gpkg"
    items = [
        {"type": "SimpleItem", "command": 16, "frame": 3, "params": [0, 0, 0, None, latitude, longitude, 120]}
        for longitude, latitude in ROUTE
    ]
    plan.write_text(json.dumps({"fileType": "Plan", "mission": {"items": items}}), encoding="utf-8")
    if not target.exists():
        parameters = {
            "DATABASE": str(run.database(run.area.stride)),
            "ROUTE": str(plan),
            "SPEED": 20,
            "SPACING": 640,
            "TRIALS": 5,
            "OUTPUT": str(target),
            "REPORT": str(folder / "route.html"),
            **NOISE,
        }
        plugin.run_algorithm("assessroute", parameters)
    rows = rows_of(target)
    longest = max(row["gap"] for row in rows)
    good = np.mean([row["success"] >= 0.9 for row in rows])
    return (
        f"A route up the Rhine valley and back over the mountains (*Assess route*, a `.plan` file, points every 640 m, "
        f"20 m/s): {rows[-1]['along'] / 1000:.1f} km, {good:.0%} of {len(rows)} points at 90 % or more, longest "
        f"stretch without an expected fix {longest:,.0f} m = {longest / 20:.0f} s."
    )
