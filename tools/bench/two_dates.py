"""A map of 1996 and images of 2018: LCDB Christchurch, every method, by how many objects are in view."""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence

import numpy as np

from bench import inputs, page
from bench import localization_dates as dates
from bench.localization import RAGGED_PX, Case, spoil
from bench.localization_trials import Outcome, QueryMap, Wanted, accuracy, milliseconds, rate

PAGE = "benchmarks.md"
AREA = "LCDB v5.0 Christchurch, 2,232 polygons."
SEED = 2018
COUNT = 60
QUICK_COUNT = 3
FOOTPRINTS_M = (3_200.0, 6_400.0, 12_800.0)
SCALES = (0.8, 1.25)
LEAST_LABELED = 0.7
RIGHT_SHARE = 0.02
NEAR_SHARE = 0.25
"""Right: within this share of the footprint. Near: all that a method can do which names a window a quarter apart."""

GROUPS = ((0, 9), (10, 19), (20, 39), (40, 10**9))
SAME_GROUND, NOISY, SAME_DATE, MIRRORED = "2018", "2018, 20 / 20 / 5 %", "1996", "2018, mirrored"
SHARES = {SAME_GROUND: 1.0, NOISY: 1.0, SAME_DATE: 0.5, MIRRORED: 0.5}
"""Kinds of images, with their share of the count."""

METHODS = ("constellation", "map correlation", "automatic", "topology vector")


def measure(run: inputs.Run) -> dict[str, str]:
    if not (run.data / dates.SOURCE).exists():
        return {"two dates": f"Not measured: the real data {dates.SOURCE} is not here."}
    count = run.how_many(COUNT, QUICK_COUNT)
    before, after = (inputs.read_labels(dates.label_map(run, year)) for year in (dates.BEFORE, dates.AFTER))
    by_footprint = []
    by_objects = {kind: {method: [] for method in METHODS} for kind in (SAME_GROUND, NOISY)}
    for footprint in FOOTPRINTS_M[1:2] if run.quick else FOOTPRINTS_M:
        for kind, part in SHARES.items():
            labels = before if kind == SAME_DATE else after
            found = _tried(run, labels, footprint, math.ceil(part * count), kind, len(by_footprint))
            for method, outcomes in found.items():
                by_footprint.append(_row(f"{footprint / 1000:g} km, {kind}", method, outcomes, kind != MIRRORED))
                print("  " + " | ".join(map(str, by_footprint[-1])), file=sys.stderr, flush=True)
                if kind in by_objects:
                    by_objects[kind][method] += outcomes
    header = [
        "footprint, images of",
        "method",
        "objects in view, median (5–95 %)",
        "right fixes",
        "wrong fixes",
        "near",
        "median error, heading, scale",
        "in the 95 % ellipse",
        "ms median, p95",
    ]
    text = [_about(count, before, after), page.table(header, by_footprint)]
    for kind, found in by_objects.items():
        text += [f"Images of {kind}, by the number of whole objects in view:", _by_objects(found)]
    return {"two dates": "\n\n".join(text)}


def _tried(run, labels: np.ndarray, footprint: float, count: int, kind: str, number: int) -> dict[str, list[Outcome]]:
    """The same images, each given to every method."""
    size = round(footprint / dates.PIXEL_SIZE_M)
    area = QueryMap(labels, dates.database(run, footprint), size)
    wanted = Wanted(SCALES, objects=(0, 10**9), labeled=LEAST_LABELED)
    rng = np.random.default_rng([SEED, number])
    found: dict[str, list[Outcome]] = {method: [] for method in METHODS}
    for _ in range(count):
        view, image, objects = area.draw(wanted, rng)
        if kind == NOISY:
            image = spoil(area, Case(kind), view, image, rng)
        if kind == MIRRORED:
            image = np.ascontiguousarray(image[:, ::-1])
        for method in METHODS:
            found[method].append(area.localize(view, image, objects, method))
    return found


def _row(name: str, method: str, outcomes: Sequence[Outcome], findable: bool) -> list[str]:
    total = len(outcomes)
    right = [o for o in outcomes if findable and is_right(o)]
    fixes = sum(o.is_fix for o in outcomes)
    low, median, high = np.percentile([o.objects for o in outcomes], [5, 50, 95])
    near = rate(sum(o.is_right(NEAR_SHARE * o.footprint_m) for o in outcomes), total) if findable else "–"
    return [
        name,
        method,
        f"{median:.0f} ({low:.0f}–{high:.0f})",
        rate(len(right), total) if findable else "–",
        rate(fixes - len(right), total),
        near,
        *accuracy(right),
        milliseconds(outcomes),
    ]


def is_right(outcome: Outcome) -> bool:
    """Within RIGHT_SHARE of the footprint."""
    return outcome.is_right(RIGHT_SHARE * outcome.footprint_m)


def _by_objects(found: dict[str, list[Outcome]]) -> str:
    rows = []
    for low, high in GROUPS:
        cells = [f"{low}–{high}" if high < 10**9 else f"≥ {low}"]
        for outcomes in found.values():
            chosen = [o for o in outcomes if low <= o.objects <= high]
            wrong = sum(o.is_fix and not is_right(o) for o in chosen)
            cells.append(f"{rate(sum(map(is_right, chosen)), len(chosen))}; {wrong} wrong" if chosen else "–")
        rows.append(cells)
    return page.table(["objects", *(f"{method}: right" for method in found)], rows)


def _about(count: int, before: np.ndarray, after: np.ndarray) -> str:
    land = (before > 0) & (after > 0)
    return _ABOUT.format(
        pixel=dates.PIXEL_SIZE_M,
        low=SCALES[0],
        high=SCALES[1],
        ragged=RAGGED_PX,
        changed=100 * (before != after)[land].mean(),
        area=dates.MINIMUM_AREA_M2,
        labeled=100 * LEAST_LABELED,
        count=count,
        right=100 * RIGHT_SHARE,
        near=100 * NEAR_SHARE,
    )


_ABOUT = """\
LCDB v5.0 Christchurch (CC BY 4.0, Landcare Research NZ), {pixel:g} m pixels: the database is made of the map of 1996,
label images are cut from the map of 2018 at any place and heading, scale {low:g}–{high:g}, with no other noise
(“2018”) or with 20 % of the objects erased, 20 % invented, 5 % misnamed and edges moved by σ {ragged:g} px (“20 / 20
/ 5 %”); {changed:.1f} % of the land has another class. Reference classes are those that lie as patches, of at least
{area:,.0f} m² (`PATCHES` in `tools/bench/localization_dates.py`). At least {labeled:g} % of each image is land.
{count} images a row (half as many of “1996” and “mirrored”), the same ones for every method, any number of objects in
view. “1996”: images of the database's own date, to see what the years cost; “mirrored” images lie nowhere. Right:
within {right:g} % of the footprint; near: fixes within {near:g} %, which is all that topology vectors (windows a
quarter of the footprint apart) can do. Times: processor, one core. Boundaries that did not change are the very same
in both maps (LCDB is revised, not redrawn): maps from two hands will differ more."""
