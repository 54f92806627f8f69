"""Measure constellation localization on Liechtenstein 2021 and print a Markdown table.

    python tools/measure_constellation.py [--trials 300] [--half south|north|both] [--only goal,hard] [--seed 1]
    python tools/measure_constellation.py --elsewhere FILE.csv [--images 30000]

Reads ../shared/data/osm_liechtenstein_2021 (or SEMREF_DATA), rasterizes it at 1 m with gdal_rasterize into a temporary
folder. Thresholds were calibrated with --half north; the figures to quote are those of --half south.
One core is used; times are processor times, so that other programs don't count.
Rates come with counts and Wilson 95 % intervals. --elsewhere tries images that are not of the map, in turn mirrored
ones, lattices and other regions, writes a line an image and goes on where the file ends.
"""

from __future__ import annotations

import argparse
import importlib.util
import os
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, replace
from pathlib import Path

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(variable, "1")

import cv2  # noqa: E402
import numpy as np  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
DATA = Path(os.environ.get("SEMREF_DATA") or ROOT.parent / "shared" / "data")
LAYER = "osm_liechtenstein_2021/li_landcover_2021.shp"
CLASSES = (1, 2, 3)  # building, bare_land, water
MINIMUM_AREA_M2 = 100.0
IMAGE_PX = 1280
RIGHT_M = 10.0
RIGHT_TILTED = 0.02  # of the footprint, for tilted cameras
PIXEL_SIZES_M = (0.4, 2.5)  # searched by default


def load_package() -> None:
    if "semref" in sys.modules:  # loaded by tools/bench, which measures with the rows of this file
        return
    spec = importlib.util.spec_from_file_location(
        "semref", ROOT / "__init__.py", submodule_search_locations=[str(ROOT)]
    )
    package = importlib.util.module_from_spec(spec)
    sys.modules["semref"] = package
    spec.loader.exec_module(package)


load_package()
sys.path[:] = [entry for entry in sys.path if Path(entry or ".").resolve() != ROOT]

from semref.core.constellation.index import build_index  # noqa: E402
from semref.core.constellation.solver import localize  # noqa: E402
from semref.core.database.model import MapLandmarks  # noqa: E402
from semref.core.evaluation.rates import wilson  # noqa: E402
from semref.core.evaluation.trial import ellipse_ratio  # noqa: E402
from semref.core.labels.sources import ArrayLabels  # noqa: E402
from semref.core.landmarks.landmarks import Landmarks, extract_landmarks  # noqa: E402
from semref.core.localization import Prior, Status  # noqa: E402
from semref.core.simulation.noise import LabelNoise, spoil_labels, spoil_landmarks  # noqa: E402
from semref.core.simulation.views import PIXELS, cut, random_view  # noqa: E402

GOAL = LabelNoise(missed=0.2, spurious=0.2, mislabeled=0.05, center=1.5, log_area=0.1)
HARD = LabelNoise(missed=0.4, spurious=0.4, mislabeled=0.1, center=1.5, log_area=0.1)
CLEAN = LabelNoise()


@dataclass(frozen=True)
class Row:
    """One line of the table: what the queries are like."""

    name: str
    noise: LabelNoise = GOAL
    scales: tuple = (0.8, 1.25)
    objects: tuple = (20, 10**9)
    tilt_deg: float = 0.0
    labels: LabelNoise | None = None
    elsewhere: str = ""
    share: float = 1.0


ROWS = {
    "goal": Row("20 % missed, 20 % invented, 5 % misnamed, scale 0.8–1.25"),
    "hard": Row("40 / 40 / 10 %", HARD),
    "scale": Row("20 / 20 / 5 %, scale 0.5–2", scales=(0.5, 2.0)),
    "clean": Row("no noise but the grid, scale 0.5–2", CLEAN, (0.5, 2.0)),
    "few": Row("20 / 20 / 5 %, 8–12 objects", objects=(8, 12)),
    "few_clean": Row("no noise, 8–12 objects", CLEAN, objects=(8, 12)),
    "ragged": Row("edges ragged by 2 px", CLEAN, labels=LabelNoise(jitter=2.0)),
    "merged": Row(
        "edges ragged by 2 px, gaps ≤ 8 px closed in half of the image, 20 % of objects cut in two",
        CLEAN,
        labels=LabelNoise(jitter=2.0, merge_share=0.5, merge_gap=9, split=0.2),
    ),
    "tilt5": Row("20 / 20 / 5 %, camera tilted 5°", tilt_deg=5.0),
    "tilt10": Row("20 / 20 / 5 %, camera tilted 10°", tilt_deg=10.0),
    "mirrored": Row("mirrored 20 / 20 / 5 % queries", elsewhere="mirrored", share=4),
    "mirrored_few": Row("mirrored, 8–12 objects, no noise", CLEAN, objects=(8, 12), elsewhere="mirrored", share=4),
    "lattices": Row("regular lattices with gaps", elsewhere="lattice", share=4),
    "sample": Row("pictures of the sample area", CLEAN, elsewhere="sample", share=2),
}


@dataclass
class Outcome:
    """What came of one query; error in m, ratio to the 95 % ellipse, heading in degrees, relative pixel size."""

    status: str
    seconds: float
    right: bool = False
    error_m: float = np.nan
    ratio: float = np.nan
    heading_deg: float = np.nan
    scale: float = np.nan
    footprint_m: float = np.nan
    confidence: float = 0.0
    log_odds: float = np.nan
    place_right: bool = False


def main() -> int:
    options = parse()
    if not (DATA / LAYER).exists():
        print(f"measure_constellation: the real data is not here: {DATA / LAYER}")
        return 0
    cv2.setNumThreads(1)
    labels = rasterize(DATA / LAYER)
    area = Area(labels, options.half)
    started = time.perf_counter()
    index = build_index(area.references(), 1.0)
    print(f"{len(index)} objects, {len(index.keys)} triangles, built in {time.perf_counter() - started:.2f} s\n")
    if options.elsewhere:
        try_elsewhere(area, index, options)
        return 0
    sample = sample_labels(options.seed) if "sample" in options.only else None
    print_header()
    for name in options.only:
        row = ROWS[name]
        rng = np.random.default_rng([options.seed, list(ROWS).index(name)])
        count = int(options.trials * row.share)
        outcomes = [trial(area, row, index, rng, sample) for _ in range(count)]
        print_row(row, outcomes)
        if options.save:
            save(options.save, name, outcomes)
    for size in options.sizes:
        print_speed(area, size, max(options.trials // 4, 20), options.seed)
    return 0


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--trials", type=int, default=300)
    parser.add_argument("--half", choices=("north", "south", "both"), default="south")
    parser.add_argument("--only", default=",".join(ROWS), help="rows, separated by commas")
    parser.add_argument("--sizes", default="10000,100000,1000000", help="catalogue sizes for the time table")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--elsewhere", type=Path, help="file of outcomes of images that are not of the map")
    parser.add_argument("--images", type=int, default=30_000, help="images of --elsewhere, those in the file included")
    parser.add_argument("--save", type=Path, help="folder for one .npz of outcomes a row")
    options = parser.parse_args()
    options.only = [name for name in options.only.split(",") if name]
    options.sizes = [int(size) for size in options.sizes.split(",") if size]
    return options


def rasterize(layer: Path) -> np.ndarray:
    """(H, W) uint8 labels at 1 m, class_id drawn in order of zorder."""
    from osgeo import gdal

    with tempfile.TemporaryDirectory() as folder:
        target = os.path.join(folder, "labels.tif")
        query = f"SELECT * FROM {layer.stem} ORDER BY zorder"
        command = ["gdal_rasterize", "-q", "-sql", query, "-a", "class_id", "-tr", "1", "1", "-tap", "-ot", "Byte"]
        subprocess.run([*command, "-co", "COMPRESS=DEFLATE", str(layer), target], check=True)
        return gdal.Open(target).ReadAsArray()


class Area:
    """The map and where query centers may lie; y of map coordinates is minus the row."""

    def __init__(self, labels: np.ndarray, half: str) -> None:
        self.labels = ArrayLabels(labels)
        self.objects = extract_landmarks(labels, CLASSES, MINIMUM_AREA_M2)
        height, width = labels.shape
        middle = int(np.median(self.objects.centers_xy[:, 1]))
        rows = {"north": (0, middle), "south": (middle, height), "both": (0, height)}[half]
        self.extent = (0, -rows[1], width, -rows[0])

    def references(self) -> MapLandmarks:
        objects = self.objects
        return MapLandmarks(objects.centers_xy * (1, -1), objects.classes, objects.areas_px, objects.touches_edge)

    def query(self, row: Row, rng: np.random.Generator) -> tuple:
        """A view with as many whole objects as the row asks for, and its objects after noise."""
        while True:
            view = random_view(rng, self.extent, (IMAGE_PX, IMAGE_PX), row.scales)
            view = replace(view, tilt_deg=row.tilt_deg, tilt_direction_deg=float(rng.uniform(0, 360)))
            near = np.abs(self.objects.centers_xy - (view.x, -view.y)).max(axis=1) < IMAGE_PX * view.pixel_size / 2
            if near.sum() < 0.7 * row.objects[0]:
                continue
            labels = cut(self.labels, PIXELS, view)
            whole = self._extract(labels)
            whole = whole.select(~whole.touches_edge & (whole.areas_px * view.pixel_size**2 >= MINIMUM_AREA_M2))
            if row.objects[0] <= len(whole) <= row.objects[1]:
                if row.labels is not None:
                    labels = spoil_labels(labels, row.labels, rng, CLASSES)
                return view, self._spoil(self._extract(labels), view, row.noise, rng)

    def _extract(self, labels: np.ndarray) -> Landmarks:
        return extract_landmarks(labels, CLASSES, max(MINIMUM_AREA_M2 / PIXEL_SIZES_M[1] ** 2, 9))

    def _spoil(self, objects: Landmarks, view, noise, rng) -> Landmarks:
        population = replace(self.objects, areas_px=self.objects.areas_px / view.pixel_size**2)
        return spoil_landmarks(objects, noise, rng, population, (IMAGE_PX, IMAGE_PX))


def trial(area: Area, row: Row, index, rng: np.random.Generator, sample) -> Outcome:
    view = None
    if row.elsewhere == "lattice":
        objects = lattice(rng)
    elif row.elsewhere == "sample":
        objects = sample_objects(sample, rng)
    else:
        view, objects = area.query(row, rng)
    if row.elsewhere == "mirrored":
        objects = replace(objects, centers_xy=np.abs((IMAGE_PX, 0) - objects.centers_xy))
    started = time.process_time()
    found = localize(objects, IMAGE_PX, IMAGE_PX, index, Prior(pixel_size_range=PIXEL_SIZES_M))
    outcome = Outcome(found.status, time.process_time() - started, confidence=found.confidence)
    if found.best is not None:
        outcome.log_odds = found.best.log_odds
    if found.best is None or row.elsewhere:
        return outcome
    off = complex(*found.best.position) - complex(*view.position)
    outcome.error_m = abs(off)
    outcome.footprint_m = IMAGE_PX * view.pixel_size
    outcome.place_right = outcome.error_m <= (RIGHT_TILTED * outcome.footprint_m if view.tilt_deg else RIGHT_M)
    outcome.right = found.is_fix and outcome.place_right
    outcome.heading_deg = abs((found.best.heading_deg - view.heading_deg + 180) % 360 - 180)
    outcome.scale = abs(found.best.pixel_size_m / view.pixel_size - 1)
    if found.covariance is not None:
        outcome.ratio = ellipse_ratio(off.real, off.imag, found.covariance.ellipse_95)
    return outcome


LATTICES = ("square", "rectangular", "hexagonal", "twin rows", "two classes")


def lattice(rng: np.random.Generator, kind: str = "") -> Landmarks:
    """Plots in rows, as in a new estate: equal spacing, little jitter, equal sizes, a few missing.

    kind: one of LATTICES, by default square or rectangular; twin rows are houses on both sides of streets.
    """
    spacing = rng.uniform(40, 160)
    other = spacing * (1.0 if kind == "square" else rng.choice([1.0, rng.uniform(0.5, 2)]))
    turn = np.exp(1j * rng.uniform(0, 2 * np.pi))
    columns, rows = np.meshgrid(np.arange(-40, 41), np.arange(-40, 41))
    if kind == "hexagonal":
        points = (columns + rows % 2 / 2) * spacing + 1j * rows * spacing * np.sqrt(0.75)
    elif kind == "twin rows":
        points = columns * spacing + 1j * (rows // 2 * 2 + rows % 2 * rng.uniform(0.5, 0.9)) * other
    else:
        points = columns * spacing + 1j * rows * other
    jitter = rng.normal(0, 1, (2, points.size))
    points = points.ravel() * turn + jitter[0] + 1j * jitter[1] + (640 + 640j)
    inside = (np.abs(points.real - 640) < 625) & (np.abs(points.imag - 640) < 625) & (rng.random(points.size) > 0.15)
    classes = np.where((kind == "two classes") & ((columns + rows).ravel() % 2 == 1), 2, 1).astype(np.uint8)[inside]
    points = points[inside]
    count = len(points)
    areas = rng.uniform(100, 400) * np.exp(rng.normal(0, 0.1, count))
    centers = np.column_stack([points.real, points.imag])
    return Landmarks(centers, classes, areas, np.zeros((count, 4), int), np.zeros(count, bool))


def try_elsewhere(area: Area, index, options: argparse.Namespace) -> None:
    """Goes through images that are not of the map; image n depends on seed and n alone."""
    regions = [("sample area", sample_labels(options.seed), (0.8, 1.25)), *dubai_regions()]
    done = len(options.elsewhere.read_text().splitlines()) if options.elsewhere.exists() else 0
    with options.elsewhere.open("a") as file:
        for number in range(done, options.images):
            rng = np.random.default_rng([options.seed, 77, number])
            kind, objects = image_from_elsewhere(area, regions, number, rng)
            found = localize(objects, IMAGE_PX, IMAGE_PX, index, Prior(pixel_size_range=PIXEL_SIZES_M))
            log_odds = found.best.log_odds if found.best is not None else np.nan
            file.write(f"{number};{kind};{len(objects)};{found.status};{log_odds:.1f}\n")
            file.flush()
    print_elsewhere(options.elsewhere)


def image_from_elsewhere(area: Area, regions: list, number: int, rng: np.random.Generator) -> tuple:
    """(kind, objects) of the image with this number: mirrored, lattice and other region in turn."""
    turn, which = number % 3, number // 3
    if turn == 0:
        objects = area.query(ROWS[("goal", "hard", "scale")[which % 3]], rng)[1]
        return "mirrored", replace(objects, centers_xy=np.abs((IMAGE_PX, 0) - objects.centers_xy))
    if turn == 1:
        kind = LATTICES[which % len(LATTICES)]
        return f"lattice, {kind}", lattice(rng, kind)
    # Every other one of the sample area, as it is the only one of its kind.
    tiles = regions[1:] or regions
    name, labels, scales = regions[0] if which % 2 else tiles[which // 2 % len(tiles)]
    height, width = labels.shape
    view = random_view(rng, (0.3 * width, -0.7 * height, 0.7 * width, -0.3 * height), (IMAGE_PX, IMAGE_PX), scales)
    return name, extract_landmarks(cut(labels, PIXELS, view), CLASSES, 16)


def dubai_regions() -> list:
    """(name, labels, scales) of the aerial label maps of Dubai, their classes renamed to those of the map."""
    from osgeo import gdal

    table = np.zeros(256, np.uint8)
    table[[1, 2, 5]] = CLASSES
    paths = sorted((DATA / "dubai_aerial").glob("tile*_label.tif"))
    return [("Dubai", table[gdal.Open(str(path)).ReadAsArray()], (0.4, 1.25)) for path in paths]


def print_elsewhere(path: Path) -> None:
    lines = [line.split(";") for line in path.read_text().splitlines()]
    print("| images from elsewhere | fixes | ambiguous | highest log odds |\n|---|---|---|---|")
    for kind in ["", *sorted({line[1] for line in lines})]:
        chosen = [line for line in lines if kind in ("", line[1])]
        fixes, ambiguous = (sum(line[3] == status for line in chosen) for status in (Status.FIX, "ambiguous"))
        highest = np.nanmax([float(line[4]) for line in chosen] + [-np.inf])
        print(f"| {kind or 'all'} | {rate_text(fixes, len(chosen))} | {ambiguous} | {highest:.1f} |")


def sample_labels(seed: int) -> np.ndarray:
    """Labels of the made-up sample area, its classes renamed to those of the map."""
    from semref.core.sample.classes import CLASSES as SAMPLE_CLASSES
    from semref.core.sample.landscape import make_landscape
    from semref.storage.sample_files import rasterize as rasterize_landscape

    labels = rasterize_landscape(make_landscape(seed), 1.0)
    table = np.zeros(256, np.uint8)
    for entry in SAMPLE_CLASSES:
        table[entry.value] = {"building": 1, "bare_land": 2, "water": 3}.get(entry.name, 0)
    return table[labels]


def sample_objects(labels: np.ndarray, rng: np.random.Generator) -> Landmarks:
    height, width = labels.shape
    view = random_view(rng, (700, 700 - height, width - 700, -700), (IMAGE_PX, IMAGE_PX), (0.8, 1.25))
    return extract_landmarks(cut(labels, PIXELS, view), CLASSES, 16)


def rate_text(count: int, total: int) -> str:
    low, high = wilson(count, total)
    return f"{count}/{total} = {100 * count / max(total, 1):.2f} % ({100 * low:.2f}–{100 * high:.2f})"


def print_header() -> None:
    print(
        "| queries | right fixes | wrong fixes | ambiguous | median error, heading, scale | in the 95 % ellipse | "
        "processor ms median, p95 |\n|---|---|---|---|---|---|---|"
    )


def print_row(row: Row, outcomes: list) -> None:
    total = len(outcomes)
    fixes = [o for o in outcomes if o.status == Status.FIX]
    right = [o for o in fixes if o.right]
    wrong = len(fixes) - len(right)
    ambiguous = sum(o.status == "ambiguous" for o in outcomes)
    accuracy = covered = "–"
    if right:
        share = np.median([o.error_m / o.footprint_m for o in right])
        heading, scale = np.median([o.heading_deg for o in right]), np.median([o.scale for o in right])
        error = np.median([o.error_m for o in right])
        accuracy = f"{error:.2f} m ({100 * share:.3f} %), {heading:.3f}°, {100 * scale:.3f} %"
        covered = rate_text(sum(o.ratio <= 1 for o in right), len(right))
    times = 1000 * np.percentile([o.seconds for o in outcomes], [50, 95])
    found = "–" if row.elsewhere else rate_text(len(right), total)
    print(
        f"| {row.name} | {found} | {rate_text(wrong, total)} | {ambiguous} | {accuracy} | {covered} | "
        f"{times[0]:.0f}, {times[1]:.0f} |",
        flush=True,
    )


def print_speed(area: Area, size: int, count: int, seed: int) -> None:
    """Time of a query in catalogues of different size, one core."""
    references = tiled(area, size, seed)
    started = time.perf_counter()
    index = build_index(references, 1.0)
    built = time.perf_counter() - started
    for name in ("goal", "hard"):
        rng = np.random.default_rng([seed, size])
        outcomes = [trial(area, ROWS[name], index, rng, None) for _ in range(count)]
        times = 1000 * np.percentile([o.seconds for o in outcomes], [50, 95])
        right = rate_text(sum(o.right for o in outcomes), count)
        print(
            f"\n{size} objects, {ROWS[name].name}: built in {built:.1f} s, {len(index.keys)} triangles; "
            f"median {times[0]:.0f} ms, p95 {times[1]:.0f} ms; right {right}",
            flush=True,
        )


def tiled(area: Area, size: int, seed: int) -> MapLandmarks:
    """The map and as many altered copies of it beside each other as make ``size`` objects: other places, other sizes.

    A smaller size takes the objects at the map's southern end, where the queries of --half south are.
    """
    own = area.references()
    height, width = area.labels.shape_hw
    rng = np.random.default_rng([seed, 9])
    copies = -(-size // len(own))
    side = int(np.ceil(np.sqrt(copies)))
    positions, areas = [own.positions], [own.areas_m2]
    for number in range(1, copies):
        step = (number % side * (width + 100), number // side * (height + 100))
        positions.append(own.positions + step + rng.normal(0, 30, own.positions.shape))
        areas.append(own.areas_m2 * np.exp(rng.normal(0, 0.3, len(own))))
    count = size if copies > 1 else len(own)
    return MapLandmarks(
        np.concatenate(positions)[:count],
        np.tile(own.classes, copies)[:count],
        np.concatenate(areas)[:count],
        np.tile(own.touches_edge, copies)[:count],
    )


def save(folder: Path, name: str, outcomes: list) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    columns = {key: np.array([getattr(o, key) for o in outcomes]) for key in vars(outcomes[0])}
    np.savez(folder / f"{name}.npz", **columns)


if __name__ == "__main__":
    sys.exit(main())
