"""Which share of the ground has a right fix, by footprint, landmarks in view, noise and road.

Positions are uniform over the ground; images show a quarter to once a window's. What the camera knew is a case of its
own: pixel sizes within 20 %, as height and lens tell them. In parts; a later run with the same --work goes on.
"""

from __future__ import annotations

import functools
import math
import sys
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from bench import inputs, kept, page, two_dates
from bench.ground import GOAL, Ground, Image, milliseconds
from semref.core.assessment.cells import ground_cells
from semref.core.evaluation.trial import Query, Trial
from semref.core.localization import Method, Prior
from semref.core.simulation.label_errors import spoil_labels
from semref.core.simulation.noise import STRONG, LabelNoise
from semref.core.simulation.views import View
from semref.storage.database.reader import read_database

PAGE = "benchmarks.md"
SEED = 320
COUNT, QUICK_COUNT = 100, 2
SHARES = (1.0, 0.5, 0.25)
"""Of a window's edge that images show; times ± 15 %."""

SPREAD = 0.15
LEAST_LABELED = 0.7
CELLS_A_WINDOW = 2
CAMERA_SPREAD = 0.2
"""How far off the pixel size is told where the camera tells it."""

GROUPS = ((0, 2), (3, 11), (12, 10**9))
METHODS = (Method.CONSTELLATION, Method.AUTOMATIC)
COLUMNS = (
    "images",
    "landmarks",
    "automatic: right",
    "wrong",
    "refused",
    "right by constellation, by map correlation",
    "constellation alone: right; wrong",
    "ms: median, p95",
)


@dataclass(frozen=True)
class Noise:
    """A kind of labels: its name and noise, in pixels or, for networks, in meters of a map of 1 m."""

    name: str
    noise: LabelNoise
    in_meters: bool = False


BACKGROUND = replace(GOAL, patches=0.35, patch_size=150.0)
NOISES = (
    Noise("20 / 20 / 5 %", GOAL),
    Noise("the same, 35 % of the area in random classes", BACKGROUND),
    Noise("poor network", STRONG, True),
)


def measure(run: inputs.Run) -> dict[str, str]:
    if run.area.name == "sample":
        return {"footprints": "Not measured: the real data is not here."}
    count = run.how_many(COUNT, QUICK_COUNT)
    grounds = [("Liechtenstein", Ground.of(run))]
    if (run.data / two_dates.SOURCE).exists():
        labels = inputs.read_labels(two_dates.label_map(run, two_dates.AFTER))
        content = read_database(str(two_dates.database(run, 6400.0)), with_overview=True)
        grounds.append(("Christchurch 1996/2018", Ground(labels, content)))
    rows = []
    for name, ground in grounds:
        for share in SHARES:
            for noise in NOISES:
                for told in (False, True):
                    case = _name(name, ground, share, noise, told)
                    if run.wants(case):
                        measured = functools.partial(_part, ground, share, noise, told)
                        trials = kept.trials(run, "footprints", case, count, measured)
                        rows += _rows(case, trials) if trials else []
    return {"footprints": f"{_ABOUT.format(half=run.half)}\n\n{page.table(COLUMNS, rows)}"}


_ABOUT = """\
Uniform positions over the ground of Liechtenstein's {half}ern half, and of Christchurch (a map of 1996, images of
2018); any heading; images show 1, ½ and ¼ of a window's edge (± 15 %), at least 70 % of each labeled. “Pixel size
told”: within 20 %, as height and lens of a camera tell it. Right: within 2 % of the footprint."""


def _name(area: str, ground: Ground, share: float, noise: Noise, told: bool) -> str:
    edge = share * ground.database.parameters.window_size
    return f"{area}, {edge:,.0f} m, {noise.name}" + (", pixel size told" if told else "")


def _part(ground: Ground, share: float, noise: Noise, told: bool, part: int, size: int) -> list[list[Trial]]:
    """Trials of METHODS an image."""
    first = part * kept.TRIALS_A_PART
    return [_tried(ground, share, noise, told, number) for number in range(first, first + size)]


def _tried(ground: Ground, share: float, noise: Noise, told: bool, number: int) -> list[Trial]:
    """One image, by every method; the same one whether its pixel size is told or not."""
    rng = np.random.default_rng([SEED, round(100 * share), NOISES.index(noise), number])
    image = drawn(ground, share, rng)
    view = image.view
    window = ground.database.parameters.window_size
    # What networks do is stated for a map of 1 m whose windows show 1,280 m.
    spoiled = noise.noise.in_pixels(view.pixel_size * 1280.0 / window) if noise.in_meters else noise.noise
    smallest = max(ground.database.parameters.minimum_area / view.pixel_size**2, 1.0)
    donor = drawn(ground, share, rng).labels_hw if spoiled.spurious else None
    labels = spoil_labels(image.labels_hw, spoiled, rng, ground.spoiled_values, donor, smallest)
    off = 1 + CAMERA_SPREAD
    ground.prior = Prior(pixel_size_range=(view.pixel_size / off, view.pixel_size * off)) if told else None
    return [ground.try_image(replace(image, labels_hw=labels), method) for method in METHODS]


def drawn(ground: Ground, share: float, rng: np.random.Generator) -> Image:
    """An image anywhere on the ground that is labeled enough."""
    parameters = ground.database.parameters
    spacing = parameters.window_size / CELLS_A_WINDOW
    centers = _centers(ground, spacing)
    left, bottom, right, top = ground.extent
    while True:
        x, y = centers[rng.integers(len(centers))] + rng.uniform(-spacing / 2, spacing / 2, 2)
        edge = share * parameters.window_size * math.exp(rng.uniform(-SPREAD, SPREAD))
        size = round(share * parameters.window_size / parameters.pixel_size)
        view = View(float(x), float(y), float(rng.uniform(0, 360)), edge / size, size, size)
        if not (left <= x <= right and bottom <= y <= top):
            continue
        labels = ground.cut(view)
        if (labels > 0).mean() >= LEAST_LABELED:
            found = ground.landmarks_in(labels, view.pixel_size)
            return Image(Query(view), labels, int((~found.touches_edge).sum()))


@functools.lru_cache(maxsize=8)
def _centers(ground: Ground, spacing: float) -> np.ndarray:
    """(N, 2) middles of the squares of ground that the map has."""
    return ground_cells(ground.database, spacing).centers


def _rows(case: str, trials: Sequence[Sequence[Trial]]) -> list[list[str]]:
    """All images of a case, and those with few, some and many landmarks in view."""
    rows = [_row(case, "any", trials)]
    for low, high in GROUPS:
        chosen = [each for each in trials if low <= (each[0].landmarks or 0) <= high]
        if chosen:
            rows.append(_row("", f"{low}–{high}" if high < 10**9 else f"≥ {low}", chosen))
    print("  " + " | ".join(rows[0]), file=sys.stderr, flush=True)
    return rows


def _row(case: str, landmarks: str, trials: Sequence[Sequence[Trial]]) -> list[str]:
    alone, both = zip(*trials)
    right, total = [trial for trial in both if trial.is_right], len(both)
    roads = Counter(trial.result.method for trial in right)
    wrong, refused = sum(trial.is_wrong for trial in both), sum(not trial.is_fix for trial in both)
    by = f"{roads[Method.CONSTELLATION]}, {roads[Method.MAP_CORRELATION]}"
    counts = (page.rate(count, total) for count in (len(right), wrong, refused))
    own = f"{page.rate(sum(t.is_right for t in alone), total)}; {sum(t.is_wrong for t in alone)}"
    return [case, landmarks, *counts, by, own, milliseconds(both)]
