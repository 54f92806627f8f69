"""Measures map correlation on real maps and prints Markdown tables.

    python tools/measure_correlation.py country [--half north|south] [--trials 100] [--elsewhere 100]
    python tools/measure_correlation.py aerial [--trials 60]
    python tools/measure_correlation.py times [--trials 12]
    python tools/measure_correlation.py radius [--half north|south] [--trials 50]
    python tools/measure_correlation.py automatic [--half north|south] [--trials 200] [--elsewhere 150] [--evidence]

Reads $SEMREF_DATA or ../shared/data. ``country``: Liechtenstein 2021 at 1 m, overview 4 m, images of 1,280 px at 0.8 to
1.25 m with any heading, labels degraded (core/simulation/noise.py); the map is the whole country, the images come
from one half of it (thresholds were fitted on the northern, the southern is the test). False accepts: images from the
other half
on a map of one half only, and mirrored images. ``aerial``: the annotated tiles of dubai_aerial, turned crops off any
grid. ``automatic``: METHOD 0 on Liechtenstein, with a database whose landmarks are buildings, bare land and
water from 100 m² on: objects missed, invented and misnamed, 8 to 12 objects, degraded labels; false accepts as for
``country``, as many of each kind as ``--elsewhere``. ``--evidence`` also records what each road says of the other's
best place, which sets ``LocalizerSettings``.
``radius``: errors of poses refined from beside the right place, on the country and on the aerial tiles, against their
deviation, which set the 95 % radius. ``--rows FILE`` adds
one JSON line a trial, from which ``fit`` proposes the decision's part of ``CorrelationSettings``.
"""

from __future__ import annotations

import argparse
import dataclasses
import importlib.util
import json
import multiprocessing
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import cv2
import numpy as np

ROOT = Path(__file__).resolve().parent.parent
DATA = Path(os.environ.get("SEMREF_DATA") or ROOT.parent / "shared" / "data")
FOOTPRINT_PX = 1280
RIGHT_SHARE = 0.02  # of the footprint
STRIP = 1200
FIX_SCORE = 0.38  # fixes have more: chance gives 0.25 and they lead by 0.13
LEAST_LABELED = 0.7  # of an image: the rest lies over the border
MINIMUM_AREA_M2 = 100.0
AERIAL_PIXEL_M = 0.5  # assumed; the tiles state none
STATE = {}


def load_package() -> None:
    spec = importlib.util.spec_from_file_location(
        "semref", ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    package = importlib.util.module_from_spec(spec)
    sys.modules["semref"] = package
    spec.loader.exec_module(package)


load_package()
from semref.core.constellation import solver as constellation  # noqa: E402
from semref.core.correlation.class_pyramid import MapPyramid  # noqa: E402
from semref.core.correlation.decision import position_error_95  # noqa: E402
from semref.core.correlation.places import (  # noqa: E402
    finest_pose,
    image_evidence,
    reduced_image,
)
from semref.core.correlation.refine import ScoredPose, axes, refine  # noqa: E402
from semref.core.correlation.settings import CORRELATION  # noqa: E402
from semref.core.correlation.solver import agreement_at, localize  # noqa: E402
from semref.core.database.build import BuildSettings, DatabaseBuilder  # noqa: E402
from semref.core.evaluation.rates import wilson  # noqa: E402
from semref.core.geometry.frame import MapFrame  # noqa: E402
from semref.core.labels.class_table import ClassTable, LandCoverClass  # noqa: E402
from semref.core.labels.overview import most_frequent_labels  # noqa: E402
from semref.core.labels.sources import ArrayLabels  # noqa: E402
from semref.core.landmarks.landmarks import extract_landmarks  # noqa: E402
from semref.core.localization import CorrelationPeaks, Method, Prior  # noqa: E402
from semref.core.localizer.localizer import Localizer  # noqa: E402
from semref.core.simulation.noise import MODEST, STRONG, LabelNoise, spoil_labels  # noqa: E402

OVERVIEW_FRAME = MapFrame.at((0.0, 0.0), 4.0)

OBJECT_CLASSES = (1, 2, 3)  # building, bare land, water
OBJECT_NOISE = LabelNoise(missed=0.2, spurious=0.2, mislabeled=0.05)
FEW_OBJECTS = (8, 12)
AUTOMATIC_KINDS = ("objects", "few objects", "modest", "strong")
NOISES = {"true labels": None, "modest": MODEST, "strong": STRONG}


def read_labels(path: Path) -> np.ndarray:
    from osgeo import gdal

    return gdal.Open(str(path)).ReadAsArray()


def country_labels() -> np.ndarray:
    """(H, W) uint8: Liechtenstein's classes at 1 m, rasterized in the order of zorder."""
    shape = DATA / "osm_liechtenstein_2021" / "li_landcover_2021.shp"
    if not shape.exists():
        sys.exit(f"measure_correlation: no data at {shape}")
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "labels.tif"
        select = "SELECT * FROM li_landcover_2021 ORDER BY zorder"
        command = ["gdal_rasterize", "-q", "-a", "class_id", "-tr", "1", "1", "-ot", "Byte", "-sql", select]
        subprocess.run([*command, str(shape), str(target)], check=True)
        return read_labels(target)


def cut_image(labels: np.ndarray, center_xy, heading_deg: float, pixel: float, size_wh) -> np.ndarray:
    """The image a camera over ``center_xy`` (pixels of the map) would see; outside the map is 0."""
    turn = np.radians(heading_deg)
    matrix = pixel * np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    offset = np.asarray(center_xy) - matrix @ ((np.array(size_wh) - 1) / 2) - 0.5
    flags = cv2.INTER_NEAREST | cv2.WARP_INVERSE_MAP
    return cv2.warpAffine(labels, np.column_stack([matrix, offset]), size_wh, flags=flags, borderValue=0)


def random_image(labels, rng, rows, size_wh, pixels, least_labeled):
    """An image from between two rows of the map: labels, center, heading, pixel size."""
    while True:
        center = rng.uniform(0, labels.shape[1]), rng.uniform(*rows)
        heading, pixel = rng.uniform(0, 360), float(np.exp(rng.uniform(*np.log(pixels))))
        image = cut_image(labels, center, heading, pixel, size_wh)
        if (image > 0).mean() >= least_labeled:
            return image, center, heading, pixel


def spoiled(labels: np.ndarray, pixel_m: float, noise: LabelNoise, seed: int) -> np.ndarray:
    """A label image as a poor network would give it; its landmarks are buildings."""
    return spoil_labels(labels, noise.in_pixels(pixel_m), np.random.default_rng(seed), (1,))


def trial(job) -> dict:
    """One image localized; a JSON row."""
    kind, noise_name, seed, prior_m = job
    rng = np.random.default_rng([seed, len(kind)])
    labels, size, pixels = STATE["labels"], STATE["size"], STATE["pixels"]
    rows = STATE["rows"][kind]
    if size is None:
        edge = int(rng.choice([384, 512, 640, 768]))
        size_wh = (edge, edge)
    else:
        size_wh = (size, size)
    source = labels[:, ::-1] if kind == "mirrored" else labels
    image, center, heading, pixel = random_image(
        np.ascontiguousarray(source), rng, rows, size_wh, pixels, STATE["least"]
    )
    noise = NOISES[noise_name]
    meters = STATE["meters"]
    if noise is not None:
        image = spoiled(image, pixel * meters, noise, seed)
    prior = Prior(pixel_size_range=STATE["search"])
    if prior_m:
        away = rng.uniform(-0.7, 0.7, 2) * prior_m
        position = center[0] + away[0], -center[1] + away[1]
        prior = Prior(position, prior_m, pixel_size_range=STATE["search"])
    started, cpu = time.perf_counter(), time.process_time()
    pyramid = STATE["pyramids"][kind]
    pyramid.settings = dataclasses.replace(CORRELATION, threads=STATE["threads"])
    found = localize(image, pyramid, prior)
    row = {
        "kind": kind,
        "noise": noise_name,
        "seed": seed,
        "size": size_wh[0],
        "status": found.status,
        **_peaks(found),
        "confidence": found.confidence,
        "seconds": time.perf_counter() - started,
        "cpu": time.process_time() - cpu,
        "footprint": size_wh[0] * pixel,
    }
    if found.best is not None:
        best = found.best
        row["error"] = float(np.hypot(best.position[0] - center[0], best.position[1] + center[1]))
        row["heading_error"] = abs((best.heading_deg - heading + 180) % 360 - 180)
        row["scale_error"] = abs(best.pixel_size_m / pixel - 1)
        row["error_95"] = found.error_95_m
        row["deviation"] = _deviation(found)
    return row


def _peaks(found) -> dict:
    """Scores of the best place, the best other one and the mirrored image's; 0 without any."""
    return vars(found.peaks or CorrelationPeaks(0.0, 0.0, 0.0))


def _deviation(found) -> float:
    """Standard deviation of the position along its longer axis."""
    return float(np.sqrt(max(np.linalg.eigvalsh(np.array(found.covariance.position)).max(), 0)))


def read_halves(half: str):
    """The country's labels; rows of the half and of the other one; the labels without what images of the other half
    show: they never reach over the middle by more than their half diagonal."""
    labels = country_labels()
    middle = labels.shape[0] // 2
    halves = {"north": (0, middle), "south": (middle, labels.shape[0])}
    other = {"north": "south", "south": "north"}[half]
    lonely = labels.copy()
    if half == "north":
        lonely[middle - STRIP :] = 0
    else:
        lonely[: middle + STRIP] = 0
    return labels, halves[half], halves[other], lonely


def radius_trial(job) -> dict:
    """A pose refined from beside the right place, as the search leaves it, without the search; a JSON row."""
    noise_name, seed = job
    rng = np.random.default_rng([seed, 95])
    edge = STATE["size"] or int(rng.choice([384, 512, 640, 768]))
    labels, center, heading, pixel = random_image(
        STATE["labels"], rng, STATE["rows"]["right"], (edge, edge), STATE["pixels"], STATE["least"]
    )
    labels = spoiled(labels, pixel * STATE["meters"], NOISES[noise_name], seed)
    pyramid = STATE["pyramids"]["right"]
    image = image_evidence(labels, pyramid)
    coarse = CORRELATION.coarse_edge
    off = rng.uniform(-0.5, 0.5, 4) * (edge * pixel / coarse, edge * pixel / coarse, CORRELATION.turn_step_deg, 1)
    pose = ScoredPose(
        center[0] + off[0], center[1] + off[1], heading + off[2], pixel * CORRELATION.scale_step ** off[3]
    )
    for edge_px in (coarse, CORRELATION.decision_edge):
        pose = refine(reduced_image(image, edge_px), pyramid, pose, pyramid.quiet, 4)
    finest, covariance = finest_pose(image, pyramid, pose)
    spread = axes(finest) @ covariance[:2, :2] @ axes(finest).T
    return {
        "noise": noise_name,
        "score": pose.score,
        "footprint": edge * pixel,
        "error": float(np.hypot(finest.x - center[0], finest.y - center[1])),
        "deviation": float(np.sqrt(np.linalg.eigvalsh(spread).max())),
        "error_95": position_error_95(spread, pose.score, pyramid.frame.pixel_size),
    }


def prepare_country(half: str) -> None:
    """Maps of the whole country and of one half; images come from ``half``."""
    labels, rows, other, lonely = read_halves(half)
    overview, lonely = most_frequent_labels(labels), most_frequent_labels(lonely)
    whole = MapPyramid(overview, OVERVIEW_FRAME)
    STATE.update(
        labels=labels, size=FOOTPRINT_PX, pixels=(0.8, 1.25), search=(0.7, 1.4), meters=1.0, least=LEAST_LABELED
    )
    STATE["rows"] = {"right": rows, "elsewhere": other, "mirrored": rows}
    STATE["pyramids"] = {"right": whole, "elsewhere": MapPyramid(lonely, OVERVIEW_FRAME), "mirrored": whole}


def prepare_aerial(tile: Path) -> None:
    labels = np.ascontiguousarray(read_labels(tile))
    pyramid = MapPyramid(most_frequent_labels(labels), OVERVIEW_FRAME)
    STATE.update(labels=labels, size=None, pixels=(0.9, 1.1), search=(0.7, 1.4), meters=AERIAL_PIXEL_M, least=0.9)
    STATE["rows"] = {"right": (0, labels.shape[0]), "mirrored": (0, labels.shape[0])}
    STATE["pyramids"] = {"right": pyramid, "mirrored": pyramid}


def prepare_automatic(half: str) -> None:
    """Databases of the whole country and of one half; images come from ``half``."""
    labels, rows, other, lonely = read_halves(half)
    whole = country_localizer(labels)
    STATE.update(labels=labels, whole=whole, rows={"elsewhere": other}, half=rows)
    STATE["localizers"] = {"elsewhere": country_localizer(lonely)}


def country_localizer(labels: np.ndarray) -> Localizer:
    """Of a database as ``builddatabase`` would make it; y of the map is minus the row."""
    names = ("building", "bare_land", "water", "forest", "cultivated", "grass_scrub", "built_up")
    table = ClassTable(
        tuple(
            LandCoverClass(value, name, "#808080", "reference" if value in OBJECT_CLASSES else "background")
            for value, name in enumerate(names, 1)
        )
    )
    settings = BuildSettings(FOOTPRINT_PX, FOOTPRINT_PX, MINIMUM_AREA_M2)
    frame = MapFrame("", (0.0, 1.0, 0.0, 0.0, 0.0, -1.0))
    builder = DatabaseBuilder(ArrayLabels(labels), frame, table, settings, "0")
    for _ in builder.steps():
        pass
    localizer = Localizer(dataclasses.replace(builder.database, overview=builder.overview))
    localizer.index, localizer.pyramid  # noqa: B018 - made here, once for all processes
    return localizer


def automatic_image(kind: str, seed: int):
    """An image of one kind, its center (pixels of the map), heading and pixel size."""
    rng = np.random.default_rng([seed, *kind.encode()])
    rows, labels = STATE["rows"].get(kind, STATE["half"]), STATE["labels"]
    size = FOOTPRINT_PX, FOOTPRINT_PX
    while True:
        image, center, heading, pixel = random_image(labels, rng, rows, size, (0.8, 1.25), LEAST_LABELED)
        if kind != "few objects" or FEW_OBJECTS[0] <= whole_objects(image, pixel) <= FEW_OBJECTS[1]:
            break
    if kind == "mirrored":
        image = np.ascontiguousarray(image[:, ::-1])
    noise = kind if kind in NOISES else ("objects", "modest", "strong")[seed % 3]
    if kind in ("few objects", "objects"):
        noise = "objects"
    if noise == "objects":
        donor, _, _, _ = random_image(labels, rng, rows, size, (pixel, pixel), LEAST_LABELED)
        least = MINIMUM_AREA_M2 / pixel**2
        image = spoil_labels(image, OBJECT_NOISE, rng, OBJECT_CLASSES, donor, least)
    else:
        image = spoiled(image, pixel, NOISES[noise], seed)
    return image, center, heading, pixel


def whole_objects(image: np.ndarray, pixel: float) -> int:
    return int((~extract_landmarks(image, OBJECT_CLASSES, MINIMUM_AREA_M2 / pixel**2).touches_edge).sum())


def automatic_trial(job) -> dict:
    """One image localized by METHOD 0; a JSON row."""
    kind, seed, with_evidence = job
    image, center, heading, pixel = automatic_image(kind, seed)
    localizer = STATE["localizers"].get(kind, STATE["whole"])

    def error(position) -> float:
        return float(np.hypot(position[0] - center[0], position[1] + center[1]))

    started = time.perf_counter()
    found = localizer.localize(image, Method.AUTOMATIC)
    row = {
        "kind": kind,
        "seed": seed,
        "status": found.status,
        "method": found.method,
        "reason": str(found.reason or ""),
    }
    row.update(seconds=time.perf_counter() - started, footprint=FOOTPRINT_PX * pixel, confidence=found.confidence)
    if found.position is not None:
        row.update(error=error(found.position), error_95=found.error_95_m)
        row["heading_error"] = abs((found.heading_deg - heading + 180) % 360 - 180)
        row["scale_error"] = abs(found.pixel_size_m / pixel - 1)
    if with_evidence:
        row["evidence"] = both_evidences(localizer, image, error)
    return row


def both_evidences(localizer: Localizer, image: np.ndarray, error) -> dict:
    """What each road says of its own best place and of the other's, fix or not."""
    smallest = max(MINIMUM_AREA_M2 / 2.5**2, 9.0)
    objects = extract_landmarks(image, OBJECT_CLASSES, smallest)
    sizes = localizer.pixel_sizes(image.shape, (0.4, 2.5))
    stars = constellation.localize(
        objects, *image.shape[::-1], localizer.index, Prior(pixel_size_range=sizes), smallest
    )
    evidence = {"constellation": stars.status, "confidence": stars.confidence}
    if stars.best is not None:
        place = stars.best
        evidence.update(log_odds=place.log_odds, inliers=place.inliers, constellation_error=error(place.position))
        evidence["agreement"] = agreement_at(image, localizer.pyramid, place)
    prior = Prior(pixel_size_range=localizer.pixel_sizes(image.shape, (0.7, 1.4)))
    areas = localize(image, localizer.pyramid, prior)
    evidence.update(correlation=areas.status, **_peaks(areas))
    if areas.best is not None:
        evidence.update(correlation_error=error(areas.best.position), error_95=areas.error_95_m)
        evidence["deviation"] = _deviation(areas)
    return evidence


def print_automatic(rows: list[dict], half: str) -> None:
    print(f"\n### Automatic, Liechtenstein, images from the {half}\n")
    print(
        "| images | right fix | by constellation, by correlation | wrong fix | no fix | median error | "
        "95 % radius holds | median s |"
    )
    print("|---|---|---|---|---|---|---|---|")
    for kind in sorted({row["kind"] for row in rows}):
        group = [row for row in rows if row["kind"] == kind]
        fixes = [row for row in group if row["status"] == "fix"]
        right = [row for row in fixes if kind in AUTOMATIC_KINDS and is_right(row)]
        roads = [sum(row["method"] == method for row in right) for method in ("constellation", "map correlation")]
        error = f"{np.median([row['error'] for row in right]):.2f} m" if right else "–"
        held = rate_text(sum(row["error"] <= row["error_95"] for row in right), len(right))
        count, wrong = len(group), len(fixes) - len(right)
        print(
            f"| {kind} | {rate_text(len(right), count)} | {roads[0]}, {roads[1]} | {rate_text(wrong, count)} | "
            f"{rate_text(count - len(fixes), count)} | {error} | {held} | "
            f"{np.median([row['seconds'] for row in group]):.2f} |"
        )


def run(jobs, processes: int, rows_file, trial=trial) -> list[dict]:
    """All trials, in processes that share the prepared maps."""
    cv2.setNumThreads(1)
    STATE["threads"] = 1 if processes > 1 else 2
    if processes > 1:
        with multiprocessing.get_context("fork").Pool(processes) as pool:
            rows = pool.map(trial, jobs, chunksize=2)
    else:
        rows = [trial(job) for job in jobs]
    if rows_file:
        with open(rows_file, "a", encoding="utf-8") as file:
            file.writelines(json.dumps(row) + "\n" for row in rows)
    return rows


def rate_text(hits: int, count: int) -> str:
    """Rate with its 95 % Wilson interval, in percent."""
    if not count:
        return "–"
    low, high = wilson(hits, count)
    return f"{hits}/{count} = {100 * hits / count:.1f} % ({100 * low:.1f}–{100 * high:.1f})"


def is_right(row: dict) -> bool:
    return row.get("error", np.inf) <= RIGHT_SHARE * row["footprint"]


def print_table(rows: list[dict], title: str) -> None:
    print(f"\n### {title}\n")
    print(
        "| images | right fix | wrong fix | refused | best place right | median error | median heading, scale error "
        "| 95 % radius holds | median s (CPU s) |"
    )
    print("|---|---|---|---|---|---|---|---|---|")
    for key in sorted({(row["kind"], row["noise"]) for row in rows}):
        group = [row for row in rows if (row["kind"], row["noise"]) == key]
        fixes = [row for row in group if row["status"] == "fix"]
        right = [row for row in fixes if key[0] == "right" and is_right(row)]
        count = len(group)
        first = rate_text(sum(is_right(row) for row in group), count) if key[0] == "right" else "–"
        numbers = "– | – | –"
        if right:
            numbers = (
                f"{np.median([row['error'] for row in right]):.2f} m | "
                f"{np.median([row['heading_error'] for row in right]):.2f}°, "
                f"{100 * np.median([row['scale_error'] for row in right]):.2f} % | "
                f"{rate_text(sum(row['error'] <= row['error_95'] for row in right), len(right))}"
            )
        print(
            f"| {', '.join(key)} | {rate_text(len(right), count)} | "
            f"{rate_text(len(fixes) - len(right), count)} | {rate_text(count - len(fixes), count)} | {first} | "
            f"{numbers} | "
            f"{np.median([row['seconds'] for row in group]):.2f} ({np.median([row['cpu'] for row in group]):.2f}) |"
        )


def print_fit(rows: list[dict]) -> None:
    """Margins and errors from which the settings of the decision are chosen."""
    from semref.core.correlation.decision import smaller_lead

    for row in rows:
        row["margin"] = smaller_lead(CorrelationPeaks(*(row[name] for name in ("score", "runner_up", "mirror"))))
    posed = [row for row in rows if "error" in row]
    wrong = np.array([row["margin"] for row in posed if not (row["kind"] == "right" and is_right(row))])
    right = np.array([row["margin"] for row in posed if row["kind"] == "right" and is_right(row)])
    print("wrong margins, highest:", np.round(np.sort(wrong)[::-1][:8], 3), "of", len(wrong))
    print("right margins, lowest:", np.round(np.sort(right)[:12], 3), "of", len(right))
    offset, slope = logistic_fit(np.concatenate([wrong, right]), np.repeat([0.0, 1.0], [len(wrong), len(right)]))
    print(f"confidence curve: offset {offset:.2f}, slope {slope:.1f}")
    print_radius([row for row in posed if row["kind"] == "right" and is_right(row)])


def print_radius(rows: list[dict]) -> None:
    """Errors in units of deviation × noise, which ``error_factor`` bounds, and how many the 95 % radius holds."""
    for noise in sorted({row["noise"] for row in rows}):
        group = [row for row in rows if row["noise"] == noise]
        ratios = [
            row["error"] / row["deviation"] / max(1 / row["score"] ** 2 - 1, CORRELATION.least_noise) for row in group
        ]
        print(
            f"{noise}: quantiles 50 90 95 98 % {np.round(np.quantile(ratios, [0.5, 0.9, 0.95, 0.98]), 2)}, "
            f"95 % radius holds {rate_text(sum(row['error'] <= row['error_95'] for row in group), len(group))}"
        )


def logistic_fit(x: np.ndarray, y: np.ndarray, steps: int = 50):
    """Offset and slope of the logistic curve, lightly damped so that separable data give a finite slope."""
    design = np.column_stack([np.ones_like(x), x])
    weights = np.zeros(2)
    for _ in range(steps):
        chance = 1 / (1 + np.exp(-design @ weights))
        normal = (design * (chance * (1 - chance))[:, None]).T @ design + np.diag([1e-3, 1e-3])
        weights += np.linalg.solve(normal, design.T @ (y - chance) - 1e-3 * weights)
    return weights


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("country", "aerial", "times", "automatic", "radius", "fit"))
    parser.add_argument("--half", choices=("north", "south"), default="south")
    parser.add_argument("--trials", type=int, default=100)
    parser.add_argument("--elsewhere", type=int, default=100)
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1671)
    parser.add_argument("--rows")
    parser.add_argument("--evidence", action="store_true")
    options = parser.parse_args()
    seeds = range(options.seed, options.seed + options.trials)
    if options.what == "fit":
        print_fit([json.loads(line) for line in Path(options.rows).read_text("utf-8").splitlines()])
    elif options.what == "country":
        prepare_country(options.half)
        jobs = [("right", noise, seed, None) for noise in ("modest", "strong") for seed in seeds]
        for seed in range(options.seed, options.seed + options.elsewhere):
            jobs += [("elsewhere", ("true labels", "modest")[seed % 2], seed, None)]
        for seed in range(options.seed, options.seed + options.elsewhere // 4):
            jobs += [("mirrored", "modest", seed, None)]
        print_table(run(jobs, options.processes, options.rows), f"Liechtenstein, images from the {options.half}")
    elif options.what == "automatic":
        prepare_automatic(options.half)
        jobs = [(kind, seed, options.evidence) for kind in AUTOMATIC_KINDS for seed in seeds]
        others = range(options.seed, options.seed + options.elsewhere)
        jobs += [(kind, seed, options.evidence) for kind in ("elsewhere", "mirrored") for seed in others]
        print_automatic(run(jobs, options.processes, options.rows, automatic_trial), options.half)
    elif options.what == "radius":
        jobs = [(noise, seed) for noise in ("modest", "strong") for seed in seeds]
        prepare_country(options.half)
        rows = run(jobs, options.processes, options.rows, radius_trial)
        print(f"Liechtenstein, {options.half}")
        print_radius([row for row in rows if is_right(row) and row["score"] > FIX_SCORE])
        rows = []
        for tile in sorted((DATA / "dubai_aerial").glob("tile*_label.tif")):
            prepare_aerial(tile)
            rows += run(jobs, options.processes, options.rows, radius_trial)
        print("Aerial label maps")
        print_radius([row for row in rows if is_right(row) and row["score"] > FIX_SCORE])
    elif options.what == "aerial":
        every = []
        for tile in sorted((DATA / "dubai_aerial").glob("tile*_label.tif")):
            prepare_aerial(tile)
            shape = STATE["labels"].shape
            jobs = [("right", noise, seed, None) for noise in NOISES for seed in seeds]
            jobs += [("mirrored", "modest", seed, None) for seed in seeds]
            rows = run(jobs, options.processes, options.rows)
            print_table(rows, f"{tile.stem}, {shape[1]} × {shape[0]} px")
            every += rows
        print_table(every, "All tiles")
    else:
        prepare_country(options.half)
        for name, prior in (("whole country", None), ("within 1 km of a prior", 1000.0)):
            rows = run([("right", "modest", seed, prior) for seed in seeds], 1, options.rows)
            print_table(rows, f"Times with 2 threads, {name}")


if __name__ == "__main__":
    main()
