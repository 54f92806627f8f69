"""Map correlation on Liechtenstein and on real aerial label maps: how often right, how close, how long it takes."""

from __future__ import annotations

import time
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from bench import inputs, page
from bench.ground import ANY, COLUMNS, NONE, Case, Ground, Wanted, cells, tried
from bench.tiles import TILE_SCALES, tile_ground, tile_paths
from semref.core.evaluation.trial import Trial, judge
from semref.core.localization import Method, Prior
from semref.core.simulation.noise import MODEST, STRONG

PAGE = "benchmarks.md"
SEED = 1671
COUNT, TIMES_COUNT = 60, 12
QUICK_COUNT = 2
BUILDINGS = (1,)
"""What poor networks are known to miss, merge and split."""

ON_THE_MAP = Wanted(landmarks=ANY, labeled=0.7)
ON_A_TILE = Wanted(TILE_SCALES, landmarks=ANY, labeled=0.9, sizes_px=(384, 512, 640, 768), is_inside=True)
MAP_CORRELATION = Case("", MODEST, wanted=ON_THE_MAP, method=Method.MAP_CORRELATION, in_meters=True)
COUNTRY = (
    replace(MAP_CORRELATION, name="Liechtenstein, modest noise"),
    replace(MAP_CORRELATION, name="Liechtenstein, strong noise", noise=STRONG),
    replace(
        MAP_CORRELATION, name="Liechtenstein, mirrored, modest noise", wanted=replace(ON_THE_MAP, is_mirrored=True)
    ),
)
ELSEWHERE = (replace(MAP_CORRELATION, name="Liechtenstein, of the other half, modest noise", is_of_map=False),)
TILE = replace(MAP_CORRELATION, wanted=ON_A_TILE)
AERIAL = (
    replace(TILE, name="aerial label maps, true labels", noise=NONE),
    replace(TILE, name="aerial label maps, modest noise"),
    replace(TILE, name="aerial label maps, strong noise", noise=STRONG),
    replace(TILE, name="aerial label maps, mirrored, modest noise", wanted=replace(ON_A_TILE, is_mirrored=True)),
)
PRIOR_RADIUS_M = 1000.0
KEPT_IN = "correlation"


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        reason = "Not measured: the real data is not here."
        return {"map correlation": reason, "map correlation times": reason}
    ground, count = country(run), run.how_many(COUNT, QUICK_COUNT)
    found = [*tried(run, ground, COUNTRY, count, SEED, KEPT_IN)]
    found += tried(run, ground.known_elsewhere(), ELSEWHERE, count, SEED, KEPT_IN)
    found += tried_on_tiles(run, tile_paths(run)[: 1 if run.quick else None], -(-count // 6))
    rows = [[*cells(trials, case.name), best_right(trials)] for case, trials in found]
    table = page.table([*COLUMNS, "best place right, fix or not"], rows)
    return {
        "map correlation": f"{_ABOUT.format(half=run.half)}\n\n{table}",
        "map correlation times": f"{_TIMES}\n\n{_times(run, ground)}",
    }


_ABOUT = """\
Images of 1,280 px of Liechtenstein's {half}ern half at 0.8–1.25 m, any heading, on the whole country; thresholds were
frozen on the northern half. Real aerial label maps of Dubai (six tiles): crops of 384–768 px at 0.9–1.1 of their
pixels, errors in pixels. Pixel sizes searched: 0.7–1.4 × nominal. Right: within 2 % of the footprint. “Modest” and
“strong” are the label noise of `core/simulation/noise.py`: houses merged and split, boundaries moved by meters, 15 %
and 35 % of the area given random classes. Any fix of a mirrored image, or of the half that the database doesn't have,
is wrong."""

_TIMES = "Goal with two cores: ≤ 2 s over 300 km², ≤ 0.3 s within 1 km of a prior."


def country(run: inputs.Run) -> Ground:
    """The area, spoiled as poor networks do."""
    ground = Ground.of(run)
    ground.spoiled_values = BUILDINGS
    return ground


def tried_on_tiles(run: inputs.Run, paths: Sequence[Path], count: int) -> list[tuple[Case, list[Trial]]]:
    """The aerial cases, trials of all tiles together."""
    together = defaultdict(list)
    for number, path in enumerate(paths if any(run.wants(case.name) for case in AERIAL) else []):
        ground = tile_ground(path)
        ground.spoiled_values = BUILDINGS
        for case, trials in tried(run, ground, AERIAL, count, SEED + number, f"{KEPT_IN}_{path.stem}"):
            together[case] += trials
    return list(together.items())


def best_right(trials: Sequence[Trial]) -> str:
    """How often the best place was right, accepted or not."""
    if not trials[0].query.can_be_right:
        return "–"
    return page.rate(sum(place_is_right(trial) for trial in trials), len(trials))


def place_is_right(trial: Trial) -> bool:
    """Whether the best place is the right one, accepted or not."""
    best, view = trial.result.best, trial.query.view
    return best is not None and np.hypot(*np.subtract(best.position, view.position)) <= 0.02 * view.footprint


def _times(run: inputs.Run, ground: Ground) -> str:
    rng = np.random.default_rng([SEED, 12])
    rows = []
    for name, radius in (("whole country", None), ("within 1 km of a prior", PRIOR_RADIUS_M)):
        seconds, trials = [], []
        for _ in range(run.how_many(TIMES_COUNT, 1)):
            image = ground.draw(ON_THE_MAP, rng)
            image = ground.spoiled(image, MODEST.in_pixels(image.view.pixel_size), rng)
            near = tuple(np.add(image.view.position, rng.uniform(-0.7, 0.7, 2) * PRIOR_RADIUS_M))
            prior = Prior(near, radius) if radius else None
            started = time.perf_counter()
            found = ground.localizer.localize(image.labels_hw, Method.MAP_CORRELATION, prior)
            seconds.append(time.perf_counter() - started)
            trials.append(judge(image.query, Method.MAP_CORRELATION, found))
        right = page.rate(sum(t.is_right for t in trials), len(trials))
        rows.append([name, f"{np.median(seconds):.2f}", f"{np.percentile(seconds, 95):.2f}", right])
    return page.table(["search", "s median, two threads", "p95", "right fixes"], rows)
