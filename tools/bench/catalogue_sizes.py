"""The constellation in catalogues of 10⁴ to 10⁷ landmarks: time to index them, time of a query."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable

import cv2
import numpy as np

from bench import inputs, page
from bench.ground import GOAL, HARD, Case, Ground
from semref.core.constellation.index import ConstellationIndex, build_index
from semref.core.database.model import MapLandmarks

PAGE = "benchmarks.md"
SEED = 1671
COUNT = 100
QUICK_COUNT = 3
GOALS_MS = {10_000: 100, 100_000: 150, 1_000_000: 300, 10_000_000: 1000}
ONE_GROUND = 10_000_000
"""From so many landmarks on only beside other ground: one index takes gigabytes and minutes."""
CASES = (
    Case("20 / 20 / 5 %", GOAL, as_landmarks=True, right_within=10.0),
    Case("40 / 40 / 10 %", HARD, as_landmarks=True, right_within=10.0),
)
COLUMNS = (
    "landmarks",
    "beside the country",
    "images",
    "ms median",
    "p95",
    "goal p95",
    "right fixes",
    "wrong fixes",
    "search capped",
    "s to index",
    "time per landmark × the first row's",
)


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"catalogue sizes": "Not measured: the real data is not here."}
    cv2.setNumThreads(1)
    count = run.how_many(COUNT, QUICK_COUNT)
    ground = Ground.of(run)
    rows, first = [], None
    for size, goal in list(GOALS_MS.items())[: 1 if run.quick else None]:
        if not run.wants(f"{size:,}"):
            continue
        for title in _beside(size, len(ground.database.references)):
            if not run.wants(title):
                continue
            seconds, index = _built(tiled(ground, size, GROUNDS[title]))
            each = seconds / len(index)
            first = first or each
            rows += _rows(ground, index, count, (goal, title, seconds, each / first))
    return {"catalogue sizes": f"{_ABOUT.format(count=count)}\n\n{page.table(COLUMNS, rows)}"}


def _beside(size: int, own: int) -> list[str]:
    """What stands beside the country to make that many landmarks."""
    if size <= own:
        return [ALTERED]
    return [title for title in GROUNDS if size < ONE_GROUND or title != ALTERED]


def _rows(ground: Ground, index: ConstellationIndex, count: int, told: tuple) -> list[list[str]]:
    goal, title, seconds, ratio = told
    rows = []
    for case in CASES:
        rng = np.random.default_rng([SEED, round(np.log10(len(index)))])
        trials = [ground.attempt(case, rng, index) for _ in range(count)]
        median, high = 1000 * np.percentile([t.seconds for t in trials], [50, 95])
        numbers = [sum(t.is_right for t in trials), sum(t.is_wrong for t in trials)]
        capped = sum(t.result.search_capped for t in trials)
        rows.append([f"{len(index):,}", title, case.name, f"{median:.0f}", f"{high:.0f}", f"≤ {goal}"])
        rows[-1] += [page.rate(number, count) for number in (*numbers, capped)]
        rows[-1] += [f"{seconds:.1f}", f"{ratio:.2f}"]
        print("  " + " | ".join(rows[-1]), file=sys.stderr, flush=True)
    return rows


_ABOUT = """\
One query of the constellation after its landmarks are found, processor time of one core, {count} images a row from
the southern half of Liechtenstein. Larger catalogues: the country with *altered copies* of itself beside it (landmarks
moved by σ 30 m, other sizes), or with *other ground*: copies turned, every other one mirrored, stretched by 15–40 %
along one axis and pressed along the other, moved by σ 5 m. Wrong: a fix anywhere but within 10 m. Capped: the fix rests
on a search that left common patterns out. Indexing happens once, when a database is first used."""


def altered(points: np.ndarray, number: int, rng: np.random.Generator) -> np.ndarray:
    """Other places for the landmarks of a copy: (N, 2) about its middle."""
    return points + rng.normal(0, 30, points.shape)


def other_ground(points: np.ndarray, number: int, rng: np.random.Generator) -> np.ndarray:
    """Ground of the same kind that lies nowhere: turned, mirrored or not, stretched along one axis."""
    stretch, turn = rng.uniform(1.15, 1.4), rng.uniform(0, 2 * np.pi)
    kept = points * (1 / stretch, stretch if number % 2 else -stretch)
    cosine, sine = np.cos(turn), np.sin(turn)
    return kept @ np.array([[cosine, sine], [-sine, cosine]]) + rng.normal(0, 5, points.shape)


ALTERED = "altered copies"
GROUNDS = {ALTERED: altered, "other ground": other_ground}


def tiled(
    ground: Ground, size: int, copied: Callable[[np.ndarray, int, np.random.Generator], np.ndarray] = altered
) -> MapLandmarks:
    """The map and as many copies of it beside each other as make ``size`` landmarks: other places and areas."""
    own = ground.database.references
    rng = np.random.default_rng([SEED, 9])
    copies = -(-size // len(own))
    side = int(np.ceil(np.sqrt(copies)))
    left, bottom, right, top = ground.frame.extent
    middle = np.array([(left + right) / 2, (bottom + top) / 2])
    # A turned and stretched copy is at most so much longer than the map.
    step = 1.5 * np.hypot(right - left, top - bottom)
    positions, areas = [own.positions], [own.areas_m2]
    for number in range(1, copies):
        away = np.array([number % side, number // side]) * step
        positions.append(copied(own.positions - middle, number, rng) + middle + away)
        areas.append(own.areas_m2 * np.exp(rng.normal(0, 0.3, len(own))))
    count = size if copies > 1 else len(own)
    return MapLandmarks(
        np.concatenate(positions)[:count],
        np.tile(own.classes, copies)[:count],
        np.concatenate(areas)[:count],
        np.tile(own.touches_edge, copies)[:count],
    )


def _built(references: MapLandmarks) -> tuple[float, ConstellationIndex]:
    started = time.process_time()
    index = build_index(references, 1.0)
    return time.process_time() - started, index
