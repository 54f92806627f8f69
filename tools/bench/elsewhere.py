"""Images that lie nowhere on the map: any fix is a wrong one. In parts; a later run with the same --work goes on."""

from __future__ import annotations

import sys
from collections import Counter
from functools import partial
from pathlib import Path

import cv2
import numpy as np
from sample.classes import CLASSES as SAMPLE_CLASSES
from sample.files import rasterize
from sample.landscape import make_landscape

from bench import inputs, kept, page
from bench.ground import GOAL, NONE, REACH_PX, Case, Ground, Image, Wanted
from bench.tiles import tile_paths
from semref.core.evaluation.trial import Query, Trial
from semref.core.landmarks.landmarks import Landmarks, extract_landmarks
from semref.core.simulation.views import PIXELS, View, cut, random_view

PAGE = "benchmarks.md"
SEED = 30_000
COUNT = 500
QUICK_COUNT = 10
PART = 100
"""Images of one kind that are tried and noted together; each part has its own seed."""

SAMPLE, MIRRORED, MIRRORED_FEW, LATTICES, AERIAL, OTHER_HALF = (
    "sample",
    "mirrored",
    "mirrored few",
    "lattices",
    "aerial",
    "other half",
)
KINDS = {
    SAMPLE: "made-up landscapes, another one each part",
    MIRRORED: "mirrored, 20 / 20 / 5 %",
    MIRRORED_FEW: "mirrored, 8–12 landmarks",
    LATTICES: "regular lattices of plots with gaps",
    AERIAL: "aerial label maps of Dubai",
    OTHER_HALF: f"one half, 20 / 20 / 5 %, on a map that ends {REACH_PX:,} m from it",
}
CASES = {
    MIRRORED: Case("", GOAL, wanted=Wanted(is_mirrored=True), as_landmarks=True),
    MIRRORED_FEW: Case("", NONE, wanted=Wanted(landmarks=(8, 12), is_mirrored=True), as_landmarks=True),
    OTHER_HALF: Case("", GOAL, as_landmarks=True, is_of_map=False),
}
LATTICE_KINDS = ("square", "rectangular", "hexagonal", "twin rows", "two classes")
IMAGE_PX = 1280
CLASS_NAMES = {"building": 1, "bare_land": 2, "water": 3}
AERIAL_CLASSES = {1: 1, 2: 2, 5: 3}
"""Classes of regions from elsewhere, as those of the map that they look like."""

STATUSES = ("fix", "ambiguous", "no_match", "too_few_references")


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"elsewhere": "Not measured: the real data is not here."}
    cv2.setNumThreads(1)
    kinds = [kind for kind in KINDS if run.wants(kind) and (kind != AERIAL or tile_paths(run))]
    each = -(-run.how_many(COUNT, QUICK_COUNT) // len(kinds))
    ground = Ground.of(run)
    rows, every, highest, smallest = [], Counter(), -np.inf, 1.0
    for kind in kinds:
        known = ground.known_elsewhere() if kind == OTHER_HALF else ground
        statuses, odds, risk = Counter(), -np.inf, 1.0
        measured = partial(_tried, run, known, kind)
        for part, size in enumerate(kept.wanted(run, "elsewhere", kind, kept.parts(each, PART))):
            found = kept.part(run, "elsewhere", kind, part, size, measured)
            statuses.update(found["statuses"])
            odds, risk = max(odds, found["log_odds"]), min(risk, found["risk"])
            print(f"  {kind}: {sum(statuses.values())} of {each}, {dict(statuses)}", file=sys.stderr, flush=True)
        every.update(statuses)
        highest, smallest = max(highest, odds), min(smallest, risk)
        rows.append(_row(KINDS[kind], statuses, odds, risk))
    rows.append(_row("all", every, highest, smallest))
    header = ["images", "fixes: all wrong", "ambiguous", "no match", "too few landmarks"]
    header += ["highest log odds", "smallest risk told"]
    return {"elsewhere": f"{_ABOUT}\n\n{page.table(header, rows)}"}


_ABOUT = """\
Constellation, images of 1,280 px that lie nowhere on the map of Liechtenstein (where they are of the map, from its
southern half). Goal: no fix for any of 30,000 (with none, the 95 % interval ends at 0.013 %); a fix needs a told risk
of at most 1 in 10,000. Each part of 100 images has its own seed; `--work` keeps what was tried, and more are added by a
larger `--count`."""


def _tried(run: inputs.Run, ground: Ground, kind: str, part: int, size: int) -> dict:
    """How many images of a part came out with each status, and the highest log odds of any place."""
    rng = np.random.default_rng([SEED, list(KINDS).index(kind), part])
    if kind in CASES:
        trials = [ground.attempt(CASES[kind], rng) for _ in range(size)]
    elif kind == LATTICES:
        trials = [_try(ground, lattice(rng, LATTICE_KINDS[n % len(LATTICE_KINDS)])) for n in range(size)]
    else:
        regions = [sample_labels(SEED + part)] if kind == SAMPLE else [aerial_labels(path) for path in tile_paths(run)]
        scales = (0.8, 1.25) if kind == SAMPLE else (0.4, 1.25)
        trials = [_try(ground, region_landmarks(regions[n % len(regions)], rng, scales)) for n in range(size)]
    odds = [t.result.best.log_odds for t in trials if t.result.best is not None]
    risks = [t.result.risk for t in trials if t.result.risk is not None]
    statuses = Counter(t.status.key for t in trials)
    return {"statuses": statuses, "log_odds": max(odds, default=-1000.0), "risk": min(risks, default=1.0)}


def _try(ground: Ground, landmarks: Landmarks) -> Trial:
    image = Image(Query(View(0.0, 0.0), is_of_map=False), np.empty((0, 0), np.uint8))
    return ground.try_landmarks(image, landmarks)


def _row(title: str, statuses: Counter, log_odds: float, risk: float) -> list[str]:
    total = sum(statuses.values())
    others = [str(statuses[status]) for status in STATUSES[1:]]
    return [title, page.rate(statuses["fix"], total), *others, f"{log_odds:.1f}", f"{risk:.2g}"]


# --- what is not of the map ---


def lattice(rng: np.random.Generator, kind: str) -> Landmarks:
    """Plots in rows, as in a new estate: equal spacing, little jitter, equal sizes, a few missing.

    kind: one of LATTICE_KINDS; twin rows are houses on both sides of streets.
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


def sample_labels(seed: int) -> np.ndarray:
    """Labels of a made-up sample area, its classes renamed to those of the map."""
    names = {entry.value: CLASS_NAMES.get(entry.name, 0) for entry in SAMPLE_CLASSES}
    return _renamed(sample_area(seed), names)


def sample_area(seed: int) -> np.ndarray:
    """Labels of a made-up sample area, with all its classes."""
    return rasterize(make_landscape(seed), 1.0)


def aerial_labels(path: Path) -> np.ndarray:
    """An aerial label map, its classes renamed to those of the map."""
    return _renamed(inputs.read_labels(path), AERIAL_CLASSES)


def _renamed(labels_hw: np.ndarray, names: dict[int, int]) -> np.ndarray:
    table = np.zeros(256, np.uint8)
    table[list(names)] = list(names.values())
    return table[labels_hw]


def region_landmarks(labels_hw: np.ndarray, rng: np.random.Generator, scales: tuple[float, float]) -> Landmarks:
    """What an image from the middle of a region shows."""
    height, width = labels_hw.shape
    extent = (0.3 * width, -0.7 * height, 0.7 * width, -0.3 * height)
    view = random_view(rng, extent, (IMAGE_PX, IMAGE_PX), scales)
    return extract_landmarks(cut(labels_hw, PIXELS, view), tuple(CLASS_NAMES.values()), 16)
