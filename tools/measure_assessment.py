"""Measures assessments on Liechtenstein 2021: predicted against measured success, the map, a route; prints Markdown.

    python tools/measure_assessment.py [--trials 1000] [--simulated 1000] [--automatic 0] [--pictures FOLDER]
                                       [--keep FOLDER]

semref:assessdatabase predicts from the database alone (seed 1). Fresh images (seed 2) are cut from the *label map*,
anywhere on the ground, at any heading, spoilt as labels (landmarks missed, drawn in, misnamed; edges moved) and
localized by the constellation, or with --automatic by both methods: what was predicted for their square is compared
with what came of them. Then a route up the Rhine valley and over the mountains. --pictures writes the pictures of the
documentation. Reads $SEMREF_DATA or ../shared/data; --keep holds what was made, and goes on where a run was broken off.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
import time
from pathlib import Path

import measure_onboard as onboard
import numpy as np
from qgis_session import qgis_session

SPACING, FOOTPRINT = 640.0, 1280.0
NOISE = {"MISSED": 20, "INVENTED": 20, "MISNAMED": 5, "RAGGED": 1}
PREDICTED_SEED, FRESH_SEED = 1, 2
LARGEST_IMAGE_PX = 2000
MAP_PX = 760, 960
"""Size of the map's picture, with its legend."""
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


def main() -> int:
    options = parse()
    if not onboard.LAYER.exists():
        print(f"measure_assessment: the real data is not here: {onboard.LAYER}")
        return 0
    onboard.cv2.setNumThreads(1)
    with tempfile.TemporaryDirectory() as folder, qgis_session():
        work = Path(options.keep or folder)
        work.mkdir(parents=True, exist_ok=True)
        labels = onboard.label_map(work)
        database = onboard.database(labels, work)
        for automatic, count in ((False, options.trials), (True, options.automatic)):
            if count:
                fresh = fresh_trials(work, labels, database, count, automatic)
                cells = assessed(work, database, options.simulated, automatic)
                print_calibration(cells, fresh, automatic, options.pictures)
        assess_route(work, database)
        if options.pictures:
            map_picture(work, database, Path(options.pictures))
            route_picture(work, Path(options.pictures))
    return 0


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--trials", type=int, default=1000, help="fresh images by the constellation")
    parser.add_argument("--automatic", type=int, default=0, help="fresh images by both methods; seconds each")
    parser.add_argument("--simulated", type=int, default=1000, help="images that the assessment simulates")
    parser.add_argument("--pictures", help="folder for the pictures of the documentation")
    parser.add_argument("--keep", help="folder for what is made; what is there already is used again")
    return parser.parse_args()


# --- fresh images of the label map ---


def fresh_trials(work: Path, labels: Path, database: Path, count: int, automatic: bool) -> list:
    """(x, y, status, right, error) of each image, one JSON object a line in a file that a later run continues."""
    from osgeo import gdal

    from semref.core.assessment.cells import ground_cells
    from semref.core.labels.sources import ArrayLabels
    from semref.core.localization import Method
    from semref.core.localizer.localizer import Localizer
    from semref.storage.database.reader import read_database

    path = work / f"fresh_{'automatic' if automatic else 'constellation'}.jsonl"
    done = [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []
    if len(done) < count:
        found = read_database(str(database), with_overview=True)
        cells, localizer = ground_cells(found, SPACING), Localizer(found)
        source = ArrayLabels(gdal.Open(str(labels)).ReadAsArray())
        method = Method.AUTOMATIC if automatic else Method.CONSTELLATION
        with path.open("a") as file:
            for number in range(len(done), count):
                done.append(fresh_trial(number, source, found, localizer, cells, method))
                file.write(json.dumps(done[-1]) + "\n")
                file.flush()
    return done[:count]


def fresh_trial(number: int, source, database, localizer, cells, method: str) -> dict:
    """One image: where it was cut, and what came of it."""
    from semref.core.simulation.noise import LabelNoise, spoil_labels
    from semref.core.simulation.views import cut

    frame = database.parameters.frame
    rng = np.random.default_rng([FRESH_SEED, number])
    x, y = cells.centers[rng.integers(len(cells))] + rng.uniform(-SPACING / 2, SPACING / 2, 2)
    view = view_at(database, x, y, float(rng.uniform(0, 360)))
    values = database.class_table.reference_values
    noise = LabelNoise(NOISE["MISSED"] / 100, NOISE["INVENTED"] / 100, NOISE["MISNAMED"] / 100, NOISE["RAGGED"])
    other = database.references.positions[rng.integers(len(database.references))]
    donor = cut(source, frame, view_at(database, *other, float(rng.uniform(0, 360))))
    smallest = database.parameters.minimum_area / view.pixel_size**2
    image = cut(source, frame, view)
    image = spoil_labels(image, noise.in_pixels(view.pixel_size), rng, values, donor, smallest)
    started = time.process_time()
    found = localizer.localize(image, method)
    seconds = time.process_time() - started
    error = float(np.hypot(found.position[0] - x, found.position[1] - y)) if found.status == "fix" else None
    right = error is not None and error <= 0.02 * FOOTPRINT
    return {
        "x": float(x),
        "y": float(y),
        "status": found.status,
        "right": right,
        "error": error,
        "seconds": seconds,
        "references": int(found.references),
    }


def view_at(database, x: float, y: float, heading_deg: float):
    from semref.core.simulation.views import View

    size = min(round(FOOTPRINT / database.parameters.pixel_size), LARGEST_IMAGE_PX)
    return View(float(x), float(y), heading_deg, FOOTPRINT / size, size, size)


# --- what the assessment predicted ---
def assessed(work: Path, database: Path, simulated: int, automatic: bool) -> list:
    """Rows of semref:assessdatabase, made unless an earlier run left them."""
    target = work / f"assessment_{'automatic' if automatic else 'constellation'}_{simulated}.gpkg"
    started, used = time.monotonic(), time.process_time()
    fresh = not target.exists()
    parameters = {
        "DATABASE": str(database),
        "FOOTPRINT": f"{FOOTPRINT:g}",
        "SPACING": SPACING,
        "TRIALS": simulated,
        "SEED": PREDICTED_SEED,
        "MAP_CORRELATION": automatic,
        "REPORT": str(target.with_suffix(".html")),
        **NOISE,
    }
    onboard.run("assessdatabase", target, "OUTPUT", parameters)
    rows = rows_of(target)
    good = np.mean([row["success"] >= 0.9 for row in rows])
    mean = np.mean([row["success"] for row in rows])
    print(f"\n{target.stem}: {len(rows)} squares, {good:.1%} of the ground at 90 % or more, mean {mean:.1%}", end="")
    if fresh:
        print(f"; {time.process_time() - used:.0f} s of processor, {time.monotonic() - started:.0f} s", end="")
    print(".", flush=True)
    return rows


def rows_of(path: Path) -> list:
    """Attributes of each feature, with the center of its geometry's extent as ``at``."""
    from osgeo import gdal

    dataset, rows = gdal.OpenEx(str(path)), []
    for feature in dataset.GetLayer(0):
        left, right, bottom, top = feature.GetGeometryRef().GetEnvelope()
        rows.append({**feature.items(), "at": ((left + right) / 2, (bottom + top) / 2)})
    return rows


def print_calibration(cells: list, fresh: list, automatic: bool, pictures: str) -> None:
    """Predicted against measured success as a table, and as a picture."""
    from semref.core.assessment.summary import brier_score, calibration
    from semref.core.evaluation.rates import rate_of
    from semref.processing.reports.page import rate_text

    method = "automatic" if automatic else "constellation"
    centers = np.array([row["at"] for row in cells])
    nearest = [int(np.abs(centers - (one["x"], one["y"])).max(axis=1).argmin()) for one in fresh]
    predicted = np.array([cells[n]["success"] for n in nearest])
    right = np.array([one["right"] for one in fresh], bool)
    wrong = rate_of(one["status"] == "fix" and not one["right"] for one in fresh)
    base = float(right.mean())
    print(f"\n### {method}: {len(fresh)} fresh images\n")
    print(f"Right {rate_text(rate_of(right.tolist()))}, predicted {predicted.mean():.1%}; ", end="")
    print(f"wrong {rate_text(wrong)}. ", end="")
    print(f"Brier score {brier_score(predicted, right):.4f} (always the mean: {base * (1 - base):.4f}).")
    errors = [(cells[n]["error"], one["error"]) for n, one in zip(nearest, fresh) if one["right"] and cells[n]["error"]]
    if errors:
        told, met = np.array(errors).T
        print(f"Median error of right fixes {np.median(met):.2f} m, expected {np.median(told):.2f} m.")
    print("\n| predicted | images | mean prediction | right (95 %) |\n|---|---:|---:|---:|")
    found = calibration(predicted, right)
    for one in found:
        print(f"| {one.low:.0%}–{one.high:.0%} | {one.rate.trials} | {one.at:.1%} | {rate_text(one.rate)} |")
    if pictures:
        reliability_picture(found, method, len(fresh), Path(pictures) / "assessment_reliability.svg")


def reliability_picture(found: list, method: str, count: int, path: Path) -> None:
    from semref.processing.reports import charts
    from semref.processing.reports.assessment_report import series_of

    if method != "constellation":
        return
    title = f"{count} fresh images, cut from the label map"
    chart = charts.reliability_diagram([series_of(title, found)], "predicted success", "right fixes", title)
    path.write_text(standing_alone(chart), encoding="utf-8")


def standing_alone(svg: str) -> str:
    """A report's chart with the colors of the report's page inside, as a file of its own."""
    colors = {
        "--ground": "#ffffff",
        "--text": "#1c2126",
        "--soft": "#5d6770",
        "--line": "#d5dade",
        "--s0": "#0067a5",
        "--s1": "#c65102",
        "--bad": "#b3261e",
    }
    for name, color in colors.items():
        svg = svg.replace(f"var({name})", color)
    style = "<style>text{font:12px sans-serif;fill:#1c2126} .soft{fill:#5d6770}</style>"
    background = '<rect width="100%" height="100%" fill="#ffffff"/>'
    head, _, body = svg.partition(">\n")
    return f"{head}>\n{style}{background}\n{body}\n"


# --- a route ---


def assess_route(work: Path, database: Path) -> None:
    import processing
    from qgis.core import QgsProcessingFeedback

    route = work / "route.plan"
    items = [
        {"type": "SimpleItem", "command": 16, "frame": 3, "params": [0, 0, 0, None, latitude, longitude, 120]}
        for longitude, latitude in ROUTE
    ]
    route.write_text(json.dumps({"fileType": "Plan", "mission": {"items": items}}), encoding="utf-8")
    target, feedback = work / "route.gpkg", QgsProcessingFeedback(False)
    if not target.exists():
        parameters = {
            "DATABASE": str(database),
            "ROUTE": str(route),
            "SPEED": 20,
            "SPACING": 640,
            "TRIALS": 5,
            "OUTPUT": str(target),
            "REPORT": str(work / "route.html"),
            **NOISE,
        }
        processing.run("semref:assessroute", parameters, feedback=feedback)
        (work / "route.log").write_text(feedback.textLog(), encoding="utf-8")
    rows = rows_of(target)
    longest = max(row["gap"] for row in rows)
    good = np.mean([row["success"] >= 0.9 for row in rows])
    length = rows[-1]["along"] / 1000
    print(f"\nRoute of {length:.1f} km, {len(rows)} points, {good:.0%} of them at 90 % or more; ", end="")
    print(f"longest gap {longest:.0f} m ({longest / 20:.0f} s at 20 m/s).\n\n{(work / 'route.log').read_text()}")


# --- pictures ---


def map_picture(work: Path, database: Path, folder: Path) -> None:
    """The assessment in its own style, the route upon it, with the legend of the style."""
    from qgis.core import QgsMapRendererParallelJob, QgsMapSettings, QgsVectorLayer
    from qgis.PyQt.QtCore import QRectF, QSize, Qt
    from qgis.PyQt.QtGui import QColor, QFont, QPainter

    source = next(iter(sorted(work.glob("assessment_constellation_*.gpkg"))))
    squares = QgsVectorLayer(str(source), "expected success", "ogr")
    route = QgsVectorLayer(str(work / "route.gpkg"), "points along a route", "ogr")
    settings = QgsMapSettings()
    settings.setLayers([route, squares])
    settings.setDestinationCrs(squares.crs())
    extent = squares.extent()
    extent.grow(SPACING)
    height = MAP_PX[1]
    width = round(height * extent.width() / extent.height())
    settings.setExtent(extent)
    settings.setOutputSize(QSize(width, height))
    settings.setOutputDpi(110)
    settings.setBackgroundColor(QColor("#ffffff"))
    job = QgsMapRendererParallelJob(settings)
    job.start()
    job.waitForFinished()
    picture = job.renderedImage().copy(0, 0, MAP_PX[0], height)
    painter = QPainter(picture)
    painter.fillRect(QRectF(width, 0, MAP_PX[0] - width, height), QColor("#ffffff"))
    texts = ["Expected success of images", "that show 1,280 m; circles:", "points along a route", ""]
    ranges = [(one.label(), one.symbol().color()) for one in squares.renderer().ranges()]
    painter.setFont(QFont("sans-serif", 9))
    for row, text in enumerate(texts + [label for label, _ in ranges]):
        color = ranges[row - len(texts)][1] if row >= len(texts) else None
        if color:
            painter.fillRect(QRectF(width + 14, 30 + 24 * row, 24, 16), color)
        left = width + (46 if color else 14)
        painter.drawText(QRectF(left, 26 + 24 * row, MAP_PX[0] - left, 24), Qt.AlignmentFlag.AlignVCenter, text)
    painter.end()
    picture.save(str(folder / "assessment_liechtenstein.png"))


def route_picture(work: Path, folder: Path) -> None:
    """The profile out of the route's report."""
    text = (work / "route.html").read_text(encoding="utf-8")
    start = text.index("<svg")
    profile = text[start : text.index("</svg>", start) + len("</svg>")]
    (folder / "assessment_route.svg").write_text(standing_alone(profile), encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
