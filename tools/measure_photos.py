"""Measures the road from photo to fix: photo → segmentation network → label image → position. Prints Markdown.

    python tools/measure_photos.py sample [--model models/sample_area.onnx] [--trials 200]
    python tools/measure_photos.py dubai --model MODEL.onnx [--tile 6] [--trials 200]

``sample``: photos of the sample area (its seed is none of the model's training seeds), anywhere, any heading, 0.8 to
1.25 m a pixel; database of its true label map. ``dubai``: a tile of dubai_aerial ($SEMREF_DATA or ../shared/data) that
the model was not trained on: IoU a class, then turned crops of its photo, --trials of each edge, at 0.9 to 1.1 tile
pixels a pixel; database of its annotated labels, all classes as references. --truth localizes the true labels of the
same places too: what no network could improve. --rows FILE adds one JSON line a trial.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import sys
import time
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
from qgis_session import ROOT, load_plugin_package

load_plugin_package()
from semref.core.correlation.solver import localize as correlate  # noqa: E402
from semref.core.database.build import BuildSettings, DatabaseBuilder  # noqa: E402
from semref.core.evaluation.rates import wilson  # noqa: E402
from semref.core.geometry.frame import MapFrame  # noqa: E402
from semref.core.labels.class_table import class_table_from_csv  # noqa: E402
from semref.core.labels.image_source import ArrayImage  # noqa: E402
from semref.core.labels.sources import ArrayLabels  # noqa: E402
from semref.core.localization import Method, Prior, Status  # noqa: E402
from semref.core.localizer.localizer import Localizer  # noqa: E402
from semref.core.segmentation.model import SegmentationModel  # noqa: E402
from semref.core.segmentation.photo_labels import PhotoLabels  # noqa: E402

DATA = Path(os.environ.get("SEMREF_DATA") or ROOT.parent / "shared" / "data")
METHODS = (Method.CONSTELLATION.key, Method.MAP_CORRELATION.key, Method.AUTOMATIC.key)
RIGHT_SHARE = 0.02  # of the ground that the photo's edge shows
ELSEWHERE_SHARE = 0.1  # a fix farther off shows another place; between the two it is only inaccurate
SAMPLE_RIGHT_M = 10.0
CROP_EDGES = (384, 512, 640, 768)
CROP_PIXELS, SEARCHED_PIXELS = (0.9, 1.1), (0.7, 1.4)  # tile pixels a pixel of the crop: true, and looked for
DUBAI_CLASSES = (
    "value,name,color,role\n1,building,#3c1098,reference\n2,land_unpaved,#8429f6,reference\n3,road,#6ec1e4,reference\n"
    "4,vegetation,#fedd3a,reference\n5,water,#e2a929,reference\n"
)
HEADINGS = (
    "labels of",
    "edge (px)",
    "method",
    "right",
    "wrong",
    "of these elsewhere",
    "no fix",
    "best place right, fix or not",
    "median error (px)",
    "95 % radius holds",
    "median s",
)
STATE = {}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("sample", "dubai"))
    parser.add_argument("--model", type=Path, default=ROOT / "models" / "sample_area.onnx")
    parser.add_argument("--tile", type=int, default=6, help="of dubai_aerial; one the model has not seen")
    parser.add_argument("--trials", type=int, default=200)
    parser.add_argument("--methods", nargs="+", choices=METHODS, default=list(METHODS))
    parser.add_argument("--truth", action="store_true", help="localize the true labels too")
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1671)
    parser.add_argument("--rows", type=Path)
    options = parser.parse_args()
    cv2.setNumThreads(1)
    STATE["methods"], STATE["truth"] = options.methods, options.truth
    STATE["model"] = SegmentationModel(str(options.model), 1)
    prepare, jobs = {"sample": (prepare_sample, sample_jobs), "dubai": (prepare_dubai, dubai_jobs)}[options.what]
    prepare(options)
    rows = run(jobs(options), options)
    print_fixes(rows)


# --- the two areas ---


def prepare_sample(options) -> None:
    from semref.core.sample import photo, pictures
    from semref.core.sample.classes import CLASSES
    from semref.core.sample.landscape import make_landscape
    from semref.storage.sample_files import grid_of, rasterize

    landscape = make_landscape(options.seed)
    labels = rasterize(landscape, 1.0)
    STATE["photo"] = photo.render(landscape, grid_of(landscape, 1.0), 1.0)
    STATE["seed"] = options.seed
    STATE["views"] = pictures.plan_photos(labels.shape, options.seed, options.trials)
    classes = [f"{c.value},{c.name},{c.color},{c.role}" for c in CLASSES]
    set_database(labels, "\n".join(["value,name,color,role", *classes]), BuildSettings(640, 160, 50))
    predicted = segmented(STATE["photo"])
    print_iou(labels, predicted, "Sample area, whole photo; class 0 is “other” (roads, tracks)")


def sample_jobs(options) -> list:
    return [("sample", index) for index in range(options.trials)]


def prepare_dubai(options) -> None:
    from osgeo import gdal

    folder = DATA / "dubai_aerial"
    paths = [folder / f"tile{options.tile}_{kind}.tif" for kind in ("image", "label")]
    if not all(path.exists() for path in paths):
        sys.exit(f"measure_photos: no data at {folder}")
    image, labels = (gdal.Open(str(path)).ReadAsArray() for path in paths)
    STATE["photo"] = np.ascontiguousarray(np.moveaxis(image[:3], 0, 2))
    set_database(labels, DUBAI_CLASSES, BuildSettings(512, 128, 60))
    print_iou(labels, segmented(STATE["photo"]), f"dubai_aerial tile {options.tile}; unlabeled pixels don't count")


def dubai_jobs(options) -> list:
    rng = np.random.default_rng(options.seed)
    height, width = STATE["labels"].shape
    jobs = []
    for edge in CROP_EDGES:
        for _ in range(options.trials):
            heading, pixel = rng.uniform(0, 360), float(np.exp(rng.uniform(*np.log(CROP_PIXELS))))
            turn = np.radians(heading)
            reach = edge / 2 * pixel * (abs(np.cos(turn)) + abs(np.sin(turn))) + 1
            center = rng.uniform((reach, reach), (width - reach, height - reach))
            jobs.append(("dubai", edge, tuple(center), heading, pixel))
    return jobs


def set_database(labels: np.ndarray, classes_csv: str, settings: BuildSettings) -> None:
    """A database of the true labels, in pixels as units, and the model's classes in its table."""
    table = class_table_from_csv(classes_csv)
    frame = MapFrame("", (0.0, 1.0, 0.0, 0.0, 0.0, -1.0))
    builder = DatabaseBuilder(ArrayLabels(labels), frame, table, settings, "measured")
    for _ in builder.steps():
        pass
    STATE["labels"] = labels
    STATE["table"] = table
    STATE["values"] = STATE["model"].classes.values_in(table, "The model")
    STATE["localizer"] = OnceLocalizer(replace(builder.database, overview=builder.overview))


class OnceLocalizer(Localizer):
    """Correlates an image without prior position once, however many of the methods need it."""

    def __init__(self, database) -> None:
        super().__init__(database)
        self._labels, self._found, self.saved_seconds = None, None, 0.0

    def localize_by_map_correlation(self, labels_hw, prior=None):
        self.correlated(labels_hw, prior)
        return self._found

    def correlated(self, labels_hw, prior):
        """Map correlation's whole result; ``saved_seconds``: what it took, added to by every later answer."""
        if labels_hw is not self._labels:
            sizes = (
                prior.pixel_size_range if prior else self.pixel_sizes(labels_hw.shape, self.settings.correlation.scales)
            )
            started = time.perf_counter()
            self._labels, self._found = labels_hw, correlate(labels_hw, self.pyramid, sizes)
            self._seconds = time.perf_counter() - started
        else:
            self.saved_seconds += self._seconds
        return self._found


def segmented(photo: np.ndarray) -> np.ndarray:
    """(H, W) uint8 labels of a photo (H, W, 3), as semref:segmentimage makes them."""
    return PhotoLabels(STATE["model"], ArrayImage(photo), STATE["values"]).found()


# --- one trial ---


def run(jobs: list, options) -> list[dict]:
    if options.processes > 1:
        with multiprocessing.get_context("fork").Pool(options.processes) as pool:
            rows = [row for part in pool.map(trial, jobs, chunksize=4) for row in part]
    else:
        rows = [row for job in jobs for row in trial(job)]
    if options.rows:
        with options.rows.open("a", encoding="utf-8") as file:
            file.writelines(json.dumps(row) + "\n" for row in rows)
    return rows


def trial(job) -> list[dict]:
    """One photo localized by each method, from the network's labels and from the true ones; JSON rows."""
    if job[0] == "sample":
        from semref.core.sample import photo, pictures

        view = STATE["views"][job[1]]
        seen = photo.shoot(STATE["photo"], view, STATE["seed"])
        jpeg = cv2.imencode(".jpg", seen[:, :, ::-1], [cv2.IMWRITE_JPEG_QUALITY, 85])[1]
        seen = np.ascontiguousarray(cv2.imdecode(jpeg, cv2.IMREAD_COLOR)[:, :, ::-1])
        truth = pictures.cut(STATE["labels"], view)
        edge, center, ground = len(seen), (view.column, view.row), len(seen) * view.scale
        prior, limit = None, SAMPLE_RIGHT_M
    else:
        _, edge, center, heading, pixel = job
        seen = cut(STATE["photo"], center, heading, pixel, edge, cv2.INTER_LINEAR)
        truth = cut(STATE["labels"], center, heading, pixel, edge, cv2.INTER_NEAREST)
        ground = edge * pixel
        prior, limit = Prior(pixel_size_range=SEARCHED_PIXELS), RIGHT_SHARE * ground
    predicted = segmented(seen)
    known = truth > 0
    common = {"area": job[0], "edge": edge, "center": center, "agreement": float((predicted == truth)[known].mean())}
    rows = []
    for source, labels in (("network", predicted), ("truth", truth))[: 2 if STATE["truth"] else 1]:
        for method in STATE["methods"]:
            localizer = STATE["localizer"]
            started, localizer.saved_seconds = time.perf_counter(), 0.0
            found = localizer.localize(labels, method, prior)
            row = {
                **common,
                "labels": source,
                "method": method,
                "status": found.status.key,
                "reason": str(found.reason or ""),
            }
            row["seconds"] = time.perf_counter() - started + localizer.saved_seconds
            row["error_95"] = found.error_95_m
            place = found.position
            if method == Method.MAP_CORRELATION:
                correlated = localizer.correlated(labels, prior)
                if correlated.peaks is not None:
                    row.update(vars(correlated.peaks))
                # Where it would have put the photo, had it not refused: tells a poor search from a careful decision.
                place, row["error_95"] = correlated.best and correlated.best.position, correlated.error_95_m
            if place is not None:
                row["error"] = float(np.hypot(place[0] - center[0], place[1] + center[1]))
                row["right"] = bool(row["error"] <= limit)
                row["elsewhere"] = bool(row["error"] > ELSEWHERE_SHARE * ground)
            rows.append(row)
    return rows


def cut(raster: np.ndarray, center_xy, heading_deg: float, pixel: float, edge: int, sampling: int) -> np.ndarray:
    """What a camera over ``center_xy`` (pixels of the tile) sees, top towards the heading; real ground only."""
    turn = np.radians(heading_deg)
    matrix = pixel * np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    offset = np.asarray(center_xy) - 0.5 - matrix @ np.full(2, (edge - 1) / 2)
    flags = sampling | cv2.WARP_INVERSE_MAP
    return cv2.warpAffine(raster, np.column_stack([matrix, offset]), (edge, edge), flags=flags)


# --- what is printed ---


def print_iou(labels: np.ndarray, predicted: np.ndarray, title: str) -> None:
    """Intersection over union a class; 0 counts only as what the network may answer where a class is."""
    known = labels > 0
    print(f"\n### {title}\n\n| class | share of the ground | IoU |\n|---|---|---|")
    found = []
    for entry in STATE["table"]:
        truth, answer = labels == entry.value, (predicted == entry.value) & known
        either = (truth | answer).sum()
        found.append((truth & answer).sum() / max(either, 1))
        print(f"| {entry.name} | {truth.mean():.1%} | {found[-1]:.3f} |")
    print(f"| mean | | {np.mean(found):.3f} |")
    print(f"\nPixels with the right class: {(predicted == labels)[known].mean():.1%}")


def print_fixes(rows: list[dict]) -> None:
    print(f"\n| {' | '.join(HEADINGS)} |\n|{'---|' * len(HEADINGS)}")
    edges = sorted({row["edge"] for row in rows})
    for source in sorted({row["labels"] for row in rows}):
        for chosen in [[edge] for edge in edges] + ([edges, [e for e in edges if e >= 512]] if len(edges) > 1 else []):
            for method in STATE["methods"]:
                group = [r for r in rows if r["labels"] == source and r["method"] == method and r["edge"] in chosen]
                print(f"| {source} | {', '.join(map(str, chosen))} | {method} | {summary(group)} |")


def summary(group: list[dict]) -> str:
    """The numbers of one row of the table."""
    fixes = [row for row in group if row["status"] == Status.FIX]
    right = [row for row in fixes if row["right"]]
    errors = f"{np.median([row['error'] for row in right]):.1f}" if right else "–"
    here = [row for row in fixes if not row["elsewhere"]]
    held = rate(sum(row["error"] <= row["error_95"] for row in here), len(here)) if here else "–"
    best = rate(sum(row.get("right", False) for row in group), len(group))
    return (
        f"{rate(len(right), len(group))} | {rate(len(fixes) - len(right), len(group))} | "
        f"{sum(row['elsewhere'] for row in fixes)} | {len(group) - len(fixes)} | "
        f"{best if group[0]['method'] == Method.MAP_CORRELATION else '–'} | {errors} | {held} | "
        f"{np.median([row['seconds'] for row in group]):.2f}"
    )


def rate(hits: int, count: int) -> str:
    """Count and share with its 95 % interval."""
    low, high = wilson(hits, count)
    return f"{hits}/{count} = {hits / count:.1%} ({100 * low:.1f}–{100 * high:.1f})"


if __name__ == "__main__":
    main()
